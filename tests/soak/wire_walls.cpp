// The part that a wire leaves against the distance of points to the wire, as a straight line at each share of
// each motion: nothing here knows how the part was made.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "app/session/run/blank.h"
#include "core/mesh/shells.h"
#include "core/mesh/tri_mesh.h"
#include "tests/soak/laws.h"

namespace proveout::soak {
namespace {

/// Beyond what the facets are off, mm.
constexpr double kWithin = 0.0005;

Vec2 pointOf(const WireTrack& track, double share) {
  if (track.sweep_rad == 0.0) return track.from + share * (track.to - track.from);
  const double c = std::cos(share * track.sweep_rad), s = std::sin(share * track.sweep_rad);
  const Vec2 arm = track.from - track.center;
  return track.center + Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y());
}

/// Of a point from the middle of the wire at a share of its motion, mm.
double distanceAt(const WireSweep& wire, double share, const Vec3& p) {
  const Vec2 low = pointOf(wire.lower, share), high = pointOf(wire.upper, share);
  const Vec2 slope = (high - low) / (wire.z_high - wire.z_low);
  const Vec2 d = p.head<2>() - low - slope * (p.z() - wire.z_low);
  const double along = d.dot(slope);
  return std::sqrt(std::max(0.0, d.squaredNorm() - along * along / (1.0 + slope.squaredNorm())));
}

/// The least distance during a motion: from where it is least of some shares by thirds.
double distanceTo(const WireSweep& wire, const Vec3& p) {
  constexpr int kShares = 24;
  std::array<double, kShares + 1> at{};
  for (int k = 0; k <= kShares; ++k)
    at[static_cast<std::size_t>(k)] = distanceAt(wire, k * (1.0 / kShares), p);
  double least = *std::min_element(at.begin(), at.end());
  for (int k = 0; k <= kShares; ++k) {
    const double here = at[static_cast<std::size_t>(k)];
    if (k > 0 && at[static_cast<std::size_t>(k - 1)] < here) continue;
    if (k < kShares && at[static_cast<std::size_t>(k + 1)] < here) continue;
    double low = std::max(0, k - 1) * (1.0 / kShares), high = std::min(kShares, k + 1) * (1.0 / kShares);
    for (int round = 0; round < 40; ++round) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (distanceAt(wire, a, p) < distanceAt(wire, b, p) ? high : low) =
          distanceAt(wire, a, p) < distanceAt(wire, b, p) ? b : a;
    }
    least = std::min(least, distanceAt(wire, 0.5 * (low + high), p));
  }
  return least;
}

/// The cuts of a run, each with half the width of its kerf.
struct Cut {
  const WireSweep* wire;
  double kerf;
  Vec2 middle;
  double reach;  ///< all of the motion is within it about the middle
};

std::vector<Cut> cutsOf(const SetupRun& setup) {
  const Toolpath& path = setup.interpreted.path;
  std::vector<Cut> cuts;
  for (const Motion& motion : path.motions) {
    if (motion.wire < 0 || motion.kind == MotionKind::kRapid) continue;
    const WireSweep& wire = path.wires[static_cast<std::size_t>(motion.wire)];
    const Tool& tool = setup.job.tools.front();
    Cut cut{&wire, 0.5 * tool.diameter + tool.spark_gap, pointOf(wire.lower, 0.5), 0.0};
    for (const WireTrack* track : {&wire.lower, &wire.upper}) {
      const double radius = track->sweep_rad == 0.0 ? 0.0 : 2.0 * (track->from - track->center).norm();
      for (const Vec2& end : {track->from, track->to})
        cut.reach = std::max(cut.reach, (end - cut.middle).norm() + radius);
    }
    cuts.push_back(cut);
  }
  return cuts;
}

/// Above 0 inside of the blank: of a point from its walls, mm.
double depthIn(const StockShape& blank, const Vec3& p) {
  if (const auto* box = std::get_if<BoxShape>(&blank))
    return std::min((p - box->min).head<2>().minCoeff(), (box->max - p).head<2>().minCoeff());
  const auto& bar = std::get<CylinderShape>(blank);
  const double radius = (p - bar.base).head<2>().norm();
  return std::min(bar.radius - radius, bar.inner_radius > 0.0 ? radius - bar.inner_radius : bar.radius);
}

class Walls {
 public:
  Walls(const StockShape& blank, const SetupRun& setup) : blank_(blank), cuts_(cutsOf(setup)) {}

