#include "removal/compare/features/judgement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {
namespace judgement_detail {

using Limits = std::pair<std::optional<double>, std::optional<double>>;

/// A deviation of a plane's coordinate is excess where it goes the normal's way.
Limits ofPlane(double along_normal, double gouge, double excess) {
  return along_normal > 0.0 ? Limits(-gouge, excess) : Limits(-excess, gouge);
}

/// The length that tolerances of angle and form go by, mm: of the feature along its axis, or across.
double lengthOf(const Feature& feature, const Characteristic& c) {
  const bool plane = c.quantity == Quantity::kFlatness ||
                     (c.quantity == Quantity::kAngle && feature.kind == FeatureKind::kPlane);
  return std::max(plane ? feature.bounds.size().maxCoeff() : (c.to - c.from).norm(), 1e-3);
}

/// What a surface within its tolerances leaves: the limits of the characteristic.
Limits surfaceLimits(const Characteristic& c, const CadFaces& faces, double length, double gouge,
                     double excess) {
  const CadFace& first = faces.faces[c.faces.front()];
  const double least = std::min(gouge, excess), both = gouge + excess;
  const auto ofSize = [&](double sides, bool hollow) {
    return hollow ? Limits(-sides * excess, sides * gouge) : Limits(-sides * gouge, sides * excess);
  };
  switch (c.quantity) {
    case Quantity::kDiameter:
      if (first.kind == SurfaceKind::kTorus) return {-2.0 * least, 2.0 * least};
      return ofSize(2.0, first.hollow);
    case Quantity::kConeDiameter:
      return {-2.0 * least, 2.0 * least};
    case Quantity::kAngle: {
      // What turns the face by its tolerance at both of its ends.
      const double turn = radToDeg(2.0 * least / length);
      const double limit = first.kind == SurfaceKind::kCone ? 2.0 * turn : turn;
      return {-limit, limit};
    }
    case Quantity::kRadius:
      return ofSize(1.0, first.hollow);
    case Quantity::kWidth:
    case Quantity::kLength:
      return ofSize(2.0, true);
    case Quantity::kX:
    case Quantity::kY:
    case Quantity::kZ:
      if (first.kind == SurfaceKind::kPlane && c.faces.size() == 1)
        return ofPlane(first.axis[static_cast<int>(c.quantity) - static_cast<int>(Quantity::kX)], gouge,
                       excess);
      return {-least, least};
    case Quantity::kOffset:
      return c.faces.size() == 1 ? ofPlane(1.0, gouge, excess) : Limits(-least, least);
    case Quantity::kPosition:
      return {std::nullopt, 2.0 * least};
    case Quantity::kDepth:
    case Quantity::kHeight:
      return {-both, both};
    case Quantity::kPerpendicularity:
    case Quantity::kFlatness:
    case Quantity::kCylindricity:
    case Quantity::kForm:
      return {std::nullopt, both};
    default:
      return {};
  }
}

bool hasSize(const Feature& feature, double size) {
  constexpr double kNear = 1e-3;
  return std::any_of(feature.characteristics.begin(), feature.characteristics.end(),
                     [&](const Characteristic& c) {
                       return (c.quantity == Quantity::kDiameter || c.quantity == Quantity::kRadius ||
                               c.quantity == Quantity::kWidth) &&
                              std::abs(c.nominal - size) <= kNear;
                     });
}

class Matcher {
 public:
  Matcher(const std::vector<Feature>& features, const CadFaces& faces, const CharacteristicRule& rule)
      : features_(features), faces_(faces), rule_(rule) {
    if (rule.at) findNearest();
  }

  bool fits(std::size_t feature, const Characteristic& c) const {
    if (rule_.at && feature != nearest_) return false;
    return fits(features_[feature]) && fitsItself(c);
  }

 private:
  bool fits(const Feature& feature) const {
    if (rule_.kind && feature.kind != *rule_.kind) return false;
    if (rule_.size && !hasSize(feature, *rule_.size)) return false;
    return rule_.face.empty() ||
           std::any_of(feature.faces.begin(), feature.faces.end(),
                       [&](std::uint32_t f) { return isNamed(faces_.faces[f], rule_.face); });
  }
  bool fitsItself(const Characteristic& c) const {
    return (!rule_.quantity || c.quantity == *rule_.quantity) && (rule_.part.empty() || c.part == rule_.part);
  }

