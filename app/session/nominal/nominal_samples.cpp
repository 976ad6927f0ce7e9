#include "app/session/nominal/nominal_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace proveout {

namespace {

struct Facet {
  Vec3 a, u, v;  ///< a corner and the sides from there
  double area;
};

/// Of a facet, the share that lies in a box, about: where its bounds lie in it.
double shareIn(const Facet& f, const Box3& box) {
  Box3 own;
  for (const Vec3& p : {f.a, Vec3(f.a + f.u), Vec3(f.a + f.v)}) own.extend(p);
  double share = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double size = own.max[k] - own.min[k];
    const double common = std::min(own.max[k], box.max[k]) - std::max(own.min[k], box.min[k]);
    if (common < 0.0) return 0.0;
    if (size > 0.0) share *= std::min(1.0, common / size);
  }
  return share;
}

/// A sequence that fills the unit square evenly (generalized golden ratio; M. Roberts, "The unreasonable
/// effectiveness of quasirandom sequences", 2018).
Vec2 spread(std::size_t k) {
  constexpr double kGolden = 1.32471795724474602596;
  const double i = static_cast<double>(k) + 0.5;
  Vec2 out(i / kGolden, i / (kGolden * kGolden));
  return out - out.array().floor().matrix();
}

bool holds(const Box3& box, const Vec3& p) { return box.overlaps({p, p}); }

}  // namespace

std::vector<Vec3> nominalSamples(const TriMesh& mesh, const Box3& box, std::size_t most) {
  std::vector<Facet> facets;
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const std::array<Vec3, 3> at{mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
                                 mesh.positions[t[2]].cast<double>()};
    Facet f{at[0], at[1] - at[0], at[2] - at[0], 0.0};
    f.area = 0.5 * f.u.cross(f.v).norm() * shareIn(f, box);
    if (!(f.area > 0.0)) continue;
    sum += f.area;
    facets.push_back(f);
  }
  std::vector<Vec3> out;
  if (facets.empty()) return out;
  // A point for each share of the area; those that fall outside of the box are tried again a few times.
  const double share = sum / static_cast<double>(most);
  double due = 0.5 * share;
  std::size_t k = 0;
  for (const Facet& f : facets) {
    due += f.area;
    for (; due >= share; due -= share) {
      constexpr int kTries = 32;
      for (int i = 0; i < kTries; ++i) {
        Vec2 uv = spread(k++);
        if (uv.sum() > 1.0) uv = Vec2(1.0, 1.0) - uv;
        const Vec3 p = f.a + uv.x() * f.u + uv.y() * f.v;
        if (!holds(box, p)) continue;
        out.push_back(p);
        break;
      }
    }
  }
  return out;
}

}  // namespace proveout
