// Coordinate systems of a channel: the chain from programmed to machine coordinates, and the registers that
// it is made of. Lengths mm, angles degrees in registers.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/geometry/types.h"
#include "core/machine/axis_point.h"
#include "core/nc/kinematics/axis_map.h"
#include "core/nc/kinematics/program_transforms.h"

namespace proveout::nc {

/// y = linear * x + offset. A chain is a list of these, applied first to last.
struct FrameStep {
  Mat3 linear = Mat3::Identity();
  Vec3 offset = Vec3::Zero();
};

/// programmed point --(transforms of the program: mirror, scale, rotation)--(local shift)--> work point
///   --(basic rotation, work offset, length offset)--> machine point.
/// Cutter compensation works on work points: there the path has its programmed shape and nothing that
/// flushes look-ahead is in force yet.
class CoordinateChain {
 public:
  CoordinateChain() = default;
  CoordinateChain(const std::vector<FrameStep>& program_to_work,
                  const std::vector<FrameStep>& work_to_machine);

  Vec3 toWork(const Vec3& p) const { return apply(work_, work_moves_only_, p); }
  Vec3 workToMachine(const Vec3& q) const { return apply(machine_, machine_moves_only_, q); }
  Vec3 toMachine(const Vec3& p) const { return workToMachine(toWork(p)); }
  /// Inverse of toMachine().
  Vec3 toProgram(const Vec3& machine) const;
  // The same for points in all axes: axes besides X Y Z are only moved.
  AxisPoint workOf(const AxisPoint& p) const;
  AxisPoint machineOf(const AxisPoint& p) const;
  AxisPoint programOf(const AxisPoint& machine) const;
  /// Program to work and work to machine coordinates, in place.
  void moveToWork(AxisPoint& p) const;
  void moveToMachine(AxisPoint& p) const;
  /// Offsets of `count` further axes from program to work and from work to machine coordinates.
  void moveFurtherAxes(int count, const AxisPoint& program_to_work, const AxisPoint& work_to_machine);
  /// Factors of the further axes between program and work coordinates: mirrored and scaled ones. Where a
  /// rotation takes two axes together, `shift` is the local shift behind it.
  void scaleFurtherAxes(const ProgramMap& map, const AxisPoint& shift);
  /// The sense of further axes from work to machine coordinates: -1 where they go against their direction.
  void turnFurtherAxes(const AxisMap& map);

  /// Whether arcs of a plane turn the other way in machine space, about the normal that
  /// directionToMachine() gives where the plane is one of X, Y and Z.
  bool turnsArcs(int u, int v) const;

  /// Is there more than shifts in it?
  bool turns() const { return turnsMain() || pair_.u >= 0; }
  /// The same of X, Y, Z among themselves.
  bool turnsMain() const {
    return !work_moves_only_ || !(machine_moves_only_ || machine_.linear.isDiagonal(0.0));
  }
  /// Turns a direction of work space into machine space.
  Vec3 directionToMachine(const Vec3& d) const { return machine_moves_only_ ? d : Vec3(machine_.linear * d); }

 private:
  static Vec3 apply(const FrameStep& step, bool moves_only, const Vec3& p) {
    if (moves_only) return p + step.offset;
    return step.linear * p + step.offset;
  }
  double senseOf(std::size_t further) const { return against_.test(kMainAxes + further) ? -1.0 : 1.0; }
  FrameStep work_, machine_;
  bool work_moves_only_ = true, machine_moves_only_ = true;
  ProgramMap::Pair pair_;  ///< two axes that are rotated together, program to work
  int more_count_ = 0;     ///< of the arrays below only so many are set
  std::array<double, kMaxAxes - kMainAxes> work_more_, machine_more_, work_factor_;
  AxisSet against_;  ///< names whose axis goes against its direction, work to machine
};

/// Mz(gamma) * My(beta) * Mx(alpha), right-handed, angles (alpha, beta, gamma) in degrees.
Mat3 basicRotation(const Vec3& angles_deg);

/// A work coordinate system: offset in the machine frame, and basic rotation about its own origin.
struct WorkSystem {
  AxisPoint offset;
  Vec3 angles_deg = Vec3::Zero();
  /// Which word set each value, X, Y, Z (see OriginWords); 0: the job.
  std::array<std::uint32_t, 3> offset_by{}, angles_by{};
};

/// Number of a work system: 1..6 are G54..G59, 101..199 are G54.1 P1..P99, 0 is the common offset.
using WorkSystemId = int;
inline constexpr WorkSystemId kFirstExtended = 101;

/// What five-axis functions put into a chain: work point --(tilted plane)--(basic rotation)--(workpiece on
/// its tables)--(length vector)--> machine point.
struct SpatialFrames {
  FrameStep tilt;
  FrameStep zero;              ///< in place of the shift by the work offset
  Vec3 length = Vec3::Zero();  ///< in place of the length offset of X, Y, Z
  AxisPoint rotary_offset;     ///< of the axes besides X Y Z, in place of those of the work offset
};

/// Registers. Plain values; whoever changes one builds a new chain.
struct WorkFrames {
  WorkSystem common;  ///< its angles stay 0
  std::array<WorkSystem, 6> basic;
  std::map<int, WorkSystem> extended;       ///< by P
  AxisPoint shift92;                        ///< G92, work coordinates
  AxisPoint shift52;                        ///< G52, work coordinates
  std::array<std::uint32_t, 3> shift_by{};  ///< which word set the shift last, as in WorkSystem
  int more_axes = 0;                        ///< axes of the channel besides X Y Z
  AxisMap axes;  ///< offsets above are by axis; the chain and `length` of chain() are by name

  WorkSystem& system(WorkSystemId id);
  WorkSystem system(WorkSystemId id) const;
  /// The chain with the program's transforms, work system `active` and length offset `length` (machine axes).
  /// `spatial`: with the five-axis functions in force; null: there are none.
  CoordinateChain chain(const ProgramMap& map, WorkSystemId active, const AxisPoint& length,
                        const SpatialFrames* spatial = nullptr) const;
};

}  // namespace proveout::nc
