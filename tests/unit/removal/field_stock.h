// Stocks filled from closed forms: exact signs, exact crossings, exact normals. What the surface is tested
// against, without the removal engine.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <vector>

#include "removal/grid/stock_impl.h"

namespace proveout::test {

/// A solid at a point: distance (negative in material; its slope is at most 1), and the face that is nearest
/// with its normal out of the material.
struct FieldSample {
  double value = 0.0;
  Vec3 normal = Vec3::UnitZ();
  std::uint32_t face = 0;
};
using Field = std::function<FieldSample(const Vec3&)>;

inline Field halfSpace(const Vec3& point, const Vec3& normal, std::uint32_t face) {
  const Vec3 n = normal.normalized();
  return [=](const Vec3& p) { return FieldSample{n.dot(p - point), n, face}; };
}
inline Field sphere(const Vec3& center, double radius, std::uint32_t face) {
  return [=](const Vec3& p) {
    return FieldSample{(p - center).norm() - radius, (p - center).normalized(), face};
  };
}
/// Endless, along `axis`.
inline Field cylinder(const Vec3& base, const Vec3& axis, double radius, std::uint32_t face) {
  const Vec3 a = axis.normalized();
  return [=](const Vec3& p) {
    const Vec3 q = p - base, off = q - a * a.dot(q);
    return FieldSample{off.norm() - radius, off.normalized(), face};
  };
}
/// Endless, opening along -axis from the apex; `half_angle` in radians.
inline Field cone(const Vec3& apex, const Vec3& axis, double half_angle, std::uint32_t face) {
  const Vec3 a = axis.normalized();
  return [=](const Vec3& p) {
    const Vec3 q = p - apex, off = q - a * a.dot(q);
    const double r = off.norm();
    const Vec3 n = (r > 0.0 ? Vec3(off / r) : Vec3(a.unitOrthogonal())) * std::cos(half_angle) +
                   a * std::sin(half_angle);
    return FieldSample{n.dot(q), n, face};
  };
}
inline Field torus(const Vec3& center, const Vec3& axis, double large, double small, std::uint32_t face) {
  const Vec3 a = axis.normalized();
  return [=](const Vec3& p) {
    const Vec3 q = p - center, off = q - a * a.dot(q);
    const Vec3 from = q - off.normalized() * large;
    return FieldSample{from.norm() - small, from.normalized(), face};
  };
}
inline Field both(const Field& a, const Field& b) {
  return [=](const Vec3& p) {
    const FieldSample sa = a(p), sb = b(p);
    return sa.value >= sb.value ? sa : sb;
  };
}
inline Field either(const Field& a, const Field& b) {
  return [=](const Vec3& p) {
    const FieldSample sa = a(p), sb = b(p);
    return sa.value <= sb.value ? sa : sb;
  };
}
inline Field without(const Field& a, const Field& b) {
  return [=](const Vec3& p) {
    const FieldSample sa = a(p), sb = b(p);
    return sa.value >= -sb.value ? sa : FieldSample{-sb.value, -sb.normal, sb.face};
  };
}
/// Faces `face` .. `face` + 5. `turn`: about the centre of the box.
inline Field box(const Vec3& min, const Vec3& max, std::uint32_t face,
                 const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  const Vec3 center = 0.5 * (min + max), half = 0.5 * (max - min);
  return [=](const Vec3& p) {
    const Vec3 q = turn.transpose() * (p - center);
    FieldSample best;
    best.value = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < 6; ++i) {
      const double value = (i & 1 ? q[i / 2] : -q[i / 2]) - half[i / 2];
      if (value > best.value) {
        best = {value, turn * (Vec3::Unit(i / 2) * (i & 1 ? 1.0 : -1.0)),
                face + static_cast<std::uint32_t>(i)};
      }
    }
    return best;
  };
}

namespace field_detail {

inline Crossing crossingOn(const Field& field, const Vec3& start, const Vec3& end, bool start_in) {
  double in = start_in ? 0.0 : 1.0, out = 1.0 - in;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (in + out);
    (field(start + (end - start) * middle).value < 0.0 ? in : out) = middle;
  }
  const double t = 0.5 * (in + out);
  const FieldSample s = field(start + (end - start) * t);
  Crossing c;
  c.setPosition(t);
  c.setNormal(s.normal);
  c.motion = s.face;
  return c;
}

inline void addCrossings(const Stock::Impl& impl, const Field& field, StockLeaf& leaf) {
  const LeafReader reader(impl);
  const LeafEdges edges = reader.edges(leaf);
  for (int axis = 0; axis < 3; ++axis) {
    for (int z = 0; z < 8; ++z) {
      for (std::uint64_t rest = edges.crossed[axis][z]; rest != 0; rest &= rest - 1) {
        const int bit = std::countr_zero(rest);
        const Coord at = leaf.origin.offsetBy(bit >> 3, bit & 7, z);
        Coord next = at;
        ++next[axis];
        leaf.crossings.push_back(crossingOn(field, impl.position(at), impl.position(next),
                                            leafSample(leaf.material(), bit >> 3, bit & 7, z)));
      }
    }
  }
}

}  // namespace field_detail

/// Fills `impl` with the solid, which must lie inside `bounds` (mm). The grid of spacing h (mm) has a point
/// at `origin`.
inline void fillStock(Stock::Impl& impl, const Field& field, const Box3& bounds, double h,
                      const Vec3& origin) {
  impl.h = h;
  impl.origin = origin;
  impl.blank = bounds;
  makeTree(impl);
  Coord low, high;
  for (int i = 0; i < 3; ++i) {
    low[i] = static_cast<int>(std::floor((bounds.min[i] - origin[i]) / h / 8.0)) - 1;
    high[i] = static_cast<int>(std::floor((bounds.max[i] - origin[i]) / h / 8.0)) + 1;
  }
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        if (!impl.tree.holds(Coord(x, y, z))) continue;
        const Coord first(x * 8, y * 8, z * 8);
        const FieldSample middle = field(impl.position(first) + Vec3::Constant(4.0 * h));
        if (std::abs(middle.value) > 4.5 * 1.7321 * h) {
          if (middle.value < 0.0) impl.tree.setUniform(Coord(x, y, z), true);
          continue;
        }
        LeafBits samples{};
        int inside = 0;
        for (int i = 0; i < 729; ++i) {
          const int sx = i / 81, sy = i / 9 % 9, sz = i % 9;
          if (field(impl.position(first.offsetBy(sx, sy, sz))).value >= 0.0) continue;
          ++inside;
          if (sx < 8 && sy < 8 && sz < 8) samples[sz] |= 1ull << leafBit(sx, sy);
        }
        if (inside > 0 && inside < 729) *addLeaf(impl, first).samples = samples;
        if (inside == 729) impl.tree.setUniform(Coord(x, y, z), true);
      }
    }
  }
  orderLeaves(impl);
  for (StockLeaf& leaf : impl.leaves) field_detail::addCrossings(impl, field, leaf);
}

}  // namespace proveout::test
