// G68.1: turns and shifts of space; G68.2: tilted planes in five forms (manual 25.3, 25.6 to 25.10).
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/five_axis.h"
#include "core/nc/iso/frames/transforms.h"

namespace proveout::nc {

namespace {

/// Vectors shorter than this (mm) or nearer to parallel (sine) define no plane. The manual gives no figure: a
/// thousandth of a degree.
constexpr double kShortestMm = 1e-6, kLeastSine = 1.7e-5;

Mat3 turn(int axis, double degrees) {
  Vec3 angles = Vec3::Zero();
  angles[axis] = degrees;
  return basicRotation(angles);
}

/// Value of a word, 0 without it; lengths in mm.
double numberAt(const IsoContext& c, Address a) {
  const Word* w = c.word(a);
  return w == nullptr ? 0.0 : w->value;
}

/// X, Y, Z of the block: always absolute, rectangular; 0 without a word.
Vec3 pointOf(const IsoContext& c, const BlockPlan& plan) {
  Vec3 out = Vec3::Zero();
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word) && word.axis < kMainAxes) out[word.axis] = lengthOf(plan, w);
  }
  return out;
}

Vec3 vectorOf(const IsoContext& c) { return {numberAt(c, 'I'), numberAt(c, 'J'), numberAt(c, 'K')}; }

/// A frame by two directions: x along the first; z across it, on the side of `plane` or at right angles to
/// both.
std::optional<Mat3> frameBy(const Vec3& x, const Vec3& z) {
  if (x.norm() < kShortestMm || z.norm() < kShortestMm * kShortestMm) return std::nullopt;
  Mat3 out;
  out.col(0) = x.normalized();
  out.col(2) = (z - out.col(0) * out.col(0).dot(z)).normalized();
  out.col(1) = out.col(2).cross(out.col(0));
  return out;
}

bool areParallel(const Vec3& a, const Vec3& b) {
  return a.cross(b).norm() <= kLeastSine * a.norm() * b.norm();
}

void takeTilt(const IsoContext& c, BlockPlan& plan, const FrameStep& tilt) {
  plan.next.five.tilt = tilt;
  plan.frames_changed = plan.flush = true;
  takeNewChain(c, plan);
}

bool refuseInComp(IsoContext& c, const char* name) {
  return !c.state.compOn() ||
         c.fail(
             "tilt-in-comp",
             fmt::format(
                 "{} cannot change the plane while cutter compensation (G41, G42) is on: program G40 first",
                 name));
}

bool refuseAxes(IsoContext& c, const BlockPlan& plan, const char* name) {
  for (const Word& w : c.block.words) {
    AxisWord word;
    if (axisWord(plan, w, word) && (word.axis >= kMainAxes || word.own_step))
      return c.alarm(SharedAlarm::kIllegalAddress, w, fmt::format("{} takes X, Y and Z, absolute", name));
  }
  return true;
}

/// Euler angles, or roll, pitch and yaw about fixed axes in the order that Q names.
std::optional<Mat3> turnOfForm(IsoContext& c, int form) {
  const double i = numberAt(c, 'I'), j = numberAt(c, 'J'), k = numberAt(c, 'K');
  if (form == 0) return Mat3(turn(2, i) * turn(0, j) * turn(2, k));
  const std::array<Mat3, 3> about{turn(0, i), turn(1, j), turn(2, k)};
  const Word* q = c.word('Q');
  const int order = q == nullptr ? 0 : static_cast<int>(q->value);
  for (const int known : {123, 132, 213, 231, 312, 321}) {
    if (q == nullptr || q->value != known) continue;
    const int first = order / 100 - 1, second = order / 10 % 10 - 1, third = order % 10 - 1;
    return Mat3(about[static_cast<std::size_t>(third)] * about[static_cast<std::size_t>(second)] *
                about[static_cast<std::size_t>(first)]);
  }
  return std::nullopt;
}

/// P4: X turned about Y, Y turned about X; K turns about the new Z.
std::optional<Mat3> turnByProjections(const IsoContext& c) {
  const Vec3 v1 = turn(1, numberAt(c, 'I')).col(0), v2 = turn(0, numberAt(c, 'J')).col(1);
  if (areParallel(v1, v2)) return std::nullopt;
  Mat3 out;
  out.col(2) = v1.cross(v2).normalized();
  out.col(0) = v1;
  out.col(1) = out.col(2).cross(out.col(0));
  return Mat3(out * turn(2, numberAt(c, 'K')));
}

/// The frame of a whole definition by points or vectors; none where these define no plane.
std::optional<FrameStep> frameOf(const TiltInput& input) {
  const auto& d = input.data;
  const Vec3 x = input.form == 2 ? Vec3(d[1] - d[0]) : d[0];
  const Vec3 other = input.form == 2 ? Vec3(d[2] - d[0]) : d[1];
  if (x.norm() < kShortestMm || other.norm() < kShortestMm || areParallel(x, other)) return std::nullopt;
  // Points: the second vector lies in X'Y'; vectors: in Z'X'.
  const std::optional<Mat3> turned = frameBy(x, input.form == 2 ? Vec3(x.cross(other)) : other);
  if (!turned) return std::nullopt;
  return FrameStep{*turned, input.form == 2 ? d[0] : input.origin};
}

