#include "removal/compare/measured_sides.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"

namespace proveout {

namespace {

/// The deviation from what the facets stand for: between the two readings there is none.
double nearerReading(double deviation, const Bulge& bulge) {
  if (deviation > 0.0) return std::max(0.0, deviation - bulge.high);
  return std::min(0.0, deviation - bulge.low);
}

bool isIgnored(const std::vector<IgnoredRegion>& regions, const Vec3& p) {
  return std::any_of(regions.begin(), regions.end(), [&](const IgnoredRegion& r) { return r.contains(p); });
}

/// Calls body(i) for each point of a side, in blocks; false where the work was cancelled.
template <typename Body>
bool forEachPoint(std::size_t count, Progress& progress, double from, double to, const Body& body) {
  constexpr std::size_t kBlock = 512;
  const std::size_t blocks = (count + kBlock - 1) / kBlock;
  std::atomic<std::size_t> done{0};
  parallelFor(std::size_t{0}, blocks, [&](std::size_t block) {
    if (progress.cancelled()) return;
    for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) body(i);
    const std::size_t finished = done.fetch_add(1) + 1;
    if (finished % 64 == 0)
      progress.report("comparing", from + (to - from) * static_cast<double>(finished) / blocks);
  });
  return !progress.cancelled();
}

class Measurer {
 public:
  Measurer(SampleMesh& part, const SampleMesh& goal, const NominalModel& nominal,
           const CompareOptions& options, Progress& progress)
      : part_(part),
        goal_(goal),
        nominal_(nominal),
        o_(options),
        progress_(progress),
        least_(std::min(options.gouge_mm, options.excess_mm)),
        reach_(2.0 * std::max(options.gouge_mm, options.excess_mm) + 2.0 * options.uncertainty_mm + 0.01),
        deep_(reach_ + 2.0 * options.resolution_mm) {}

  bool run(BothSides& out) {
    sides_ = &out;
    start(out.machined, part_);
    if (!measureMachined() || !measureNominal()) return false;
    if (o_.part == nullptr) return true;
    for (const double sign : {1.0, -1.0}) {
      settleLargest(out.machined, sign, [this](std::size_t i) { settleMachined(i); });
      settleLargest(out.nominal, sign, [this](std::size_t i) { tellNominal(i, true); });
    }
    return !progress_.cancelled();
  }

 private:
  static void start(SampledSide& side, const SampleMesh& mesh) {
    const std::size_t count = mesh.surface.points.size();
    side.mesh = &mesh;
    side.deviation.assign(count, std::numeric_limits<float>::quiet_NaN());
    side.bound.assign(count, 0.0f);
    side.gradient.assign(count, Eigen::Vector3f::Zero());
    side.opposite.assign(count, 0);
  }

  /// Whether an error of the mesh could hide or feign a deviation that matters; those that are no finding yet
  /// are told as figures.
  bool decides(double deviation) const {
    constexpr double kTold = 0.2;  // of the tolerance
    return std::abs(deviation) + o_.uncertainty_mm > least_ || std::abs(deviation) > kTold * least_;
  }

  bool measureMachined() {
    const std::vector<Vec3>& points = part_.surface.points;
    const std::vector<SurfaceDistance> first = nominal_.distance.at(points, progress_, 0.05, 0.3);
    if (first.empty()) return points.empty();
    PROVEOUT_ASSERT(first.size() == points.size());
    return forEachPoint(points.size(), progress_, 0.3, 0.45, [&](std::size_t i) {
      const double deviation = tellMachined(i, first[i], o_.uncertainty_mm);
      if (o_.part != nullptr && decides(deviation) && std::abs(deviation) < deep_) settleMachined(i);
    });
  }

  double tellMachined(std::size_t i, const SurfaceDistance& d, double bound) {
    SampledSide& side = sides_->machined;
    const Vec3& p = part_.surface.points[i];
    const double deviation = nominal_.deviation(d, p);
    side.gradient[i] = d.gradient;
    side.opposite[i] = d.triangle;
    const bool left_out = isIgnored(o_.ignored, p);
    side.deviation[i] = left_out ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(deviation);
    side.bound[i] = static_cast<float>(left_out ? 0.0 : bound);
    return deviation;
  }