  /// By the boxes, then by the faces themselves.
  void findNearest() {
    constexpr double kNear = 1.0;
    std::pair<double, double> best(kNear, std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < features_.size(); ++k) {
      const Feature& feature = features_[k];
      if (!fits(feature) || std::none_of(feature.characteristics.begin(), feature.characteristics.end(),
                                         [&](const Characteristic& c) { return fitsItself(c); }))
        continue;
      const Vec3& p = *rule_.at;
      const Vec3 off = (feature.bounds.min - p).cwiseMax(p - feature.bounds.max).cwiseMax(Vec3::Zero());
      double face = std::numeric_limits<double>::infinity();
      for (const std::uint32_t f : feature.faces)
        if (faces_.faces[f].kind != SurfaceKind::kOther)
          face = std::min(face, std::abs(faces_.faces[f].distance(p)));
      const std::pair<double, double> here(off.norm(), face);
      if (here >= best) continue;
      best = here;
      nearest_ = k;
    }
  }

  const std::vector<Feature>& features_;
  const CadFaces& faces_;
  const CharacteristicRule& rule_;
  std::size_t nearest_ = std::numeric_limits<std::size_t>::max();
};

void judge(const Characteristic& c, JudgedCharacteristic& out) {
  constexpr double kRounding = 1e-9;
  if (!out.lower && !out.upper) return;
  bool good = c.measured.has_value();
  if (good) {
    const double off = *c.measured - out.nominal;
    good = (!out.lower || off >= *out.lower - kRounding) && (!out.upper || off <= *out.upper + kRounding);
  }
  out.verdict = good ? CharacteristicVerdict::kPass : CharacteristicVerdict::kFail;
}

}  // namespace judgement_detail

Judgement judgeFeatures(const std::vector<Feature>& features, const CadFaces& faces,
                        const FeatureTolerances& tolerances) {
  using namespace judgement_detail;
  Judgement out;
  for (const Feature& feature : features) {
    std::vector<JudgedCharacteristic>& own = out.features.emplace_back();
    for (const Characteristic& c : feature.characteristics) {
      JudgedCharacteristic& judged = own.emplace_back();
      judged.nominal = c.nominal;
      if (const auto limit = tolerances.general.limit(c, lengthOf(feature, c))) {
        judged.source = ToleranceSource::kGeneral;
        judged.upper = *limit;
        if (!isZone(c.quantity)) judged.lower = -*limit;
      } else if (!c.faces.empty()) {
        std::tie(judged.lower, judged.upper) =
            surfaceLimits(c, faces, lengthOf(feature, c), tolerances.gouge_mm, tolerances.excess_mm);
        if (judged.lower || judged.upper) judged.source = ToleranceSource::kSurface;
      }
    }
  }
  for (const CharacteristicRule& rule : tolerances.rules) {
    const Matcher matcher(features, faces, rule);
    bool used = false;
    for (std::size_t k = 0; k < features.size(); ++k) {
      for (std::size_t i = 0; i < features[k].characteristics.size(); ++i) {
        if (!matcher.fits(k, features[k].characteristics[i])) continue;
        used = true;
        JudgedCharacteristic& judged = out.features[k][i];
        judged.source = ToleranceSource::kRule;
        judged.rule = &rule;
        judged.nominal = rule.nominal.value_or(features[k].characteristics[i].nominal);
        judged.lower = isZone(features[k].characteristics[i].quantity) ? std::nullopt : rule.lower;
        judged.upper = rule.upper;
      }
    }
    if (!used) out.unused.push_back(&rule);
  }
  for (std::size_t k = 0; k < features.size(); ++k)
    for (std::size_t i = 0; i < features[k].characteristics.size(); ++i)
      judge(features[k].characteristics[i], out.features[k][i]);
  return out;
}

}  // namespace proveout
