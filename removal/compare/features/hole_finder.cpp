// Holes: round hollow faces about one axis, one behind the other.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>

#include "removal/compare/features/feature_parts.h"

namespace proveout {
namespace hole_detail {

/// The faces of a hole along its axis.
struct Stack {
  Vec3 origin, into;                 ///< into the material, from the entry to the bottom
  std::vector<std::uint32_t> walls;  ///< cylinders and cones, from the entry on
  std::vector<std::uint32_t> ends;   ///< shoulders and floors across the axis, round bottoms
  std::uint32_t entry = kNoFace;     ///< the plane that it starts from; kNoFace: it is none
  std::uint32_t exit = kNoFace;      ///< the plane where a through hole comes out
  bool through = false;
};

bool isHole(const CadFace& face) { return face.isWholeCylinder() && face.hollow; }
bool isWall(const CadFace& face) {
  return isHole(face) || (face.kind == SurfaceKind::kCone && face.hollow && face.turn_rad > 1.1 * kPi);
}
bool isRoundEnd(const CadFace& face) {
  return (face.kind == SurfaceKind::kSphere || face.kind == SurfaceKind::kTorus) && face.hollow;
}

class HoleFinder {
 public:
  explicit HoleFinder(FeatureSearch& search) : s_(search) {}

  void run() {
    for (std::uint32_t f = 0; f < s_.network.size(); ++f) {
      if (!isHole(s_.face(f)) || s_.taken[f]) continue;
      Stack stack = gather(f);
      direct(stack);
      tell(stack);
    }
  }

 private:
  /// All walls about the axis of `first` that are joined by themselves, a shoulder or a round.
  Stack gather(std::uint32_t first) const {
    Stack out;
    out.origin = s_.face(first).origin;
    out.into = s_.face(first).axis;
    out.walls = {first};
    const auto has = [](const std::vector<std::uint32_t>& list, std::uint32_t f) {
      return std::find(list.begin(), list.end(), f) != list.end();
    };
    std::deque<std::uint32_t> open = {first};
    while (!open.empty()) {
      const std::uint32_t f = open.front();
      open.pop_front();
      for (const FaceBorder& border : s_.network.borders(f)) {
        const std::uint32_t g = border.other;
        const CadFace& face = s_.face(g);
        if (s_.taken[g] || has(out.walls, g) || has(out.ends, g)) continue;
        if (isWall(face) && s_.coaxial(face, out.origin, out.into)) {
          out.walls.push_back(g);
          open.push_back(g);
        } else if (isRoundEnd(face) && s_.coaxial(face, out.origin, out.into)) {
          out.ends.push_back(g);
          open.push_back(g);
        } else if (s_.across(face, out.into) && isEnd(f, border)) {
          out.ends.push_back(g);
          open.push_back(g);
        }
      }
    }
    return out;
  }

  /// Whether a plane across the axis is inside of the hole: at the wide end of a step, or its floor. A plane
  /// that a wall comes out of is where the hole starts, unless a wider wall about the same axis stands around
  /// it.
  bool isEnd(std::uint32_t wall, const FaceBorder& to_plane) const {
    if (to_plane.isConcave()) return true;
    const CadFace& own = s_.face(wall);
    for (const FaceBorder& border : s_.network.borders(to_plane.other)) {
      const CadFace& other = s_.face(border.other);
      if (border.isConcave() && isWall(other) && s_.coaxial(other, own.origin, own.axis)) return true;
    }
    return false;
  }

  double levelOf(const Stack& stack, std::uint32_t f) const {
    return s_.network.along(f, stack.origin, stack.into).middle();
  }
  void sortAlong(Stack& stack, std::vector<std::uint32_t>& faces) const {
    std::stable_sort(faces.begin(), faces.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return levelOf(stack, a) < levelOf(stack, b); });
  }

  /// Whether anything closes the hole at its far or near end: a floor, a round bottom, the tip of a cone.
  bool closedAt(const Stack& stack, bool far) const {
    const double sign = far ? 1.0 : -1.0;
    const auto reach = [&](std::uint32_t f) {
      const auto range = s_.network.along(f, stack.origin, stack.into);
      return far ? range.high : -range.low;
    };
    const std::uint32_t last = far ? stack.walls.back() : stack.walls.front();
    const CadFace& wall = s_.face(last);
    if (wall.kind == SurfaceKind::kCone && sign * wall.axis.dot(stack.into) < 0.0 && endsInTip(last))
      return true;
    for (const std::uint32_t f : stack.ends) {
      const CadFace& end = s_.face(f);
      if (reach(f) + s_.accuracy.near_mm < reach(last)) continue;
      if (end.kind != SurfaceKind::kPlane || end.axis.dot(stack.into) * sign < 0.0) return true;
    }
    return false;
  }

  bool endsInTip(std::uint32_t cone) const {
    const CadFace& face = s_.face(cone);
    const auto range = s_.network.along(cone, face.origin, face.axis);
    const double narrow = face.radius + range.low * std::tan(face.half_angle_rad);
    const double wide = face.radius + range.high * std::tan(face.half_angle_rad);
    return std::abs(narrow) < 1e-3 * wide + s_.accuracy.near_mm;
  }

  double widest(std::uint32_t f) const {
    const CadFace& face = s_.face(f);
    if (face.kind == SurfaceKind::kCylinder) return face.radius;
    return face.radius + s_.network.along(f, face.origin, face.axis).high * std::tan(face.half_angle_rad);
  }