  /// Puts a sample onto the exact part.
  void settleMachined(std::size_t i) {
    SampledSide& side = sides_->machined;
    Vec3& p = part_.surface.points[i];
    const double deviation = std::abs(side.deviation[i]);
    if (std::isnan(deviation)) return;
    const SettledPoint at = settle(*o_.part, p, std::max(reach_, 1.2 * deviation));
    if (at.found) {
      p = at.p;
      tellMachined(i, nominal_.distance.at(p), at.residual);
    } else {
      side.bound[i] =
          std::max(side.bound[i], static_cast<float>(deviation));  // the mesh shows what is not there
    }
  }

  bool measureNominal() {
    const std::vector<Vec3>& points = goal_.surface.points;
    to_machined_ = SignedDistance(part_.surface, 0.5 * o_.resolution_mm).at(points, progress_, 0.5, 0.75);
    start(sides_->nominal, goal_);
    if (to_machined_.empty()) return points.empty();
    bulges_ = bulgesOfSamples();
    PROVEOUT_ASSERT(to_machined_.size() == points.size() &&
                    (bulges_.empty() || bulges_.size() == points.size()));
    return forEachPoint(points.size(), progress_, 0.75, 0.95, [&](std::size_t i) { tellNominal(i, false); });
  }

  /// `all`: also a deviation that decides nothing is measured on the exact part.
  void tellNominal(std::size_t i, bool all) {
    SampledSide& side = sides_->nominal;
    const Vec3& p = goal_.surface.points[i];
    const SurfaceDistance& d = to_machined_[i];
    side.gradient[i] = d.gradient;
    side.opposite[i] = d.triangle;
    if (isIgnored(o_.ignored, p)) return;
    // Inside of the machined solid means that material is left.
    double raw = -d.distance, bound = o_.uncertainty_mm;
    if (o_.part != nullptr) measureExactly(p, d, all, raw, bound);
    double deviation = nearerReading(raw, bulges_.empty() ? Bulge() : bulges_[i]);
    deviation = besideRounds(p, deviation);
    side.deviation[i] = static_cast<float>(deviation);
    side.bound[i] = static_cast<float>(bound);
  }

  /// The largest deviations of a sign are told even where they decide nothing: those of the mesh that are
  /// larger than any that is known are measured on the exact part, largest first.
  template <typename Measure>
  void settleLargest(SampledSide& side, double sign, const Measure& measure) {
    constexpr std::size_t kBatch = 256, kBatches = 16;
    const float sure = static_cast<float>(2.0 * o_.part->accuracy());
    const auto value = [&](std::uint32_t i) { return sign * side.deviation[i]; };
    std::vector<std::uint32_t> open;
    float known = 0.0f;
    for (std::uint32_t i = 0; i < side.deviation.size(); ++i) {
      if (!(value(i) > 0.0f) || std::abs(side.deviation[i]) > deep_) continue;
      if (side.bound[i] > sure) {
        open.push_back(i);
      } else {
        known = std::max(known, static_cast<float>(value(i)));
      }
    }
    for (std::size_t batch = 0; batch < kBatches && !open.empty(); ++batch) {
      const std::size_t count = std::min(kBatch, open.size());
      std::nth_element(open.begin(), open.end() - static_cast<std::ptrdiff_t>(count), open.end(),
                       [&](std::uint32_t a, std::uint32_t b) {
                         return value(a) != value(b) ? value(a) < value(b) : a > b;
                       });
      const std::vector<std::uint32_t> now(open.end() - static_cast<std::ptrdiff_t>(count), open.end());
      open.resize(open.size() - count);
      if (std::none_of(now.begin(), now.end(), [&](std::uint32_t i) { return value(i) > known; })) return;
      parallelFor(std::size_t{0}, count, [&](std::size_t k) { measure(now[k]); });
      for (const std::uint32_t i : now) known = std::max(known, static_cast<float>(value(i)));
    }
  }

