// Bosses and shafts: round solid faces about one axis.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "removal/compare/features/feature_parts.h"

namespace proveout {
namespace boss_detail {

class BossFinder {
 public:
  explicit BossFinder(FeatureSearch& search) : s_(search) {}

  void run() {
    for (std::uint32_t f = 0; f < s_.network.size(); ++f)
      if (s_.face(f).isWholeCylinder() && !s_.face(f).hollow && !s_.taken[f]) tell(f);
  }

 private:
  /// The plane across the axis at one end, itself or behind the round or the chamfer of an edge.
  struct End {
    std::uint32_t plane = kNoFace;
    bool outer = false;  ///< the cylinder ends there; else it stands on the plane
    double level = 0.0;
  };
  std::vector<End> endsOf(std::uint32_t f) const {
    const CadFace& own = s_.face(f);
    const auto range = s_.network.along(f, own.origin, own.axis);
    std::vector<End> out;
    const auto consider = [&](std::uint32_t of) {
      for (const FaceBorder& border : s_.network.borders(of)) {
        const CadFace& plane = s_.face(border.other);
        if (!s_.across(plane, own.axis)) continue;
        const double level = (plane.origin - own.origin).dot(own.axis);
        const bool upper = level > range.middle();
        const bool outer = (plane.axis.dot(own.axis) > 0.0) == upper;
        const auto same = [&](const End& e) { return (e.level > range.middle()) == upper; };
        if (std::none_of(out.begin(), out.end(), same)) out.push_back({border.other, outer, level});
      }
    };
    consider(f);
    for (const FaceBorder& border : s_.network.borders(f)) {
      const CadFace& edge = s_.face(border.other);
      if ((edge.kind == SurfaceKind::kTorus || edge.kind == SurfaceKind::kCone) &&
          s_.coaxial(edge, own.origin, own.axis) && out.size() < 2)
        consider(border.other);
    }
    return out;
  }

  /// A top that only this boss has.
  bool isOwn(std::uint32_t plane, std::uint32_t f) const {
    const CadFace& own = s_.face(f);
    const auto borders = s_.network.borders(plane);
    return std::all_of(borders.begin(), borders.end(), [&](const FaceBorder& border) {
      return border.other == f ||
             (s_.face(border.other).kind != SurfaceKind::kCylinder &&
              s_.coaxial(s_.face(border.other), own.origin, own.axis)) ||
             s_.taken[border.other];
    });
  }

  void tell(std::uint32_t f) {
    const CadFace& face = s_.face(f);
    const auto range = s_.network.along(f, face.origin, face.axis);
    Characteristic c;
    c.from = face.origin + range.low * face.axis;
    c.to = face.origin + range.high * face.axis;
    c.at = face.origin + range.middle() * face.axis;
    Feature out;
    out.kind = FeatureKind::kBoss;
    out.faces = {f};
    out.at = c.at;
    const auto add = [&](Quantity quantity, std::vector<std::uint32_t> faces) {
      c.quantity = quantity;
      c.faces = std::move(faces);
      out.characteristics.push_back(c);
    };
    add(Quantity::kDiameter, {f});
    addPlace(f, "", c, face, out.characteristics);
    const std::vector<End> ends = endsOf(f);
    bool boss = false;
    if (ends.size() == 2) {
      add(Quantity::kHeight, {ends[0].plane, ends[1].plane});
      boss = ends[0].outer != ends[1].outer;
    }
    for (const End& end : ends) {
      if (!end.outer) add(Quantity::kPerpendicularity, {f, end.plane});
      if (end.outer && boss && isOwn(end.plane, f) && !s_.taken[end.plane]) {
        add(Quantity::kFlatness, {end.plane});
        out.faces.push_back(end.plane);
      }
    }
    add(Quantity::kCylindricity, {f});
    out.name = fmt::format("{} of diameter {:.6g} at {}{}", boss ? "boss" : "cylinder", 2.0 * face.radius,
                           placeText(c.at, face.axis), face.name.empty() ? "" : " (" + face.name + ")");
    s_.add(std::move(out));
  }

  FeatureSearch& s_;
};

}  // namespace boss_detail

void findBosses(FeatureSearch& search) { boss_detail::BossFinder(search).run(); }

}  // namespace proveout
