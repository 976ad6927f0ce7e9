// Crests that a tool leaves between its passes: their height, and the roughness that they are.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel_for.h"
#include "removal/compare/part/part_probe.h"

namespace proveout {
namespace {

constexpr double kLeastRidge = 0.2 * kPi / 180.0;
constexpr std::size_t kMostRidges = 60'000, kMostProfiles = 600;
/// Points at which Ra is taken from valley to valley.
constexpr int kProfilePoints = 65;

/// Mean distance from its mean of a parabola of height 1: what arcs with a height far below their radius are.
const double kParabolaRa = 4.0 / (9.0 * std::sqrt(3.0));

/// Where two passes of one tool meet.
struct Ridge {
  Vec3 p = Vec3::Zero(), up = Vec3::UnitZ(), across = Vec3::UnitX();
  double half_turn = 0.0;  ///< between `up` and the normals to both sides
  Pass pass;
  SurfaceMaker maker;
  double likely = 0.0;  ///< height, as of a ball of that diameter
};

std::optional<Ridge> ridgeAt(const MeasuredPart& part, const MeshEdge& edge) {
  const double step = 0.05 * part.spacing_mm, reach = 2.0 * part.spacing_mm;
  const Vec3 side = edge.normal.cross(edge.along).normalized();
  const std::optional<SurfacePoint> middle = surfaceNear(*part.exact, edge.middle, reach);
  if (!middle) return std::nullopt;
  // The edge of the mesh is not just where the passes meet: to either side until they are apart.
  for (double s = step; s <= 16.0 * step; s *= 2.0) {
    const auto a = surfaceNear(*part.exact, middle->p - s * side, reach);
    const auto b = surfaceNear(*part.exact, middle->p + s * side, reach);
    if (!a || !b) return std::nullopt;
    if (a->maker == b->maker || (b->p - a->p).dot(b->normal - a->normal) <= 0.0) continue;
    if (a->maker.motion == kNoMotion || b->maker.motion == kNoMotion) return std::nullopt;
    Ridge out;
    out.pass = part.pass(a->maker);
    if (part.pass(b->maker).tool != out.pass.tool || !(out.pass.diameter_mm > 0.0)) return std::nullopt;
    const Vec3 sum = a->normal + b->normal;
    if (sum.norm() < 0.1) return std::nullopt;
    out.up = sum.normalized();
    const Vec3 along = a->normal.cross(b->normal);
    out.across = out.up.cross(along.norm() > 1e-6 ? along.normalized() : edge.along).normalized();
    out.half_turn = 0.5 * std::atan2(along.norm(), a->normal.dot(b->normal));
    out.p = 0.5 * (a->p + b->p);
    out.maker = a->maker;
    out.likely = 0.5 * out.pass.diameter_mm * (1.0 - std::cos(out.half_turn));
    return out;
  }
  return std::nullopt;
}

/// The surface over a line across a ridge.
class Profile {
 public:
  Profile(const ExactPart& part, const Ridge& ridge) : part_(part), ridge_(ridge) {}

  /// Height at `u` across, looked for about `near`: from `above` higher down to `below` lower.
  std::optional<double> at(double u, double near, double above, double below) const {
    const Vec3 foot = ridge_.p + u * ridge_.across;
    const Vec3 outside = foot + (near + above) * ridge_.up, inside = foot + (near - below) * ridge_.up;
    const std::optional<double> share = crossingBetween(part_, outside, inside);
    if (!share) return std::nullopt;
    return near + above - *share * (above + below);
  }

