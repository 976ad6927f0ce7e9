// What the job says of a wire EDM machine (digest wedm, D1): [control.wedm].
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/nc/control/control_info.h"
#include "core/nc/services/wire_offset.h"

namespace proveout::nc {

std::vector<ParameterInfo> wedmParameterTable();

inline constexpr int kWedmConditions = 100;  ///< C001 to C100
inline constexpr int kWedmOffsets = 1000;    ///< H000 to H999; the control has those to H099

/// Values of the parameters. Lengths mm; heights above the table, z upward.
class WedmParameters {
 public:
  /// Error: an unknown name, a value out of range, or heights that do not go together.
  Status set(const std::map<std::string, double>& given);

  double thickness = 20.0;  ///< of the workpiece
  bool thickness_given = false;
  double bottom = 0.0;                          ///< of the workpiece
  double z_main = 0.0, z_second = 0.0;          ///< planes of the programmed contour and of the taper
  double z_lower = 0.0, z_upper = 0.0;          ///< guides
  double arc_tolerance = 0.01;                  ///< allowed difference of the radii at the ends of an arc
  double tangent = 0.002;                       ///< element ends nearer than this are joined
  double max_tilt_deg = 0.0;                    ///< 0: that of taper angles, 45
  double u_travel = 0.0, v_travel = 0.0;        ///< to each side; 0: no limit
  bool uv_upper = false;                        ///< U, V of G74 are told at the upper guide
  OuterJoin straight_join = OuterJoin::kMiter;  ///< of G29
  bool taper_arcs = false;  ///< outer corners of two lines get an arc in the secondary plane
  double slow_share = 0.5;  ///< of the speed in the last 3 mm with G34

  /// Speed of the condition along a path, mm/min; 0: not in the machine's table. 0 is the speed without C.
  double feedOf(int condition) const;
  double rise() const { return z_second - z_main; }  ///< h of the digest
  double guides() const { return z_upper - z_lower; }
  const std::array<double, kWedmOffsets>& offsets() const { return offsets_; }  ///< H at the start

 private:
  struct Condition {
    double feed = 3.0;  ///< mm/min
    double area = 0.0;  ///< mm2/min; 0: `feed` counts
    bool absent = false;
  };
  Status put(const std::string& name, double value);
  Status finish();

  std::array<Condition, kWedmConditions + 1> conditions_;  ///< [0]: none selected
  std::array<double, kWedmOffsets> offsets_{};
  std::optional<double> z_main_, z_second_, z_lower_, z_upper_;
};

}  // namespace proveout::nc
