// Cutting a tool path into the stock: blocks of the grid are halved down to leaves, each with the passes that can
// touch it; a leaf's samples see its passes in program order; then the crossings of all changed leaves are found.
#include <fmt/format.h>
#include <tbb/concurrent_vector.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "core/base/parallel_for.h"
#include "core/tool/tool_solid.h"
#include "removal/leaf_crossings.h"
#include "removal/leaf_cutter.h"
#include "removal/threads.h"

namespace proveout {

namespace {

using openvdb::Coord;

/// Curved motions are cut as chords that lie this close to them, mm: far below the smallest error that the surface
/// has elsewhere. Level arcs of one radius have a closed form and need none.
constexpr double kChordMm = 5e-5;
/// The same for parts of the tool that do not cut: below what counts as contact.
constexpr double kContactChordMm = 5e-4;
constexpr double kMostChords = 1e6;
/// Level arcs whose radius and height change by less than this are circles, mm.
constexpr double kSameRadiusMm = 1e-7;

struct Solids {
  explicit Solids(const Tool& tool) : solid(makeToolSolid(tool)) {
    for (const ConvexProfile& p : solid.cutter) add(p, ToolPart::kCutter);
    for (const ConvexProfile& p : solid.shank) add(p, ToolPart::kShank);
    for (const ConvexProfile& p : solid.holder) add(p, ToolPart::kHolder);
  }
  Solids(const Solids&) = delete;

  struct Part {
    const ConvexProfile* profile;
    ColumnSolid columns;
    ToolPart part;
  };
  ToolSolid solid;
  std::vector<Part> parts;

 private:
  void add(const ConvexProfile& profile, ToolPart part) { parts.push_back({&profile, columnSolid(profile), part}); }
};

class Remover {
 public:
  Remover(Stock::Impl& impl, const Toolpath& path, const std::vector<Tool>& tools, Progress& progress,
          double limit_bytes)
      : impl_(impl),
        path_(path),
        progress_(progress),
        limit_bytes_(limit_bytes),
        removed_(path.motions.size()),
        cutters_([this] { return LeafCutter(impl_, table_); }),
        finders_([this] { return CrossingFinder(impl_, table_); }) {
    for (const Tool& tool : tools) solids_.try_emplace(tool.number, tool);
  }

  Status preparePasses();
  Status run();
  RemovalSummary summary() const;

 private:
  using List = std::vector<std::uint32_t>;

  void addPasses(MotionId id, const Solids::Part& part, bool watched, std::int32_t curve);
  bool isLevelArc(const Motion& motion, const ArcGeometry& arc) const;
  void visit(const Coord& origin, int size, const List& candidates);
  List cull(const Coord& origin, int size, const List& candidates) const;
  void leaf(const Coord& origin, List passes);