  /// Half width of the widest kerf, mm.
  double kerf() const {
    double most = 0.0;
    for (const Cut& cut : cuts_) most = std::max(most, cut.kerf);
    return most;
  }
  /// Above 0 in the material that is left: the distance to the nearest wall.
  double materialAt(const Vec3& p) const {
    double least = depthIn(blank_, p);
    for (const Cut& cut : cuts_) {
      if ((p.head<2>() - cut.middle).norm() - cut.reach - cut.kerf > least) continue;
      least = std::min(least, distanceTo(*cut.wire, p) - cut.kerf);
    }
    return least;
  }

 private:
  const StockShape& blank_;
  std::vector<Cut> cuts_;
};

bool coveredAt(const TriMesh& mesh, const Vec3& p) {
  const auto side = [&](const Vec3& a, const Vec3& b) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  };
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const Vec3 a = mesh.positions[t[0]].template cast<double>(),
               b = mesh.positions[t[1]].template cast<double>(),
               c = mesh.positions[t[2]].template cast<double>();
    for (const Vec3* v : {&a, &b, &c}) {
      if (std::abs(v->z() - p.z()) > 1e-4) return false;
    }
    const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  });
}

std::optional<std::string> verticesOnWalls(const Walls& walls, const TriMesh& mesh, double within) {
  const std::size_t step = std::max<std::size_t>(1, mesh.positions.size() / 2000);
  for (std::size_t i = 0; i < mesh.positions.size(); i += step) {
    const Vec3 p = mesh.positions[i].cast<double>();
    const double off = walls.materialAt(p);
    if (std::abs(off) > within)
      return fmt::format("a vertex is {:.5f} mm off all walls at X{:.3f} Y{:.3f} Z{:.3f}", off, p.x(), p.y(),
                         p.z());
  }
  return std::nullopt;
}

/// The shells of a mesh: those of pieces that fell while the program went on, which later cuts do not reach,
/// and the others.
struct Fallen {
  TriMesh fallen, others;
};
/// Crumbs, which fall untold, are counted among them.
Fallen fallenOf(const TriMesh& mesh, const std::vector<FallenPiece>& fallen, double z_low, double crumb_mm3) {
  Fallen out;
  for (const TriMesh& one : shellMeshes(splitShells(mesh))) {
    const bool fell = meshVolume(one) < crumb_mm3 ||
                      std::any_of(fallen.begin(), fallen.end(), [&](const FallenPiece& piece) {
                        return coveredAt(one, Vec3(piece.where.x(), piece.where.y(), z_low));
                      });
    append(fell ? out.fallen : out.others, one);
  }
  return out;
}

/// Points of the lower and the upper face.
std::optional<std::string> facesAreWhatIsLeft(const Walls& walls, const Fallen& mesh, const Box3& bounds,
                                              double within, std::uint64_t seed) {
  constexpr int kPoints = 200;
  Random random(seed);
  for (int k = 0; k < kPoints; ++k) {
    const Vec3 p(random.number(bounds.min.x(), bounds.max.x()), random.number(bounds.min.y(), bounds.max.y()),
                 k % 2 == 0 ? bounds.min.z() : bounds.max.z());
    const double material = walls.materialAt(p);
    if (std::abs(material) < within) continue;
    if (coveredAt(mesh.fallen, p)) continue;
    if (coveredAt(mesh.others, p) != (material > 0.0))
      return fmt::format("X{:.3f} Y{:.3f} Z{:.3f} is {:.5f} mm {} the part's walls, which the mesh denies",
                         p.x(), p.y(), p.z(), std::abs(material),
                         material > 0.0 ? "inside of" : "outside of");
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> wallsBesideTheWire(const LawCase& c) {
  if (!c.runner.made().cutsWithWire()) return std::nullopt;
  std::string error;
  const Job job = c.runner.load("job.toml", error);
  Progress progress;
  const auto blank = openBlank(job, progress);
  if (!blank) return blank.error().message;
  const SetupRun& setup = c.whole.setups.back();
  const Walls walls(blank->shape, setup);
  const double within = kWithin + setup.facet_error_mm;
  const Fallen mesh = fallenOf(setup.surface.mesh, setup.removal.fallen, blank->bounds.min.z(),
                               kPi * walls.kerf() * walls.kerf() * blank->bounds.size().z());
  if (const auto broken = verticesOnWalls(walls, mesh.others, within)) return broken;
  return facesAreWhatIsLeft(walls, mesh, blank->bounds, within, c.runner.made().seed);
}

}  // namespace proveout::soak
