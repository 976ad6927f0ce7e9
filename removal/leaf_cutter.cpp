#include "removal/leaf_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/edge_root.h"

namespace proveout {

namespace {

using openvdb::Coord;

/// Penetration that counts as contact, mm: above the rounding of float samples, below any gauge on a shop
/// floor.
constexpr double kContactToleranceMm = 1e-3;
/// A later motion takes a voxel over only if it reaches this much deeper, mm: what an equal surface differs
/// by in floats stays below.
constexpr double kDeeperMm = 1e-5;
/// A later motion takes a crossing over only if it cuts the edge shorter by this fraction.
constexpr double kShorter = 1e-7;

}  // namespace

bool LeafCutter::cut(const Coord& origin, const std::vector<std::uint32_t>& list, LeafResult& result) {
  origin_ = origin;
  removed_.clear();
  contacts_.clear();
  near_.clear();
  near_distance_.clear();
  evaluations_ = 0;
  if (!readBlock()) return false;
  for (const std::uint32_t index : list) {
    if (open_columns_ == 0) break;
    applyPass(index);
  }
  result.origin = origin;
  packLeaf(distance_.data(), owner_.data(), impl_.band(), result);
  if (result.state == LeafResult::State::kSurface) addCrossings(result);
  return true;
}

bool LeafCutter::readBlock() {
  auto read = impl_.distance->getConstUnsafeAccessor();
  auto read_owner = impl_.owner->getConstUnsafeAccessor();
  bool material = false;
  open_columns_ = 0;
  for (int column = 0; column < kBlock * kBlock; ++column) {
    float least = impl_.band();
    for (int z = 0; z < kBlock; ++z) {
      const Coord at = origin_.offsetBy(column / kBlock, column % kBlock, z);
      const int i = column * kBlock + z;
      distance_[i] = read.getValue(at);
      owner_[i] = static_cast<std::uint32_t>(read_owner.getValue(at));
      least = std::min(least, distance_[i]);
    }
    column_min_[column] = least;
    material = material || least < 0.0f;
    if (least < impl_.band()) ++open_columns_;
  }
  return material;
}

void LeafCutter::applyPass(std::uint32_t index) {
  const Pass& pass = passes_[index];
  const float band = impl_.band();
  PassTotals totals;
  totals.contact.pass = index;
  const std::size_t base = near_distance_.size();
  const bool cutter = pass.part == ToolPart::kCutter;
  if (cutter) near_distance_.resize(base + kBlockSize, std::numeric_limits<float>::max());
  double cutoff[kBlock], values[kBlock];
  for (int column = 0; column < kBlock * kBlock; ++column) {
    if (column_min_[column] >= band) continue;  // nothing left that could change
    const float* d = &distance_[column * kBlock];
    // Only what reaches deeper than the sample matters; a sample at the band's end cannot change any more.
    for (int z = 0; z < kBlock; ++z) cutoff[z] = d[z] < band ? -d[z] : -std::numeric_limits<double>::max();
    const Vec3 at = impl_.position(origin_.offsetBy(column / kBlock, column % kBlock, 0));
    pass.sweep.column(at.x(), at.y(), at.z(), impl_.h, kBlock, cutoff, values);
    evaluations_ += kBlock;
    if (cutter) {
      float* keep = &near_distance_[base + column * kBlock];
      for (int z = 0; z < kBlock; ++z) {
        keep[z] = static_cast<float>(values[z]);
        totals.near = totals.near || (d[z] < 0.0f && values[z] < impl_.h);
      }
    }
    applyColumn(pass, column, values, totals);
  }
  if (totals.near) {
    near_.push_back(&pass);
  } else {
    near_distance_.resize(base);
  }
  if (totals.removed > 0.0) {
    removed_.emplace_back(pass.motion, static_cast<std::int64_t>(std::llround(totals.removed / kVolumeUnit)));
  }
  if (totals.contact.depth > kContactToleranceMm) {
    totals.contact.volume = static_cast<std::int64_t>(std::llround(totals.contact_volume / kVolumeUnit));
    contacts_.push_back(totals.contact);
  }
}

void LeafCutter::applyColumn(const Pass& pass, int column, const double* values, PassTotals& totals) {
  const int x = column / kBlock, y = column % kBlock;
  const double inverse_h = 1.0 / impl_.h;
  // Share of a voxel that holds material, from its distance.
  const auto fraction = [&](double d) { return std::clamp(0.5 - d * inverse_h, 0.0, 1.0); };
  const float band = impl_.band();
  float* d = &distance_[column * kBlock];
  float least = band;
  for (int z = 0; z < kBlock; ++z) {
    const double overlap = -values[z] - d[z];
    if (overlap > kDeeperMm || (d[z] < 0.0f && values[z] <= 0.0)) {
      const bool own = x < 8 && y < 8 && z < 8;
      const double change = own ? fraction(d[z]) - fraction(-values[z]) : 0.0;
      if (pass.watched && own) {
        totals.contact_volume += change;
        // A material voxel is the centre of a ball of material of radius -d: the solid reaches into it by the
        // overlap.
        if (d[z] < 0.0f && overlap > totals.contact.depth) {
          totals.contact.depth = overlap;
          totals.contact.where = impl_.position(origin_.offsetBy(x, y, z));
        }
      }
      if (pass.part == ToolPart::kCutter) {
        totals.removed += change;
        d[z] = static_cast<float>(std::min(-values[z], static_cast<double>(band)));
        owner_[column * kBlock + z] = pass.motion;
      }
    }
    least = std::min(least, d[z]);
  }
  column_min_[column] = least;
  if (least >= band) --open_columns_;
}

void LeafCutter::addCrossings(LeafResult& result) const {
  for (int v = 0; v < 512; ++v) {
    const int x = v >> 6, y = (v >> 3) & 7, z = v & 7;
    const int start = blockIndex(x, y, z);
    for (int axis = 0; axis < 3; ++axis) {
      const int end = start + kBlockStride[axis];
      if ((distance_[start] < 0.0f) == (distance_[end] < 0.0f)) continue;
      Crossing c = crossing(origin_.offsetBy(x, y, z), axis, start, end);
      c.key = static_cast<std::uint16_t>(v * 3 + axis);
      result.crossings.push_back(c);
    }
  }
}

/// Moves `hit` to where the pass cuts the edge nearer to the material end `a`, if it does. `at_a`: its
/// distance at `a`.
void LeafCutter::tryPass(const Pass& pass, double at_a, const Vec3& a, const Vec3& step, EdgeHit& hit) const {
  const double h = impl_.h;
  const auto f = [&](double s) { return pass.sweep.distance(a + s * step, 2.0 * h); };
  double upper = hit.s, at_upper = f(hit.s);
  if (at_upper >= -1e-9) {
    // The point found so far is outside this sweep; it may still have cut a piece out between `a` and there.
    if (hit.pass == nullptr && hit.s == 1.0) return;
    if (at_upper > hit.s * h) return;
    if (pass.sweep.sample(a + hit.s * step).gradient.dot(step) <= 0.0) return;
    double low = 0.0, high = hit.s;
    for (int i = 0; i < 24 && at_upper >= -1e-6; ++i) {
      const double s1 = low + 0.382 * (high - low), s2 = low + 0.618 * (high - low);
      const double f1 = f(s1), f2 = f(s2);
      if (f1 < at_upper) at_upper = f1, upper = s1;
      if (f2 < at_upper) at_upper = f2, upper = s2;
      if (std::min(f1, f2) > (high - low) * h) return;  // too far to reach the piece that is left
      (f1 < f2 ? high : low) = f1 < f2 ? s2 : s1;
    }
    if (at_upper >= -1e-6) return;
  }
  at_a = at_a < 0.5 * h ? f(0.0)
                        : at_a;  // the kept value may be a lower bound; near the surface it must be exact
  if (at_a < 0.0) return;        // rounding: `a` counts as material
  const double s = edgeRoot(f, 0.0, at_a, upper, at_upper, 1e-9);
  if (s < hit.s - kShorter) hit = {s, &pass};
}

/// The nearest cut to the material end. `first`: fraction of the crossing that was there before, or 1.
LeafCutter::EdgeHit LeafCutter::findHit(const Vec3& a, const Vec3& step, int material, int empty,
                                        double first) const {
  EdgeHit hit{first, nullptr};
  const auto kept = [&](std::size_t pass, int sample) { return near_distance_[pass * kBlockSize + sample]; };
  // First the cut that looks nearest on the chord between the samples: it cuts the other searches short.
  std::size_t likely = near_.size();
  double nearest = 2.0;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const double at_a = kept(i, material), at_b = kept(i, empty);
    if (at_b >= 0.0 || at_a < 0.0) continue;
    const double chord = at_a / (at_a - at_b);
    if (chord < nearest) nearest = chord, likely = i;
  }
  if (likely < near_.size()) tryPass(*near_[likely], kept(likely, material), a, step, hit);
  const EdgeHit best_guess = hit;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (i == likely || kept(i, material) >= hit.s * impl_.h)
      continue;  // cannot reach: distances are 1-Lipschitz
    tryPass(*near_[i], kept(i, material), a, step, hit);
  }
  // Equal cuts belong to the first motion that made them, in whatever order they were tried.
  if (hit.pass != nullptr && hit.pass == best_guess.pass) {
    for (std::size_t i = 0; i < likely; ++i) {
      if (kept(i, material) >= (hit.s + kShorter) * impl_.h) continue;
      if (std::abs(near_[i]->sweep.distance(a + hit.s * step, impl_.h)) < kShorter * impl_.h)
        return {hit.s, near_[i]};
    }
  }
  return hit;
}

