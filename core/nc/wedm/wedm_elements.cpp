#include "core/nc/wedm/wedm_elements.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

namespace {

constexpr double kMostCoordinate = 999.999, kMostInch = 99.9999;  ///< mm, inch
constexpr double kMostCenter = 99999.999;                         ///< mm
constexpr double kOnePoint = 1e-9;                                ///< mm
constexpr double kFarthest =
    2.0 * 1000.0 * 1.41421356237309505;  ///< mm, between corners of the field of coordinates

const WedmWord* wordIn(const std::vector<WedmWord>& words, char address) {
  for (const WedmWord& word : words) {
    if (word.address == address && !word.argument) return &word;
  }
  return nullptr;
}

std::optional<double> coordinateOf(WedmContext& c, const WedmState& s, const WedmWord& word) {
  const auto value = wedmLength(c, s, word.terms, word.columns);
  const bool center = word.address == 'I' || word.address == 'J';
  const double most = center ? kMostCenter : s.units == 20 ? kMostInch * kInchMm : kMostCoordinate;
  if (!value || std::abs(*value) <= most + kOnePoint) return value;
  c.report.fail("wedm-1.4-ranges", fmt::format("{} is beyond {} mm", word.address, most), word.columns);
  return std::nullopt;
}

OriginKind originKindOf(char address) {
  switch (address) {
    case 'X':
      return OriginKind::kX;
    case 'Y':
      return OriginKind::kY;
    case 'U':
      return OriginKind::kU;
    case 'V':
      return OriginKind::kV;
    case 'I':
      return OriginKind::kI;
    default:
      return OriginKind::kJ;
  }
}

/// The centre moves to where both ends are equally far from it.
Vec2 balanced(const Vec2& center, const Vec2& from, const Vec2& to) {
  const Vec2 chord = to - from;
  if (chord.norm() < kOnePoint) return center;
  const Vec2 t = chord.normalized();
  return center - (center - 0.5 * (from + to)).dot(t) * t;
}

std::optional<ContourElement> arcOf(WedmContext& c, const WedmState& s, const WordShape& shape,
                                    const Vec2& to) {
  const WedmWord *const i = wordIn(*shape.words, 'I'), *const j = wordIn(*shape.words, 'J');
  if (i == nullptr && j == nullptr) {
    c.report.fail("wedm-5.3-IJ", "an arc needs its centre: I and J from the start of the arc");
    return std::nullopt;
  }
  Vec2 arm = Vec2::Zero();
  for (const WedmWord* word : {i, j}) {
    if (word == nullptr) continue;
    const auto value = coordinateOf(c, s, *word);
    if (!value) return std::nullopt;
    arm[word == i ? 0 : 1] = *value;
    c.recorder.word(originKindOf(word->address), word->columns, *value, 0, {true, s.units == 20});
  }
  ContourElement arc = lineElement(shape.from, to);
  arc.arc = true;
  arc.center = shape.from + s.turned(arm);
  const double radius = arm.norm(), at_end = (to - arc.center).norm();
  if (radius < kOnePoint || std::abs(at_end - radius) > c.parameters.arc_tolerance) {
    c.report.fail(
        "wedm-5.3-radius",
        fmt::format("the end is not on the circle: the radius is {:.4f} mm at the start and {:.4f} at the "
                    "end, allowed is a difference of {} (ARC_TOL)",
                    radius, at_end, c.parameters.arc_tolerance));
    return std::nullopt;
  }
  const bool counter_clockwise = (shape.motion == 3) != s.reflected();
  if ((to - shape.from).norm() < kOnePoint) {
    arc.sweep = counter_clockwise ? 2.0 * kPi : -2.0 * kPi;
    return arc;
  }
  arc.center = balanced(arc.center, shape.from, to);
  const Vec2 a = shape.from - arc.center, b = to - arc.center;
  double turn = std::atan2(cross2(a, b), a.dot(b));
  if (counter_clockwise ? turn <= 0.0 : turn >= 0.0) turn += counter_clockwise ? 2.0 * kPi : -2.0 * kPi;
  arc.sweep = turn;
  return arc;
}

/// False: the arc leads farther from its start than coordinates reach, reported.
bool withinReach(WedmContext& c, const ContourElement& arc) {
  const double turn = std::min(std::abs(arc.sweep), kPi), radius = (arc.from - arc.center).norm();
  const double away = 2.0 * radius * std::sin(0.5 * turn);
  return away <= kFarthest ||
         c.report.fail(
             "wedm-5.3-far",
             fmt::format("the arc leads {:.1f} m away from its start: no machine gets there. Its radius is "
                         "{:.3f} mm; I and J count from the start to the centre",
                         1e-3 * away, radius));
}

}  // namespace

bool hasWordOf(const std::vector<WedmWord>& words, std::string_view addresses) {
  return std::any_of(words.begin(), words.end(), [&](const WedmWord& word) {
    return !word.argument && addresses.find(word.address) != std::string_view::npos;
  });
}

std::optional<Vec2> targetOf(WedmContext& c, const WedmState& s, const std::vector<WedmWord>& words,
                             char first, const Vec2& from, const Vec2& origin) {
  Vec2 target = from;
  for (int k = 0; k < 2; ++k) {
    const WedmWord* const word = wordIn(words, static_cast<char>(first + k));
    if (word == nullptr) continue;
    const auto value = coordinateOf(c, s, *word);
    if (!value) return std::nullopt;
    const bool mirrored = (k == 0 ? s.mirror_x : s.mirror_y) != 0;
    const int axis = s.swap != 0 ? 1 - k : k;
    target[axis] = (s.distance == 91 ? from : origin)[axis] + (mirrored ? -*value : *value);
    c.recorder.word(originKindOf(word->address), word->columns, *value, 0, {s.distance == 91, s.units == 20});
  }
  return target;
}

std::optional<ContourElement> elementOf(WedmContext& c, const WedmState& s, const WordShape& shape) {
  const auto to = targetOf(c, s, *shape.words, 'X', shape.from, s.origin[s.systemIndex()]);
  if (!to) return std::nullopt;
  if (shape.motion >= 2) {
    const auto arc = arcOf(c, s, shape, *to);
    return arc && withinReach(c, *arc) ? arc : std::nullopt;
  }
  if (hasWordOf(*shape.words, "IJ")) {
    c.report.fail("wedm-5.3-IJ", "I and J belong to G02 and G03");
    return std::nullopt;
  }
  return lineElement(shape.from, *to);
}

}  // namespace proveout::nc
