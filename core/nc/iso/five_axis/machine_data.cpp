#include "core/nc/iso/five_axis/machine_data.h"

#include <fmt/core.h>

#include <cmath>

#include "core/geometry/degrees.h"

namespace proveout::nc {

namespace {

/// Values nearer than this are one, mm and parts of 1.
constexpr double kSame = 1e-6;

class MachineData {
 public:
  explicit MachineData(IsoContext& c) : c_(c), model_(c.five_axes) {}

  bool run() {
    takeKind();
    if (!takeAxis(FiveAxisParam::kFirstAxis, model_.first) ||
        !takeAxis(FiveAxisParam::kSecondAxis, model_.second))
      return false;
    takeTool();
    takeTurn(
        {FiveAxisParam::kFirstDirection, FiveAxisParam::kFirstInclination, FiveAxisParam::kFirstReversed},
        model_.first_direction, model_.first_sign);
    takeTurn(
        {FiveAxisParam::kSecondDirection, FiveAxisParam::kSecondInclination, FiveAxisParam::kSecondReversed},
        model_.second_direction, model_.second_sign);
    takePoint(FiveAxisParam::kTableX, model_.table);
    takePoint(FiveAxisParam::kTableOffsetX, model_.table_offset);
    takePoint(FiveAxisParam::kHeadX, model_.head);
    takePoint(FiveAxisParam::kHeadOffsetX, model_.head_offset);
    return checkAxes();
  }

 private:
  struct TurnParams {
    FiveAxisParam direction, inclination, reversed;
  };

  bool given(FiveAxisParam p) const { return c_.parameters.given(p); }
  void tell(FiveAxisParam p, const std::string& is, const std::string& machine) {
    c_.warn(
        "machine-data",
        fmt::format(
            "{} = {}, but the machine has {}: the control computes with its parameter, and the machine moves "
            "as it is built",
            c_.parameters.name(p), is, machine));
  }

  void takeKind() {
    if (!given(FiveAxisParam::kMechanicalType)) return;
    const auto kind =
        static_cast<FiveAxisKind>(static_cast<int>(c_.parameters[FiveAxisParam::kMechanicalType]));
    if (kind != model_.kind)
      tell(FiveAxisParam::kMechanicalType, fmt::format("{}", static_cast<int>(kind)),
           fmt::format("{}", static_cast<int>(model_.kind)));
    model_.kind = kind;
  }

  bool takeAxis(FiveAxisParam p, int& axis) {
    if (!given(p)) return true;
    const int number = static_cast<int>(c_.parameters[p]), own = axis < 0 ? 0 : c_.axes.at(axis).number;
    if (number == own) return true;
    const int found = number == 0 ? -1 : c_.axes.byNumber(number);
    if (number != 0 && (found < 0 || !c_.axes.at(found).rotary())) {
      return c_.fail("machine-data", fmt::format("{} = {}: there is no rotary axis of this number",
                                                 c_.parameters.name(p), number));
    }
    tell(p, fmt::format("{}", number), fmt::format("{}", own));
    axis = found;
    return true;
  }

  void takeTool() {
    if (!given(FiveAxisParam::kToolAxis)) return;
    const int axis = static_cast<int>(c_.parameters[FiveAxisParam::kToolAxis]) - 1;
    const Vec3 tool = Vec3::Unit(axis);
    if ((tool - model_.tool).norm() > kSame)
      tell(FiveAxisParam::kToolAxis, fmt::format("{}", axis + 1),
           fmt::format("its tool along {:.4g}, {:.4g}, {:.4g}", model_.tool.x(), model_.tool.y(),
                       model_.tool.z()));
    model_.tool = tool;
  }

  /// The value of N3205 for a direction: along an axis, or in the plane of two; 0: neither.
  static int codeOf(const Vec3& direction) {
    int code = 0;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(direction[k]) > 1.0 - kSame) return k + 1;
      if (std::abs(direction[k]) < kSame) code = 4 + (k + 1) % 3;  // square to Z: in the plane of X and Y
    }
    return code;
  }

  /// Direction and sense together: one turned round with the other is the same axis.
  void takeTurn(const TurnParams& p, Vec3& direction, double& sign) {
    const Vec3 before = sign * direction;
    const int code = given(p.direction) ? static_cast<int>(c_.parameters[p.direction]) : codeOf(direction);
    const bool inclined = given(p.inclination) && code > 3;
    if ((given(p.direction) || inclined) && code > 0) {
      const SinCos turn = sinCosDegrees(c_.parameters[p.inclination]);
      direction = code <= 3 ? Vec3(Vec3::Unit(code - 1))
                            : Vec3(turn.cos * Vec3::Unit(code - 4) + turn.sin * Vec3::Unit((code - 3) % 3));
    }
    if (given(p.reversed)) sign = c_.parameters.flag(p.reversed) ? -1.0 : 1.0;
    const Vec3 after = sign * direction;
    if ((after - before).norm() <= kSame) return;
    const bool opposed = (after + before).norm() <= kSame && given(p.reversed);
    const double value = inclined ? c_.parameters[p.inclination] : code;
    tell(opposed    ? p.reversed
         : inclined ? p.inclination
                    : p.direction,
         opposed ? fmt::format("{}", sign < 0.0 ? 1 : 0)
                 : fmt::format("{:g} (turns about {:.4g}, {:.4g}, {:.4g})", value, after.x(), after.y(),
                               after.z()),
         opposed ? fmt::format("{}", sign < 0.0 ? 0 : 1)
                 : fmt::format("an axis that turns about {:.4g}, {:.4g}, {:.4g}", before.x(), before.y(),
                               before.z()));
  }

  void takePoint(FiveAxisParam first, Vec3& point) {
    for (int k = 0; k < 3; ++k) {
      const auto p = static_cast<FiveAxisParam>(static_cast<int>(first) + k);
      if (!given(p)) continue;
      const double value = c_.parameters[p];
      if (std::abs(value - point[k]) > kSame)
        tell(p, fmt::format("{:g}", value), fmt::format("{:g}", point[k]));
      point[k] = value;
    }
  }

  bool checkAxes() {
    if (model_.second < 0 || model_.first < 0) return true;
    return std::abs(model_.first_direction.dot(model_.second_direction)) < 1.0 - kSame ||
           c_.fail("machine-data",
                   "the two rotary axes of N3204 and N3208 are parallel: five-axis functions need two "
                   "directions");
  }

  IsoContext& c_;
  FiveAxisModel& model_;
};

}  // namespace

bool takeMachineData(IsoContext& c) {
  // Without rotary axes and parameters there is nothing to take.
  if (c.five_axes.kind == FiveAxisKind::kNone && !c.parameters.given(FiveAxisParam::kMechanicalType))
    return true;
  return MachineData(c).run();
}

}  // namespace proveout::nc
