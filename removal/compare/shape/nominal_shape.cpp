#include "removal/compare/shape/nominal_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "removal/compare/shape/shape_reader.h"

namespace proveout {

namespace {

/// Off both readings the face may be by this many of its chords: where facets are cut by others the reading
/// is rough.
constexpr double kMisread = 2.0;
/// Cosine; triangles that turn by less than a degree are of one face.
constexpr double kSameFace = 0.99985;
constexpr double kLeastOfRing = 0.5, kMostMisfit = 3.0;
/// The same of flats in doubt: the round of a regular polygon is known to a few per cent.
constexpr double kDoubtShare = 1.2;

}  // namespace

double NominalShape::largestOf(std::uint32_t t) const {
  double largest = std::abs(at(t, mesh_.middle(t)));
  for (std::size_t c = 0; c < 3; ++c) {
    const float middle = 0.5f * (bulge_[t][c] + bulge_[t][(c + 1) % 3]) + bulge_[t][3 + c];
    largest = std::max(largest, static_cast<double>(std::abs(middle)));
  }
  return largest;
}

double NominalShape::mostUnsure() const {
  if (!read_) return faceted_.empty() ? 0.0 : chord_;
  return kMisread * std::max(largest_, largest_doubt_);
}

double NominalShape::unsureAt(std::uint32_t triangle, const Vec3& place, double reach) const {
  if (!read_) {
    if (faceted_.empty()) return 0.0;
    bool beside = faceted_[triangle] != 0;
    const Box3 around = {place - Vec3::Constant(reach), place + Vec3::Constant(reach)};
    if (!beside)
      distance_.tree().forEachIn(around, [&](std::uint32_t t) { beside = beside || faceted_[t] != 0; });
    return beside ? chord_ : 0.0;
  }
  if (largest_ == 0.0 && largest_doubt_ == 0.0) return 0.0;
  PROVEOUT_ASSERT(triangle < bulge_.size());
  double largest = 0.0, misfit = 0.0, doubt = 0.0;
  const auto add = [&](std::uint32_t t) {
    if (largest_ > 0.0) {
      largest = std::max(largest, largestOf(t));
      misfit = std::max(misfit, static_cast<double>(misfit_[t]));
    }
    if (!doubt_.empty()) doubt = std::max(doubt, static_cast<double>(doubt_[t]));
  };
  add(triangle);
  const double own = largest;
  if (own > 0.0 || misfit > 0.0) {
    for (const std::uint32_t v : mesh_.triangles[triangle]) {
      largest = std::max(largest, static_cast<double>(around_[v][0]));
      misfit = std::max(misfit, static_cast<double>(around_[v][1]));
    }
  }
  // Beside another face what that one is cut of counts: the pieces left at the border tell little themselves.
  const Vec3 normal = mesh_.areaVector(triangle).normalized();
  distance_.tree().forEachIn(
      {place - Vec3::Constant(reach), place + Vec3::Constant(reach)}, [&](std::uint32_t t) {
        add(t);
        if (around_.empty() || mesh_.areaVector(t).normalized().dot(normal) > kSameFace) return;
        for (const std::uint32_t v : mesh_.triangles[t])
          largest = std::max(largest, static_cast<double>(around_[v][0]));
      });
  const double most = kMisread * largest;
  // What is much lower than around it was hardly read at all.
  const bool well = own > kLeastOfRing * largest;
  return std::max(well ? std::min(most, misfit) : std::max(most, std::min(misfit, kMostMisfit * largest)),
                  kDoubtShare * doubt);
}

NominalShape::NominalShape(const SurfaceMesh& mesh, const SignedDistance& distance)
    : mesh_(mesh), distance_(distance) {
  shape_detail::ShapeReading reading = shape_detail::readShape(mesh);
  bulge_ = std::move(reading.bulge);
  doubt_ = std::move(reading.doubt);
  misfit_ = std::move(reading.misfit);
  PROVEOUT_ASSERT(bulge_.size() == mesh.triangles.size());
  PROVEOUT_ASSERT((doubt_.empty() || doubt_.size() == bulge_.size()) &&
                  (misfit_.empty() || misfit_.size() == bulge_.size()));
  if (!misfit_.empty()) lookAround();
  for (std::uint32_t t = 0; t < bulge_.size(); ++t) {
    const double largest = largestOf(t);
    if (!doubt_.empty() && doubt_[t] > largest_doubt_) {
      largest_doubt_ = doubt_[t];
      largest_doubt_at_ = mesh.middle(t);
    }
    if (largest <= largest_) continue;
    largest_ = largest;
    largest_at_ = mesh.middle(t);
  }
}

NominalShape::NominalShape(const SurfaceMesh& mesh, const SignedDistance& distance, const CadFaces& faces)
    : mesh_(mesh), distance_(distance), read_(false), chord_(faces.chord_mm) {
  PROVEOUT_ASSERT(faces.of_triangle.size() == mesh.triangles.size());
  bulge_.resize(mesh.triangles.size());
  for (std::uint32_t t = 0; t < bulge_.size(); ++t) {
    if (const CadFace* face = faces.exactAt(t)) {
      takeExact(t, *face);
      largest_ = std::max(largest_, largestOf(t));
      continue;
    }
    if (faceted_.empty()) {
      faceted_.resize(bulge_.size());
      largest_at_ = mesh.middle(t);
    }
    faceted_[t] = 1;
  }
}

/// The face lies as far beyond the facet as its points lie within it.
void NominalShape::takeExact(std::uint32_t triangle, const CadFace& face) {
  if (face.kind == SurfaceKind::kPlane) return;
  const auto& v = mesh_.triangles[triangle];
  const auto beyond = [&](const Vec3& p) { return static_cast<float>(-face.distance(p)); };
  auto& b = bulge_[triangle];
  for (std::size_t c = 0; c < 3; ++c) b[c] = beyond(mesh_.points[v[c]]);
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3 middle = 0.5 * (mesh_.points[v[c]] + mesh_.points[v[(c + 1) % 3]]);
    b[3 + c] = beyond(middle) - 0.5f * (b[c] + b[(c + 1) % 3]);
  }
}

