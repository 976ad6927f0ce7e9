#include "core/mesh/faces/found_faces.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "core/mesh/edge_table.h"
#include "core/mesh/faces/coordinate_rounding.h"
#include "core/mesh/faces/flat_facets.h"
#include "core/mesh/faces/round_regions.h"
#include "core/mesh/faces/tidy_faces.h"
#include "core/mesh/turn_counter.h"

namespace proveout {
namespace found_detail {

/// Corners may be off by so many times what their coordinates are rounded by, and by what CAD systems leave
/// between faces that meet, mm.
constexpr double kRoundings = 4.0, kCadGap = 1e-5;
/// Points that a face's figures are settled by.
constexpr std::size_t kMostPoints = 600;

/// Faces that are being put together: their facets.
struct Draft {
  std::vector<FittedFace> faces;
  std::vector<std::vector<std::uint32_t>> facets;
  std::vector<std::uint32_t> face_of;  ///< per facet, or kNoFace
  void add(FittedFace face, std::vector<std::uint32_t> own) {
    for (const std::uint32_t f : own) face_of[f] = static_cast<std::uint32_t>(faces.size());
    faces.push_back(std::move(face));
    facets.push_back(std::move(own));
  }
};

std::vector<Vec3> someOf(const std::vector<Vec3>& all) {
  if (all.size() <= kMostPoints) return all;
  std::vector<Vec3> out;
  for (std::size_t k = 0; k < kMostPoints; ++k) out.push_back(all[k * all.size() / kMostPoints]);
  return out;
}

/// Corners of facets, each facet's own: of rounds those that lie on the curve.
std::vector<Vec3> pointsOf(const FlatFacets& facets, const std::vector<std::uint32_t>& of, bool on_curve) {
  std::vector<std::uint32_t> all;
  for (const std::uint32_t f : of)
    for (const FacetCorner& corner : facets.corners(f))
      if (corner.on_curve || !on_curve) all.push_back(corner.vertex);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<Vec3> out;
  for (const std::uint32_t v : all) out.push_back(facets.point(v));
  return someOf(out);
}

double areaOf(const FlatFacets& facets, const std::vector<std::uint32_t>& of) {
  double sum = 0.0;
  for (const std::uint32_t f : of) sum += facets[f].area;
  return sum;
}

void addRounds(const FlatFacets& facets, double near_mm, Draft& draft, double& chord_mm) {
  std::vector<bool> taken(facets.size(), false);
  for (FacetRegion& region : findRoundRegions(facets, near_mm, taken)) {
    FittedFace face;
    face.face = region.face;
    face.points = pointsOf(facets, region.facets, true);
    face.weight = areaOf(facets, region.facets);
    chord_mm = std::max(chord_mm, region.chord_mm);
    draft.add(std::move(face), std::move(region.facets));
  }
}

CadFace planeThrough(const FlatFacet& facet, const std::vector<Vec3>& points) {
  CadFace out;
  out.kind = SurfaceKind::kPlane;
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) m += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  const Vec3 normal = solver.eigenvectors().col(0);
  out.axis = normal.dot(facet.normal) < 0.0 ? Vec3(-normal) : normal;
  out.origin = mean;
  return out;
}

/// Whether a facet is one of many of a free-form face, and no plane: most of its border goes on smoothly into
/// others that are of no face, and about as large; or it is a splinter of one.
bool isFreeForm(const FlatFacets& facets, const Draft& draft, double least_mm2, std::uint32_t f) {
  constexpr double kLarge = 8.0;
  if (facets[f].area < least_mm2) return true;
  double all = 0.0, soft = 0.0;
  for (const FacetLink& link : facets.links(f)) {
    all += link.length;
    const bool open = link.smooth && draft.face_of[link.other] == kNoFace;
    if (open && facets[f].area < kLarge * facets[link.other].area) soft += link.length;
  }
  return soft > 0.4 * all;
}

void addPlanes(const FlatFacets& facets, Draft& draft) {
  constexpr double kLeastShare = 1e-5;  // of the whole surface
  double area = 0.0;
  for (std::uint32_t f = 0; f < facets.size(); ++f) area += facets[f].area;
  std::vector<std::uint32_t> planes;
  for (std::uint32_t f = 0; f < facets.size(); ++f)
    if (draft.face_of[f] == kNoFace && facets[f].firm && !isFreeForm(facets, draft, kLeastShare * area, f))
      planes.push_back(f);
  for (const std::uint32_t f : planes) {
    FittedFace face;
    face.points = pointsOf(facets, {f}, false);
    face.face = planeThrough(facets[f], face.points);
    face.weight = facets[f].area;
    draft.add(std::move(face), {f});
  }
}

/// Slivers belong to a face that they lie on and border most.
void addSlivers(const FlatFacets& facets, double near_mm, Draft& draft) {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      if (draft.face_of[f] != kNoFace || facets[f].firm) continue;
      double longest = 0.0;
      std::uint32_t best = kNoFace;
      for (const FacetLink& link : facets.links(f)) {
        const std::uint32_t face = draft.face_of[link.other];
        if (face == kNoFace || link.length <= longest) continue;
        const auto corners = facets.corners(f);
        const CadFace& surface = draft.faces[face].face;
        const bool on = std::all_of(corners.begin(), corners.end(), [&](const FacetCorner& c) {
          return std::abs(surface.distance(facets.point(c.vertex))) <= 2.0 * near_mm;
        });
        if (!on) continue;
        longest = link.length;
        best = face;
      }
      if (best == kNoFace) continue;
      draft.face_of[f] = best;
      draft.facets[best].push_back(f);
    }
  }
}

