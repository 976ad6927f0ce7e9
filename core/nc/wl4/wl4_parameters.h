// Parameters of the WL4 control (digest wl4, 12).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_info.h"

namespace proveout::nc {

std::vector<ParameterInfo> wl4ParameterTable(bool lathe);

/// Values of the parameters.
class Wl4Parameters {
 public:
  /// Error: an unknown name or a value out of range.
  Status set(const std::map<std::string, double>& given, bool lathe);

  bool g18_zx = false;         ///< G18 looks at Z to the right and X up (ISO), else X to the right and Z up
  bool conditional = false;    ///< blocks with `/` are executed
  double arc_threshold = 0.0;  ///< Delt_L, mm
  double max_feed = 65000.0;   ///< mm/min
  double max_speed = 0.0;      ///< 1/min; 0: no limit
  static constexpr int kTools = 127;
  struct Tool {
    double nose_radius = 0.0;   ///< Rt, mm
    bool at_center = false;     ///< working point S, the nose centre, else P
    int tip = 0;                ///< where P is seen from S, 1 to 8 as usual on lathes; 0, 9: at S
    double dx = 0.0, dz = 0.0;  ///< dXw, dZw, added to programmed coordinates, X as a radius, mm
  };
  const Tool& tool(int number) const;
  const std::map<int, Tool>& tools() const { return tools_; }

 private:
  std::map<int, Tool> tools_;
};

}  // namespace proveout::nc
