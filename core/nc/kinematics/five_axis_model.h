// What a control knows of a machine with two rotary axes: the equations of the NCT manual, 25.1 to 25.4.
//
// Machine frame, mm and deg. Matrices are right-handed and active.
#pragma once

#include <array>
#include <optional>

#include "core/machine/machine_model.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/kinematics/frames.h"

namespace proveout::nc {

/// The values of N3200.
enum class FiveAxisKind : std::uint8_t { kNone, kHeadHead, kTableTable, kHeadTable };

/// Positions of the rotary axes, machine coordinates, deg.
struct RotaryAngles {
  double first = 0.0, second = 0.0;
};

/// Either axis may be missing: a machine with one rotary axis has one matrix that is the identity.
struct FiveAxisModel {
  FiveAxisKind kind = FiveAxisKind::kNone;
  int first = -1, second = -1;  ///< axes by index; -1: there is none
  Vec3 first_direction = Vec3::UnitX(), second_direction = Vec3::UnitZ();  ///< unit, all axes at 0
  double first_sign = 1.0, second_sign = 1.0;  ///< -1: a positive angle turns left-handed (RD1, RD2)
  Vec3 tool = Vec3::UnitZ();                   ///< from tip to holder, all axes at 0 (N3201)
  Vec3 table = Vec3::Zero();  ///< a point of the first table axis, of the only one of a head-table machine
  Vec3 table_offset = Vec3::Zero();  ///< from there to the second table axis, first axis at 0
  Vec3 head = Vec3::Zero();          ///< from the holder's point to the nearest head axis, all axes at 0
  Vec3 head_offset = Vec3::Zero();   ///< from there to the other head axis

  bool hasHead() const { return kind == FiveAxisKind::kHeadHead || kind == FiveAxisKind::kHeadTable; }
  bool hasTable() const { return kind == FiveAxisKind::kTableTable || kind == FiveAxisKind::kHeadTable; }
  RotaryAngles at(const AxisPoint& machine) const {
    return {first >= 0 ? machine[first] : 0.0, second >= 0 ? machine[second] : 0.0};
  }
  Mat3 firstTurn(double degrees) const;
  Mat3 secondTurn(double degrees) const;

  /// From the tip to the control point, of a tool of length `length`: V of 25.2.
  Vec3 lengthVector(const RotaryAngles& at, double length) const;
  /// From a point of the workpiece to the machine, where the tables carry it: `zero` is the machine point of
  /// its origin, measured with the tables at `zero_at`.
  FrameStep workpieceOnTable(const RotaryAngles& at, const Vec3& zero, const RotaryAngles& zero_at) const;
  /// Machine point of the dynamic zero of G54.2 (25.4): `vector` leads from the second table axis to it with
  /// the tables at `measured_at`.
  Vec3 dynamicZero(const RotaryAngles& at, const Vec3& vector, const RotaryAngles& measured_at) const;
  /// Direction of the tool seen from the workpiece, for which the tables at 0 are where it was measured.
  Vec3 toolVector(const RotaryAngles& at) const;
  /// The same seen from the machine: tables do not matter.
  Vec3 spindleVector(const RotaryAngles& at) const;
  /// Up to two positions at which the tool has this direction, -180 < angle <= 180; axes that do not matter
  /// stay where they are in `now`.
  struct Positions {
    int count = 0;
    std::array<RotaryAngles, 2> at;
  };
  Positions positionsFor(const Vec3& tool_vector, const RotaryAngles& now) const;

 private:
  Positions positionsOfOne(const Vec3& tool_vector, const RotaryAngles& now) const;
};

/// The model of a machine; kNone with more than two rotary axes that carry tool or part, or none.
FiveAxisModel fiveAxisModelOf(const MachineModel& machine);

/// The position that the control takes of two (25.11): within travel, by the smaller motion of the first axis
/// (of the table, where only one axis is a table), of the other axis, nearest to a whole turn; where all are
/// alike the larger angle. None: both are out of travel.
std::optional<RotaryAngles> choosePosition(const FiveAxisModel& model,
                                           const FiveAxisModel::Positions& positions, const RotaryAngles& now,
                                           const AxisTable& axes);

}  // namespace proveout::nc
