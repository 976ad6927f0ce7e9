#include "core/nc/nct/nct_parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <string_view>

namespace proveout::nc {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

const std::array<ParameterInfo, static_cast<std::size_t>(NctParam::kCount)>& nctParameterTable() {
  static constexpr std::array<ParameterInfo, static_cast<std::size_t>(NctParam::kCount)> kTable{{
      {"N0300", 0, 0, 1e6, "feed at power-on in G94, units of length a minute; 0: a feed must be programmed"},
      {"N0301", 0, 0, 1e3, "feed at power-on in G95, units of length a turn; 0: a feed must be programmed"},
      {"N0607.ORI", 1, 0, 1, "the spindle can be oriented (G76, G87 back boring)"},
      {"N0607.INX", 1, 0, 1, "the spindle can be indexed (G84.2, G84.3)"},
      {"N1300.G01", 0, 0, 1, "power-on interpolation: 0 G0, 1 G1"},
      {"N1300.G18", 0, 0, 1, "power-on plane G18"},
      {"N1300.G19", 0, 0, 1, "power-on plane G19"},
      {"N1300.G43", 0, 0, 1, "power-on length compensation G43"},
      {"N1300.G44", 0, 0, 1, "power-on length compensation G44"},
      {"N1300.G91", 0, 0, 1, "power-on incremental data"},
      {"N1301.G95", 0, 0, 1, "power-on feed per turn"},
      {"N1337.SEC", 0, 0, 1, "dwell always in seconds"},
      {"N1337.CCA", 0, 0, 1, "arc centre words are absolute"},
      {"N1337.HEF", 0, 0, 1, "helix feed along the path in space, not along the circle"},
      {"N1337.CBB", 1, 0, 1, "an optional-skip block does not stop look-ahead"},
      {"N1338.M06", 1, 0, 1, "1: M6 changes the tool, T selects it; 0: T changes it"},
      {"N1339", 0.01, 0, 1e3, "difference of start and end radius that an arc may have, mm"},
      {"N1400", 999, 1, 999, "rows of the offset table"},
      {"N1403.IEN", 1, 0, 1, "interference check of cutter compensation"},
      {"N1403.AAL", 0, 0, 1, "interference: 1 always alarm, 0 leave out blocks where that mends it"},
      {"N1404", 0, 0, 8, "further blocks that the interference check looks ahead"},
      {"N1405", 0.001, 0, 10, "corner points of cutter compensation nearer than this are merged, mm"},
      {"N1416.ZAX", 1, 0, 1, "length compensation always on Z"},
      {"N1416.PLN", 0, 0, 1, "length compensation on the axis normal to the plane"},
      {"N1500", 1, 0, 1e3, "G73 pull-back, mm"},
      {"N1501", 1, 0, 1e3, "G83 clearance, mm"},
      {"N1502", 100, 1, 1000, "G85, G89 feed out, % of the feed in"},
      {"N1506", 100, 1, 1000, "rigid tapping: feed out, % (with N1503.EOE)"},
      {"N1503.TSC", 0, 0, 1, "rigid tapping: orient the spindle instead of closing the loop"},
      {"N1503.PTC", 0, 0, 1, "rigid tapping with Q: return to R between pecks"},
      {"N1503.EOE", 0, 0, 1, "rigid tapping: override of the feed out in force"},
      {"N1504", 1, 0, 1e3, "rigid tapping with Q: pull-back, mm"},
      {"N1505", 1, 0, 1e3, "rigid tapping with Q and return to R: clearance, mm"},
  }};
  return kTable;
}

NctParameters::NctParameters() {
  const auto& table = nctParameterTable();
  for (std::size_t i = 0; i < table.size(); ++i) values_[i] = table[i].default_value;
}

Status NctParameters::set(const std::map<std::string, double>& values) {
  const auto& table = nctParameterTable();
  for (const auto& entry : values) {
    const std::string& name = entry.first;
    const double value = entry.second;
    const auto row = std::find_if(table.begin(), table.end(), [&](const auto& p) { return p.name == name; });
    if (row == table.end()) {
      const auto bit = std::find_if(table.begin(), table.end(),
                                    [&](const auto& q) { return q.name.starts_with(name + "."); });
      if (bit != table.end()) {
        return inputError(
            fmt::format("parameter {} of control nct is set by its bits (for example {})", name, bit->name));
      }
      const auto nearest = std::min_element(table.begin(), table.end(), [&](const auto& a, const auto& b) {
        return editDistance(a.name, name) < editDistance(b.name, name);
      });
      return inputError(
          fmt::format("unknown parameter {} of control nct (nearest known: {})", name, nearest->name));
    }
    const bool is_flag = row->min == 0 && row->max == 1 && name.find('.') != std::string::npos;
    if (!(value >= row->min && value <= row->max) || (is_flag && value != 0 && value != 1)) {
      return inputError(fmt::format("parameter {} = {}: must be {} {} to {}", name, value,
                                    is_flag ? "0 or 1, that is" : "from", row->min, row->max));
    }
    values_[static_cast<std::size_t>(row - table.begin())] = value;
    given_[static_cast<std::size_t>(row - table.begin())] = true;
  }
  return Done{};
}

}  // namespace proveout::nc
