#include "removal/sweep/column_way.h"

#include <cmath>

namespace proveout {

namespace {

/// Angle of a part.
constexpr double kPartRad = 0.25 * kPi;
/// Rounding of bounds that decide whether parts are made, and of reach, mm.
constexpr double kSlackMm = 1e-9;

/// Whether no column sees the part twice: the way bends less than the tool's rim. A way that leaves a disc
/// and bends less than its rim comes back to it behind half a turn at the least.
bool seenOnce(const CurveWay& way, int part, double tool_radius) {
  const double step = way.node_rad;
  const CurveWay::Node* node = &way.nodes[static_cast<std::size_t>(part * CurveWay::kNodesAPart)];
  if (way.u.z() == 0.0 && way.v.z() == 0.0) {
    const double a = way.radius + way.growth * part * CurveWay::kNodesAPart * step,
                 b = a + way.growth * CurveWay::kNodesAPart * step;
    const double r = std::min(std::abs(a), std::abs(b)), g = way.growth;
    return a * b > 0.0 && (r * r + 2.0 * g * g) * tool_radius < r * r * r;
  }
  double slowest = kNothing;
  for (int i = 0; i < CurveWay::kNodesAPart; ++i) {
    const double a = node[i].velocity.head<2>().norm(), b = node[i + 1].velocity.head<2>().norm();
    slowest = std::min(slowest, std::max(a, b) - 0.5 * step * way.most_bend);
  }
  return slowest > 0.0 && way.most_bend * tool_radius < slowest * slowest;
}

void setBounds(CurveWay& w) {
  const Vec2 u = w.u.head<2>(), v = w.v.head<2>();
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  // |u cos t + v sin t|^2 level is a constant and `swing` times a cosine of 2 t.
  const double swing = std::hypot(0.5 * (uu - vv), uv), out = std::sqrt(0.5 * (uu + vv) + swing);
  const double r = std::max(w.radius, w.radius + w.growth * w.way_rad), g = std::abs(w.growth);
  const double k = w.climb.head<2>().norm(), upright = std::hypot(w.u.z(), w.v.z());
  w.most_bend = r + 2.0 * g;
  w.still4 = swing * (16.0 * r * r + 64.0 * r * g + 48.0 * g * g) + 8.0 * out * r * k + 24.0 * out * g * k;
  w.far4 = 2.0 * out * (r + 4.0 * g);
  w.height4 = upright * (r + 4.0 * g);
}

CurveWay::Node nodeAt(const CurveWay& w, double rad, double c, double s) {
  const double r = w.radius + w.growth * rad;
  const Vec3 out = c * w.u + s * w.v, on = c * w.v - s * w.u;
  return {w.center + r * out + rad * w.climb, w.growth * out + r * on + w.climb,
          2.0 * w.growth * on - r * out, c, s};
}

}  // namespace

/// From the nearest node by the series of sine and cosine, which are exact there within rounding.
CurveWay::Node CurveWay::node(double rad) const {
  const double number = std::clamp(std::round(rad / node_rad), 0.0, static_cast<double>(nodes.size() - 1));
  const Node& near = nodes[static_cast<std::size_t>(number)];
  const double a = rad - number * node_rad, b = a * a;
  const double s = a * (1.0 + b * (-1.0 / 6 + b * (1.0 / 120 + b * (-1.0 / 5040 + b * (1.0 / 362880)))));
  const double c =
      1.0 + b * (-0.5 + b * (1.0 / 24 + b * (-1.0 / 720 + b * (1.0 / 40320 + b * (-1.0 / 3628800)))));
  return nodeAt(*this, rad, c * near.cosine - s * near.sine, s * near.cosine + c * near.sine);
}

CurveWay curveWay(const Vec3& from, const Vec3& to, const ArcGeometry& arc) {
  const ArcFrame frame = arcFrame(from, to, arc);
  CurveWay w;
  w.way_rad = std::abs(arc.sweep_rad);
  w.center = arc.center;
  w.u = frame.u;
  w.v = arc.sweep_rad < 0.0 ? Vec3(-frame.v) : frame.v;
  w.climb = frame.n * (frame.rise / w.way_rad);
  w.radius = frame.radius_start;
  w.growth = (frame.radius_end - frame.radius_start) / w.way_rad;
  const int parts = std::max(1, static_cast<int>(std::ceil(w.way_rad / kPartRad - 1e-9)));
  const int nodes = parts * CurveWay::kNodesAPart;
  w.node_rad = w.way_rad / nodes;
  w.nodes.reserve(static_cast<std::size_t>(nodes) + 1);
  for (int i = 0; i <= nodes; ++i) {
    const double rad = i * w.node_rad;
    w.nodes.push_back(nodeAt(w, rad, std::cos(rad), std::sin(rad)));
  }
  setBounds(w);
  return w;
}

std::vector<ColumnSweep> columnParts(const ColumnSolid& solid, const CurveWay& way) {
  std::vector<ColumnSweep> out;
  ColumnSweep s;
  s.kind = ColumnSweep::Kind::kWay;
  s.solid = &solid;
  s.way = &way;
  const double sag = way.height4 * way.node_rad * way.node_rad / 8.0 + kSlackMm;
  for (s.part = 0; s.part < way.parts(); ++s.part) {
    const CurveWay::Node* node = &way.nodes[static_cast<std::size_t>(s.part * CurveWay::kNodesAPart)];
    double low = kNothing, high = -kNothing;
    for (int i = 0; i <= CurveWay::kNodesAPart; ++i) {
      low = std::min(low, node[i].at.z());
      high = std::max(high, node[i].at.z());
    }
    s.x = node->at.x();
    s.y = node->at.y();
    s.z = low - sag;
    s.rise = high - low + 2.0 * sag;
    s.twice = !seenOnce(way, s.part, solid.radius);
    for (const bool again : {false, true}) {
      s.again = again;
      if (!again || s.twice) out.push_back(s);
    }
  }
  return out;
}

void wayReach(const ColumnSweep& part, const FourBlocks& blocks, double* low) {
  const CurveWay& way = *part.way;
  const ColumnSolid& tool = *part.solid;
  const CurveWay::Node* node = &way.nodes[static_cast<std::size_t>(part.part * CurveWay::kNodesAPart)];
  const double step2 = way.node_rad * way.node_rad / 8.0;
  const double sag = way.most_bend * step2, height_sag = way.height4 * step2;
  const double corner = std::sqrt(2.0) * blocks.half_width, reach = corner + tool.radius + sag + kCullSlackMm;
  double lowest[4] = {kNothing, kNothing, kNothing, kNothing};
  double highest[4] = {-kNothing, -kNothing, -kNothing, -kNothing};
  for (int k = 0; k < CurveWay::kNodesAPart; ++k) {
    const Vec3 &a = node[k].at, &b = node[k + 1].at;
    const double wx = b.x() - a.x(), wy = b.y() - a.y(), length2 = std::max(wx * wx + wy * wy, 1e-300);
    const double tip = std::min(a.z(), b.z()) - height_sag - kCullSlackMm;
    const double top = std::max(a.z(), b.z()) + height_sag + tool.z_max + kCullSlackMm;
    for (int i = 0; i < 4; ++i) {
      const double qx = blocks.x[i] - a.x(), qy = blocks.y[i] - a.y();
      const double t = std::clamp((qx * wx + qy * wy) / length2, 0.0, 1.0);
      const double dx = qx - t * wx, dy = qy - t * wy, gap2 = dx * dx + dy * dy;
      if (gap2 > reach * reach) continue;
      const double radial = std::clamp(std::sqrt(gap2) - corner - sag, 0.0, tool.radius);
      lowest[i] = std::min(lowest[i], tip + tool.lower.height(radial));
      highest[i] = std::max(highest[i], top);
    }
  }
  for (int i = 0; i < 4; ++i)
    low[i] = lowest[i] < blocks.z_high[i] && highest[i] > blocks.z_low[i] ? lowest[i] : kNothing;
}

}  // namespace proveout
