// Cutting a tool path into the stock: blocks of the grid are halved down to leaves, each with the motions
// that can touch it; a leaf sees its motions in program order.
#include <fmt/format.h>
#include <tbb/concurrent_vector.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <map>
#include <mutex>

#include "core/base/parallel_for.h"
#include "core/tool/tool_solid.h"
#include "removal/leaf_cutter.h"
#include "removal/threads.h"

namespace proveout {

namespace {

using openvdb::Coord;

class Remover {
 public:
  Remover(Stock::Impl& impl, const Toolpath& path, const std::vector<Tool>& tools, Progress& progress,
          double limit_bytes)
      : impl_(impl),
        path_(path),
        progress_(progress),
        limit_bytes_(limit_bytes),
        removed_(path.motions.size()),
        cutters_([this] { return LeafCutter(impl_, passes_); }) {
    for (const Tool& tool : tools) solids_.emplace(tool.number, makeToolSolid(tool));
  }

  Status preparePasses();
  Status run();
  RemovalSummary summary() const;

 private:
  using List = std::vector<std::uint32_t>;

  void addParts(const std::vector<ConvexProfile>& parts, ToolPart part, MotionId id, const ArcGeometry* arc,
                bool watched);
  void visit(const Coord& origin, int size, const List& candidates);
  List cull(const Coord& origin, int size, const List& candidates) const;
  void leaf(const Coord& origin, const List& passes);

  Stock::Impl& impl_;
  const Toolpath& path_;
  Progress& progress_;
  double limit_bytes_;
  std::map<int, ToolSolid> solids_;
  std::deque<Pass> passes_;
  std::vector<std::atomic<std::int64_t>> removed_;
  tbb::enumerable_thread_specific<LeafCutter> cutters_;
  tbb::concurrent_vector<ContactSample> contacts_;
  std::mutex mutex_;
  std::vector<LeafResult> results_;
  std::atomic<std::uint64_t> evaluations_{0}, leaves_{0};
  std::atomic<double> done_{0.0};
  double total_blocks_ = 1.0;
  std::atomic<bool> over_limit_{false};
};

void Remover::addParts(const std::vector<ConvexProfile>& parts, ToolPart part, MotionId id,
                       const ArcGeometry* arc, bool watched) {
  const Motion& m = path_.motions[id];
  for (const ConvexProfile& profile : parts)
    passes_.push_back({Sweep(profile, m.from, m.to, arc), id, part, watched});
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
    addParts(solid->second.cutter, ToolPart::kCutter, id, arc, watched);
    addParts(solid->second.shank, ToolPart::kShank, id, arc, true);
    addParts(solid->second.holder, ToolPart::kHolder, id, arc, true);
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
    parallelFor(0, 8, child);
  } else {
    for (int i = 0; i < 8; ++i) child(i);
  }
  if (size >= 64) progress_.report("removing", done_.load() / total_blocks_);
}

void Remover::leaf(const Coord& origin, const List& passes) {
  LeafCutter& cutter = cutters_.local();
  LeafResult result;
  if (!cutter.cut(origin, passes, result)) return;
  for (const auto& [motion, volume] : cutter.removed())
    removed_[motion].fetch_add(volume, std::memory_order_relaxed);
  for (const ContactSample& c : cutter.contacts()) contacts_.push_back(c);
  evaluations_.fetch_add(cutter.evaluations(), std::memory_order_relaxed);
  const std::lock_guard<std::mutex> lock(mutex_);
  results_.push_back(std::move(result));
  if (leafBytes(static_cast<double>(++leaves_)) > limit_bytes_) over_limit_ = true;
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
    if (pass.part == ToolPart::kShank) kind = ContactKind::kShank;
    if (pass.part == ToolPart::kHolder) kind = ContactKind::kHolder;
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
