// The rows of the nct manual that this control is to serve, each with what is done and what proves it.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/nc/iso/model/codes.h"

namespace proveout::nc {

enum class RowStatus {
  kDone,
  kPartly,
  kMissing,
  kDeferred  ///< turning, gear and five-axis functions: not asked of this control yet
};
std::string_view rowStatusName(RowStatus status);  ///< "done", "partly", "missing", "deferred"

struct CoverageId {
  std::string_view id;  ///< "nct-4.3-G2"
  CodeClass cls;
  RowStatus status;
  /// A golden program ("good/arc_cone.nc") whose "proves:" names the id, or a test source
  /// ("tests/unit/...cpp") that names it; empty: no test names it yet.
  std::string_view proof;
};

/// Rows of the six parts of the manual's list.
std::span<const CoverageId> coverage1();
std::span<const CoverageId> coverage2();
std::span<const CoverageId> coverage3();
std::span<const CoverageId> coverage4();
std::span<const CoverageId> coverage5();
std::span<const CoverageId> coverage6();
/// All of them in order.
std::vector<CoverageId> nctRows();

/// Rows of the specification that are open for one reason.
struct OpenRows {
  std::string_view reason;  ///< one line
  std::string_view ids;     ///< separated by blanks
};
/// Every row that is not done is in one of them, deferred ones too.
std::span<const OpenRows> nctOpenRows();

}  // namespace proveout::nc
