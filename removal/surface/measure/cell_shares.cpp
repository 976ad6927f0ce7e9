#include "removal/surface/measure/cell_shares.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "removal/cut/cut_record.h"
#include "removal/grid/blank_field.h"
#include "removal/surface/cell/cell_cycles.h"
#include "removal/surface/measure/quad_volume.h"

namespace proveout {

namespace {

/// How often a part is halved before it is cut by the tangent plane: where one face lies in it, and where
/// several meet.
constexpr int kPlaneDepth = 4, kMostDepth = 5;
/// Distance from the middle of a cube to its corners, by its edge.
constexpr double kRadius = 0.8660254037844387;
/// Normals are made to lean from the planes of the axes by at least this, as the formula divides by it.
constexpr double kLean = 1e-3;

/// The distance to a helix takes as long as this many to lines.
constexpr std::size_t kAsksOfACurve = 20;

/// The part of a unit cube that lies under a plane, `height` above its middle; `n`: unit normal.
double shareUnder(double height, const Vec3& n) {
  const Vec3 a = n.cwiseAbs().cwiseMax(kLean);
  const double from_lowest = height + 0.5 * a.sum();
  if (from_lowest <= 0.0) return 0.0;
  if (from_lowest >= a.sum()) return 1.0;
  double sum = 0.0;  // cubes of what is left behind each corner, with their signs
  for (int corner = 0; corner < 8; ++corner) {
    double rest = from_lowest, sign = 1.0;
    for (int k = 0; k < 3; ++k) {
      if (corner >> k & 1) rest -= a[k], sign = -sign;
    }
    if (rest > 0.0) sum += sign * rest * rest * rest;
  }
  return std::clamp(sum / (6.0 * a.prod()), 0.0, 1.0);
}

/// As SweptField::sample, but also inside with the distance to a tangent plane, found by probing from
/// outside.
SweepSample samplePlane(const SweptField& sweep, const Vec3& p, double reach) {
  SweepSample s = sweep.sample(p);
  if (s.value >= 0.0) return s;
  const Vec3 out = reach * s.gradient;
  s = sweep.sample(p + out);
  s.value -= s.gradient.dot(out);
  return s;
}

/// Six times the volume between the origin and a triangle is their determinant.
double cone(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)) / 6.0; }

/// From the middle of the cell.
Vec3 placeOf(int corner) { return Vec3(corner & 1, corner >> 1 & 1, corner >> 2) - Vec3::Constant(0.5); }

int axisBetween(int a, int b) { return std::countr_zero(static_cast<unsigned>(a ^ b)); }
int edgeBetween(int a, int b) { return edgeAt(axisBetween(a, b), a & b); }
/// The number that an edge in a wall across `axis` has in the cell behind it.
int seenFromBeyond(int edge, int axis) { return edgeAt(edge / 4, edgeStartCorner(edge) ^ 1 << axis); }

Coord stepped(const Coord& from, int corner) {
  return from.offsetBy(corner & 1, corner >> 1 & 1, corner >> 2);
}

}  // namespace

std::optional<double> CellMaterial::share(const Vec3& low) {
  const Vec3 middle = low + Vec3::Constant(0.5 * impl_.h);
  sweeps_.clear();
  impl_.cut->cutters().collect(middle, kRadius * impl_.h, sweeps_);
  if (sweeps_.empty()) return std::nullopt;
  kept_.resize(sweeps_.size());
  for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = static_cast<std::uint16_t>(i);
  return shareOf({middle, impl_.h, 0, true}, 0, kept_.size());
}

