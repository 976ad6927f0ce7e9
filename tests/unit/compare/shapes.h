// Solids whose distances, areas and volumes are known in closed form.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>

#include "core/mesh/signed_distance.h"
#include "core/mesh/tri_mesh.h"

namespace proveout::shapes {

/// Solid made of the filled cells of a rectilinear grid: plates with pits, bosses, walls. Vertices are
/// shared.
inline TriMesh blocks(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<double>& z, const std::function<bool(int, int, int)>& filled) {
  TriMesh mesh;
  const std::array<int, 3> cells = {static_cast<int>(x.size()) - 1, static_cast<int>(y.size()) - 1,
                                    static_cast<int>(z.size()) - 1};
  const auto isFilled = [&](std::array<int, 3> c) {
    for (int a = 0; a < 3; ++a) {
      if (c[a] < 0 || c[a] >= cells[a]) return false;
    }
    return filled(c[0], c[1], c[2]);
  };
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto vertex = [&](std::array<int, 3> c) {
    const auto [it, is_new] = vertices.try_emplace(c, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(Vec3(x[c[0]], y[c[1]], z[c[2]]).cast<float>());
    return it->second;
  };
  for (int i = 0; i < cells[0]; ++i) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int k = 0; k < cells[2]; ++k) {
        if (!isFilled({i, j, k})) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (int up = 0; up < 2; ++up) {
            std::array<int, 3> beyond = {i, j, k};
            beyond[axis] += up ? 1 : -1;
            if (isFilled(beyond)) continue;
            std::array<std::uint32_t, 4> q;
            for (int corner = 0; corner < 4; ++corner) {
              std::array<int, 3> c = {i, j, k};
              c[axis] += up;
              c[(axis + 1) % 3] += corner == 1 || corner == 2;
              c[(axis + 2) % 3] += corner >= 2;
              q[corner] = vertex(c);
            }
            if (!up) std::swap(q[1], q[3]);
            mesh.triangles.push_back({q[0], q[1], q[2]});
            mesh.triangles.push_back({q[0], q[2], q[3]});
          }
        }
      }
    }
  }
  return mesh;
}

inline TriMesh box(const Vec3& lo, const Vec3& hi) {
  return blocks({lo.x(), hi.x()}, {lo.y(), hi.y()}, {lo.z(), hi.z()}, [](int, int, int) { return true; });
}

/// Octahedron split `levels` times, on a sphere about `center`.
inline TriMesh sphere(const Vec3& center, double radius, int levels) {
  std::vector<Vec3> p = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<std::uint32_t, 3>> t = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                 {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int l = 0; l < levels; ++l) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto mid = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, is_new] = middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(p.size()));
      if (is_new) p.push_back((p[a] + p[b]).normalized());
      return it->second;
    };
    std::vector<std::array<std::uint32_t, 3>> next;
    for (const auto& v : t) {
      const auto a = mid(v[0], v[1]), b = mid(v[1], v[2]), c = mid(v[2], v[0]);
      next.insert(next.end(), {{v[0], a, c}, {a, v[1], b}, {c, b, v[2]}, {a, b, c}});
    }
    t = std::move(next);
  }
  TriMesh mesh;
  for (const Vec3& q : p) mesh.positions.push_back((center + radius * q).cast<float>());
  mesh.triangles = t;
  return mesh;
}

inline TriMesh together(const TriMesh& a, const TriMesh& b) {
  TriMesh m = a;
  const auto n = static_cast<std::uint32_t>(a.positions.size());
  m.positions.insert(m.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles) m.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return m;
}

inline TriMesh insideOut(TriMesh m) {
  for (auto& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

inline SurfaceMesh surface(const TriMesh& mesh) {
  SurfaceMesh s;
  for (const auto& p : mesh.positions) s.points.push_back(p.cast<double>());
  s.triangles = mesh.triangles;
  return s;
}

/// How often the mesh winds around a point: 1 inside, 0 outside. Solid angles after A. van Oosterom and J.
/// Strackee.
inline double windingNumber(const SurfaceMesh& mesh, const Vec3& q) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]] - q, b = mesh.points[t[1]] - q, c = mesh.points[t[2]] - q;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2.0 * kPi);
}

}  // namespace proveout::shapes