  Stock::Impl& impl_;
  const Toolpath& path_;
  Progress& progress_;
  double limit_bytes_;
  std::map<int, Solids> solids_;
  PassTable table_;
  std::vector<std::atomic<std::int64_t>> removed_;
  tbb::enumerable_thread_specific<LeafCutter> cutters_;
  tbb::enumerable_thread_specific<CrossingFinder> finders_;
  tbb::concurrent_vector<ContactSample> contacts_;
  std::mutex mutex_;
  std::vector<LeafChange> changes_;
  std::vector<List> lists_;  ///< passes of each change
  std::atomic<std::uint64_t> evaluations_{0};
  std::atomic<double> bytes_{0.0}, done_{0.0};
  double total_blocks_ = 1.0;
  std::atomic<bool> over_limit_{false};
};

void addTo(std::atomic<double>& sum, double value) {
  for (double old = sum.load(); !sum.compare_exchange_weak(old, old + value);) {
  }
}

bool Remover::isLevelArc(const Motion& motion, const ArcGeometry& arc) const {
  const ArcFrame frame = arcFrame(motion.from, motion.to, arc);
  return arc.normal.head<2>().squaredNorm() < 1e-24 && std::abs(frame.rise) < kSameRadiusMm &&
         std::abs(frame.radius_end - frame.radius_start) < kSameRadiusMm && frame.radius_start > kSameRadiusMm;
}

void Remover::addPasses(MotionId id, const Solids::Part& part, bool watched, std::int32_t curve) {
  const Motion& m = path_.motions[id];
  Pass pass;
  pass.profile = part.profile;
  pass.motion = id;
  pass.curve = curve;
  pass.part = part.part;
  pass.watched = watched;
  if (m.arc < 0) {
    pass.columns = columnLine(part.columns, m.from, m.to);
    table_.passes.push_back(pass);
    return;
  }
  const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
  if (isLevelArc(m, arc)) {
    pass.columns = columnArc(part.columns, m.from, m.to, arc);
    table_.passes.push_back(pass);
    return;
  }
  const ArcFrame frame = arcFrame(m.from, m.to, arc);
  const double radius = std::max({frame.radius_start, frame.radius_end, 1e-6});
  const double within = part.part == ToolPart::kCutter ? kChordMm : kContactChordMm;
  const double step = std::sqrt(8.0 * std::min(within, radius) / radius);
  const int chords = static_cast<int>(std::clamp(std::ceil(std::abs(arc.sweep_rad) / step), 1.0, kMostChords));
  Vec3 from = m.from;
  for (int i = 1; i <= chords; ++i) {
    const Vec3 to = i == chords ? m.to : arcPoint(frame, arc, static_cast<double>(i) / chords);
    pass.columns = columnLine(part.columns, from, to);
    table_.passes.push_back(pass);
    from = to;
  }
}

Status Remover::preparePasses() {
  for (MotionId id = 0; id < path_.motions.size(); ++id) {
    const Motion& m = path_.motions[id];
    if (!m.from.allFinite() || !m.to.allFinite()) {
      return Error{ErrorKind::kInternal,
                   fmt::format("motion {} has a coordinate that is not a finite number", id)};
    }
    const auto found = solids_.find(m.tool);
    if (found == solids_.end()) {
      const std::string file = m.source.file < path_.files.size() ? path_.files[m.source.file] : "";
      return inputError(fmt::format(
          "{}:{}: tool {} is not described; give it in the job ([[tool]]) or with --tool {}=SHAPE:...", file,
          m.source.line, m.tool, m.tool));
    }
    const bool watched = m.kind == MotionKind::kRapid || m.spindle == 0.0;
    for (const Solids::Part& part : found->second.parts) {
      std::int32_t curve = -1;
      if (m.arc >= 0) {
        curve = static_cast<std::int32_t>(table_.curves.size());
        table_.curves.emplace_back(*part.profile, m.from, m.to, &path_.arcs[static_cast<std::size_t>(m.arc)]);
      }
      addPasses(id, part, watched || part.part != ToolPart::kCutter, curve);
    }
    if (static_cast<double>(table_.passes.size() * sizeof(Pass)) > limit_bytes_) {
      return memoryError(2.0 * limit_bytes_, limit_bytes_, impl_.h);
    }
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
  List all(table_.passes.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  total_blocks_ = std::pow(size / 8.0, 3);
  visit(low, size, all);
  if (over_limit_) return memoryError(bytes_ * 1.5, limit_bytes_, impl_.h);
  if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  commitChanges(impl_, changes_, [this](std::size_t i, const LeafEdges& edges, const auto& before) {
    std::vector<Crossing> found;
    if (!progress_.cancelled()) found = finders_.local().find(changes_[i], edges, before, lists_[i]);
    List().swap(lists_[i]);
    return found;
  });
  if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  return Done{};
}

Remover::List Remover::cull(const Coord& origin, int size, const List& candidates) const {
  // The block reaches from voxel 0 to voxel `size`: one layer more than its own.
  const double half = 0.5 * size * impl_.h;
  const Vec3 low = impl_.position(origin);
  const BlockBox box{low.x() + half, low.y() + half, half, low.z(), low.z() + 2.0 * half};
  List kept;
  for (const std::uint32_t i : candidates) {
    if (reachIn(table_.passes[i], box) < std::numeric_limits<double>::infinity()) kept.push_back(i);
  }
  return kept;
}

void Remover::visit(const Coord& origin, int size, const List& candidates) {
  if (over_limit_ || progress_.cancelled()) return;
  const double blocks = std::pow(size / 8.0, 3);
  const Vec3 low = impl_.position(origin);
  const Box3 box{low, low + Vec3::Constant(size * impl_.h)};
  const bool in_blank = box.overlaps(impl_.blank.inflated(impl_.h));
  List passes = in_blank ? cull(origin, size, candidates) : List{};
  if (passes.empty() || size == 8) {
    if (!passes.empty()) leaf(origin, std::move(passes));
    if (size >= 64) addTo(done_, blocks);
    return;
  }
  const int half = size / 2;
  const auto child = [&](int i) {
    visit(origin.offsetBy(i & 1 ? half : 0, i & 2 ? half : 0, i & 4 ? half : 0), half, passes);
  };
  if (size >= 32) {
    parallelFor(0, 8, child);
  } else {
    for (int i = 0; i < 8; ++i) child(i);
  }
  if (size == 64) addTo(done_, blocks);
  if (size >= 64) progress_.report("removing", done_.load() / total_blocks_);
}

void Remover::leaf(const Coord& origin, List passes) {
  const LeafReader reader(impl_);
  LeafChange change = readLeaf(reader, origin);
  if (!isMixed(reader, origin) && change.material[0] == 0) return;  // empty already
  LeafCutter& cutter = cutters_.local();
  cutter.cut(change, passes);
  for (const auto& [motion, volume] : cutter.removed())
    removed_[motion].fetch_add(volume, std::memory_order_relaxed);
  for (const ContactSample& c : cutter.contacts()) contacts_.push_back(c);
  evaluations_.fetch_add(cutter.evaluations(), std::memory_order_relaxed);
  passes.shrink_to_fit();
  addTo(bytes_, leafBytes(1.0) + static_cast<double>(sizeof(LeafChange) + passes.size() * sizeof(std::uint32_t)));
  if (bytes_ > limit_bytes_) over_limit_ = true;
  const std::lock_guard<std::mutex> lock(mutex_);
  changes_.push_back(change);
  lists_.push_back(std::move(passes));
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
    const Pass& pass = table_.passes[s.pass];
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
