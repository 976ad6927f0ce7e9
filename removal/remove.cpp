// Cutting a tool path into the stock: blocks of the grid are halved down to leaves, each with the motions
// that can touch it; a leaf sees its motions in program order.
#include <fmt/format.h>
#include <tbb/concurrent_vector.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "removal/edge_root.h"
#include "removal/stock_impl.h"
#include "removal/sweep.h"
#include "removal/threads.h"

namespace proveout {

namespace {

using openvdb::Coord;

/// Penetration that counts as contact, mm: above the rounding of float samples, below any gauge on a shop
/// floor.
constexpr double kContactToleranceMm = 1e-3;
/// A later motion takes a voxel over only if it reaches this much deeper, mm: what an equal surface differs
/// by in floats stays below.
constexpr double kDeeperMm = 1e-5;
/// Volumes per motion are summed as whole numbers of this part of a voxel, so that the sum does not depend on
/// threads.
constexpr double kVolumeUnit = 1.0 / 65536.0;

enum class Part : std::uint8_t { kCutter, kShank, kHolder };

/// One solid of one motion.
struct Pass {
  Sweep sweep;
  MotionId motion;
  Part part;
  bool watched;  ///< contact with stock is a finding
};

struct ContactSample {
  std::uint32_t pass;
  double depth;
  Vec3 where;
  std::int64_t volume;
};

struct EdgeHit {
  double s = 1.0;
  const Pass* pass = nullptr;
};

class Remover {
 public:
  Remover(Stock::Impl& impl, const Toolpath& path, const std::vector<Tool>& tools, Progress& progress,
          double limit_bytes)
      : impl_(impl),
        path_(path),
        progress_(progress),
        limit_bytes_(limit_bytes),
        removed_(path.motions.size()) {
    for (const Tool& tool : tools) solids_.emplace(tool.number, makeToolSolid(tool));
  }

  Status preparePasses();
  Status run();
  RemovalSummary summary() const;

 private:
  using List = std::vector<std::uint32_t>;

  void addParts(const std::vector<ConvexProfile>& parts, Part part, MotionId id, const ArcGeometry* arc);
  void visit(const Coord& origin, int size, const List& candidates);
  List cull(const Coord& origin, int size, const List& candidates) const;
  void leaf(const Coord& origin, const List& passes);
  bool readBlock(const Coord& origin, float* distance, std::uint32_t* owner) const;
  void applyPass(const Coord& origin, std::uint32_t index, float* distance, std::uint32_t* owner,
                 float* column_min, std::vector<ContactSample>& contacts);
  void addCrossings(const float* distance, const std::uint32_t* owner, const List& passes,
                    LeafResult& result) const;
  Crossing crossing(const Coord& at, int axis, bool in_at_start, const float* d, const std::uint32_t* owner,
                    const List& passes) const;
  void tryPass(const Pass& pass, const Vec3& a, const Vec3& step, EdgeHit& hit) const;
  void reportProgress();

