#include "core/tool/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/geometry/types.h"

namespace proveout {

namespace {

/// Share of the radius by which the ends of an arc may be further apart than twice its radius: rounded input.
constexpr double kArcSlack = 1e-9;
/// Sine of the angle up to which edges that bend inwards count as straight: rounding.
constexpr double kStraight = 1e-12;

Error wrongPoint(std::size_t index, std::string_view why) {
  return Error{ErrorKind::kInput, fmt::format("point {} of the profile {}", index + 1, why)};
}

/// Sets the centre of an arc that runs upwards and lies on the outer side (`bulge`) or the inner side of its
/// chord. Null, or what is wrong.
const char* placeCenter(OutlineEdge& e, double radius, bool bulge) {
  const double dr = e.br - e.ar, dz = e.bz - e.az, chord = std::hypot(dr, dz);
  if (chord > 2.0 * radius * (1.0 + kArcSlack))
    return "is too far from the one before for the radius of its arc";
  const double along = std::sqrt(std::max(0.0, radius * radius - 0.25 * chord * chord));
  // The inner side is to the left of the direction of travel.
  const double side = bulge ? along / chord : -along / chord;
  e.cr = 0.5 * (e.ar + e.br) - side * dz;
  e.cz = 0.5 * (e.az + e.bz) + side * dr;
  const double slack = kArcSlack * radius;
  const double a = bulge ? e.ar - e.cr : e.cr - e.ar, b = bulge ? e.br - e.cr : e.cr - e.br;
  if (a < -slack || b < -slack) return "ends an arc that turns back in height";
  return nullptr;
}

void addHollow(const OutlineEdge& e, double radius, std::vector<OutlineEdge>& edges) {
  const double chord = std::hypot(e.br - e.ar, e.bz - e.az);
  const double angle = 2.0 * std::asin(std::min(1.0, 0.5 * chord / radius));
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - kHollowArcToleranceMm / radius));
  const int count = std::clamp(static_cast<int>(std::ceil(angle / step)), 1, 2 * kMaxToolParts);
  const double start = std::atan2(e.az - e.cz, e.ar - e.cr);
  double r = e.ar, z = e.az;
  for (int i = 1; i <= count; ++i) {  // clockwise about the centre
    const double at = start - angle * i / count;
    const double br = i == count ? e.br : e.cr + radius * std::cos(at);
    const double bz = i == count ? e.bz : std::max(z, e.cz + radius * std::sin(at));
    edges.push_back({false, r, z, br, bz, 0.0, 0.0});
    r = br;
    z = bz;
  }
}

struct Direction {
  double r, z;
};

/// Unit direction of travel at the lower (or upper) end.
Direction direction(const OutlineEdge& e, bool upper) {
  const double r = e.arc ? e.cz - (upper ? e.bz : e.az) : e.br - e.ar;
  const double z = e.arc ? (upper ? e.br : e.ar) - e.cr : e.bz - e.az;
  const double length = std::hypot(r, z);
  return {r / length, std::max(0.0, z / length)};
}

/// Edges that one convex profile takes: those from first to last.
struct Run {
  std::size_t first, last;
  int elements = 0;
};

int elementsOf(const OutlineEdge& e) { return e.arc && e.az < e.cz && e.bz > e.cz ? 2 : 1; }

std::vector<Run> splitRuns(const std::vector<OutlineEdge>& edges) {
  constexpr int kMost = ConvexProfile::kMaxElements - 4;  // the rest lengthens and closes the profile
  std::vector<Run> runs;
  bool stepped = true;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const OutlineEdge& e = edges[i];
    if (e.az == e.bz) {  // a step has no volume of its own
      stepped = true;
      continue;
    }
    bool fresh = stepped || runs.back().elements + elementsOf(e) > kMost;
    if (!fresh) {
      const Direction in = direction(edges[i - 1], true), out = direction(e, false);
      fresh = in.r * out.z - in.z * out.r < -kStraight;
    }
    if (fresh) runs.push_back({i, i, 0});
    runs.back().last = i;
    runs.back().elements += elementsOf(e);
    stepped = false;
  }
  return runs;
}

/// Height up to which (down to which) the outline is nowhere narrower than at the run's upper (lower) end.
double wideAbove(const std::vector<OutlineEdge>& edges, const Run& run) {
  const double r = edges[run.last].br;
  std::size_t i = run.last + 1;
  while (i < edges.size() && edges[i].ar >= r && edges[i].br >= r) ++i;
  return edges[i - 1].bz;
}
double wideBelow(const std::vector<OutlineEdge>& edges, const Run& run) {
  const double r = edges[run.first].ar;
  std::size_t i = run.first;
  while (i > 0 && edges[i - 1].ar >= r && edges[i - 1].br >= r) --i;
  return edges[i].az;
}

/// How far the cone that closes a part may reach into its neighbour: convex with the part's own edge, which
/// leaves the end of radius r in the direction (outwards, away), and inside the neighbour, which is at least
/// as wide there and convex, and so holds the cone up to its own height.
double capReach(double r, double outwards, double away, double neighbour_height) {
  PROVEOUT_ASSERT(neighbour_height >= 0.0);
  double reach = 0.5 * neighbour_height;
  if (outwards > 0.0) reach = std::min(reach, 0.5 * r * away / outwards);
  return reach;
}

/// How two runs that meet overlap: the narrower one reaches into the other, of equal ones that which can
/// reach further.
struct Overlap {
  double down = 0.0;  ///< of the upper run below its lower end
  double up = 0.0;    ///< of the lower run above its upper end
};

