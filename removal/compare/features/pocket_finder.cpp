// Pockets and slots with a floor: a plane with walls around it, or on two sides.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "removal/compare/features/feature_parts.h"

namespace proveout {
namespace pocket_detail {

/// The end of a slot goes half round.
constexpr double kHalfRound = degToRad(150.0);

/// Two planes that face each other over air.
struct Facing {
  std::uint32_t a = kNoFace, b = kNoFace;
  double width = 0.0;
};

class PocketFinder {
 public:
  explicit PocketFinder(FeatureSearch& search) : s_(search) {}

  void run() {
    for (std::uint32_t f = 0; f < s_.network.size(); ++f)
      if (s_.face(f).kind == SurfaceKind::kPlane && !s_.taken[f]) consider(f);
  }

 private:
  /// A round that leads from one face into another: the fillet between floor and wall, the corner of a
  /// pocket.
  bool isInnerRound(std::uint32_t f) const {
    const CadFace& face = s_.face(f);
    return face.hollow && !face.isWholeCylinder() &&
           (face.kind == SurfaceKind::kCylinder || face.kind == SurfaceKind::kTorus ||
            face.kind == SurfaceKind::kSphere);
  }

  /// Walls of a floor: what stands on it at an inner edge, or behind an inner round; walls that these lead
  /// to.
  std::set<std::uint32_t> wallsOf(std::uint32_t floor) const {
    const Vec3& up = s_.face(floor).axis;
    std::set<std::uint32_t> walls;
    std::vector<std::uint32_t> open;
    const auto take = [&](std::uint32_t f) {
      const CadFace& face = s_.face(f);
      const bool plane = face.kind == SurfaceKind::kPlane && std::abs(face.axis.dot(up)) < 0.7;
      if (f == floor || s_.taken[f] || !(plane || isInnerRound(f)) || !walls.insert(f).second) return;
      if (isInnerRound(f)) open.push_back(f);
    };
    for (const FaceBorder& border : s_.network.borders(floor))
      if (border.isConcave() || (border.isSmooth() && isInnerRound(border.other))) take(border.other);
    while (!open.empty()) {
      const std::uint32_t f = open.back();
      open.pop_back();
      for (const FaceBorder& border : s_.network.borders(f))
        if (border.isSmooth() || border.isConcave()) take(border.other);
    }
    return walls;
  }

  std::vector<Facing> facingPairs(const std::set<std::uint32_t>& walls) const {
    std::vector<Facing> out;
    for (const std::uint32_t a : walls) {
      const CadFace& first = s_.face(a);
      if (first.kind != SurfaceKind::kPlane) continue;
      Facing best;
      for (const std::uint32_t b : walls) {
        const CadFace& second = s_.face(b);
        if (b <= a || second.kind != SurfaceKind::kPlane || first.axis.dot(second.axis) > 0.0 ||
            !s_.parallel(first.axis, second.axis))
          continue;
        const double width = (second.origin - first.origin).dot(first.axis);
        if (width > 0.0 && (best.a == kNoFace || width < best.width)) best = {a, b, width};
      }
      if (best.a != kNoFace) out.push_back(best);
    }
    return out;
  }

  /// The lowest plane above the floor that looks the same way and that a wall comes out of.
  std::uint32_t rimOf(std::uint32_t floor, const std::set<std::uint32_t>& walls) const {
    const CadFace& base = s_.face(floor);
    std::uint32_t best = kNoFace;
    double lowest = 0.0;
    for (const std::uint32_t wall : walls) {
      for (const FaceBorder& border : s_.network.borders(wall)) {
        const CadFace& plane = s_.face(border.other);
        if (plane.kind != SurfaceKind::kPlane || !border.isConvex() || plane.axis.dot(base.axis) <= 0.0 ||
            !s_.parallel(plane.axis, base.axis))
          continue;
        const double height = (plane.origin - base.origin).dot(base.axis);
        if (height > s_.accuracy.near_mm && (best == kNoFace || height < lowest)) {
          lowest = height;
          best = border.other;
        }
      }
    }
    return best;
  }

