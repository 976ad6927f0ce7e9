#include "core/tool/insert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/assert.h"
#include "core/geometry/degrees.h"
#include "core/geometry/plane.h"
#include "core/tool/insert_holder.h"

namespace proveout {

namespace {

constexpr double kLeastMm = 1e-3;
constexpr double kMostMm = 1e3;        ///< of an insert
constexpr double kMostHolderMm = 1e5;  ///< of a coordinate of the holder

/// Grooving inserts turn along with their sides as deep as this part of their width: makers give 0.7 to 0.8.
constexpr double kTurningDepth = 0.75;

bool namesCorner(int orientation) { return orientation >= 1 && orientation <= 4; }

/// Direction in which the front of a blade or the tip of a tooth faces.
Vec2 frontDirection(const Insert& insert) {
  Vec2 t = tipDirection(insert.orientation);
  if (namesCorner(insert.orientation)) t.y() = 0.0;
  return t;
}

/// The nose centre seen from the touch-off point.
Vec2 centerFromP(const Insert& insert) {
  const bool tooth = insert.shape == InsertShape::kThread;
  return -insert.nose_radius * (tooth ? frontDirection(insert) : tipDirection(insert.orientation));
}

OutlineSide line(const Vec2& from, const Vec2& to, SideUse use) { return {from, to, use}; }

/// About `center`, counter-clockwise between two unit normals.
OutlineSide arc(const Vec2& center, double radius, const Vec2& normal_from, const Vec2& normal_to) {
  return {center + radius * normal_from, center + radius * normal_to, SideUse::kCuts, true, center, radius};
}

/// A rhombus with its sharp corner rounded. `first` and `second` are unit directions away from the corner,
/// the first clockwise of the second.
ConvexOutline rhombus(const Insert& insert, const Vec2& center, const Vec2& first, const Vec2& second,
                      SideUse first_use, SideUse second_use) {
  const double half = degToRad(0.5 * insert.insert_angle_deg), r = insert.nose_radius;
  const Vec2 corner = center - r / std::sin(half) * (first + second).normalized();
  const double tangent = r / std::tan(half), length = insert.edge_length;
  PROVEOUT_ASSERT(tangent < length);  // validateInsert has seen to it
  const Vec2 a = corner + length * first, b = corner + length * second, far = a + length * second;
  return ConvexOutline({line(corner + tangent * first, a, first_use), line(a, far, SideUse::kBack),
                        line(far, b, SideUse::kBack), line(b, corner + tangent * second, second_use),
                        arc(center, r, leftOf(second), -leftOf(first))});
}

ConvexOutline cornerOutline(const Insert& insert) {
  const Vec2 t = tipDirection(insert.orientation), center = centerFromP(insert);
  const double angle = degToRad(insert.insert_angle_deg);
  if (!namesCorner(insert.orientation)) {
    const Vec2 back = -std::cos(0.5 * angle) * t, side = std::sin(0.5 * angle) * leftOf(t);
    return rhombus(insert, center, back + side, back - side, SideUse::kCuts, SideUse::kCuts);
  }
  const Vec2 away(-t.x(), 0.0), feed(0.0, t.y());
  const double lead = degToRad(insert.lead_angle_deg);
  const Vec2 leading = std::sin(lead) * away + std::cos(lead) * feed;
  const Vec2 trailing = std::sin(lead + angle) * away + std::cos(lead + angle) * feed;
  // From the feed direction to the one away from the work it is a quarter turn, left or right.
  if (t.x() * t.y() > 0.0)
    return rhombus(insert, center, leading, trailing, SideUse::kCuts, SideUse::kTrails);
  return rhombus(insert, center, trailing, leading, SideUse::kTrails, SideUse::kCuts);
}

ConvexOutline roundOutline(const Insert& insert) {
  const Vec2 center = centerFromP(insert), x = Vec2::UnitX();
  return ConvexOutline({arc(center, insert.nose_radius, x, -x), arc(center, insert.nose_radius, -x, x)});
}

/// A blade or a tooth: a front, two rounded corners, two sides and the back.
struct Blade {
  Vec2 front;           ///< where the front faces, unit
  Vec2 middle;          ///< of the front
  double half = 0.0;    ///< of the front's straight part: to the centres of the corners
  double radius = 0.0;  ///< of the corners
  double lean = 0.0;    ///< of the sides' normals: above 0 they look to the back, below to the front, radians
  double length = 0.0;  ///< from front to back
  double cuts = 0.0;    ///< of it, how far behind the front the sides cut
};

ConvexOutline bladeOutline(const Blade& blade) {
  const Vec2 f = blade.front, v = leftOf(f);
  const double c = std::cos(blade.lean), s = std::sin(blade.lean), r = blade.radius;
  const Vec2 inner = blade.middle - r * f;
  const Vec2 left = inner + blade.half * v, right = inner - blade.half * v;
  const Vec2 left_normal = c * v - s * f, right_normal = -c * v - s * f;
  const double run = (blade.length - r * (1.0 + s)) / c;  // of the sides
  PROVEOUT_ASSERT(run > 0.0);  // validateInsert has seen to it
  const Vec2 left_top = left + r * left_normal, right_top = right + r * right_normal;
  const double cuts = std::clamp((blade.cuts - r * (1.0 + s)) / c, 0.0, run);
  const Vec2 left_way = leftOf(left_normal), right_way = -leftOf(right_normal);
  const Vec2 left_edge = left_top + cuts * left_way, left_end = left_top + run * left_way;
  const Vec2 right_edge = right_top + cuts * right_way, right_end = right_top + run * right_way;
  return ConvexOutline({line(right + r * f, left + r * f, SideUse::kCuts), arc(left, r, f, left_normal),
                        line(left_top, left_edge, SideUse::kCuts), line(left_edge, left_end, SideUse::kBack),
                        line(left_end, right_end, SideUse::kBack),
                        line(right_end, right_edge, SideUse::kBack),
                        line(right_edge, right_top, SideUse::kCuts), arc(right, r, right_normal, f)});
}

ConvexOutline grooveOutline(const Insert& insert) {
  Blade blade;
  blade.front = frontDirection(insert);
  blade.middle = Vec2::Zero();
  if (namesCorner(insert.orientation))
    blade.middle.y() = -0.5 * insert.width * tipDirection(insert.orientation).y();
  blade.radius = insert.nose_radius;
  blade.half = 0.5 * insert.width - insert.nose_radius;
  blade.lean = degToRad(insert.side_relief_deg);
  blade.length = insert.edge_length;
  blade.cuts = kTurningDepth * insert.width;
  return bladeOutline(blade);
}

ConvexOutline threadOutlineOf(const Insert& insert) {
  Blade blade;
  blade.front = frontDirection(insert);
  blade.middle = Vec2::Zero();
  blade.radius = insert.nose_radius;
  blade.half = 0.5 * insert.tip_flat;
  blade.lean = -degToRad(0.5 * insert.insert_angle_deg);
  blade.length = insert.edge_length;
  blade.cuts = blade.length;
  return bladeOutline(blade);
}

/// With the touch-off point at (0, 0).
ConvexOutline outlineAtP(const Insert& insert) {
  switch (insert.shape) {
    case InsertShape::kGroove:
      return grooveOutline(insert);
    case InsertShape::kThread:
      return threadOutlineOf(insert);
    case InsertShape::kRound:
      return roundOutline(insert);
    case InsertShape::kCorner:
      break;
  }
  return cornerOutline(insert);
}

/// Collects the first thing that is wrong.
class InsertChecker {
 public:
  explicit InsertChecker(const Insert& insert) : insert_(insert) {}

