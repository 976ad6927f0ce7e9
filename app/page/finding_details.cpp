#include "app/page/finding_details.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel_for.h"

namespace proveout {

namespace {

constexpr std::size_t kMostDetails = 12;
/// Lines before and after the block's own.
constexpr std::uint32_t kLinesAround = 3;
/// Of larger meshes it is not looked whether something hides the place.
constexpr std::size_t kMostLookedAt = 1'500'000;

/// Does the mesh hide a place from an eye in that direction (unit)? What is nearer than `clear` hides
/// nothing. (T. Möller, B. Trumbore: Fast, minimum storage ray-triangle intersection, 1997)
bool isHidden(const TriMesh& mesh, const Vec3& place, const Vec3& direction, double clear) {
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>();
    const Vec3 edge1 = mesh.positions[t[1]].cast<double>() - a,
               edge2 = mesh.positions[t[2]].cast<double>() - a;
    const Vec3 p = direction.cross(edge2);
    const double det = edge1.dot(p);
    if (std::abs(det) < 1e-14) continue;
    const Vec3 s = place - a;
    const double u = s.dot(p) / det;
    if (u < 0.0 || u > 1.0) continue;
    const Vec3 q = s.cross(edge1);
    const double v = direction.dot(q) / det;
    if (v >= 0.0 && u + v <= 1.0 && edge2.dot(q) / det > clear) return true;
  }
  return false;
}

/// Mean normal of the mesh near a place, unit; +z where nothing is near.
Vec3 normalNear(const TriMesh& mesh, const Vec3& place, double reach) {
  Vec3 sum = Vec3::Zero();
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]].cast<double>(), b = mesh.positions[t[1]].cast<double>(),
               c = mesh.positions[t[2]].cast<double>();
    const double near = std::min({(a - place).norm(), (b - place).norm(), (c - place).norm()});
    if (near < reach) sum += (1.0 - near / reach) * (b - a).cross(c - a);
  }
  return sum.norm() > 0.0 ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

/// From where a finding is looked at: along the surface's normal, a little from above, or where nothing hides
/// it.
Vec3 eyeDirection(const TriMesh& mesh, const Finding& finding, double size) {
  if (mesh.triangles.size() > kMostLookedAt) return Vec3(1, -1.15, 1).normalized();
  const Vec3 normal = normalNear(mesh, *finding.where, 0.03 * size);
  std::vector<Vec3> around;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) around.push_back(Vec3(x, y, z).normalized());
      }
    }
  }
  std::stable_sort(around.begin(), around.end(),
                   [&](const Vec3& a, const Vec3& b) { return a.dot(normal) > b.dot(normal) + 1e-9; });
  std::vector<Vec3> tries{(normal + Vec3(0.25, -0.35, 0.35)).normalized(), normal};
  tries.insert(tries.end(), around.begin(), around.begin() + 12);
  for (const Vec3& direction : tries) {
    if (!isHidden(mesh, *finding.where + 2e-3 * size * normal, direction, 2e-3 * size)) return direction;
  }
  return tries.front();
}

void addLines(const RunResult& run, const RunSources& sources, const Finding& finding,
              FindingDetail& detail) {
  if (!finding.source || finding.source->line == 0) return;
  for (std::size_t k = 0; k < run.setups.size(); ++k) {
    if (run.setups[k].name != finding.setup || !sources[k]->has(finding.source->file)) continue;
    detail.own_line = finding.source->line;
    const std::uint32_t first = detail.own_line > kLinesAround ? detail.own_line - kLinesAround : 1;
    for (std::uint32_t n = first; n <= detail.own_line + kLinesAround; ++n)
      detail.lines.push_back({n, sources[k]->line(finding.source->file, n)});
    // Behind the end of the program there is nothing.
    while (detail.lines.back().number > detail.own_line && detail.lines.back().text.empty())
      detail.lines.pop_back();
    return;
  }
}

}  // namespace

Result<std::vector<FindingDetail>> findingDetails(const DrawCloseUp& draw, const TriMesh& mesh,
                                                  const std::vector<Finding>& findings, const RunResult* run,
                                                  const RunSources* sources) {
  std::vector<FindingDetail> details;
  for (std::size_t i = 0; i < findings.size() && details.size() < kMostDetails; ++i) {
    if (!findings[i].where && !findings[i].source) continue;
    FindingDetail& detail = details.emplace_back();
    detail.number = i + 1;
    if (run != nullptr) addLines(*run, *sources, findings[i], detail);
  }
  const double size = meshBounds(mesh).size().norm();
  std::vector<Vec3> eyes(details.size(), Vec3::UnitZ());
  parallelFor(std::size_t{0}, details.size(), [&](std::size_t i) {
    const Finding& finding = findings[details[i].number - 1];
    if (finding.where && finding.where->allFinite()) eyes[i] = eyeDirection(mesh, finding, size);
  });
  for (std::size_t i = 0; i < details.size(); ++i) {
    const Finding& finding = findings[details[i].number - 1];
    if (!finding.where || !finding.where->allFinite()) continue;
    const double side = std::sqrt(std::max(0.0, finding.area_mm2.value_or(0.0)));
    Result<std::string> png =
        draw(details[i].number, finding, eyes[i], std::clamp(5.0 * side, 0.15 * size, 0.6 * size));
    if (!png) return png.error();
    details[i].png = std::move(*png);
  }
  return details;
}

}  // namespace proveout
