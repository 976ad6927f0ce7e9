// Settings of the machine that the FlexNC manual leaves open, and the operator's correctors (digest flexnc,
// 1.2, 1.3, 14).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_info.h"

namespace proveout::nc {

std::vector<ParameterInfo> flexncParameterTable();

class FlexParameters {
 public:
  /// Error: an unknown name or a value out of range.
  Status set(const std::map<std::string, double>& given);

  bool arcs_seen_x_up = false;     ///< G02, G03, G12, G13, G3.1: clockwise is seen with X up (ISO)
  bool sides_seen_x_down = false;  ///< G41, G42: left is seen with X down
  bool diameters = false;          ///< X and I outside of templates are diameters
  bool g52_shifts = false;         ///< G52 shifts the origin, else it names the point where the tool is
  bool ring_outer_edge = false;    ///< G79.2: the tool's point is its outer edge
  double max_speed = 0.0;          ///< 1/min, highest speed of the spindle; 0: no limit

  static constexpr int kCorrectors = 127;
  /// What D selects.
  struct Corrector {
    double nose_radius = 0.0;   ///< mm
    int tip = 0;                ///< where the point that moves is seen from the nose centre, 0 to 9
    double dx = 0.0, dz = 0.0;  ///< mm, shift of the tool; X as a radius
  };
  /// Without a shift and without a nose where nothing was entered.
  const Corrector& corrector(int number) const;
  const std::map<int, Corrector>& correctors() const { return correctors_; }

 private:
  Status put(const std::string& name, double value);

  std::map<int, Corrector> correctors_;
};

}  // namespace proveout::nc