/// What is left and goes on smoothly is a free-form face.
void addFreeForms(const FlatFacets& facets, Draft& draft) {
  DisjointSets parts(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    if (draft.face_of[f] != kNoFace) continue;
    for (const FacetLink& link : facets.links(f))
      if (draft.face_of[link.other] == kNoFace &&
          (link.smooth || !facets[f].firm || !facets[link.other].firm))
        parts.join(f, link.other);
  }
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members;
  std::vector<std::uint32_t> heads;
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    if (draft.face_of[f] != kNoFace) continue;
    const std::uint32_t head = parts.find(f);
    if (head == f) heads.push_back(f);
    members[head].push_back(f);
  }
  for (const std::uint32_t head : heads) draft.add({}, std::move(members[head]));
}

/// Numbers the faces by their first triangles; tells their residuals.
void tell(const FlatFacets& facets, const Draft& draft, FoundFaces& out) {
  const TriMesh& mesh = facets.mesh();
  std::vector<std::uint32_t> number(draft.faces.size(), kNoFace);
  out.faces.of_triangle.assign(mesh.triangles.size(), kNoFace);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t face = draft.face_of[facets.of(t)];
    if (face == kNoFace) continue;
    if (number[face] == kNoFace) {
      number[face] = static_cast<std::uint32_t>(out.faces.faces.size());
      const FittedFace& fitted = draft.faces[face];
      out.faces.faces.push_back(fitted.face);
    }
    out.faces.of_triangle[t] = number[face];
  }
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    if (draft.face_of[f] == kNoFace) continue;
    CadFace& face = out.faces.faces[number[draft.face_of[f]]];
    if (face.kind == SurfaceKind::kOther) continue;
    for (const FacetCorner& corner : facets.corners(f))
      if (corner.on_curve || face.kind == SurfaceKind::kPlane)
        face.residual_mm = std::max(face.residual_mm, std::abs(face.distance(facets.point(corner.vertex))));
  }
  countTurns(mesh, std::vector<bool>(out.faces.faces.size(), true), out.faces);
}

/// Facets of one surface that meet are of one face: where something kept a region from growing over them.
void joinAlike(const FlatFacets& facets, double near_mm, Draft& draft) {
  constexpr double kNearRad = 1e-9;
  DisjointSets sets(draft.faces.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const std::uint32_t a = draft.face_of[f];
    if (a == kNoFace) continue;
    for (const FacetLink& link : facets.links(f)) {
      const std::uint32_t b = draft.face_of[link.other];
      if (b == kNoFace || sets.find(a) == sets.find(b)) continue;
      if (sameSurface(draft.faces[a].face, draft.faces[b].face, near_mm, kNearRad)) sets.join(a, b);
    }
  }
  for (std::uint32_t& face : draft.face_of)
    if (face != kNoFace) face = sets.find(face);
}

}  // namespace found_detail

FoundFaces findFaces(const TriMesh& mesh) {
  using namespace found_detail;
  FoundFaces out;
  out.near_mm = kRoundings * coordinateRounding(mesh) + kCadGap;
  const FlatFacets facets(mesh, out.near_mm);
  Draft draft;
  draft.face_of.assign(facets.size(), kNoFace);
  addRounds(facets, out.near_mm, draft, out.chord_mm);
  addPlanes(facets, draft);
  tidyFaces(out.near_mm, draft.faces);
  addSlivers(facets, out.near_mm, draft);
  joinAlike(facets, out.near_mm, draft);
  addFreeForms(facets, draft);
  tell(facets, draft, out);
  return out;
}

}  // namespace proveout
