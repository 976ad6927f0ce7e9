#include "core/nc/nct/coverage/coverage_rows.h"

namespace proveout::nc {

std::string_view rowStatusName(RowStatus status) {
  switch (status) {
    case RowStatus::kDone:
      return "done";
    case RowStatus::kPartly:
      return "partly";
    case RowStatus::kMissing:
      return "missing";
    case RowStatus::kDeferred:
      return "deferred";
  }
  return "missing";
}

std::vector<CoverageId> nctRows() {
  std::vector<CoverageId> all;
  for (const auto rows : {coverage1(), coverage2(), coverage3(), coverage4(), coverage5(), coverage6()}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

}  // namespace proveout::nc