Overlap overlap(const std::vector<OutlineEdge>& edges, const Run& lower, const Run& upper) {
  const OutlineEdge &below = edges[lower.last], &above = edges[upper.first];
  const Direction in = direction(below, true), out = direction(above, false);
  const double down = capReach(above.ar, out.r, out.z, below.bz - edges[lower.first].az);
  const double up = capReach(below.br, -in.r, in.z, edges[upper.last].bz - above.az);
  if (below.br > above.ar) return {down, 0.0};
  if (below.br < above.ar) return {0.0, up};
  return down >= up ? Overlap{down, 0.0} : Overlap{0.0, up};
}

/// The convex solid of a run. Where the run widens upwards it goes on as a cylinder as far as the outline
/// lets it, downwards the same: a column of the grid then meets few tall parts instead of a pile of thin
/// ones.
ConvexProfile runProfile(const std::vector<OutlineEdge>& edges, const Run& run, const Overlap& caps) {
  const OutlineEdge &first = edges[run.first], &last = edges[run.last];
  const double low = direction(first, false).r <= 0.0 ? wideBelow(edges, run) : first.az;
  const double high = direction(last, true).r >= 0.0 ? wideAbove(edges, run) : last.bz;
  ConvexProfile p;
  p.start(0.0, low < first.az ? low : first.az - caps.down);
  p.lineTo(first.ar, low);
  const auto vertical = [](const OutlineEdge& e) { return !e.arc && e.ar == e.br; };
  if (!vertical(first)) p.lineTo(first.ar, first.az);
  for (std::size_t i = run.first; i <= run.last; ++i) {
    const OutlineEdge& e = edges[i];
    if (i == run.last && vertical(e)) break;
    e.arc ? p.arcTo(e.cr, e.cz, e.br, e.bz) : p.lineTo(e.br, e.bz);
  }
  p.lineTo(last.br, high);
  p.lineTo(0.0, high > last.bz ? high : last.bz + caps.up);
  return p;
}

/// True for two equal cylinders: cores between the teeth of one comb.
bool sameCylinder(const ConvexProfile& a, const ConvexProfile& b) {
  const auto cylinder = [](const ConvexProfile& p) {
    return p.elementCount() == 3 && p.element(0).dz == 0.0 && p.element(1).dr == 0.0 &&
           p.element(2).dz == 0.0;
  };
  return cylinder(a) && cylinder(b) && a.maxRadius() == b.maxRadius() && a.zMin() == b.zMin() &&
         a.zMax() == b.zMax();
}

}  // namespace

Result<std::vector<OutlineEdge>> outlineEdges(const std::vector<OutlinePoint>& points) {
  if (points.size() < 2) return Error{ErrorKind::kInput, "the profile needs at least two points"};
  if (points.front().z != 0.0) return wrongPoint(0, "must have z = 0: the tip of the tool");
  if (points.front().arc_radius != 0.0) return wrongPoint(0, "cannot end an arc");
  std::vector<OutlineEdge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const OutlinePoint& p = points[i];
    if (!std::isfinite(p.r) || !std::isfinite(p.z) || !std::isfinite(p.arc_radius))
      return wrongPoint(i, "is not finite");
    const bool end = i == 0 || i + 1 == points.size();
    if (p.r < 0.0) return wrongPoint(i, "has a radius below 0");
    if (p.r == 0.0 && !end) return wrongPoint(i, "lies on the axis; only the first and the last may");
    if (i == 0) continue;
    const OutlinePoint& o = points[i - 1];
    if (p.z < o.z) return wrongPoint(i, "is lower than the one before; heights must not go down");
    if (p.z == o.z && p.r == o.r) return wrongPoint(i, "is the same as the one before");
    OutlineEdge e{p.arc_radius > 0.0, o.r, o.z, p.r, p.z, 0.0, 0.0};
    if (p.arc_radius != 0.0) {
      if (const char* why = placeCenter(e, std::abs(p.arc_radius), p.arc_radius > 0.0))
        return wrongPoint(i, why);
    }
    if (p.arc_radius < 0.0) {
      addHollow(e, -p.arc_radius, edges);
    } else {
      edges.push_back(e);
    }
  }
  if (points.back().z <= 0.0) return Error{ErrorKind::kInput, "the profile has no height"};
  if (const std::size_t parts = splitRuns(edges).size(); parts > kMaxToolParts) {
    return Error{ErrorKind::kInput,
                 fmt::format("the profile falls into more than {} convex parts", kMaxToolParts)};
  }
  return edges;
}

double outlineDiameter(const std::vector<OutlineEdge>& edges) {
  double radius = 0.0;
  for (const OutlineEdge& e : edges) {
    radius = std::max({radius, e.ar, e.br});
    if (elementsOf(e) == 2) radius = std::max(radius, e.cr + std::hypot(e.ar - e.cr, e.az - e.cz));
  }
  return 2.0 * radius;
}

std::vector<ConvexProfile> convexParts(const std::vector<OutlineEdge>& edges) {
  const std::vector<Run> runs = splitRuns(edges);
  std::vector<ConvexProfile> parts;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Overlap caps;
    if (i > 0) caps.down = overlap(edges, runs[i - 1], runs[i]).down;
    if (i + 1 < runs.size()) caps.up = overlap(edges, runs[i], runs[i + 1]).up;
    ConvexProfile p = runProfile(edges, runs[i], caps);
    const auto same = [&](const ConvexProfile& other) { return sameCylinder(p, other); };
    if (std::any_of(parts.begin(), parts.end(), same)) continue;
    p.setFirstElementId(static_cast<int>(i) * ConvexProfile::kMaxElements);
    parts.push_back(p);
  }
  return parts;
}

}  // namespace proveout