 private:
  const ExactPart& part_;
  const Ridge& ridge_;
};

struct Valley {
  double u = 0.0, height = 0.0;
};

/// The lowest place to one side of the ridge, before the surface rises again.
std::optional<Valley> valleyFrom(const Profile& profile, const Ridge& ridge, double top, double sign) {
  const double most = ridge.pass.diameter_mm;
  const double slope = std::tan(std::min(ridge.half_turn, 1.4)) + 0.02;
  double step = std::clamp(0.5 * most * std::sin(ridge.half_turn) / 24.0, 1e-4, most / 32.0);
  Valley low{0.0, top};
  double before = top;
  for (double u = step; u <= most; u += step) {
    const double room = 2.0 * step * slope + 1e-4;
    const std::optional<double> height = profile.at(sign * u, before, room, room);
    if (!height || *height > low.height + 1e-6) {
      // What rises steeply is a wall; what falls away is no valley. By thirds to the lowest place.
      if (!height && !profile.at(sign * u, before, most, room)) return std::nullopt;
      double from = std::max(0.0, std::abs(low.u) - step), to = u;
      for (int round = 0; round < 40 && to - from > 1e-6; ++round) {
        const double a = from + (to - from) / 3.0, b = to - (to - from) / 3.0;
        const std::optional<double> at_a = profile.at(sign * a, low.height, room, room);
        const std::optional<double> at_b = profile.at(sign * b, low.height, room, room);
        if (at_a && *at_a < low.height) low = {sign * a, *at_a};
        if (at_b && *at_b < low.height) low = {sign * b, *at_b};
        if (at_b && (!at_a || *at_a > *at_b)) {
          from = a;
        } else {
          to = b;
        }
      }
      return low.height < top - 1e-7 ? std::optional<Valley>(low) : std::nullopt;
    }
    if (*height < low.height) low = {sign * u, *height};
    before = *height;
    if (top - before > most) return std::nullopt;
    step *= 1.03;
  }
  return std::nullopt;
}

struct Crest {
  CrestSample sample;
  double ra_um = 0.0;
};

/// Mean distance of the profile from its mean line between two valleys, micrometres.
double roughnessOf(const Profile& profile, const Valley& left, const Valley& right, double top) {
  std::array<double, kProfilePoints> y{};
  const double width = right.u - left.u;
  const double deep = top - std::min(left.height, right.height);
  for (int k = 0; k < kProfilePoints; ++k) {
    const double u = left.u + width * (k + 0.5) / kProfilePoints;
    const std::optional<double> height = profile.at(u, top, 1e-4 + 0.1 * deep, 1.5 * deep + 1e-3);
    if (!height) return 0.0;
    y[static_cast<std::size_t>(k)] = *height;
  }
  // Mean line by least squares over equal steps.
  double mean = 0.0, moment = 0.0, square = 0.0;
  for (const double v : y) mean += v / kProfilePoints;
  for (int k = 0; k < kProfilePoints; ++k) {
    const double x = k - 0.5 * (kProfilePoints - 1);
    moment += x * y[static_cast<std::size_t>(k)];
    square += x * x;
  }
  double sum = 0.0;
  for (int k = 0; k < kProfilePoints; ++k) {
    const double x = k - 0.5 * (kProfilePoints - 1);
    sum += std::abs(y[static_cast<std::size_t>(k)] - mean - moment / square * x);
  }
  return 1e3 * sum / kProfilePoints;
}

std::optional<Crest> crestAt(const MeasuredPart& part, const Ridge& ridge) {
  const Profile profile(*part.exact, ridge);
  // The top: to either side of where the passes were found to meet.
  const double wide = 0.2 * part.spacing_mm;
  double best_u = 0.0, top = -1e300;
  for (int k = -8; k <= 8; ++k) {
    const double u = wide * k / 8.0;
    const std::optional<double> height = profile.at(u, 0.0, 2.0 * wide, 2.0 * wide);
    if (height && *height > top) top = *height, best_u = u;
  }
  if (top < -1e299) return std::nullopt;
  for (double step = wide / 8.0; step > 1e-6; step *= 0.5) {
    for (const double u : {best_u - step, best_u + step}) {
      const std::optional<double> height = profile.at(u, top, 2.0 * step, 4.0 * step);
      if (height && *height > top) top = *height, best_u = u;
    }
  }
  Ridge moved = ridge;
  moved.p += best_u * ridge.across + top * ridge.up;
  const Profile own(*part.exact, moved);
  const std::optional<Valley> left = valleyFrom(own, moved, 0.0, -1.0);
  const std::optional<Valley> right = valleyFrom(own, moved, 0.0, 1.0);
  if (!left || !right) return std::nullopt;
  const double width = right->u - left->u, rise = right->height - left->height;
  const double line = left->height - left->u * rise / width;
  Crest crest;
  crest.sample = {moved.p, -line * width / std::hypot(width, rise), width};
  if (crest.sample.height_mm > 0.5 * ridge.pass.diameter_mm) return std::nullopt;  // a rib
  crest.ra_um = roughnessOf(own, *left, *right, 0.0);
  return crest;
}

std::vector<Ridge> ridgesOf(const MeasuredPart& part, const PartRule& rule, const Progress& progress) {
  std::vector<MeshEdge> edges = turningEdges(part.mesh, kLeastRidge, rule);
  std::erase_if(edges, [](const MeshEdge& edge) {
    return edge.turn_rad < 0.0 || edge.left_motion == edge.right_motion || edge.left_motion == kNoMotion ||
           edge.right_motion == kNoMotion;
  });
  const std::size_t each = edges.size() / kMostRidges + 1;
  std::vector<std::optional<Ridge>> found((edges.size() + each - 1) / each);
  parallelFor(std::size_t{0}, found.size(), [&](std::size_t k) {
    if (!progress.cancelled()) found[k] = ridgeAt(part, edges[k * each]);
  });
  std::vector<Ridge> out;
  for (const std::optional<Ridge>& ridge : found)
    if (ridge) out.push_back(*ridge);
  return out;
}

/// Marks of a lathe's feed: the highest of those that left surface.
void addFeedMarks(const MeasuredPart& part, const PartRule& rule, PartFeature& out) {
  const TriMesh& mesh = part.mesh;
  std::uint32_t last = kNoMotion;
  for (std::size_t t = 0; t < mesh.motion.size(); ++t) {
    if (mesh.motion[t] == kNoMotion || mesh.motion[t] == last) continue;
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t v : mesh.triangles[t]) middle += mesh.positions[v].cast<double>() / 3.0;
    if (!isIn(rule, middle)) continue;
    last = mesh.motion[t];
    const SurfaceMaker maker{SurfaceMaker::kLastSetup, last};
    const double mark = part.pass(maker).feed_mark_mm;
    const double value = out.quantity == Quantity::kScallop ? mark : 1e3 * kParabolaRa * mark;
    if (mark <= 0.0 || (out.measured && *out.measured >= value)) continue;
    out.measured = value;
    out.where = middle;
    out.maker = maker;
  }
}

}  // namespace

