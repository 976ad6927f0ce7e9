#include "removal/compare/features/face_network.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/mesh/edge_table.h"

namespace proveout {
namespace {

/// The normal of a face near an edge of its mesh: of its surface, or of the triangle where that is not known.
Vec3 normalNear(const TriMesh& mesh, const CadFaces& faces, std::uint32_t triangle, const Vec3& p) {
  if (const CadFace* face = faces.exactAt(triangle)) return face->normalAt(p);
  const auto& t = mesh.triangles[triangle];
  const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
             c = mesh.positions[t[2]].cast<double>();
  return (b - a).cross(c - a).normalized();
}

}  // namespace

FaceNetwork::FaceNetwork(const TriMesh& mesh, const CadFaces& faces, double smooth_rad)
    : mesh_(mesh),
      faces_(faces),
      borders_(faces.faces.size()),
      corners_(faces.faces.size()),
      area_(faces.faces.size(), 0.0),
      middle_(faces.faces.size(), Vec3::Zero()) {
  gatherFaces();
  gatherBorders(smooth_rad);
}

void FaceNetwork::gatherFaces() {
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    const std::uint32_t f = faces_.of_triangle[t];
    if (f == kNoFace) continue;
    const Vec3 a = point(mesh_.triangles[t][0]), b = point(mesh_.triangles[t][1]),
               c = point(mesh_.triangles[t][2]);
    const double area = 0.5 * (b - a).cross(c - a).norm();
    area_[f] += area;
    middle_[f] += area / 3.0 * (a + b + c);
    corners_[f].insert(corners_[f].end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
  }
  for (std::size_t f = 0; f < size(); ++f) {
    std::vector<std::uint32_t>& own = corners_[f];
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    if (area_[f] > 0.0) middle_[f] /= area_[f];
  }
}

void FaceNetwork::gatherBorders(double smooth_rad) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, FaceBorder> all;  // lengths until they are divided
  EdgeTable(mesh_.positions.size(), mesh_.triangles)
      .forEachEdge([&](std::uint32_t, const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2) return;
        const std::uint32_t s = first[0].half_edge / 3, t = first[1].half_edge / 3;
        const std::uint32_t a = faces_.of_triangle[s], b = faces_.of_triangle[t];
        if (a == b || a == kNoFace || b == kNoFace) return;
        const std::uint32_t corner = first[0].half_edge % 3;
        const Vec3 from = point(mesh_.triangles[s][corner]),
                   edge = point(mesh_.triangles[s][(corner + 1) % 3]) - from, middle = from + 0.5 * edge;
        const double length = edge.norm();
        const Vec3 n = normalNear(mesh_, faces_, s, middle), m = normalNear(mesh_, faces_, t, middle);
        FaceBorder& border = all[{std::min(a, b), std::max(a, b)}];
        border.length_mm += length;
        border.middle += length * middle;
        const Vec3 turn = n.cross(m);
        if (std::atan2(turn.norm(), n.dot(m)) <= smooth_rad) return;
        (turn.dot(edge) > 0.0 ? border.convex : border.concave) += length;
      });
  for (auto& [pair, border] : all) {
    if (!(border.length_mm > 0.0)) continue;
    border.middle /= border.length_mm;
    border.convex /= border.length_mm;
    border.concave /= border.length_mm;
    border.other = pair.second;
    borders_[pair.first].push_back(border);
    border.other = pair.first;
    borders_[pair.second].push_back(border);
  }
  for (std::vector<FaceBorder>& own : borders_)
    std::sort(own.begin(), own.end(),
              [](const FaceBorder& a, const FaceBorder& b) { return a.other < b.other; });
}

const FaceBorder* FaceNetwork::border(std::uint32_t a, std::uint32_t b) const {
  const std::vector<FaceBorder>& own = borders_[a];
  const auto found = std::lower_bound(
      own.begin(), own.end(), b, [](const FaceBorder& border, std::uint32_t f) { return border.other < f; });
  return found == own.end() || found->other != b ? nullptr : &*found;
}

FaceNetwork::Range FaceNetwork::along(std::uint32_t f, const Vec3& from, const Vec3& direction) const {
  Range out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const std::uint32_t corner : corners_[f]) {
    const double at = (point(corner) - from).dot(direction);
    out.low = std::min(out.low, at);
    out.high = std::max(out.high, at);
  }
  return out;
}

}  // namespace proveout