  void require(bool good, const std::string& what) {
    if (!good && message_.empty()) message_ = what;
  }
  void range(double value, const char* field, double least, double most, const char* unit) {
    require(std::isfinite(value) && value >= least && value <= most,
            fmt::format("{} must be between {} and {} {}, not {}", field, least, most, unit, value));
  }
  void length(double value, const char* field) { range(value, field, kLeastMm, kMostMm, "mm"); }
  void lengthOrZero(double value, const char* field) {
    require(value == 0.0 || (std::isfinite(value) && value >= kLeastMm && value <= kMostMm),
            fmt::format("{} must be 0 or between {} and {} mm, not {}", field, kLeastMm, kMostMm, value));
  }
  void angle(double value, const char* field, double limit) {
    require(std::isfinite(value) && value > 0.0 && value < limit,
            fmt::format("{} must be above 0 and below {:.6g} degrees, not {}", field, limit, value));
  }
  void unused(double value, const char* field) {
    require(value == 0.0, fmt::format("{} has no meaning for an insert of shape {}", field,
                                      insertShapeName(insert_.shape)));
  }
  bool good() const { return message_.empty(); }
  Status status() const {
    if (!good()) return inputError(message_);
    return Done{};
  }

 private:
  const Insert& insert_;
  std::string message_;
};

void checkCorner(const Insert& insert, InsertChecker& check) {
  check.lengthOrZero(insert.nose_radius, "nose_radius");
  check.length(insert.edge_length, "edge_length");
  if (namesCorner(insert.orientation)) {
    check.angle(insert.lead_angle_deg, "lead_angle", 180.0);
    if (check.good()) check.angle(insert.insert_angle_deg, "insert_angle", 180.0 - insert.lead_angle_deg);
  } else {
    check.require(insert.lead_angle_deg == 0.0,
                  "lead_angle has no meaning for orientations 5 to 8, where the corner is symmetric");
    check.angle(insert.insert_angle_deg, "insert_angle", 180.0);
  }
  check.unused(insert.width, "width");
  check.unused(insert.side_relief_deg, "side_relief");
  check.unused(insert.tip_flat, "tip_flat");
  if (!check.good()) return;
  const double tangent = insert.nose_radius / std::tan(degToRad(0.5 * insert.insert_angle_deg));
  check.require(
      insert.edge_length >= tangent + kLeastMm,
      fmt::format("edge_length must be above {:.6g} mm: the nose_radius takes that of it", tangent));
}

void checkGroove(const Insert& insert, InsertChecker& check) {
  check.lengthOrZero(insert.nose_radius, "nose_radius");
  check.length(insert.width, "width");
  check.length(insert.edge_length, "edge_length");
  check.range(insert.side_relief_deg, "side_relief", 0.0, 45.0, "degrees");
  check.unused(insert.insert_angle_deg, "insert_angle");
  check.unused(insert.lead_angle_deg, "lead_angle");
  check.unused(insert.tip_flat, "tip_flat");
  if (!check.good()) return;
  const double relief = degToRad(insert.side_relief_deg), r = insert.nose_radius;
  check.require(2.0 * r <= insert.width, "nose_radius is larger than half the width");
  const double tops = r * (1.0 + std::sin(relief));
  check.require(insert.edge_length >= tops + kLeastMm,
                fmt::format("edge_length must be above {:.6g} mm: the corners take that of it", tops));
  const double back = insert.width - 2.0 * r * (1.0 - std::cos(relief)) -
                      2.0 * (insert.edge_length - tops) * std::tan(relief);
  check.require(back >= kLeastMm, "side_relief leaves nothing of the width at the back of the blade");
}

void checkThread(const Insert& insert, InsertChecker& check) {
  check.require(frontDirection(insert).x() != 0.0,
                "orientation of a thread insert must be 1 to 4, 6 or 8: teeth point along X");
  check.angle(insert.insert_angle_deg, "insert_angle", 180.0);
  check.lengthOrZero(insert.nose_radius, "nose_radius");
  check.lengthOrZero(insert.tip_flat, "tip_flat");
  check.length(insert.edge_length, "edge_length");
  check.unused(insert.lead_angle_deg, "lead_angle");
  check.unused(insert.width, "width");
  check.unused(insert.side_relief_deg, "side_relief");
  check.require(insert.nose_radius == 0.0 || insert.tip_flat == 0.0,
                "a tip has nose_radius or tip_flat, not both");
  if (!check.good()) return;
  const double half = degToRad(0.5 * insert.insert_angle_deg);
  const double tip = insert.nose_radius * (1.0 - std::sin(half));
  check.require(insert.edge_length >= tip + kLeastMm,
                fmt::format("edge_length must be above {:.6g} mm: the rounded tip takes that of it", tip));
  check.require(insert.edge_length * std::tan(half) <= kMostMm,
                fmt::format("insert_angle and edge_length make a tooth wider than {} mm", 2.0 * kMostMm));
}

void checkRound(const Insert& insert, InsertChecker& check) {
  check.length(insert.nose_radius, "nose_radius");
  check.unused(insert.insert_angle_deg, "insert_angle");
  check.unused(insert.lead_angle_deg, "lead_angle");
  check.unused(insert.edge_length, "edge_length");
  check.unused(insert.width, "width");
  check.unused(insert.side_relief_deg, "side_relief");
  check.unused(insert.tip_flat, "tip_flat");
}

}  // namespace

std::string_view insertShapeName(InsertShape shape) {
  switch (shape) {
    case InsertShape::kGroove:
      return "groove";
    case InsertShape::kThread:
      return "thread";
    case InsertShape::kRound:
      return "round";
    case InsertShape::kCorner:
      break;
  }
  return "corner";
}

Status validateInsert(const Insert& insert) {
  InsertChecker check(insert);
  check.require(insert.orientation >= 1 && insert.orientation <= 8,
                fmt::format("an insert points to one of the directions 1 to 8, not {}", insert.orientation));
  if (!check.good()) return check.status();
  switch (insert.shape) {
    case InsertShape::kCorner:
      checkCorner(insert, check);
      break;
    case InsertShape::kGroove:
      checkGroove(insert, check);
      break;
    case InsertShape::kThread:
      checkThread(insert, check);
      break;
    case InsertShape::kRound:
      checkRound(insert, check);
      break;
  }
  for (const Vec2& p : insert.holder) {
    check.range(p.x(), "an x of the holder", -kMostHolderMm, kMostHolderMm, "mm");
    check.range(p.y(), "a z of the holder", -kMostHolderMm, kMostHolderMm, "mm");
  }
  if (!check.good() || insert.holder.empty()) return check.status();
  const auto pieces = convexPieces(insert.holder);
  if (!pieces) return inputError("holder: " + pieces.error().message);
  return Done{};
}

ConvexOutline insertOutline(const Insert& insert) {
  const ConvexOutline outline = outlineAtP(insert);
  return insert.at_center ? shifted(outline, -centerFromP(insert)) : outline;
}

Vec2 noseCenter(const Insert& insert) { return insert.at_center ? Vec2(Vec2::Zero()) : centerFromP(insert); }

std::optional<ConvexOutline> endOfEdge(const Insert& insert) {
  if (insert.shape != InsertShape::kGroove && insert.shape != InsertShape::kThread) return std::nullopt;
  constexpr double kStripMm = 0.05;
  const ConvexOutline outline = insertOutline(insert);
  const Vec2 front = frontDirection(insert);
  const int along = front.x() != 0.0 ? 0 : 1, across = 1 - along;
  Vec2 low = outline.min(), high = outline.max();
  low[across] -= kStripMm;
  high[across] += kStripMm;
  if (front[along] < 0.0) {
    low[along] = high[along];
    high[along] += kStripMm;
  } else {
    high[along] = low[along];
    low[along] -= kStripMm;
  }
  const Vec2 a(high.x(), low.y()), b(low.x(), high.y());
  return ConvexOutline({line(low, a, SideUse::kBack), line(a, high, SideUse::kBack),
                        line(high, b, SideUse::kBack), line(b, low, SideUse::kBack)});
}

std::vector<ConvexOutline> holderPieces(const Insert& insert) {
  std::vector<ConvexOutline> outlines;
  if (insert.holder.empty()) return outlines;
  const auto pieces = convexPieces(insert.holder);
  PROVEOUT_ASSERT(pieces.ok());  // validateInsert has seen them
  for (const std::vector<Vec2>& piece : *pieces) {
    std::vector<OutlineSide> sides;
    for (std::size_t k = 0; k < piece.size(); ++k)
      sides.push_back(line(piece[k], piece[(k + 1) % piece.size()], SideUse::kBack));
    outlines.emplace_back(sides);
  }
  return outlines;
}

}  // namespace proveout