/// Q0 of P2: a shift in the new system and a turn about its Z.
bool planTiltCorrection(IsoContext& c, BlockPlan& plan, const TiltInput& input) {
  if (!input.complete() || input.form != 2)
    return c.alarm(SharedAlarm::kSyntax, "", "G68.2 P2 Q0 follows the three points Q1, Q2, Q3");
  FrameStep tilt = *frameOf(input);
  tilt.offset += tilt.linear * pointOf(c, plan);
  tilt.linear = tilt.linear * turn(2, numberAt(c, 'R'));
  takeTilt(c, plan, tilt);
  plan.payload.emplace<TiltInput>();
  return true;
}

/// One of the blocks of P2 or P3.
bool planTiltPart(IsoContext& c, BlockPlan& plan, int form) {
  const Word* q = c.word('Q');
  const int parts = form == 2 ? 3 : 2;
  const bool known = q != nullptr && q->value == std::floor(q->value) && q->value >= (form == 2 ? 0 : 1) &&
                     q->value <= parts;
  if (!known)
    return c.alarm(SharedAlarm::kTorque, "",
                   fmt::format("G68.2 P{} takes Q{} to Q{}", form, form == 2 ? 0 : 1, parts));
  const int part = static_cast<int>(q->value);
  TiltInput input = c.registers.tilt_input;
  if (part == 0) return planTiltCorrection(c, plan, input);
  if (input.form != form || input.complete()) {
    input = TiltInput();
    input.form = static_cast<std::int8_t>(form);
  }
  const auto bit = static_cast<std::uint8_t>(1 << (part - 1));
  if ((input.given & bit) != 0)
    return c.alarm(SharedAlarm::kSyntax, "", fmt::format("G68.2 P{} Q{} comes twice", form, part));
  input.given |= bit;
  input.data[static_cast<std::size_t>(part - 1)] = form == 2 ? pointOf(c, plan) : vectorOf(c);
  if (form == 3 && part == 1) input.origin = pointOf(c, plan);
  if (input.complete()) {
    const std::optional<FrameStep> tilt = frameOf(input);
    if (!tilt) return c.alarm(SharedAlarm::kPlane, "", "the points or vectors of G68.2 define no plane");
    takeTilt(c, plan, *tilt);
  }
  plan.payload = input;
  return true;
}

}  // namespace

bool planTiltState(IsoContext& c, BlockPlan& plan) {
  const GCode* code = plan.by_group[kGroupTilt];
  const TiltInput& input = c.registers.tilt_input;
  const bool goes_on = code != nullptr && code->code10 == gcode::kTiltedPlane;
  if (input.form != 0 && !goes_on && !input.complete())
    return c.alarm(SharedAlarm::kSyntax, "",
                   fmt::format("the definition by G68.2 P{} is not whole: a Q is missing", input.form));
  if (code == nullptr || code->code10 != gcode::kTiltOff) return true;
  if (plan.next.five.any() && !refuseInComp(c, "G69.1")) return false;
  plan.next.five.tilt = FrameStep();
  plan.next.five.rotations = 0;
  plan.next.five.tilted = plan.next.five.on_table = false;
  plan.frames_changed = plan.flush = true;
  return true;
}

bool planSpaceRotation(IsoContext& c, BlockPlan& plan) {
  if (!refuseInComp(c, "G68.1") || !refuseAxes(c, plan, "G68.1")) return false;
  FiveAxisState& five = plan.next.five;
  if (five.tilted) return c.fail("tilt", "G68.1 while G68.2 is in force: program G69.1 first");
  if (five.rotations >= 2)
    return c.fail("tilt", "no more than two G68.1 may be in force: program G69.1 first");
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    const double value = numberAt(c, "IJK"[k]);
    if (value == 0.0) continue;
    if (value != 1.0 || axis >= 0)
      return c.alarm(SharedAlarm::kOutOfRange, std::string(1, "IJK"[k]),
                     "one of I, J and K is 1, the others are 0");
    axis = k;
  }
  if (axis < 0)
    return c.alarm(SharedAlarm::kMissingData, "I", "one of I, J and K is 1: the axis of the turn");
  if (c.word('R') == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "the angle of the turn");
  const FrameStep own{turn(axis, numberAt(c, 'R')), pointOf(c, plan)};
  const FrameStep outer = five.tilt;
  ++five.rotations;
  takeTilt(c, plan, {outer.linear * own.linear, outer.linear * own.offset + outer.offset});
  return true;
}

bool planTiltedPlane(IsoContext& c, BlockPlan& plan) {
  if (!refuseInComp(c, "G68.2") || !refuseAxes(c, plan, "G68.2")) return false;
  std::int64_t form = 0;
  if (const Word* p = c.word('P'); p != nullptr && !integerWord(c, *p, 0, 4, form)) return false;
  FiveAxisState& five = plan.next.five;
  if (five.rotations > 0) return c.fail("tilt", "G68.2 while G68.1 is in force: program G69.1 first");
  const TiltInput& input = c.registers.tilt_input;
  if (input.form != 0 && input.form != form && !input.complete())
    return c.alarm(SharedAlarm::kSyntax, "",
                   fmt::format("the definition by G68.2 P{} is not whole", input.form));
  five.tilted = true;
  if (form == 2 || form == 3) return planTiltPart(c, plan, static_cast<int>(form));
  const std::optional<Mat3> turned = form == 4 ? turnByProjections(c) : turnOfForm(c, static_cast<int>(form));
  if (!turned && form == 1)
    return c.alarm(SharedAlarm::kTorque, "", "G68.2 P1 takes Q123, Q132, Q213, Q231, Q312 or Q321");
  if (!turned) return c.alarm(SharedAlarm::kPlane, "", "the two vectors of G68.2 P4 have one direction");
  takeTilt(c, plan, {*turned, pointOf(c, plan)});
  return true;
}

}  // namespace proveout::nc
