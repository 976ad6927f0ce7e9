#include "app/session/nominal/placement_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/session/nominal/nominal_samples.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace proveout {
namespace {

constexpr std::size_t kPoints = 600, kFirstPoints = 60;
constexpr double kMost = 0.6;          ///< share of the nominal that agrees where it is said to belong there
constexpr double kPromising = 0.45;     ///< of the first points, before all are asked
constexpr double kLeastSize = 0.3;     ///< of the part's longest side: less fits anywhere
constexpr double kSlack = 1.01;        ///< a nominal is no larger than its part
constexpr double kBetter = 0.02;       ///< of Agreement::off: by so much another place must be better than a nearer one

/// Of points of the nominal with the part's surface.
struct Agreement {
  double share = 0.0;  ///< of those that lie on it
  double off = 1.0;    ///< mean distance, as a part of what counts as lying on it; farther ones count 1
};

class Judge {
 public:
  Judge(const TriMesh& nominal, const TriMesh& part, double within_mm)
      : samples_(nominalSamples(nominal, meshBounds(nominal), kPoints)), tree_(toSurface(part)), within_(within_mm) {}

  Agreement all(const MeshPlacement& at) const { return of(at, 1); }
  bool promising(const MeshPlacement& at) const {
    return of(at, std::max<std::size_t>(1, samples_.size() / kFirstPoints)).share >= kPromising;
  }

 private:
  Agreement of(const MeshPlacement& at, std::size_t step) const {
    const RigidTransform motion = at.motion();
    double asked = 0.0, near = 0.0, off = 0.0;
    for (std::size_t k = 0; k < samples_.size(); k += step) {
      asked += 1.0;
      const auto found = tree_.nearest(motion(at.scale * samples_[k]), TriangleTree::kNone, within_);
      const bool is_near = found.triangle != TriangleTree::kNone && found.squared <= within_ * within_;
      near += is_near ? 1.0 : 0.0;
      off += is_near ? std::sqrt(found.squared) / within_ : 1.0;
    }
    return asked > 0.0 ? Agreement{near / asked, off / asked} : Agreement{};
  }

  std::vector<Vec3> samples_;
  TriangleTree tree_;
  double within_;
};

/// People write few decimals: the roundest number that is as good.
double rounded(double value, double within_mm) {
  for (const double unit : {1.0, 0.1, 0.01}) {
    const double round = unit * std::round(value / unit);
    if (std::abs(round - value) <= 0.1 * within_mm) return round + 0.0;
  }
  return value;
}

/// Moves that bring two sides, or the middles, together along each axis.
std::vector<Vec3> movesOnto(const Box3& body, const Box3& part, double within_mm) {
  const auto along = [&](int k) {
    std::vector<double> out;
    for (const double move : {part.min[k] - body.min[k], part.max[k] - body.max[k], part.center()[k] - body.center()[k],
                              0.0}) {
      const double value = rounded(move, within_mm);
      const auto same = [&](double other) { return std::abs(other - value) <= 0.2 * within_mm; };
      if (std::none_of(out.begin(), out.end(), same)) out.push_back(value);
    }
    return out;
  };
  std::vector<Vec3> out;
  for (const double x : along(0))
    for (const double y : along(1))
      for (const double z : along(2)) out.emplace_back(x, y, z);
  std::stable_sort(out.begin(), out.end(), [](const Vec3& a, const Vec3& b) { return a.norm() < b.norm(); });
  return out;
}

/// How many keys of a job say it.
int entriesOf(const MeshPlacement& change) {
  return (change.scale != 1.0 ? 1 : 0) + (change.rotate_deg.isZero(0.0) ? 0 : 1) + (change.move.isZero(0.0) ? 0 : 1);
}

bool mayFit(const Box3& body, const Box3& part) {
  const Vec3 size = body.size(), most = kSlack * part.size();
  return (size.array() <= most.array()).all() && size.maxCoeff() >= kLeastSize * part.size().maxCoeff();
}

std::string percent(double share) { return fmt::format("{:.0f} %", std::floor(100.0 * share)); }

std::string boundsText(const Box3& b) {
  return fmt::format("X{:g} Y{:g} Z{:g} to X{:g} Y{:g} Z{:g}", b.min.x(), b.min.y(), b.min.z(), b.max.x(), b.max.y(),
                     b.max.z());
}

/// The share of a box that lies in another.
double commonShare(const Box3& box, const Box3& other) {
  const Vec3 common = box.max.cwiseMin(other.max) - box.min.cwiseMax(other.min);
  if (!(common.minCoeff() > 0.0)) return 0.0;
  return (common.array() / box.size().array()).prod();
}

constexpr const char* kElsewhere = "the nominal does not lie where the part does, and is not compared: ";

/// What to enter, in a job or on the command line.
std::string entries(const MeshPlacement& given, const MeshPlacement& change, MeshUnit unit) {
  const std::string options = placementOptions(given, change);
  return fmt::format("enter {} under [nominal]{}", placementKeys(given, change, unit),
                     options.empty() ? options : " (" + options + ")");
}

/// A change of the unit alone, with what moves it back, that brings bounds onto others.
std::optional<MeshPlacement> otherUnit(const Box3& own, const Box3& wanted) {
  const auto evident = evidentPlacement(own, wanted);
  return evident && evident->scale != 1.0 ? evident : std::nullopt;
}

}  // namespace