  void addWidth(const Facing& pair, Quantity quantity, Feature& out) const {
    const CadFace& first = s_.face(pair.a);
    Characteristic c;
    c.faces = {pair.a, pair.b};
    // In the middle of the two, at half of their height.
    c.at = 0.5 * (s_.network.middle(pair.a) + s_.network.middle(pair.b));
    c.from = Vec3::Zero();
    c.to = first.axis;
    c.quantity = quantity;
    out.characteristics.push_back(c);
    c.quantity = placeQuantity(first.axis);
    out.characteristics.push_back(c);
  }

  void consider(std::uint32_t floor) {
    const CadFace& base = s_.face(floor);
    const std::set<std::uint32_t> walls = wallsOf(floor);
    const std::vector<Facing> pairs = facingPairs(walls);
    const auto borders = s_.network.borders(floor);
    double open = 0.0, all = 0.0;
    for (const FaceBorder& border : borders) {
      all += border.length_mm;
      if (border.isConvex() && !isHoleWall(border.other)) open += border.length_mm;
    }
    const bool closed = open < 1e-6 * all;
    if (pairs.empty() && !(closed && !walls.empty())) return;
    const std::uint32_t rim = rimOf(floor, walls);
    if (rim == kNoFace) return;
    Feature out;
    out.kind = isSlot(closed, walls, pairs) ? FeatureKind::kSlot : FeatureKind::kPocket;
    out.at = s_.network.middle(floor);
    out.faces = {floor};
    std::vector<Facing> sorted = pairs;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Facing& a, const Facing& b) { return a.width < b.width; });
    for (const Facing& pair : sorted)
      addWidth(pair, &pair == sorted.data() ? Quantity::kWidth : Quantity::kLength, out);
    for (const std::uint32_t wall : walls)
      if (s_.face(wall).kind == SurfaceKind::kPlane && isPaired(wall, pairs)) out.faces.push_back(wall);
    addEnds(walls, out);
    Characteristic c;
    c.at = out.at;
    c.to = base.axis;
    c.quantity = Quantity::kDepth;
    c.faces = {floor, rim};
    out.characteristics.push_back(c);
    c.part = "floor";
    c.quantity = Quantity::kFlatness;
    c.faces = {floor};
    out.characteristics.push_back(c);
    std::string sizes;
    for (const Facing& pair : sorted)
      sizes += fmt::format("{}{:.6g}", sizes.empty() ? "" : " x ", pair.width);
    out.name = fmt::format("{}{} of depth {:.6g} at {}{}", out.kind == FeatureKind::kSlot ? "slot" : "pocket",
                           sizes.empty() ? "" : (pairs.size() == 1 ? " of width " : " of ") + sizes,
                           (s_.face(rim).origin - base.origin).dot(base.axis), placeText(out.at, base.axis),
                           base.name.empty() ? "" : " (" + base.name + ")");
    s_.add(std::move(out));
  }

