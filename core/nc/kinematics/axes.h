// Axes of a channel: names, kinds, limits, and points in all of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/types.h"
#include "core/machine/axis_point.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/kinematics/feed_limits.h"
#include "core/nc/services/plane_frame.h"
#include "core/nc/text/lex_names.h"

namespace proveout::nc {

/// The plane of arcs and compensation by axis index; w is the axis of drilling. u and v may be axes parallel
/// to the main ones, or rotary ones where a code says so.
struct WorkPlane {
  int u = 0, v = 1, w = 2;
  WorkPlane() = default;
  WorkPlane(int first, int second, int third) : u(first), v(second), w(third) {}
  explicit WorkPlane(const PlaneFrame& frame) : u(frame.u()), v(frame.v()), w(frame.w()) {}
  /// (u, v, w) of a point.
  Vec3 of(const AxisPoint& p) const { return {p[u], p[v], p[w]}; }
  /// The point with these coordinates, the others 0.
  AxisPoint point(const Vec3& uvw) const {
    AxisPoint p;
    p[u] = uvw.x();
    p[v] = uvw.y();
    p[w] = uvw.z();
    return p;
  }
  bool operator==(const WorkPlane&) const = default;
};

/// A rotary axis that turns the part: right-handed about `direction`, as the tool moves seen from the part.
struct RotaryMount {
  Vec3 direction = Vec3::UnitZ();
  std::optional<Vec3> center;  ///< machine frame, mm; without it the axis goes through the workpiece origin
};

/// An axis as the channel knows it.
struct AxisInfo {
  std::string name;  ///< upper case
  int number = 1;    ///< of the machine, for AX[n] and axis parameters
  AxisKind kind = AxisKind::kLinear;
  int parallel_to = -1;              ///< 0..2, or -1
  double rapid = 15000.0;            ///< mm/min or deg/min, > 0
  double acceleration = 0.0;         ///< mm/s^2 or deg/s^2; 0: no limit
  std::optional<AxisLimit> limit;    ///< machine coordinates
  std::optional<RotaryMount> mount;  ///< of tables, where the settings name no machine
  bool turns = false;                ///< rotary: it turns tool or part, as the job describes it
  bool rotary() const { return kind == AxisKind::kRotary; }
};

/// Names of spindles: their speeds come first in Word::spindle, their positions behind them.
inline constexpr int kSpindleNames = 16;

/// The axes of a channel, fixed for a run. X, Y, Z are always there.
class AxisTable {
 public:
  /// Settings that checkAxes() refuses give X, Y, Z alone.
  explicit AxisTable(const ControlSettings& settings);

  int count() const { return static_cast<int>(axes_.size()); }
  /// Axes besides X Y Z.
  int moreCount() const { return count() - kMainAxes; }
  const AxisInfo& at(int axis) const { return axes_[static_cast<std::size_t>(axis)]; }
  AxisInfo& at(int axis) { return axes_[static_cast<std::size_t>(axis)]; }
  /// Index of the axis of that name, or -1.
  int find(std::string_view name) const;
  /// Index of the axis of that number, or -1.
  int byNumber(int number) const;
  /// Addresses that words of axes have: X Y Z, U V W, and those of further axes.
  AddressSet addresses() const { return addresses_; }
  const LexNames& names() const { return names_; }

 private:
  std::vector<AxisInfo> axes_;
  AddressSet addresses_ = "XYZUVW";
  LexNames names_;
};

/// Why the axes of the settings cannot be: too many, a bad or doubled name or number, a rate or period not
/// above 0. Empty: they can.
std::string checkAxes(const ControlSettings& settings);

/// The accelerations of the axes and the bell time, s; no other limit. For controls whose parameters say no
/// more.
MotionLimits accelerationLimits(const AxisTable& axes, double bell_time_s);

}  // namespace proveout::nc