  /// Turns the stack so that it starts at the entry: the end that is open, of two the wider one, else the
  /// upper.
  void direct(Stack& stack) const {
    sortAlong(stack, stack.walls);
    const bool far = closedAt(stack, true), near = closedAt(stack, false);
    stack.through = !far && !near;
    const double wide_near = widest(stack.walls.front()), wide_far = widest(stack.walls.back());
    bool turn = near && !far;
    if (stack.through)
      turn = wide_far > wide_near + s_.accuracy.near_mm ||
             (std::abs(wide_far - wide_near) <= s_.accuracy.near_mm && upwards(stack.into));
    if (turn) {
      stack.into = -stack.into;
      std::reverse(stack.walls.begin(), stack.walls.end());
    }
    stack.entry = planeBeside(stack, stack.walls.front(), -1.0);
    if (stack.through) stack.exit = planeBeside(stack, stack.walls.back(), 1.0);
  }
  static bool upwards(const Vec3& v) {
    for (const int k : {2, 1, 0})
      if (std::abs(v[k]) > 1e-6) return v[k] > 0.0;
    return false;
  }

  /// The plane that the end wall comes out of.
  std::uint32_t planeBeside(const Stack& stack, std::uint32_t wall, double sign) const {
    return outerPlane(s_, wall, sign * stack.into);
  }

  /// What a wall ends at, away from the entry.
  std::uint32_t endOf(const Stack& stack, std::uint32_t wall) const {
    const double level = s_.network.along(wall, stack.origin, stack.into).high;
    std::uint32_t best = kNoFace;
    double nearest = s_.accuracy.near_mm + 1e-3;
    const auto consider = [&](std::uint32_t f, double at) {
      if (std::abs(at - level) > nearest || s_.network.border(wall, f) == nullptr) return;
      nearest = std::abs(at - level);
      best = f;
    };
    for (const std::uint32_t f : stack.ends) consider(f, s_.network.along(f, stack.origin, stack.into).low);
    for (const std::uint32_t f : stack.walls)
      if (s_.face(f).kind == SurfaceKind::kCone && f != wall)
        consider(f, s_.network.along(f, stack.origin, stack.into).low);
    if (best == kNoFace && wall == stack.walls.back()) best = stack.exit;
    return best;
  }

  void tellCylinder(const Stack& stack, std::uint32_t f, const std::string& part, Feature& out) const {
    const CadFace& face = s_.face(f);
    const auto range = s_.network.along(f, stack.origin, stack.into);
    Characteristic c;
    c.part = part;
    c.from = stack.origin + range.low * stack.into;
    c.to = stack.origin + range.high * stack.into;
    c.at = stack.origin + range.middle() * stack.into;
    const auto add = [&](Quantity quantity, std::vector<std::uint32_t> faces) {
      c.quantity = quantity;
      c.faces = std::move(faces);
      out.characteristics.push_back(c);
    };
    add(Quantity::kDiameter, {f});
    addPlace(f, part, c, face, out.characteristics);
    const std::uint32_t end = endOf(stack, f);
    if (stack.entry != kNoFace && end != kNoFace) add(Quantity::kDepth, {f, stack.entry, end});
    if (stack.entry != kNoFace && s_.across(s_.face(stack.entry), stack.into))
      add(Quantity::kPerpendicularity, {f, stack.entry});
    add(Quantity::kCylindricity, {f});
  }

  void tellCone(const Stack& stack, std::uint32_t f, const std::string& part, Feature& out) const {
    Characteristic c;
    c.part = part;
    c.quantity = Quantity::kAngle;
    c.faces = {f};
    const auto range = s_.network.along(f, stack.origin, stack.into);
    c.at = stack.origin + range.middle() * stack.into;
    c.from = stack.origin + range.low * stack.into;
    c.to = stack.origin + range.high * stack.into;
    out.characteristics.push_back(c);
    if (f == stack.walls.front() && stack.entry != kNoFace) {
      c.quantity = Quantity::kConeDiameter;
      c.faces = {f, stack.entry};
      out.characteristics.push_back(c);
    }
  }

  void tell(const Stack& stack) {
    Feature out;
    out.kind = FeatureKind::kHole;
    std::vector<std::uint32_t> cylinders;
    for (const std::uint32_t f : stack.walls)
      if (s_.face(f).kind == SurfaceKind::kCylinder) cylinders.push_back(f);
    const bool sunk = s_.face(stack.walls.front()).kind == SurfaceKind::kCone;
    std::string sizes, names;
    for (const std::uint32_t f : cylinders) {
      const std::string part =
          cylinders.size() == 1 ? "" : fmt::format("step of {:.6g}", 2.0 * s_.face(f).radius);
      tellCylinder(stack, f, part, out);
      sizes += fmt::format("{}{:.6g}", sizes.empty() ? "" : "/", 2.0 * s_.face(f).radius);
    }
    for (const std::uint32_t f : stack.walls) {
      const CadFace& face = s_.face(f);
      if (!face.name.empty()) names += (names.empty() ? "" : ", ") + face.name;
      if (face.kind == SurfaceKind::kCone)
        tellCone(stack, f, f == stack.walls.front() ? "countersink" : endsInTip(f) ? "tip" : "cone", out);
    }
    out.at = out.characteristics.front().at;
    out.name = fmt::format("{}{}{}hole of diameter {} at {}{}", sunk ? "countersunk " : "",
                           cylinders.size() > 1 ? "stepped " : "", stack.through ? "through " : "blind ",
                           sizes, placeText(out.at, stack.into), names.empty() ? "" : " (" + names + ")");
    out.faces = stack.walls;
    out.faces.insert(out.faces.end(), stack.ends.begin(), stack.ends.end());
    s_.add(std::move(out));
  }

  FeatureSearch& s_;
};

}  // namespace hole_detail

void findHoles(FeatureSearch& search) { hole_detail::HoleFinder(search).run(); }

}  // namespace proveout