  bool isHoleWall(std::uint32_t f) const { return s_.taken[f] && s_.face(f).hollow; }
  static bool isPaired(std::uint32_t wall, const std::vector<Facing>& pairs) {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const Facing& p) { return p.a == wall || p.b == wall; });
  }
  /// One pair of walls, open at the ends, or closed by half rounds.
  bool isSlot(bool closed, const std::set<std::uint32_t>& walls, const std::vector<Facing>& pairs) const {
    if (pairs.size() != 1) return false;
    if (!closed) return true;
    return std::any_of(walls.begin(), walls.end(), [&](std::uint32_t f) {
      return s_.face(f).kind == SurfaceKind::kCylinder &&
             std::abs(2.0 * s_.face(f).radius - pairs.front().width) <= 2.0 * s_.accuracy.near_mm;
    });
  }
  /// Half rounds at the ends of a slot, corners of a pocket: their radii.
  void addEnds(const std::set<std::uint32_t>& walls, Feature& out) const {
    for (const std::uint32_t f : walls) {
      const CadFace& face = s_.face(f);
      if (face.kind != SurfaceKind::kCylinder || s_.taken[f]) continue;
      const bool upright = s_.parallel(face.axis, s_.face(out.faces.front()).axis);
      Characteristic c;
      const auto range = s_.network.along(f, face.origin, face.axis);
      c.from = face.origin + range.low * face.axis;
      c.to = face.origin + range.high * face.axis;
      c.at = face.origin + range.middle() * face.axis;
      c.part = fmt::format("{} at {}",
                           !upright                     ? "fillet"
                           : face.turn_rad > kHalfRound ? "end"
                                                        : "corner",
                           placeText(c.at, face.axis));
      c.quantity = Quantity::kRadius;
      c.faces = {f};
      out.characteristics.push_back(c);
      if (upright && face.turn_rad > kHalfRound) addPlace(f, c.part, c, face, out.characteristics);
      out.faces.push_back(f);
    }
  }

  FeatureSearch& s_;
};

/// Slots that go through: two planes that half rounds lead from one to the other.
void throughSlots(FeatureSearch& s) {
  for (std::uint32_t f = 0; f < s.network.size(); ++f) {
    const CadFace& round = s.face(f);
    if (round.kind != SurfaceKind::kCylinder || !round.hollow || s.taken[f] || round.isWholeCylinder() ||
        round.turn_rad < kHalfRound)
      continue;
    std::vector<std::uint32_t> sides;
    for (const FaceBorder& border : s.network.borders(f))
      if (border.isSmooth() && s.face(border.other).kind == SurfaceKind::kPlane && !s.taken[border.other])
        sides.push_back(border.other);
    if (sides.size() != 2 || !s.parallel(s.face(sides[0]).axis, s.face(sides[1]).axis)) continue;
    const CadFace& first = s.face(sides[0]);
    Feature out;
    out.kind = FeatureKind::kSlot;
    out.faces = {sides[0], sides[1], f};
    // The round at the other end.
    for (const FaceBorder& border : s.network.borders(sides[0])) {
      const CadFace& other = s.face(border.other);
      if (border.other != f && border.isSmooth() && other.kind == SurfaceKind::kCylinder && other.hollow &&
          !s.taken[border.other] && s.network.border(border.other, sides[1]) != nullptr)
        out.faces.push_back(border.other);
    }
    Characteristic c;
    c.faces = {sides[0], sides[1]};
    c.at = out.at = 0.5 * (s.network.middle(sides[0]) + s.network.middle(sides[1]));
    c.to = first.axis;
    c.quantity = Quantity::kWidth;
    out.characteristics.push_back(c);
    c.quantity = placeQuantity(first.axis);
    out.characteristics.push_back(c);
    for (std::size_t k = 2; k < out.faces.size(); ++k) {
      Characteristic end;
      const CadFace& face = s.face(out.faces[k]);
      const auto range = s.network.along(out.faces[k], face.origin, face.axis);
      end.from = face.origin + range.low * face.axis;
      end.to = face.origin + range.high * face.axis;
      end.at = face.origin + range.middle() * face.axis;
      const std::string part = fmt::format("end at {}", placeText(end.at, face.axis));
      end.part = part;
      end.quantity = Quantity::kRadius;
      end.faces = {out.faces[k]};
      out.characteristics.push_back(end);
      addPlace(out.faces[k], part, end, face, out.characteristics);
    }
    out.name = fmt::format("slot of width {:.6g} at {}", 2.0 * round.radius, placeText(out.at, round.axis));
    s.add(std::move(out));
  }
}

}  // namespace pocket_detail

void findPockets(FeatureSearch& search) { pocket_detail::PocketFinder(search).run(); }
void findSlots(FeatureSearch& search) { pocket_detail::throughSlots(search); }

}  // namespace proveout