  Stock::Impl& impl_;
  const Toolpath& path_;
  Progress& progress_;
  double limit_bytes_;
  std::map<int, ToolSolid> solids_;
  std::deque<Pass> passes_;
  std::vector<std::atomic<std::int64_t>> removed_;
  tbb::concurrent_vector<ContactSample> contacts_;
  std::mutex mutex_;
  std::vector<LeafResult> results_;
  std::atomic<std::uint64_t> evaluations_{0}, leaves_{0};
  std::atomic<double> done_{0.0};
  double total_blocks_ = 1.0;
  std::atomic<bool> over_limit_{false};
};

void Remover::addParts(const std::vector<ConvexProfile>& parts, Part part, MotionId id,
                       const ArcGeometry* arc) {
  const Motion& m = path_.motions[id];
  for (const ConvexProfile& profile : parts)
    passes_.push_back({Sweep(profile, m.from, m.to, arc), id, part, true});
}

Status Remover::preparePasses() {
  for (MotionId id = 0; id < path_.motions.size(); ++id) {
    const Motion& m = path_.motions[id];
    if (!m.from.allFinite() || !m.to.allFinite()) {
      return Error{ErrorKind::kInternal,
                   fmt::format("motion {} has a coordinate that is not a finite number", id)};
    }
    const auto solid = solids_.find(m.tool);
    if (solid == solids_.end()) {
      const std::string file = m.source.file < path_.files.size() ? path_.files[m.source.file] : "";
      return inputError(fmt::format(
          "{}:{}: tool {} is not described; give it in the job ([[tool]]) or with --tool {}=SHAPE:...", file,
          m.source.line, m.tool, m.tool));
    }
    const ArcGeometry* arc = m.arc >= 0 ? &path_.arcs[m.arc] : nullptr;
    const bool watched = m.kind == MotionKind::kRapid || m.spindle == 0.0;
    passes_.push_back({Sweep(solid->second.cutter, m.from, m.to, arc), id, Part::kCutter, watched});
    addParts(solid->second.shank, Part::kShank, id, arc);
    addParts(solid->second.holder, Part::kHolder, id, arc);
  }
  return Done{};
}

Status Remover::run() {
  Coord low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] =
        (static_cast<int>(std::floor((impl_.blank.min[axis] - impl_.origin[axis]) / impl_.h)) - 1) & ~7;
    high[axis] = static_cast<int>(std::ceil((impl_.blank.max[axis] - impl_.origin[axis]) / impl_.h)) + 1;
  }
  int size = 8;
  while (size <= (high - low)[openvdb::math::MaxIndex(high - low)]) size *= 2;
  List all(passes_.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  total_blocks_ = std::pow(size / 8.0, 3);
  visit(low, size, all);
  if (over_limit_)
    return memoryError(leafBytes(static_cast<double>(leaves_.load())) * 1.5, limit_bytes_, impl_.h);
  if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  commitLeaves(impl_, results_);
  return Done{};
}

Remover::List Remover::cull(const Coord& origin, int size, const List& candidates) const {
  // The block reaches from voxel 0 to voxel `size`: one layer more than its own.
  const double half = 0.5 * size * impl_.h;
  const Vec3 center = impl_.position(origin) + Vec3::Constant(half);
  const double reach = std::sqrt(3.0) * half + impl_.band();
  const Box3 box = Box3{center, center}.inflated(half + impl_.band());
  List kept;
  for (const std::uint32_t i : candidates) {
    const Sweep& sweep = passes_[i].sweep;
    if (box.overlaps(sweep.bounds()) && sweep.distance(center, reach) <= reach) kept.push_back(i);
  }
  return kept;
}

void Remover::visit(const Coord& origin, int size, const List& candidates) {
  if (over_limit_ || progress_.cancelled()) return;
  const double blocks = std::pow(size / 8.0, 3);
  const Vec3 low = impl_.position(origin);
  const Box3 box{low, low + Vec3::Constant(size * impl_.h)};
  const bool in_blank = box.overlaps(impl_.blank.inflated(impl_.h));
  const List passes = in_blank ? cull(origin, size, candidates) : List{};
  if (passes.empty() || size == 8) {
    if (!passes.empty()) leaf(origin, passes);
    for (double old = done_.load(); !done_.compare_exchange_weak(old, old + blocks);) {
    }
    if (size >= 64) progress_.report("removing", done_.load() / total_blocks_);
    return;
  }
  const int half = size / 2;
  const auto child = [&](int i) {
    visit(origin.offsetBy(i & 1 ? half : 0, i & 2 ? half : 0, i & 4 ? half : 0), half, passes);
  };
  if (size >= 16) {
    tbb::parallel_for(0, 8, child);
  } else {
    for (int i = 0; i < 8; ++i) child(i);
  }
  if (size >= 64) progress_.report("removing", done_.load() / total_blocks_);
}

bool Remover::readBlock(const Coord& origin, float* distance, std::uint32_t* owner) const {
  auto read = impl_.distance->getConstUnsafeAccessor();
  auto read_owner = impl_.owner->getConstUnsafeAccessor();
  bool material = false;
  for (int x = 0; x < kBlock; ++x) {
    for (int y = 0; y < kBlock; ++y) {
      for (int z = 0; z < kBlock; ++z) {
        const Coord at = origin.offsetBy(x, y, z);
        const int i = blockIndex(x, y, z);
        distance[i] = read.getValue(at);
        owner[i] = static_cast<std::uint32_t>(read_owner.getValue(at));
        material = material || distance[i] < 0.0f;
      }
    }
  }
  return material;
}

void Remover::leaf(const Coord& origin, const List& passes) {
  std::array<float, kBlockSize> distance;
  std::array<std::uint32_t, kBlockSize> owner;
  if (!readBlock(origin, distance.data(), owner.data())) return;
  std::array<float, kBlock * kBlock> column_min;
  for (int c = 0; c < kBlock * kBlock; ++c) {
    column_min[c] = *std::min_element(&distance[c * kBlock], &distance[c * kBlock] + kBlock);
  }
  std::vector<ContactSample> contacts;
  for (const std::uint32_t index : passes)
    applyPass(origin, index, distance.data(), owner.data(), column_min.data(), contacts);
  for (const ContactSample& c : contacts) contacts_.push_back(c);
  LeafResult result;
  result.origin = origin;
  packLeaf(distance.data(), owner.data(), impl_.band(), result);
  if (result.state == LeafResult::State::kSurface)
    addCrossings(distance.data(), owner.data(), passes, result);
  const std::lock_guard<std::mutex> lock(mutex_);
  results_.push_back(std::move(result));
  if (leafBytes(static_cast<double>(++leaves_)) > limit_bytes_) over_limit_ = true;
}

void Remover::applyPass(const Coord& origin, std::uint32_t index, float* distance, std::uint32_t* owner,
                        float* column_min, std::vector<ContactSample>& contacts) {
  const Pass& pass = passes_[index];
  const float band = impl_.band();
  const double inverse_h = 1.0 / impl_.h;
  // Share of a voxel that holds material, from its distance.
  const auto fraction = [&](double d) { return std::clamp(0.5 - d * inverse_h, 0.0, 1.0); };
  double values[kBlock];
  double removed = 0.0, contact_volume = 0.0;
  ContactSample contact{index, 0.0, Vec3::Zero(), 0};
  for (int column = 0; column < kBlock * kBlock; ++column) {
    if (column_min[column] >= band) continue;  // nothing left that could change
    const int x = column / kBlock, y = column % kBlock;
    const Vec3 at = impl_.position(origin.offsetBy(x, y, 0));
    pass.sweep.column(at.x(), at.y(), at.z(), impl_.h, kBlock, band, values);
    float* d = distance + column * kBlock;
    float least = band;
    for (int z = 0; z < kBlock; ++z) {
      const double overlap = -values[z] - d[z];
      const bool deeper = overlap > kDeeperMm || (d[z] < 0.0f && values[z] <= 0.0);
      if (deeper) {
        const bool own = x < 8 && y < 8 && z < 8;
        const double change = own ? fraction(d[z]) - fraction(-values[z]) : 0.0;
        // A material voxel is the centre of a ball of material of radius -d: the solid reaches into it by the
        // overlap.
        if (pass.watched && own) {
          contact_volume += change;
          if (d[z] < 0.0f && overlap > contact.depth) {
            contact.depth = overlap;
            contact.where = at + Vec3(0, 0, z * impl_.h);
          }
        }
        if (pass.part == Part::kCutter) {
          removed += change;
          d[z] = static_cast<float>(std::min(-values[z], static_cast<double>(band)));
          owner[column * kBlock + z] = pass.motion;
        }
      }
      least = std::min(least, d[z]);
    }
    column_min[column] = least;
  }
  evaluations_.fetch_add(kBlockSize, std::memory_order_relaxed);
  if (removed > 0.0) {
    removed_[pass.motion].fetch_add(static_cast<std::int64_t>(std::llround(removed / kVolumeUnit)),
                                    std::memory_order_relaxed);
  }
  if (contact.depth > kContactToleranceMm) {
    contact.volume = static_cast<std::int64_t>(std::llround(contact_volume / kVolumeUnit));
    contacts.push_back(contact);
  }
}

void Remover::addCrossings(const float* distance, const std::uint32_t* owner, const List& passes,
                           LeafResult& result) const {
  List cutting;
  for (const std::uint32_t i : passes) {
    if (passes_[i].part == Part::kCutter) cutting.push_back(i);
  }
  for (int v = 0; v < 512; ++v) {
    const int x = v >> 6, y = (v >> 3) & 7, z = v & 7;
    const int at = blockIndex(x, y, z);
    for (int axis = 0; axis < 3; ++axis) {
      const bool in = distance[at] < 0.0f;
      if (in == (distance[at + kBlockStride[axis]] < 0.0f)) continue;
      const float d[2] = {distance[at], distance[at + kBlockStride[axis]]};
      const std::uint32_t owners[2] = {owner[at], owner[at + kBlockStride[axis]]};
      Crossing c = crossing(result.origin.offsetBy(x, y, z), axis, in, d, owners, cutting);
      c.key = static_cast<std::uint16_t>(v * 3 + axis);
      result.crossings.push_back(c);
    }
  }
}

/// Moves `hit` to where the pass cuts the edge nearer to the material end `a`, if it does.
void Remover::tryPass(const Pass& pass, const Vec3& a, const Vec3& step, EdgeHit& hit) const {
  const double h = impl_.h;
  const auto f = [&](double s) { return pass.sweep.distance(a + s * step, 2.0 * h); };
  const double at_hit = f(hit.s);
  if (at_hit > hit.s * h) return;  // the swept volume is farther than the rest of the edge is long
  double upper = hit.s, at_upper = at_hit;
  if (at_hit >= -1e-9) {
    // The point found so far is outside this sweep; it may still have cut a piece out between `a` and there.
    if (hit.pass == nullptr && at_hit >= 0.0 && hit.s == 1.0) return;
    const SweepSample sample = pass.sweep.sample(a + hit.s * step);
    if (sample.gradient.dot(step) <= 0.0) return;
    double low = 0.0, high = hit.s;
    for (int i = 0; i < 24 && at_upper >= -1e-6; ++i) {
      const double s1 = low + 0.382 * (high - low), s2 = low + 0.618 * (high - low);
      const double f1 = f(s1), f2 = f(s2);
      if (f1 < at_upper) at_upper = f1, upper = s1;
      if (f2 < at_upper) at_upper = f2, upper = s2;
      (f1 < f2 ? high : low) = f1 < f2 ? s2 : s1;
    }
    if (at_upper >= -1e-6) return;
  }
  const double at_a = f(0.0);
  if (at_a < 0.0) return;  // rounding: `a` counts as material
  const double s = edgeRoot(f, 0.0, at_a, upper, at_upper, 1e-9);
  if (s < hit.s - 1e-7) hit = {s, &pass};
}

Crossing Remover::crossing(const Coord& at, int axis, bool in_at_start, const float* d,
                           const std::uint32_t* owner, const List& passes) const {
  const Vec3 start = impl_.position(at);
  const Vec3 edge = Vec3::Unit(axis) * impl_.h;
  const Vec3 a = in_at_start ? start : Vec3(start + edge);  // the end in the material
  const Vec3 step = in_at_start ? edge : Vec3(-edge);
  EdgeHit hit;
  const Crossing* old = findCrossing(impl_.crossings, at, axis);
  if (old != nullptr) hit.s = in_at_start ? old->t : 1.0 - old->t;
  // First the motion that owns the empty end: it nearly always made the crossing, and cuts the others short.
  const std::uint32_t likely = owner[in_at_start ? 1 : 0];
  for (const std::uint32_t i : passes) {
    if (passes_[i].motion == likely) tryPass(passes_[i], a, step, hit);
  }
  for (const std::uint32_t i : passes) {
    if (passes_[i].motion != likely) tryPass(passes_[i], a, step, hit);
  }
  Crossing c;
  if (hit.pass == nullptr && old != nullptr) return *old;
  Vec3 normal = step.normalized();
  double s = hit.s;
  if (hit.pass != nullptr) {
    const SweepSample sample = hit.pass->sweep.sample(a + s * step);
    normal = -sample.gradient;
    c.element = static_cast<std::uint16_t>(sample.element);
    c.motion = hit.pass->motion;
  } else {  // rounding hid the crossing: take the samples' own zero
    s = std::abs(d[in_at_start ? 0 : 1]) / (std::abs(d[0]) + std::abs(d[1]));
    c.motion = likely;
  }
  const double t = in_at_start ? s : 1.0 - s;
  c.t = static_cast<float>(std::clamp(t, kEdgeMargin, 1.0 - kEdgeMargin));
  for (int i = 0; i < 3; ++i) c.normal[i] = static_cast<float>(normal[i]);
  return c;
}

RemovalSummary Remover::summary() const {
  RemovalSummary out;
  out.voxel_evaluations = evaluations_;
  const double unit = kVolumeUnit * impl_.h * impl_.h * impl_.h;
  out.removed_mm3.reserve(removed_.size());
  for (const auto& r : removed_)
    out.removed_mm3.push_back(static_cast<float>(static_cast<double>(r.load()) * unit));

  std::vector<ContactSample> samples(contacts_.begin(), contacts_.end());
  std::sort(samples.begin(), samples.end(), [](const ContactSample& a, const ContactSample& b) {
    if (a.pass != b.pass) return a.pass < b.pass;
    if (a.depth != b.depth) return a.depth > b.depth;
    return std::lexicographical_compare(a.where.data(), a.where.data() + 3, b.where.data(),
                                        b.where.data() + 3);
  });
  for (const ContactSample& s : samples) {
    const Pass& pass = passes_[s.pass];
    const Motion& m = path_.motions[pass.motion];
    ContactKind kind = m.kind == MotionKind::kRapid ? ContactKind::kRapid : ContactKind::kSpindleOff;
    if (pass.part == Part::kShank) kind = ContactKind::kShank;
    if (pass.part == Part::kHolder) kind = ContactKind::kHolder;
    Contact* last = nullptr;
    for (auto it = out.contacts.rbegin(); it != out.contacts.rend() && last == nullptr; ++it) {
      const Motion& other = path_.motions[it->motion];
      const bool same_block = other.source.file == m.source.file && other.source.line == m.source.line;
      if (it->kind == kind && other.tool == m.tool && same_block) last = &*it;
      if (other.source.line != m.source.line) break;
    }
    if (last == nullptr) {
      out.contacts.push_back({kind, pass.motion, s.where, s.depth, 0.0});
      last = &out.contacts.back();
    }
    last->volume_mm3 += static_cast<double>(s.volume) * unit;
    if (s.depth > last->depth_mm) {
      last->depth_mm = s.depth;
      last->where = s.where;
    }
  }
  return out;
}

}  // namespace

void fitRemovedVolume(RemovalSummary& summary, double exact_total_mm3) {
  double sum = 0.0;
  for (const float r : summary.removed_mm3) sum += r;
  if (sum <= 0.0) return;
  for (float& r : summary.removed_mm3) r = static_cast<float>(r * (exact_total_mm3 / sum));
}

Result<RemovalSummary> Stock::remove(const Toolpath& path, const std::vector<Tool>& tools,
                                     const RemovalOptions& options, Progress& progress) {
  const ThreadLimit limit(options.threads);
  try {
    Remover remover(*impl_, path, tools, progress, memoryLimit(options));
    if (Status status = remover.preparePasses(); !status) return status.error();
    if (Status status = remover.run(); !status) return status.error();
    return remover.summary();
  } catch (const std::bad_alloc&) {
    return memoryError(2.0 * memoryLimit(options), memoryLimit(options), impl_->h);
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("removing material failed: {}", e.what())};
  }
}

}  // namespace proveout
