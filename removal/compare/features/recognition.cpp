#include "removal/compare/features/recognition.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "removal/compare/features/feature_parts.h"

namespace proveout {

bool FeatureSearch::coaxial(const CadFace& round, const Vec3& origin, const Vec3& axis) const {
  const Vec3 from = round.origin - origin;
  const double off = (from - from.dot(axis) * axis).norm();
  switch (round.kind) {
    case SurfaceKind::kCylinder:
    case SurfaceKind::kCone:
    case SurfaceKind::kTorus:
      return off <= accuracy.near_mm && parallel(round.axis, axis);
    case SurfaceKind::kSphere:
      return off <= accuracy.near_mm;
    default:
      return false;
  }
}

void FeatureSearch::add(Feature feature) {
  const FaceAt at = [this](std::uint32_t f) -> const CadFace& { return network.face(f); };
  std::erase_if(feature.characteristics, [&](Characteristic& c) {
    const auto value = valueOf(c, at);
    if (value) c.nominal = *value;
    return !value;
  });
  for (const std::uint32_t f : feature.faces) {
    taken[f] = true;
    for (const std::uint32_t corner : network.corners(f)) feature.bounds.extend(network.point(corner));
  }
  features.push_back(std::move(feature));
}

int frameAxis(const Vec3& direction) {
  for (int k = 0; k < 3; ++k)
    if (std::abs(direction[k]) > 1.0 - 1e-9) return k;
  return -1;
}

Quantity placeQuantity(const Vec3& normal) {
  const int axis = frameAxis(normal);
  return axis < 0 ? Quantity::kOffset : static_cast<Quantity>(static_cast<int>(Quantity::kX) + axis);
}

std::string placeText(const Vec3& at, const Vec3& axis) {
  const int along = frameAxis(axis);
  std::string out;
  for (int k = 0; k < 3; ++k)
    if (k != along) out += fmt::format("{}{}{:.3f}", out.empty() ? "" : " ", "XYZ"[k], at[k] + 0.0);
  return out;
}

void addPlace(std::uint32_t face, const std::string& part, const Characteristic& where, const CadFace& round,
              std::vector<Characteristic>& out) {
  const bool centre = round.kind == SurfaceKind::kSphere || round.kind == SurfaceKind::kTorus;
  const int along = centre ? -1 : frameAxis(round.axis);
  for (int k = 0; k < 3; ++k) {
    if (!centre && (along < 0 || k == along)) continue;
    Characteristic c = where;
    c.quantity = static_cast<Quantity>(static_cast<int>(Quantity::kX) + k);
    c.part = part;
    c.faces = {face};
    out.push_back(std::move(c));
  }
  Characteristic position = where;
  position.quantity = Quantity::kPosition;
  position.part = part;
  position.faces = {face};
  out.push_back(std::move(position));
}

std::uint32_t outerPlane(const FeatureSearch& search, std::uint32_t round, const Vec3& outwards) {
  std::uint32_t out = kNoFace;
  double longest = 0.0;
  const auto consider = [&](std::uint32_t of, bool by_round) {
    for (const FaceBorder& border : search.network.borders(of)) {
      const CadFace& face = search.face(border.other);
      if (face.kind != SurfaceKind::kPlane || face.axis.dot(outwards) < 0.1) continue;
      if (!(by_round ? border.isSmooth() : border.isConvex()) || border.length_mm <= longest) continue;
      longest = border.length_mm;
      out = border.other;
    }
  };
  consider(round, false);
  if (out != kNoFace) return out;
  const CadFace& own = search.face(round);
  for (const FaceBorder& border : search.network.borders(round)) {
    const CadFace& edge = search.face(border.other);
    if (edge.kind == SurfaceKind::kTorus && !edge.hollow && search.coaxial(edge, own.origin, own.axis))
      consider(border.other, true);
  }
  return out;
}

namespace {

/// The order of an inspection sheet: by kind, then by name of the first face.
void sortByKind(std::vector<Feature>& features) {
  std::stable_sort(features.begin(), features.end(), [](const Feature& a, const Feature& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.faces.front() < b.faces.front();
  });
}

}  // namespace

std::vector<Feature> recognizeFeatures(const FaceNetwork& network, const FaceAccuracy& accuracy) {
  FeatureSearch search(network, accuracy);
  findHoles(search);
  findBosses(search);
  findPockets(search);
  findSlots(search);
  findSingleFaces(search);
  sortByKind(search.features);
  return std::move(search.features);
}

}  // namespace proveout
