#include "removal/compare/shape/mesh_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace proveout::shape_detail {

namespace {

/// Triangles that turn by less against each other are one facet: above the noise of float coordinates, rad.
constexpr double kFlatRad = degToRad(0.05);
/// Text with six digits rounds coordinates by this share: slivers turn by it against the facet that they were
/// cut of, and are at most this part of it wide.
constexpr double kTextNoise = 1e-5, kSliverShare = 0.25;
/// Height of a triangle below which its normal is noise, as a share of its coordinates.
constexpr double kFloatNoise = 400 * 1.2e-7;

}  // namespace

MeshFacets::MeshFacets(const SurfaceMesh& of)
    : mesh(of), facet_of(of.triangles.size()), edges(of.points.size(), of.triangles) {
  findNormals();
  findFacets();
}

void MeshFacets::findNormals() {
  normals.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3 doubled = mesh.areaVector(t);
    double longest = 0.0;
    for (int c = 0; c < 3; ++c) longest = std::max(longest, edge(t, c).norm());
    const double coordinate = mesh.middle(t).cwiseAbs().maxCoeff();
    // No normal to trust: floats turn it by more than a tenth of a degree.
    const bool sliver = doubled.norm() <= std::max(2e-5 * longest, kFloatNoise * coordinate) * longest;
    normals.push_back(sliver ? Vec3::Zero() : Vec3(doubled.normalized()));
  }
}

void MeshFacets::findFacets() {
  DisjointSets sets(mesh.triangles.size());
  std::vector<char> joined(mesh.triangles.size(), 0);
  forEachPair([&](std::uint32_t g, std::uint32_t h) {
    if (std::abs(turnAt(g, h)) >= kFlatRad) return;
    sets.join(g / 3, h / 3);
    joined[g / 3] = joined[h / 3] = 1;
  });
  const std::vector<std::uint32_t> slivers = joinSlivers(joined, sets);
  straighten(slivers, sets);
  area.assign(mesh.triangles.size(), 0.0);
  triangles.assign(mesh.triangles.size(), 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    facet_of[t] = sets.find(t);
    area[facet_of[t]] += 0.5 * mesh.areaVector(t).norm();
    ++triangles[facet_of[t]];
  }
  // A triangle with a sliver is no strip.
  for (const std::uint32_t t : slivers) {
    if (triangles[facet_of[t]] > 1) --triangles[facet_of[t]];
  }
}

MeshFacets::Sliver MeshFacets::sliverOf(std::uint32_t g, std::uint32_t h) const {
  const double length = edge(g / 3, static_cast<int>(g % 3)).norm();
  const double a = mesh.areaVector(g / 3).norm() / length, b = mesh.areaVector(h / 3).norm() / length;
  const auto [narrow, wide] = a < b ? std::pair(g / 3, h / 3) : std::pair(h / 3, g / 3);
  if (std::min(a, b) >= kSliverShare * std::max(a, b)) return {};
  const double off = std::abs(turnAt(g, h)) * std::min(a, b);
  const double noise = kTextNoise * mesh.middle(narrow).cwiseAbs().maxCoeff();
  return off < noise ? Sliver{narrow, wide, off} : Sliver();
}

/// Joins those that are of no facet yet with the one that rounding turned them least against: never two
/// facets by what lies between them. Returns them.
std::vector<std::uint32_t> MeshFacets::joinSlivers(const std::vector<char>& joined,
                                                   DisjointSets& sets) const {
  std::vector<Sliver> best(mesh.triangles.size());
  forEachPair([&](std::uint32_t g, std::uint32_t h) {
    const Sliver sliver = sliverOf(g, h);
    if (sliver.triangle == kNobody || joined[sliver.triangle]) return;
    if (sliver.off < best[sliver.triangle].off) best[sliver.triangle] = sliver;
  });
  std::vector<std::uint32_t> out;
  for (const Sliver& sliver : best) {
    if (sliver.triangle == kNobody) continue;
    sets.join(sliver.triangle, sliver.beside);
    out.push_back(sliver.triangle);
  }
  return out;
}

/// Slivers have the normal of the facet that they are of.
void MeshFacets::straighten(const std::vector<std::uint32_t>& slivers, DisjointSets& sets) {
  if (slivers.empty()) return;
  std::vector<Vec3> sum(mesh.triangles.size(), Vec3::Zero());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) sum[sets.find(t)] += mesh.areaVector(t);
  for (const std::uint32_t t : slivers) {
    const Vec3& whole = sum[sets.find(t)];
    normals[t] = normals[sets.find(t)] = whole.normalized();
  }
}

double MeshFacets::widthOf(std::uint32_t facet, double length) const {
  return (triangles[facet] == 1 ? 2.0 : 1.0) * area[facet] / length;  // a strip's, a triangle's height
}

std::vector<Link> MeshFacets::links() const {
  std::vector<Link> out;
  std::size_t borders = 0;
  forEachPair(
      [&](std::uint32_t g, std::uint32_t h) { borders += facet_of[g / 3] != facet_of[h / 3] ? 1 : 0; });
  out.reserve(borders);
  forEachPair([&](std::uint32_t g, std::uint32_t h) {
    const std::uint32_t a = facet_of[g / 3], b = facet_of[h / 3];
    if (a == b) return;
    const Vec3 way = edge(g / 3, static_cast<int>(g % 3));
    out.push_back({std::min(a, b), std::max(a, b), way.norm(), turnAt(g, h), 0.0, 0.0, a < b ? way : -way});
  });
  std::stable_sort(out.begin(), out.end(),
                   [](const Link& l, const Link& m) { return std::pair(l.a, l.b) < std::pair(m.a, m.b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.size();) {  // a border of several edges is one
    Link sum = out[i];
    sum.turn *= sum.length;
    std::size_t j = i + 1;
    for (; j < out.size() && out[j].a == sum.a && out[j].b == sum.b; ++j) {
      sum.turn += out[j].turn * out[j].length;
      sum.length += out[j].length;
      sum.along += out[j].along;
    }
    sum.along.normalize();
    sum.turn /= sum.length;
    sum.width_a = widthOf(sum.a, sum.length);
    sum.width_b = widthOf(sum.b, sum.length);
    out[kept++] = sum;
    i = j;
  }
  out.resize(kept);
  return out;
}

}  // namespace proveout::shape_detail