std::optional<FoundPlacement> searchPlacement(const TriMesh& nominal, const TriMesh& part, double within_mm) {
  const Judge judge(nominal, part, within_mm);
  const Box3 own = meshBounds(nominal), wanted = meshBounds(part);
  FoundPlacement found;
  Agreement best = judge.all({});
  found.before = best.share;
  for (const double factor : kUnitFactors) {
    for (const Vec3& turn : quarterTurns()) {
      MeshPlacement change{factor, turn, Vec3::Zero()};
      const Box3 turned = placedBounds(change, own);
      if (!mayFit(turned, wanted)) continue;
      for (const Vec3& move : movesOnto(turned, wanted, within_mm)) {
        change.move = move;
        if (!judge.promising(change)) continue;
        const Agreement agreement = judge.all(change);
        const bool simpler = agreement.off <= best.off + kBetter && entriesOf(change) < entriesOf(found.change);
        if (agreement.off >= best.off - kBetter && !(simpler && !found.change.none())) continue;
        best = agreement;
        found.change = change;
      }
    }
  }
  found.after = best.share;
  if (found.change.none() || found.after < kMost || 1.0 - found.after > 0.5 * (1.0 - found.before)) return std::nullopt;
  return found;
}

PlacementFault placementFault(const TriMesh& nominal, const MeshPlacement& given, MeshUnit unit,
                              const PartSpace& space) {
  constexpr double kOut = 0.01;    // of its size: less may be a blank that was sawn short
  constexpr double kWithin = 0.5;  // of its bounds: of less lies where there was material
  const Box3 own = meshBounds(nominal), part = meshBounds(space.part), room = space.blank.value_or(part);
  if (boundsAgree(own, part)) return {};
  const double out = std::max((room.min - own.min).maxCoeff(), (own.max - room.max).maxCoeff());
  const bool outside = out > kOut * own.size().maxCoeff();
  auto evident = evidentPlacement(own, part);
  const bool onto_part = evident.has_value();
  if (!evident && outside) evident = evidentPlacement(own, room);
  if (!evident && !boundsAgree(own, room)) evident = otherUnit(own, room);
  PlacementFault fault;
  fault.rescaled = evident && evident->scale != 1.0;
  const bool turned = evident && !evident->rotate_deg.isZero(0.0);
  if (outside || turned || fault.rescaled || !space.blank) {
    const auto found = searchPlacement(nominal, space.part, space.within_mm);
    const bool moved_alone = found && found->change.scale == 1.0 && found->change.rotate_deg.isZero(0.0);
    if (found && !(space.clamped_again && moved_alone)) {
      fault.comparable = false;
      fault.rescaled = found->change.scale != 1.0;
      fault.text = fmt::format("{}{} it would lie on the part with {} of its surface (now {}); {}", kElsewhere,
                               placementText(found->change, unit), percent(found->after), percent(found->before),
                               entries(given, found->change, unit));
      return fault;
    }
  }
  fault.comparable = !fault.rescaled && !(outside && (turned || commonShare(own, room) < kWithin));
  const double told_mm = space.blank ? space.within_mm : kOut * own.size().maxCoeff();
  if (out > told_mm) {
    fault.text = fmt::format("reaches {:.4g} mm out of the {} ({})", out, space.blank ? "blank" : "part", boundsText(own));
  } else if (fault.rescaled) {
    fault.text = fmt::format("is much smaller than the {} ({})", space.blank ? "blank" : "part", boundsText(own));
  } else if (evident) {
    fault.text = "may lie elsewhere than the part";
  } else {
    return {};
  }
  fault.text = (fault.comparable ? "the nominal " : "the nominal is not compared: it ") + fault.text + "; ";
  fault.text += evident ? fmt::format("{} its bounds would agree with those of the {}; {}",
                                      placementText(*evident, unit), onto_part ? "machined part" : "blank",
                                      entries(given, *evident, unit))
                        : "check its unit, its place and its axes (unit, scale, rotate and move under [nominal])";
  return fault;
}

}  // namespace proveout