  /// The deviation of a point of the nominal, from the exact part. `d`: from the machined mesh.
  void measureExactly(const Vec3& p, const SurfaceDistance& d, bool all, double& raw, double& bound) const {
    double reach = reach_;
    ExactPart::Sample s = o_.part->at(p, reach);
    if (s.value <= -reach && raw < deep_) {  // also where the mesh lacks what is there
      reach = deep_ + std::abs(raw);
      s = o_.part->at(p, reach);
      raw = std::max(raw, std::min(-s.value, reach));
    }
    const double accuracy = o_.part->accuracy();
    if (s.value <= 0.0) {
      if (s.value > -reach) {
        raw = -s.value;  // exact in the material
        bound = accuracy;
      }
      return;
    }
    // Outside the value is a lower bound; a point of the surface gives an upper one.
    const bool small = !all && !decides(raw) && s.value < least_, large = raw <= -deep_ && s.value >= reach_;
    if (small || large) return;
    const double far = std::max(reach_, std::min(1.2 * std::abs(raw), deep_));
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& from : {Vec3(p - d.distance * d.gradient.cast<double>()), p}) {
      const SettledPoint at = settle(*o_.part, from, far);
      if (at.found) least = std::min(least, (at.p - p).norm() + at.residual);
    }
    if (!std::isfinite(least)) return;
    raw = -least;
    bound = std::max(least - std::min(s.value, least), accuracy);
    if (s.value < reach_) bound = std::min(bound, std::max(o_.uncertainty_mm, accuracy));
  }

  /// What the curved reading of the nominal says at its own samples.
  std::vector<Bulge> bulgesOfSamples() const {
    std::vector<Bulge> out;
    if (nominal_.shape.largest() == 0.0) return out;
    out.resize(goal_.surface.points.size());
    for (std::size_t t = 0; t < goal_.parent.size(); ++t) {
      for (const auto v : goal_.surface.triangles[t]) {
        const double b = nominal_.shape.at(goal_.parent[t], goal_.surface.points[v]);
        out[v].low = std::min(out[v].low, b);
        out[v].high = std::max(out[v].high, b);
      }
    }
    return out;
  }

  /// A flat face of the nominal reaches to the chords of a round beside it, and the true one to the arc:
  /// between them nothing can be told.
  double besideRounds(const Vec3& p, double deviation) const {
    const double most = nominal_.shape.largest();
    // Nothing to a shallow deviation, and little to a deep one.
    if (most == 0.0 || std::abs(deviation) < 0.01 * least_ || std::abs(deviation) > 100.0 * most)
      return deviation;
    double slack = 0.0;
    nominal_.distance.tree().forEachIn(
        {p - Vec3::Constant(most), p + Vec3::Constant(most)}, [&](std::uint32_t t) {
          const auto& v = nominal_.surface.triangles[t];
          const auto& points = nominal_.surface.points;
          const Vec3 foot = nearestOfTriangle(p, points[v[0]], points[v[1]], points[v[2]]).point;
          const double bulge = std::abs(nominal_.shape.at(t, foot));
          if ((foot - p).norm() <= 1.05 * bulge + 1e-5) slack = std::max(slack, bulge);
        });
    return deviation > 0.0 ? std::max(0.0, deviation - slack) : std::min(0.0, deviation + slack);
  }

  SampleMesh& part_;
  const SampleMesh& goal_;
  const NominalModel& nominal_;
  const CompareOptions& o_;
  Progress& progress_;
  double least_, reach_;  ///< smaller tolerance; how far the exact part is looked at, mm
  double deep_;           ///< no fault of the mesh reaches so far, mm
  BothSides* sides_ = nullptr;
  std::vector<SurfaceDistance> to_machined_;  ///< of the nominal's samples
  std::vector<Bulge> bulges_;                 ///< of the nominal there; empty: it is flat
};

}  // namespace

double NominalModel::deviation(const SurfaceDistance& d, const Vec3& p) const {
  return nearerReading(d.distance, shape.at(d, p));
}

BothSides measureSides(SampleMesh& part, const SampleMesh& goal, const NominalModel& nominal,
                       const CompareOptions& options, Progress& progress) {
  BothSides out;
  if (!Measurer(part, goal, nominal, options, progress).run(out)) return {};
  return out;
}

}  // namespace proveout