void NominalShape::lookAround() {
  const auto raise = [](std::array<float, 2>& most, const std::array<float, 2>& by) {
    most = {std::max(most[0], by[0]), std::max(most[1], by[1])};
  };
  std::vector<std::array<float, 2>> of(mesh_.triangles.size());
  for (std::uint32_t t = 0; t < of.size(); ++t) of[t] = {static_cast<float>(largestOf(t)), misfit_[t]};
  constexpr int kRings = 2;
  for (int ring = 0; ring < kRings; ++ring) {
    around_.assign(mesh_.points.size(), {0.0f, 0.0f});
    for (std::uint32_t t = 0; t < of.size(); ++t) {
      for (const std::uint32_t v : mesh_.triangles[t]) raise(around_[v], of[t]);
    }
    for (std::uint32_t t = 0; t < of.size(); ++t) {
      if (of[t][0] == 0.0f && of[t][1] == 0.0f) continue;  // a flat face between two rounds joins nothing
      for (const std::uint32_t v : mesh_.triangles[t]) raise(of[t], around_[v]);
    }
  }
}

double NominalShape::at(std::uint32_t triangle, const Vec3& point) const {
  const auto& b = bulge_[triangle];
  if (b == std::array<float, 6>{}) return 0.0;
  const auto& v = mesh_.triangles[triangle];
  const Vec3 normal = mesh_.areaVector(triangle);
  const auto share = [&](int c) {  // barycentric
    const Vec3 &p = mesh_.points[v[(c + 1) % 3]], &q = mesh_.points[v[(c + 2) % 3]];
    return std::clamp((p - point).cross(q - point).dot(normal) / normal.squaredNorm(), 0.0, 1.0);
  };
  const double s[3] = {share(0), share(1), share(2)};
  return b[0] * s[0] + b[1] * s[1] + b[2] * s[2] +
         4.0 * (b[3] * s[0] * s[1] + b[4] * s[1] * s[2] + b[5] * s[2] * s[0]);
}

Bulge NominalShape::at(const SurfaceDistance& nearest, const Vec3& place) const {
  if (largest_ == 0.0) return {};
  const Vec3 foot = place - nearest.distance * nearest.gradient.cast<double>();
  Bulge out;
  const auto add = [&](std::uint32_t t) {
    const double b = at(t, foot);
    out.low = std::min(out.low, b);
    out.high = std::max(out.high, b);
  };
  add(nearest.triangle);
  if (nearest.part >= 3 && nearest.part < kFacePart) {
    const std::uint32_t other = distance_.neighbour(nearest.triangle, nearest.part - 3);
    if (other != TriangleTree::kNone) add(other);
  }
  return out;
}

}  // namespace proveout
