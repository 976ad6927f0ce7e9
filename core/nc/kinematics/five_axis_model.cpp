#include "core/nc/kinematics/five_axis_model.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid_transform.h"
#include "core/machine/machine_chain.h"
#include "core/machine/rotary_pair.h"

namespace proveout::nc {

namespace {

/// Angles nearer than this are alike, deg.
constexpr double kSameDeg = 1e-6;
/// Directions nearer to an axis than this (sine) lie along it.
constexpr double kAlong = 1e-9;
/// A direction is reached where the tool's is this near to it: rounding of the angles.
constexpr double kReached = 1e-7;

/// Of an angle and its whole turns away, the one nearest to `now` that is within travel; NaN: none.
double nearestWithin(double angle, double now, const std::optional<AxisLimit>& limit) {
  double best = angle + 360.0 * std::round((now - angle) / 360.0);
  if (!limit || (best >= limit->min - kSameDeg && best <= limit->max + kSameDeg)) return best;
  const double low = angle + 360.0 * std::ceil((limit->min - kSameDeg - angle) / 360.0);
  const double high = angle + 360.0 * std::floor((limit->max + kSameDeg - angle) / 360.0);
  if (low > limit->max + kSameDeg) return std::nan("");
  return best < limit->min ? low : high;
}

double fromWholeTurn(double angle) { return std::abs(std::remainder(angle, 360.0)); }

}  // namespace

Mat3 FiveAxisModel::firstTurn(double degrees) const {
  return first < 0 ? Mat3(Mat3::Identity()) : turnAbout(first_direction, first_sign * degrees);
}

Mat3 FiveAxisModel::secondTurn(double degrees) const {
  return second < 0 ? Mat3(Mat3::Identity()) : turnAbout(second_direction, second_sign * degrees);
}

Vec3 FiveAxisModel::lengthVector(const RotaryAngles& at, double length) const {
  const Vec3 along = length * tool;
  if (kind == FiveAxisKind::kHeadTable) return firstTurn(at.first) * (along + head) - head;
  if (kind != FiveAxisKind::kHeadHead) return along;
  const Mat3 outer = firstTurn(at.first);
  return outer * (secondTurn(at.second) * (along + head) + head_offset) - (head + head_offset);
}

FrameStep FiveAxisModel::workpieceOnTable(const RotaryAngles& at, const Vec3& zero,
                                          const RotaryAngles& zero_at) const {
  if (!hasTable()) return {Mat3::Identity(), zero};
  if (kind == FiveAxisKind::kHeadTable) {
    const Mat3 turn = secondTurn(at.second), back = secondTurn(-zero_at.second);
    return {turn * back, table + turn * (back * (zero - table))};
  }
  const Mat3 outer = firstTurn(at.first), inner = secondTurn(at.second),
             outer_back = firstTurn(-zero_at.first), inner_back = secondTurn(-zero_at.second);
  const Vec3 on_table = inner_back * (outer_back * (zero - table) - table_offset);
  return {outer * inner * inner_back * outer_back, table + outer * (table_offset + inner * on_table)};
}

Vec3 FiveAxisModel::dynamicZero(const RotaryAngles& at, const Vec3& vector,
                                const RotaryAngles& measured_at) const {
  if (kind == FiveAxisKind::kHeadTable)
    return secondTurn(at.second) * (secondTurn(-measured_at.second) * vector) + table;
  const Vec3 on_table = secondTurn(-measured_at.second) * (firstTurn(-measured_at.first) * vector);
  const Mat3 outer = firstTurn(at.first);
  return outer * (secondTurn(at.second) * on_table + table_offset) + table;
}

Vec3 FiveAxisModel::spindleVector(const RotaryAngles& at) const {
  if (kind == FiveAxisKind::kHeadTable) return firstTurn(at.first) * tool;
  return kind == FiveAxisKind::kHeadHead ? Vec3(firstTurn(at.first) * (secondTurn(at.second) * tool)) : tool;
}

Vec3 FiveAxisModel::toolVector(const RotaryAngles& at) const {
  const Mat3 outer = firstTurn(at.first), inner = secondTurn(at.second);
  if (kind == FiveAxisKind::kHeadHead) return outer * (inner * tool);
  if (kind == FiveAxisKind::kHeadTable) return inner.transpose() * (outer * tool);
  return inner.transpose() * (outer.transpose() * tool);
}

/// The position of a machine with one rotary axis, if it reaches the direction.
FiveAxisModel::Positions FiveAxisModel::positionsOfOne(const Vec3& tool_vector,
                                                       const RotaryAngles& now) const {
  const Vec3& axis = first_direction;
  const Vec3 from = kind == FiveAxisKind::kTableTable ? tool_vector : tool,
             to = kind == FiveAxisKind::kTableTable ? tool : tool_vector;
  const Vec3 a = from - axis.dot(from) * axis, b = to - axis.dot(to) * axis;
  Positions out;
  out.at[0] = now;
  if (a.norm() > kAlong) out.at[0].first = first_sign * radToDeg(std::atan2(axis.dot(a.cross(b)), a.dot(b)));
  out.count = (toolVector(out.at[0]) - tool_vector).norm() < kReached ? 1 : 0;
  return out;
}

FiveAxisModel::Positions FiveAxisModel::positionsFor(const Vec3& tool_vector, const RotaryAngles& now) const {
  if (second < 0) return positionsOfOne(tool_vector, now);
  Positions out;
  AnglePairs pairs;
  if (kind == FiveAxisKind::kHeadTable) {
    pairs = solveAngles(-second_direction, first_direction, tool, tool_vector);
    for (AnglePair& p : pairs.pair) {
      std::swap(p.first, p.second);
      std::swap(p.first_free, p.second_free);
    }
  } else if (kind == FiveAxisKind::kHeadHead) {
    pairs = solveAngles(first_direction, second_direction, tool, tool_vector);
  } else {
    pairs = solveAngles(first_direction, second_direction, tool_vector, tool);
  }
  out.count = pairs.count;
  for (int i = 0; i < pairs.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    out.at[k].first = pairs.pair[k].first_free ? now.first : first_sign * pairs.pair[k].first;
    out.at[k].second = pairs.pair[k].second_free ? now.second : second_sign * pairs.pair[k].second;
  }
  return out;
}

FiveAxisModel fiveAxisModelOf(const MachineModel& machine) {
  FiveAxisModel out;
  const MachineChain chain(machine, Vec3::Zero());
  const std::vector<MachineChain::Turn> turns = chain.rotaryAxes();  // from the tip to the bed to the part
  if (turns.empty() || turns.size() > 2) return out;
  const auto isTable = [&](const MachineChain::Turn& t) {
    return machine.axes[static_cast<std::size_t>(t.axis)].side == AxisSide::kPart;
  };
  out.tool = machine.spindle.direction;
  const auto tables = static_cast<std::size_t>(std::ranges::count_if(turns, isTable));
  const auto signOf = [&](const MachineChain::Turn& t) {
    return machine.axes[static_cast<std::size_t>(t.axis)].left ? -1.0 : 1.0;
  };
  const auto setFirst = [&](const MachineChain::Turn& t) {
    out.first = t.axis;
    out.first_direction = t.direction;
    out.first_sign = signOf(t);
  };
  const auto setSecond = [&](const MachineChain::Turn& t) {
    out.second = t.axis;
    out.second_direction = t.direction;
    out.second_sign = signOf(t);
  };
  if (tables == turns.size()) {
    out.kind = FiveAxisKind::kTableTable;
    setFirst(turns.front());
    out.table = turns.front().point;
    if (turns.size() == 2) {
      setSecond(turns[1]);
      out.table_offset = turns[1].point - turns[0].point;
    }
  } else if (tables == 1) {
    out.kind = FiveAxisKind::kHeadTable;
    setFirst(turns[0]);
    setSecond(turns[1]);
    out.head = turns[0].point;
    out.table = turns[1].point;
  } else {
    out.kind = FiveAxisKind::kHeadHead;
    out.head = turns[0].point;
    if (turns.size() == 2) {
      setSecond(turns[0]);
      out.head_offset = turns[1].point - turns[0].point;
    }
    setFirst(turns.back());
  }
  return out;
}

std::optional<RotaryAngles> choosePosition(const FiveAxisModel& model,
                                           const FiveAxisModel::Positions& positions, const RotaryAngles& now,
                                           const AxisTable& axes) {
  const auto limitOf = [&](int axis) { return axis < 0 ? std::optional<AxisLimit>() : axes.at(axis).limit; };
  const bool table_first = model.kind == FiveAxisKind::kHeadTable;
  std::optional<RotaryAngles> best;
  std::array<double, 5> best_key{};
  for (int i = 0; i < positions.count; ++i) {
    RotaryAngles at = positions.at[static_cast<std::size_t>(i)];
    at.first = nearestWithin(at.first, now.first, limitOf(model.first));
    at.second = nearestWithin(at.second, now.second, limitOf(model.second));
    if (std::isnan(at.first) || std::isnan(at.second)) continue;
    const double main = table_first ? at.second : at.first, other = table_first ? at.first : at.second;
    const double main_now = table_first ? now.second : now.first,
                 other_now = table_first ? now.first : now.second;
    const std::array<double, 5> key{std::abs(main - main_now), std::abs(other - other_now),
                                    fromWholeTurn(main), fromWholeTurn(other), -main};
    bool better = !best;
    for (std::size_t k = 0; best && k < key.size(); ++k) {
      if (std::abs(key[k] - best_key[k]) <= kSameDeg) continue;
      better = key[k] < best_key[k];
      break;
    }
    if (!better) continue;
    best = at;
    best_key = key;
  }
  return best;
}

}  // namespace proveout::nc
