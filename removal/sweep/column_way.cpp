#include "removal/sweep/column_way.h"

#include <cmath>

#include "removal/sweep/column_curve.h"

namespace proveout {

namespace {

/// Angle of a part.
constexpr double kPartRad = 0.125 * kPi;
/// Rounding of bounds that decide whether parts are made, and of reach, mm.
constexpr double kSlackMm = 1e-9;

/// Whether no column sees the part twice: the way bends less than the tool's rim. A way that leaves a disc
/// and bends less than its rim comes back to it behind half a turn at the least.
bool seenOnce(const CurveWay& way, int part, double tool_radius) {
  if (way.u.z() == 0.0 && way.v.z() == 0.0) {
    const double wide = CurveWay::kNodesAPart * way.node_rad, a = way.radius + way.growth * part * wide,
                 b = a + way.growth * wide;
    const double r = std::min(std::abs(a), std::abs(b)), g = way.growth;
    return a * b > 0.0 && (r * r + 2.0 * g * g) * tool_radius < r * r * r;
  }
  const WayPart& plain = way.plain[static_cast<std::size_t>(part)];
  const double turned = plain.curvature * plain.speed * 2.0 * plain.half;
  return plain.curvature * tool_radius < 1.0 && turned < kPi;
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

/// Places at which a part's curvatures are looked at; what lies between two is as far off them as they are
/// from each other at most.
constexpr int kLooks = 33;

/// Of a place: curvature of the way as seen from above, and second derivative of the height by the level way.
Vec2 bendsOf(const CurveWay::Node& n) {
  const Vec2 v = n.velocity.head<2>(), a = n.bend.head<2>();
  const double speed2 = std::max(v.squaredNorm(), 1e-12), speed = std::sqrt(speed2);
  return {std::abs(v.x() * a.y() - v.y() * a.x()) / (speed2 * speed),
          (n.bend.z() - n.velocity.z() * v.dot(a) / speed2) / speed2};
}

/// Bounds of a part's bends, with what they may change between the places.
void boundPart(const CurveWay& w, double first, double wide, WayPart& out) {
  double curved = 0.0, sag = kNoHeight, step_curved = 0.0, step_sag = 0.0;
  Vec2 before;
  for (int i = 0; i < kLooks; ++i) {
    const CurveWay::Node n = w.node(first + wide * i / (kLooks - 1));
    const Vec2 bends = bendsOf(n), at = n.at.head<2>() - Vec2(out.x, out.y);
    if (i > 0) {
      step_curved = std::max(step_curved, std::abs(bends.x() - before.x()));
      step_sag = std::max(step_sag, std::abs(bends.y() - before.y()));
    }
    before = bends;
    curved = std::max(curved, bends.x()), sag = std::min(sag, bends.y());
    out.reach = std::max(out.reach, at.norm());
    out.speed = std::max(out.speed, n.velocity.head<2>().norm());
    out.least_bend = std::min(out.least_bend, n.bend.z());
    out.most_bend = std::max(out.most_bend, n.bend.z());
  }
  const double step = wide / (kLooks - 1), step2 = step * step / 8.0;
  out.reach += w.most_bend * step2;
  out.speed += 0.5 * w.most_bend * step;
  out.least_bend -= w.height4 * step2, out.most_bend += w.height4 * step2;
  out.curvature = curved + step_curved;
  out.sag = sag - step_sag;
}

WayPart plainPart(const CurveWay& w, int part) {
  const CurveWay::Node* node = &w.nodes[static_cast<std::size_t>(part * CurveWay::kNodesAPart)];
  constexpr int kMiddle = CurveWay::kNodesAPart / 2;
  const CurveWay::Node& middle = node[kMiddle];
  const double first = part * CurveWay::kNodesAPart * w.node_rad, wide = CurveWay::kNodesAPart * w.node_rad;
  const Vec3 u = middle.cosine * w.u + middle.sine * w.v, v = middle.cosine * w.v - middle.sine * w.u;
  WayPart out{};
  out.x = middle.at.x(), out.y = middle.at.y(), out.z = middle.at.z();
  out.ux = u.x(), out.uy = u.y(), out.uz = u.z();
  out.vx = v.x(), out.vy = v.y(), out.vz = v.z();
  out.kx = w.climb.x(), out.ky = w.climb.y(), out.kz = w.climb.z();
  out.radius = w.radius + w.growth * (first + 0.5 * wide);
  out.growth = w.growth;
  out.half = 0.5 * wide;
  out.least_bend = kNoHeight, out.most_bend = -kNoHeight;
  for (int i = 0; i < 3; ++i) {
    const Vec3 at = node[i * kMiddle].at - middle.at, &velocity = node[i * kMiddle].velocity;
    out.end_x[i] = at.x(), out.end_y[i] = at.y();
    out.end_vx[i] = velocity.x(), out.end_vy[i] = velocity.y();
  }
  boundPart(w, first, wide, out);
  return out;
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
  for (int part = 0; part < w.parts(); ++part) w.plain.push_back(plainPart(w, part));
  return w;
}

bool hasPlainEnds(const ColumnSolid& solid) {
  const ColumnBoundary& lower = solid.lower;
  const ColumnBoundary::Piece &first = lower.piece[0], &last = lower.piece[lower.count - 1];
  const bool level = first.kind == ColumnBoundary::Kind::kLevel,
             arc = last.kind == ColumnBoundary::Kind::kArc;
  if (solid.round_top) return false;
  return lower.count == 1 ? level || (arc && last.rc == 0.0)
                          : lower.count == 2 && level && arc && last.rc == last.ra;
}

std::vector<WaySweep> columnParts(const ColumnSolid& solid, const CurveWay& way) {
  std::vector<WaySweep> out;
  WaySweep s;
  s.solid = &solid;
  s.way = &way;
  const double sag = way.height4 * way.node_rad * way.node_rad / 8.0 + kSlackMm;
  for (s.part = 0; s.part < way.parts(); ++s.part) {
    s.plain = &way.plain[static_cast<std::size_t>(s.part)];
    const CurveWay::Node* node = &way.nodes[static_cast<std::size_t>(s.part * CurveWay::kNodesAPart)];
    double low = kNoHeight, high = -kNoHeight;
    for (int i = 0; i <= CurveWay::kNodesAPart; ++i) {
      low = std::min(low, node[i].at.z());
      high = std::max(high, node[i].at.z());
    }
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

void curveReach(const WaySweep& part, const FourBlocks& blocks, double* low, double* high) {
  const CurveWay& way = *part.way;
  const ColumnSolid& tool = *part.solid;
  const CurveWay::Node* node = &way.nodes[static_cast<std::size_t>(part.part * CurveWay::kNodesAPart)];
  const double step2 = way.node_rad * way.node_rad / 8.0;
  const double sag = way.most_bend * step2, height_sag = way.height4 * step2;
  const double corner = std::sqrt(2.0) * blocks.half_width, reach = corner + tool.radius + sag + kCullSlackMm;
  double lowest[4] = {kNoHeight, kNoHeight, kNoHeight, kNoHeight};
  double highest[4] = {-kNoHeight, -kNoHeight, -kNoHeight, -kNoHeight};
  for (int k = 0; k < CurveWay::kNodesAPart; ++k) {
    const Vec3 &a = node[k].at, &b = node[k + 1].at;
    const double wx = b.x() - a.x(), wy = b.y() - a.y(), length2 = std::max(wx * wx + wy * wy, 1e-300);
    const double tip = std::min(a.z(), b.z()) - height_sag - kCullSlackMm;
    const double top = std::max(a.z(), b.z()) + height_sag + kCullSlackMm;
    for (int i = 0; i < 4; ++i) {
      const double qx = blocks.x[i] - a.x(), qy = blocks.y[i] - a.y();
      const double t = std::clamp((qx * wx + qy * wy) / length2, 0.0, 1.0);
      const double dx = qx - t * wx, dy = qy - t * wy, gap2 = dx * dx + dy * dy;
      if (gap2 > reach * reach) continue;
      const double radial = std::clamp(std::sqrt(gap2) - corner - sag, 0.0, tool.radius);
      lowest[i] = std::min(lowest[i], tip + tool.lower.height(radial));
      highest[i] = std::max(highest[i], top - tool.upper.height(radial));
    }
  }
  for (int i = 0; i < 4; ++i) {
    const bool in = lowest[i] < blocks.z_high[i] && highest[i] > blocks.z_low[i];
    low[i] = in ? lowest[i] : kNoHeight;
    high[i] = in ? highest[i] : -kNoHeight;
  }
}

}  // namespace proveout