/// `begin` to `end`: the bodies in kept_ that may reach the part.
double CellMaterial::shareOf(Part part, std::size_t begin, std::size_t end) {
  const double radius = kRadius * part.edge;
  if (part.at_blank) {
    const double off = impl_.cut_blank->value(part.middle);
    if (off >= radius) return 0.0;
    part.at_blank = off > -radius;
  }
  double sum = 0.0;
  bool swept = false;
  for (std::size_t i = begin; i < end && !swept; ++i) {
    asked_ += sweeps_[kept_[i]].isSlow() ? kAsksOfACurve : 1;
    const double off = sweeps_[kept_[i]].distance(part.middle, radius);
    swept = off <= -radius;
    if (off < radius) kept_.push_back(kept_[i]);
  }
  const std::size_t faces = kept_.size() - end + (part.at_blank ? 1 : 0);
  if (!swept && faces == 0) sum = 1.0;
  if (!swept && faces > 0) {
    if (part.depth == kMostDepth || (faces == 1 && part.depth >= kPlaneDepth)) {
      sum = cutByPlanes(part, end);
    } else {
      const std::size_t kept = kept_.size();
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 middle = part.middle + 0.5 * part.edge * placeOf(corner);
        sum += 0.125 * shareOf({middle, 0.5 * part.edge, part.depth + 1, part.at_blank}, end, kept);
      }
    }
  }
  kept_.resize(end);
  return sum;
}

/// Of several faces, the one that leaves least material stands for all.
double CellMaterial::cutByPlanes(const Part& part, std::size_t begin) const {
  double least = 1.0;
  for (std::size_t i = begin; i < kept_.size(); ++i) {
    const SweepSample s = samplePlane(sweeps_[kept_[i]], part.middle, kRadius * part.edge);
    least = std::min(least, shareUnder(s.value / part.edge, s.gradient));
  }
  if (part.at_blank) {
    const BlankSample s = impl_.cut_blank->sample(part.middle);
    least = std::min(least, shareUnder(-s.value / part.edge, s.normal));
  }
  return least;
}

/// The sum of cones from the middle of the cell: to the material parts of its walls, and to its own pieces
/// of the quads, which are triangles of a crossing, the vertex of the cell, and the point where the line to
/// the vertex of the next cell goes through the wall.
double CellUnderSurface::share(const Coord& cell) {
  cell_ = cell;
  const std::optional<std::uint32_t> number = grid_.cellAt(cell);
  if (!number) return read_.isMaterial(cell) ? 1.0 : 0.0;
  shape_ = grid_.shape(*number);
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, far = 1 << axis;
    sum += wall({0, v, u | v, u}, axis, -1) + wall({far, far | u, far | u | v, far | v}, axis, 1);
  }
  for (int edge = 0; edge < 12; ++edge) {
    const int start = edgeStartCorner(edge);
    if (isIn(start) != isIn(start | 1 << edge / 4)) sum += 0.25 * bulge(edge);
  }
  return sum;
}

/// `corners`: counter-clockwise from outside.
double CellUnderSurface::wall(const Corners& corners, int axis, int side) const {
  if (std::all_of(corners.begin(), corners.end(), [&](int c) { return isIn(c); })) return 1.0 / 6.0;
  // A joined face is all material but for what the surface cuts off at the other corners.
  const bool joined = isJoined(shape_, axis, side > 0 ? 1 : 0);
  const auto isOfPiece = [&](int i) { return isIn(corners[i % 4]) != joined; };
  double sum = 0.0;
  for (int from = 0; from < 4; ++from) {
    if (!isOfPiece(from) || isOfPiece(from + 3)) continue;
    int to = from;
    while (isOfPiece(to + 1)) ++to;
    sum += pieceAtWall(corners, from, to, axis, side);
  }
  return joined ? 1.0 / 6.0 - sum : sum;
}

