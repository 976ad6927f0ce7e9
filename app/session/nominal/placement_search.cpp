#include "app/session/nominal/placement_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/session/nominal/nominal_samples.h"
#include "core/mesh/surface_mesh.h"
#include "core/mesh/triangle_tree.h"

namespace proveout {
namespace {

constexpr std::size_t kPoints = 600, kFirstPoints = 60;
constexpr double kMost = 0.6;        ///< share of the nominal that agrees where it is said to belong there
constexpr double kPromising = 0.45;  ///< of the first points, before all are asked
constexpr double kLeastSize = 0.3;   ///< of the part's longest side: less fits anywhere
constexpr double kSlack = 1.01;      ///< a nominal is no larger than its part
constexpr double kBetter =
    0.02;  ///< of Agreement::off: by so much another place must be better than a nearer one

/// Of points of the nominal with the part's surface.
struct Agreement {
  double share = 0.0;  ///< of those that lie on it
  double off = 1.0;    ///< mean distance, as a part of what counts as lying on it; farther ones count 1
};

class Judge {
 public:
  Judge(const TriMesh& nominal, const TriMesh& part, double within_mm)
      : samples_(nominalSamples(nominal, meshBounds(nominal), kPoints)),
        tree_(toSurface(part)),
        within_(within_mm) {}

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
    for (const double move :
         {part.min[k] - body.min[k], part.max[k] - body.max[k], part.center()[k] - body.center()[k], 0.0}) {
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
  return (change.scale != 1.0 ? 1 : 0) + (change.rotate_deg.isZero(0.0) ? 0 : 1) +
         (change.move.isZero(0.0) ? 0 : 1);
}

bool mayFit(const Box3& body, const Box3& part) {
  const Vec3 size = body.size(), most = kSlack * part.size();
  return (size.array() <= most.array()).all() && size.maxCoeff() >= kLeastSize * part.size().maxCoeff();
}

std::string percent(double share) { return fmt::format("{:.0f} %", std::floor(100.0 * share)); }

std::string boundsText(const Box3& b) {
  return fmt::format("X{:g} Y{:g} Z{:g} to X{:g} Y{:g} Z{:g}", b.min.x(), b.min.y(), b.min.z(), b.max.x(),
                     b.max.y(), b.max.z());
}

/// The share of a box that lies in another.
double commonShare(const Box3& box, const Box3& other) {
  const Vec3 common = box.max.cwiseMin(other.max) - box.min.cwiseMax(other.min);
  if (!(common.minCoeff() > 0.0)) return 0.0;
  return (common.array() / box.size().array()).prod();
}

/// What to enter, in a job or on the command line.
std::string entries(const MeshPlacement& given, const MeshPlacement& change, MeshUnit unit) {
  const std::string options = placementOptions(given, change);
  return fmt::format("enter {} under [nominal]{}", placementKeys(given, change, unit),
                     options.empty() ? options : " (" + options + ")");
}

constexpr double kOut = 0.01;  // of its size: by less a blank may have been sawn short

/// How the bounds of a nominal lie to those of the part and of the space in which it was made.
struct Outline {
  Box3 own, room;
  double out_mm = 0.0;   ///< by how much it reaches out of that space
  bool outside = false;  ///< by more than a blank may be short
  std::optional<MeshPlacement> evident;
  bool onto_part = false;  ///< that change brings it onto the part's bounds, not the space's

  bool rescaled() const { return evident && evident->scale != 1.0; }
  bool turned() const { return evident && !evident->rotate_deg.isZero(0.0); }
};

Outline outlineOf(const TriMesh& nominal, const PartSpace& space) {
  const Box3 part = meshBounds(space.part);
  Outline out;
  out.own = meshBounds(nominal);
  out.room = space.blank.value_or(part);
  out.out_mm = std::max((out.room.min - out.own.min).maxCoeff(), (out.own.max - out.room.max).maxCoeff());
  out.outside = out.out_mm > kOut * out.own.size().maxCoeff();
  out.evident = evidentPlacement(out.own, part);
  out.onto_part = out.evident.has_value();
  if (out.onto_part) return out;
  out.evident = evidentPlacement(out.own, out.room);
  // Inside of a blank that it fits but for its place or turn a nominal may well lie right.
  if (!out.outside && !out.rescaled()) out.evident.reset();
  return out;
}

/// What looks wrong about the bounds, "reaches 3 mm out of the blank (...)"; empty: nothing.
std::string suspicion(const Outline& outline, const PartSpace& space) {
  const char* const room = space.blank ? "blank" : "part";
  const double told_mm = space.blank ? space.within_mm : kOut * outline.own.size().maxCoeff();
  if (outline.out_mm > told_mm)
    return fmt::format("reaches {:.4g} mm out of the {} ({})", outline.out_mm, room, boundsText(outline.own));
  if (outline.rescaled())
    return fmt::format("is much smaller than the {} ({})", room, boundsText(outline.own));
  return outline.evident ? "may lie elsewhere than the part" : "";
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
        const bool simpler =
            agreement.off <= best.off + kBetter && entriesOf(change) < entriesOf(found.change);
        if (agreement.off >= best.off - kBetter && !(simpler && !found.change.none())) continue;
        best = agreement;
        found.change = change;
      }
    }
  }
  found.after = best.share;
  if (found.change.none() || found.after < kMost || 1.0 - found.after > 0.5 * (1.0 - found.before))
    return std::nullopt;
  return found;
}

PlacementFault placementFault(const TriMesh& nominal, const MeshPlacement& given, MeshUnit unit,
                              const PartSpace& space) {
  const Outline outline = outlineOf(nominal, space);
  if (boundsAgree(outline.own, meshBounds(space.part))) return {};
  PlacementFault fault;
  fault.rescaled = outline.rescaled();
  if (outline.outside || outline.turned() || fault.rescaled || !space.blank) {
    const auto found = searchPlacement(nominal, space.part, space.within_mm);
    const bool moved_alone = found && found->change.scale == 1.0 && found->change.rotate_deg.isZero(0.0);
    if (found && !(space.clamped_again && moved_alone)) {
      fault.comparable = false;
      fault.rescaled = found->change.scale != 1.0;
      fault.text = fmt::format(
          "the nominal does not lie where the part does, and is not compared: {} it would lie on "
          "the part with {} of its surface (now {}); {}",
          placementText(found->change, unit), percent(found->after), percent(found->before),
          entries(given, found->change, unit));
      return fault;
    }
  }
  constexpr double kWithin = 0.5;  // of its bounds: of less lies where there was material
  const bool elsewhere =
      outline.outside && (outline.turned() || commonShare(outline.own, outline.room) < kWithin);
  fault.comparable = !fault.rescaled && !elsewhere;
  const std::string what = suspicion(outline, space);
  if (what.empty()) return {};
  fault.text = (fault.comparable ? "the nominal " : "the nominal is not compared: it ") + what + "; ";
  fault.text +=
      outline.evident
          ? fmt::format("{} its bounds would agree with those of the {}; {}",
                        placementText(*outline.evident, unit), outline.onto_part ? "machined part" : "blank",
                        entries(given, *outline.evident, unit))
          : "check its unit, its place and its axes (unit, scale, rotate and move under [nominal])";
  return fault;
}

}  // namespace proveout