Crossing LeafCutter::crossing(const Coord& at, int axis, int start, int end) const {
  const bool in_at_start = distance_[start] < 0.0f;
  const Vec3 first = impl_.position(at), edge = Vec3::Unit(axis) * impl_.h;
  const Vec3 a = in_at_start ? first : Vec3(first + edge);  // the end in the material
  const Vec3 step = in_at_start ? edge : Vec3(-edge);
  const Crossing* old = findCrossing(impl_.crossings, at, axis);
  double limit = 1.0;
  if (old != nullptr) limit = in_at_start ? old->t : 1.0 - old->t;
  const EdgeHit hit = findHit(a, step, in_at_start ? start : end, in_at_start ? end : start, limit);
  if (hit.pass == nullptr && old != nullptr) return *old;
  Crossing c;
  Vec3 normal = step.normalized();
  double s = hit.s;
  if (hit.pass != nullptr) {
    const SweepSample sample = hit.pass->sweep.sample(a + s * step);
    normal = -sample.gradient;
    c.element = static_cast<std::uint16_t>(sample.element);
    c.motion = hit.pass->motion;
  } else {  // rounding hid the crossing: take the samples' own zero
    const double in = std::abs(distance_[in_at_start ? start : end]),
                 out = std::abs(distance_[in_at_start ? end : start]);
    s = in / (in + out);
    c.motion = owner_[in_at_start ? end : start];
  }
  const double t = in_at_start ? s : 1.0 - s;
  c.t = static_cast<float>(std::clamp(t, kEdgeMargin, 1.0 - kEdgeMargin));
  for (int i = 0; i < 3; ++i) c.normal[i] = static_cast<float>(normal[i]);
  return c;
}

}  // namespace proveout