/// `from` to `to`: a run of neighbouring corners that are all in material, or all not; the corners before
/// and after it are the opposite.
double CellUnderSurface::pieceAtWall(const Corners& corners, int from, int to, int axis, int side) const {
  const int before = corners[(from + 3) % 4], start = corners[from];
  const Vec3 first = crossing(before, start), last = crossing(corners[to % 4], corners[(to + 1) % 4]);
  double sum = 0.0;
  Vec3 at = placeOf(start);
  for (int i = from + 1; i <= to; ++i) {
    const Vec3 next = placeOf(corners[i % 4]);
    sum += cone(first, at, next);
    at = next;
  }
  sum += cone(first, at, last);
  const int edge = edgeBetween(before, start);
  std::array<int, 3> step{};
  step[static_cast<std::size_t>(axis)] = side;
  const Vec3 own = vertex(cell_, edge),
             other = vertex(cell_.offsetBy(step[0], step[1], step[2]), seenFromBeyond(edge, axis));
  const double way = other[axis] - own[axis];
  const double part = way != 0.0 ? std::clamp((0.5 * side - own[axis]) / way, 0.0, 1.0) : 0.5;
  const Vec3 through = own + part * (other - own);
  return sum + cone(last, through, first) + cone(own, through, last) + cone(own, first, through);
}

/// By how much the surface bulges out of the triangles around a crossed edge; a quarter belongs to each
/// cell.
double CellUnderSurface::bulge(int edge) const {
  const int axis = edge / 4, u = (axis + 1) % 3, v = (axis + 2) % 3, start = edgeStartCorner(edge);
  const Coord at = stepped(cell_, start);
  const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(read_.state(at & ~7))];
  const int number = leaf.edges.indexOf(axis, at.x() & 7, at.y() & 7, at.z() & 7);
  Quad quad;
  QuadReader::readCrossing(axis, start & 1, start >> 1 & 1, start >> 2,
                           leaf.stock->crossings[static_cast<std::size_t>(number)], quad);
  quad.middle -= Vec3::Constant(0.5);
  unsigned smooth_corners = 0;
  for (int i = 0; i < 4; ++i) {
    const auto& back = kRing[isIn(start) ? i : 3 - i];
    std::array<int, 3> step{};
    step[static_cast<std::size_t>(u)] = -back[0];
    step[static_cast<std::size_t>(v)] = -back[1];
    bool smooth = false;
    quad.p[static_cast<std::size_t>(i)] =
        vertex(at.offsetBy(step[0], step[1], step[2]), edgeAt(axis, back[0] << u | back[1] << v), &smooth);
    if (smooth) smooth_corners |= 1u << i;
  }
  return quadVolume(quad.p, quad.middle, quad.normal, quad.middle, smooth_corners).volume;
}

/// The crossing of the edge between two corners, from the middle of the cell.
Vec3 CellUnderSurface::crossing(int from, int to) const {
  const int axis = axisBetween(from, to), start = from & to;
  Vec3 p = placeOf(start);
  p[axis] += grid_.crossingOn(axis, stepped(cell_, start));
  return p;
}

/// The vertex of a cell's sheet that crosses an edge of it, from the middle of the own cell. `smooth`:
/// receives whether a smooth face runs through the cell.
Vec3 CellUnderSurface::vertex(const Coord& cell, int edge, bool* smooth) const {
  const SurfaceLeaf& leaf = grid_.leaves()[static_cast<std::size_t>(read_.state(cell & ~7))];
  const std::uint32_t number = leaf.cellAt((cell.z() & 7) << 6 | leafBit(cell.x() & 7, cell.y() & 7));
  if (smooth != nullptr) *smooth = (grid_.traits(number) & CellTraits::kSmooth) != 0;
  Eigen::Vector3f p = grid_.vertex(number);
  const int sheet = cellCycles(grid_.shape(number)).cycle_of_edge[static_cast<std::size_t>(edge)];
  if (sheet > 0) {
    for (const ExtraVertex& extra : leaf.extra) {
      if (extra.cell == number - leaf.base && extra.sheet == sheet) p = extra.p;
    }
  }
  return p.cast<double>() + stepsBetween(cell_, leaf.stock->origin) - Vec3::Constant(0.5);
}

}  // namespace proveout