void measureCrests(const MeasuredPart& part, const PartRule& rule, Progress& progress, PartFeature& out) {
  addFeedMarks(part, rule, out);
  if (part.exact == nullptr) return;
  progress.report("measuring crests", 0.0);
  std::vector<Ridge> ridges = ridgesOf(part, rule, progress);
  std::stable_sort(ridges.begin(), ridges.end(),
                   [](const Ridge& a, const Ridge& b) { return a.likely > b.likely; });
  // The likeliest, and of the others as many again.
  if (ridges.size() > kMostProfiles) {
    const std::size_t each = ridges.size() / (kMostProfiles / 2) + 1;
    std::vector<Ridge> fewer(ridges.begin(), ridges.begin() + kMostProfiles / 2);
    for (std::size_t k = kMostProfiles / 2; k < ridges.size(); k += each) fewer.push_back(ridges[k]);
    ridges = std::move(fewer);
  }
  std::vector<std::optional<Crest>> crests(ridges.size());
  parallelFor(std::size_t{0}, ridges.size(), [&](std::size_t k) {
    if (!progress.cancelled()) crests[k] = crestAt(part, ridges[k]);
  });
  for (std::size_t k = 0; k < crests.size(); ++k) {
    if (!crests[k]) continue;
    out.crests.push_back(crests[k]->sample);
    const bool height = out.quantity == Quantity::kScallop;
    const double value = height ? crests[k]->sample.height_mm : crests[k]->ra_um;
    if (out.measured && *out.measured >= value) continue;
    out.measured = value;
    out.where = crests[k]->sample.where;
    out.maker = ridges[k].maker;
  }
}

}  // namespace proveout
