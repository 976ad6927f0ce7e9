// Cutting a tool path into the stock: its leaves see the passes that reach into them in program order; then
// the crossings of all changed leaves are found.
#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/base/thread_limit.h"
#include "core/geometry/to_float.h"
#include "removal/contact/contacts.h"
#include "removal/contact/near_contacts.h"
#include "removal/cut/cut_record.h"
#include "removal/cut/leaf_crossings.h"
#include "removal/cut/leaf_cutter.h"
#include "removal/cut/leaf_stacks.h"
#include "removal/cut/narrow_cuts.h"
#include "removal/cut/own_track.h"
#include "removal/cut/thin_walls.h"
#include "removal/sweep/offset_profile.h"

namespace proveout {

namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

class Remover {
 public:
  Remover(Stock::Impl& impl, const Toolpath& path, const std::vector<Tool>& tools,
          const RemovalOptions& options, Progress& progress)
      : impl_(impl),
        path_(path),
        progress_(progress),
        limit_bytes_(memoryLimit(options)),
        watch_all_(options.watch_all),
        spindle_used_(startsSpindle(path)),
        uncut_(impl.uncut),
        blank_(impl.uncut != nullptr ? impl.uncut : impl.field),
        record_(std::make_shared<CutRecord>()),
        table_(record_->table),
        bodies_(path, impl.h, impl.blank.max.z(), table_.store),
        depth_(impl, blank_.get(), *record_),
        near_(depth_, table_, impl.h),
        removed_(path.motions.size()),
        cutters_([this] { return LeafCutter(impl_, table_); }),
        finders_([this] { return CrossingFinder(impl_, table_); }),
        walls_([this] { return ThinWallFinder(impl_, table_); }) {
    for (const Tool& tool : tools) record_->tools.try_emplace(tool.number, tool);
  }

  Status preparePasses();
  Status run();
  RemovalSummary summary() const;

 private:
  void addPart(MotionId id, const ToolParts& tool, ToolParts::Part& part);
  bool needsEnvelope(const Motion& m, const ToolParts::Part& part) const;
  void addEnvelope(MotionId id, ToolParts::Part& part);
  void addPasses(MotionId id, const ToolParts::Part& part, bool watched);
  void takeOverBlank();
  void giveBackBlank();
  bool inBlank(const Coord& origin) const;
  bool stopped() const { return over_limit_ || progress_.cancelled(); }
  void cutStack(const Coord& origin, const StackList& passes);
  bool isOnlyPassed(const Coord& origin, const StackList& passes) const;
  void cutLeaf(const Coord& origin, const StackList& passes);
  /// A leaf that passes reach into, as they leave it.
  struct CutLeaf {
    LeafChange change;
    std::unique_ptr<OpenEdges> open;
    float highest;  ///< see LeafCutter::highest
  };
  struct Finish;
  void commit();
  bool mayLose(const CutLeaf& leaf, const LeafEdges& edges, const std::vector<Crossing>& before);
  float neededHeight(Finish& finish, std::size_t i);
  void finishStack(Finish& finish, const Coord& origin, const StackList& passes);
  void finishLeaf(Finish& finish, std::size_t i, const ReachList& list);
  void findContacts();
  void countShaved(const LeafChange& change, const LeafEdges& edges, const std::vector<Crossing>& before,
                   const std::vector<Crossing>& found);
  void addContacts(RemovalSummary& out) const;
  void addLost(RemovalSummary& out) const;
  void countCrossings(std::vector<float>& removed_mm3, float unit_mm3) const;

  Stock::Impl& impl_;
  const Toolpath& path_;
  Progress& progress_;
  double limit_bytes_;
  bool watch_all_, spindle_used_, any_envelope_ = false;
  std::shared_ptr<const BlankField> uncut_;  ///< as Impl::uncut, before the path
  std::shared_ptr<const BlankField> blank_;  ///< the blank before the path, where it has a closed form
  std::shared_ptr<CutRecord> record_;
  PassTable& table_;
  BodyMaker bodies_;
  OwnTrack track_;
  StockDepth depth_;  ///< before the path
  NearContacts near_;
  std::vector<std::atomic<std::int64_t>> removed_;
  tbb::enumerable_thread_specific<LeafCutter> cutters_;
  tbb::enumerable_thread_specific<CrossingFinder> finders_;
  tbb::enumerable_thread_specific<ThinWallFinder> walls_;
  ConcurrentList<ContactSample> contacts_;
  std::vector<Contact> found_contacts_;
  /// Of motions, kVolumeUnit; empty where no contact asks for it.
  std::vector<std::atomic<std::int64_t>> shaved_;
  bool changed_ = false;  ///< a sample or a crossing
  ConcurrentList<LostFilm> lost_;
  ConcurrentList<CutLeaf> cut_;
  std::atomic<std::uint64_t> evaluations_{0};
  std::atomic<double> bytes_{0.0};
  std::atomic<std::size_t> done_{0};  ///< stacks of leaves
  std::atomic<bool> over_limit_{false};
};

/// Gives motions of earlier paths numbers that those of this path do not have.
void renumberEarlier(Stock::Impl& impl) {
  std::atomic<std::uint32_t> base{kEarlierMotions};
  std::atomic<bool> any_known{false};
  parallelFor(std::size_t{0}, impl.leaves.size(), [&](std::size_t i) {
    bool known = false;
    std::uint32_t above = kEarlierMotions;
    for (const Crossing& c : impl.leaves[i].crossings) {
      if (c.motion == kNoMotion) continue;
      known = known || c.motion < kEarlierMotions;
      above = std::max(above, c.motion + 1);
    }
    if (known) any_known = true;
    for (std::uint32_t old = base; above > old && !base.compare_exchange_weak(old, above);) {
    }
  });
  if (!any_known) return;
  parallelFor(std::size_t{0}, impl.leaves.size(), [&](std::size_t i) {
    for (Crossing& c : impl.leaves[i].crossings) {
      if (c.motion < kEarlierMotions) c.motion += base;
    }
  });
}

void addTo(std::atomic<double>& sum, double value) {
  for (double old = sum.load(); !sum.compare_exchange_weak(old, old + value);) {
  }
}

/// Envelopes go before what they are around, which may take away what they are to come near to.
void Remover::addPart(MotionId id, const ToolParts& tool, ToolParts::Part& part) {
  const Motion& m = path_.motions[id];
  // Bodies of tools that lean or turn take much memory: most parts of them are far from the blank.
  if (const MotionWay way = wayOf(path_, m);
      (way.leans() || way.turns()) &&
      !partBounds(*part.profile, way, path_.bounds(m), 2.0 * impl_.h).overlaps(impl_.blank))
    return;
  const bool watched =
      watch_all_ || part.part != ToolPart::kCutter || m.kind == MotionKind::kRapid || m.spindle == 0.0;
  if (watched && needsEnvelope(m, part) && !track_.holds(wayOf(path_, m), tool, part, impl_.blank.max.z()))
    addEnvelope(id, part);
  addPasses(id, part, watched);
}

/// Whether the part may touch the blank. Where the program never starts the spindle that is told once, from
/// the samples.
bool Remover::needsEnvelope(const Motion& m, const ToolParts::Part& part) const {
  if (!watch_all_ && !spindle_used_ && part.part == ToolPart::kCutter && m.kind != MotionKind::kRapid)
    return false;
  return partBounds(*part.profile, wayOf(path_, m), path_.bounds(m), 0.0).overlaps(impl_.blank);
}

void Remover::addEnvelope(MotionId id, ToolParts::Part& part) {
  const MotionWay way = wayOf(path_, path_.motions[id]);
  const bool leans = way.leans() || way.turns();
  std::unique_ptr<ToolParts::Envelope>& envelope = leans ? part.lean_envelope : part.envelope;
  if (envelope == nullptr) {
    // What is level in the grid may be anything in a tool that leans.
    const double any = std::hypot(kNearLevel, kNearUpright);
    envelope = std::make_unique<ToolParts::Envelope>(offsetProfile(
        *part.profile, (leans ? any : kNearLevel) * impl_.h, (leans ? any : kNearUpright) * impl_.h));
  }
  any_envelope_ = true;
  const std::size_t first = table_.passes.size();
  addPasses(id, envelope->body, true);
  for (std::size_t i = first; i < table_.passes.size(); ++i) {
    table_.passes[i].part = part.part;
    table_.passes[i].around = static_cast<std::int32_t>(table_.passes.size() - i);
  }
}

void Remover::addPasses(MotionId id, const ToolParts::Part& part, bool watched) {
  Pass pass;
  pass.motion = id;
  pass.part = part.part;
  pass.watched = watched;
  for (const MotionBody& made :
       bodies_.make(id, {part.profile, &part.columns, pass.cuts(), pass.cuts() && !pass.watched})) {
    pass.body = made.body;
    pass.lower = made.lower;
    table_.passes.push_back(pass);
  }
}

/// Whether the passes of a motion are where the table says, and those one turn lower are of the same motion.
bool inOrder(const PassTable& table) {
  for (MotionId id = 0; id + 1 < table.first.size(); ++id) {
    for (std::size_t i = table.first[id]; i < table.first[id + 1]; ++i) {
      const Pass& pass = table.passes[i];
      if (pass.motion != id || table.passes[i + static_cast<std::size_t>(pass.lower)].motion != id)
        return false;
    }
  }
  return table.first.back() == table.passes.size();
}

Status Remover::preparePasses() {
  table_.passes.reserve(path_.motions.size());
  table_.first.reserve(path_.motions.size() + 1);
  for (MotionId id = 0; id < path_.motions.size(); ++id) {
    table_.first.push_back(static_cast<std::uint32_t>(table_.passes.size()));
    const Motion& m = path_.motions[id];
    if (!m.from.allFinite() || !m.to.allFinite()) {
      return Error{ErrorKind::kInternal,
                   fmt::format("motion {} has a coordinate that is not a finite number", id)};
    }
    const auto found = record_->tools.find(m.tool);
    if (found == record_->tools.end()) {
      const std::string file = m.source.file < path_.files.size() ? path_.files[m.source.file] : "";
      return inputError(fmt::format(
          "{}:{}: tool {} is not described; give it in the job ([[tool]]) or with --tool {}=SHAPE:...", file,
          m.source.line, m.tool, m.tool));
    }
    const MotionWay way = wayOf(path_, m);
    // A measuring move ends where it touches and takes nothing; a fixture it must not run into.
    if (m.kind == MotionKind::kProbe && !watch_all_) continue;
    for (ToolParts::Part& part : found->second.parts) addPart(id, found->second, part);
    track_.add(way);
    if (static_cast<double>(table_.passes.size() * sizeof(Pass)) > limit_bytes_) {
      return memoryError(2.0 * limit_bytes_, limit_bytes_, impl_.h);
    }
  }
  table_.first.push_back(static_cast<std::uint32_t>(table_.passes.size()));
  PROVEOUT_ASSERT_DEAR(inOrder(table_));
  return Done{};
}

/// From here on what was the blank is what the path cuts.
void Remover::takeOverBlank() {
  if (impl_.cut != nullptr) {  // faces may be of the path before
    impl_.blank_mesh = nullptr;
    impl_.earlier = nullptr;
  }
  forgetLargeRecords(impl_);
  impl_.cut_field = impl_.field;
  impl_.cut_blank = impl_.uncut != nullptr ? impl_.uncut : impl_.field;
  impl_.cut = nullptr;
  impl_.field = impl_.uncut = nullptr;
}

/// Where nothing was cut the stock is the blank that it was, and read like it: what it was before less what
/// it is now is nothing.
void Remover::giveBackBlank() {
  impl_.field = std::exchange(impl_.cut_field, nullptr);
  impl_.cut_blank = nullptr;
  impl_.uncut = uncut_;
}

Status Remover::run() {
  const bool fresh = impl_.cut == nullptr;
  renumberEarlier(impl_);
  takeOverBlank();
  LeafStacks stacks(impl_, std::numeric_limits<float>::infinity());
  const auto stopped = [this] { return this->stopped(); };
  stacks.visit(table_, stopped, [&](const Coord& origin, const StackList& passes) {
    cutStack(origin, passes);
    if (++done_ % 64 == 0)
      progress_.report("removing", static_cast<double>(done_) / static_cast<double>(stacks.count()));
  });
  if (over_limit_) return memoryError(bytes_ * 1.5, limit_bytes_, impl_.h);
  if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  findContacts();
  commit();
  if (progress_.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  if (!changed_ && fresh) {
    giveBackBlank();
  } else {
    impl_.cut = record_;
    impl_.made_from = nullptr;
  }
  return Done{};
}

void Remover::findContacts() {
  found_contacts_ = gatherContacts({impl_, depth_, path_, *record_, watch_all_},
                                   {contacts_.begin(), contacts_.end()}, progress_);
  const bool unseen = std::any_of(found_contacts_.begin(), found_contacts_.end(),
                                  [](const Contact& c) { return c.volume_mm3 == 0.0; });
  if (unseen) shaved_ = std::vector<std::atomic<std::int64_t>>(path_.motions.size());
}

/// What a motion takes between the samples moves crossings, each over a face of a cell. Edges along all three
/// axes tell of the same volume: they share it as their directions are those of the surface.
void Remover::countShaved(const LeafChange& change, const LeafEdges& edges,
                          const std::vector<Crossing>& before, const std::vector<Crossing>& found) {
  std::size_t next = 0;
  forEachEdge(edges, [&](int axis, int x, int y, int z) {
    const Crossing& now = found[next++];
    if (now.motion >= shaved_.size() || !change.before.isCrossed(axis, x, y, z)) return;
    const Crossing& old = before[static_cast<std::size_t>(change.before.indexOf(axis, x, y, z))];
    const double moved = std::abs(static_cast<double>(now.t) - static_cast<double>(old.t)),
                 along = now.unitNormal()[axis];
    shaved_[now.motion].fetch_add(std::llround(moved * along * along / kVolumeUnit),
                                  std::memory_order_relaxed);
  });
}

bool Remover::inBlank(const Coord& origin) const {
  const Vec3 low = impl_.position(origin);
  return Box3{low, low + Vec3::Constant(8 * impl_.h)}.overlaps(impl_.blank.inflated(impl_.h));
}

/// The leaves that stand above each other, from the lowest on; `passes`: what reaches into them.
void Remover::cutStack(const Coord& origin, const StackList& passes) {
  if (passes.empty()) return;
  double lowest = kNowhere, highest = -kNowhere;
  for (const StackReach& reach : passes) {
    lowest = std::min<double>(lowest, reach.low);
    highest = std::max<double>(highest, reach.high);
  }
  for (Coord at = origin; inBlank(at); at = at.offsetBy(0, 0, 8)) {
    const double bottom = impl_.position(at).z(), top = impl_.position(at.offsetBy(0, 0, 8)).z();
    if (lowest < top && highest > bottom) cutLeaf(at, passes);
  }
}

/// Whether nothing but envelopes reaches into a leaf.
bool Remover::isOnlyPassed(const Coord& origin, const StackList& passes) const {
  const double bottom = impl_.position(origin).z(), top = impl_.position(origin.offsetBy(0, 0, 8)).z();
  return std::none_of(passes.begin(), passes.end(), [&](const StackReach& reach) {
    return !table_.passes[reach.pass].isEnvelope() && reach.counts(bottom, top);
  });
}

void Remover::cutLeaf(const Coord& origin, const StackList& passes) {
  const LeafReader reader(impl_);
  LeafChange change = readLeaf(reader, origin);
  if (change.material[0] == 0 && !isMixed(reader, origin)) return;  // empty already
  LeafCutter& cutter = cutters_.local();
  cutter.cut(change, passes);
  for (const auto& [motion, volume] : cutter.removed())
    removed_[motion].fetch_add(volume, std::memory_order_relaxed);
  for (const ContactSample& c : cutter.contacts()) contacts_.push_back(c);
  for (const NearSample& near : cutter.near()) {
    if (const std::optional<ContactSample> c = near_.at(near)) contacts_.push_back(*c);
  }
  if (any_envelope_ && isOnlyPassed(origin, passes)) return;
  evaluations_.fetch_add(cutter.evaluations(), std::memory_order_relaxed);
  const bool uniform = change.material == kAllInside || change.material == kAllOutside;
  addTo(bytes_, (uniform ? 0.0 : leafBytes(1.0)) + static_cast<double>(sizeof(CutLeaf)));
  if (bytes_ > limit_bytes_) over_limit_ = true;
  cut_.push_back({std::move(change), cutter.openEdges(), toFloat(cutter.highest())});
}

/// What the crossings of all changed leaves are found with.
struct Remover::Finish {
  LeafCommit commit;
  LeafStacks stacks;
  std::vector<std::vector<std::uint32_t>> leaves;  ///< of each stack, those whose passes are asked for
  std::vector<float> height;                       ///< of each changed leaf: below which they are
  std::vector<std::uint8_t> may_lose;
};

/// The samples of all leaves come first: edges lead into the neighbours. Then passes are listed again, for
/// the few leaves that have edges and only as far as they reach down to them: kept lists would be most of the
/// memory.
void Remover::commit() {
  std::vector<const LeafChange*> changes;
  for (const CutLeaf& leaf : cut_) changes.push_back(&leaf.change);
  Finish finish{LeafCommit(impl_, changes), LeafStacks(impl_, LeafStacks::kNone), {}, {}, {}};
  finish.height.resize(changes.size());
  finish.may_lose.resize(changes.size());
  parallelFor(std::size_t{0}, changes.size(),
              [&](std::size_t i) { finish.height[i] = neededHeight(finish, i); });
  finish.leaves.resize(finish.stacks.count());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (finish.height[i] == LeafStacks::kNone) continue;
    const std::size_t stack = finish.stacks.number(changes[i]->origin);
    finish.stacks.raise(stack, finish.height[i]);
    finish.leaves[stack].push_back(static_cast<std::uint32_t>(i));
  }
  const auto stopped = [this] { return this->stopped(); };
  finish.stacks.visit(table_, stopped, [&](const Coord& origin, const StackList& passes) {
    finishStack(finish, origin, passes);
  });
  finish.commit.finish();
  changed_ = finish.commit.changed();
}

/// Whether material may be lost, as far as the passes that took most and last tell. Others could only show
/// that it is not.
bool Remover::mayLose(const CutLeaf& leaf, const LeafEdges& edges, const std::vector<Crossing>& before) {
  ReachList takers;
  for (const std::uint32_t taker : leaf.change.takers) {
    if (taker != kNoPass) takers.push_back({taker, -toFloat(kNowhere), toFloat(kNowhere)});
  }
  return finders_.local().findLost(leaf.change, edges, before, takers).edges > 0 ||
         walls_.local().mayFind(leaf.change, edges, leaf.open.get());
}

/// Height below which passes may count for the crossings of a leaf, mm; kNone, and it is done, where none do.
float Remover::neededHeight(Finish& finish, std::size_t i) {
  if (progress_.cancelled()) return LeafStacks::kNone;
  const CutLeaf& leaf = cut_[i];
  const LeafEdges edges = finish.commit.edges(i);
  const auto heightOf = [&](int z) { return impl_.position(leaf.change.origin.offsetBy(0, 0, z)).z(); };
  finish.may_lose[i] = mayLose(leaf, edges, finish.commit.before(i));
  if (finish.may_lose[i]) return toFloat(heightOf(9));
  if (edges.count == 0) {
    finish.commit.set(i, edges, {});
    return LeafStacks::kNone;
  }
  // Far more than what makes two cuts differ, so that what is left out bears on none that counts.
  const double slack = 1e-3 * impl_.h;
  double level = -kNowhere, upright = -kNowhere;
  for (int z = 0; z < 8; ++z) {
    if ((edges.crossed[0][z] | edges.crossed[1][z]) != 0) level = heightOf(z);
    if (edges.crossed[2][z] != 0) upright = heightOf(z + 1);
  }
  return toFloat(std::max(level, std::min<double>(upright, leaf.highest)) + slack);
}

void Remover::finishStack(Finish& finish, const Coord& origin, const StackList& passes) {
  ReachList list;
  for (const std::uint32_t i : finish.leaves[finish.stacks.number(origin)]) {
    const Coord& at = cut_[i].change.origin;
    const double bottom = impl_.position(at).z(), top = impl_.position(at.offsetBy(0, 0, 8)).z();
    reachesBetween(passes, bottom, std::min<double>(top, finish.height[i]), list);
    finishLeaf(finish, i, list);
  }
}

/// `list`: the passes that may count for the leaf.
void Remover::finishLeaf(Finish& finish, std::size_t i, const ReachList& list) {
  if (progress_.cancelled()) return;
  CutLeaf& leaf = cut_[i];
  const LeafEdges edges = finish.commit.edges(i);
  const std::vector<Crossing>& before = finish.commit.before(i);
  CrossingFinder& finder = finders_.local();
  if (finish.may_lose[i]) {
    for (const LostFilm& lost : {finder.findLost(leaf.change, edges, before, list),
                                 walls_.local().find(leaf.change, edges, leaf.open.get(), list)}) {
      if (lost.edges > 0) lost_.push_back(lost);
    }
  }
  std::vector<Crossing> found = finder.find(leaf.change, edges, before, list);
  if (!shaved_.empty()) countShaved(leaf.change, edges, before, found);
  finish.commit.set(i, edges, std::move(found));
  leaf.open.reset();
}

void Remover::addLost(RemovalSummary& out) const {
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::uint64_t edges = 0, parts = 0;
  for (const LostFilm& lost : lost_) {
    if (edges == 0 || before(lost.where, out.lost_film_at)) out.lost_film_at = lost.where;
    edges += static_cast<std::uint64_t>(lost.edges);
    parts += static_cast<std::uint64_t>(lost.parts);
  }
  const double area = impl_.h * impl_.h;
  out.lost_film_mm2 = static_cast<double>(edges) * area;
  out.lost_mm3 = static_cast<double>(parts) / LostFilm::kParts * area * impl_.h;
}

/// What goes through between the samples leaves crossings alone: each counts for the motion that made it.
void Remover::countCrossings(std::vector<float>& removed_mm3, float unit_mm3) const {
  for (const StockLeaf& leaf : impl_.leaves) {
    for (const Crossing& c : leaf.crossings) {
      if (c.motion < removed_mm3.size()) removed_mm3[c.motion] += unit_mm3;
    }
  }
}

/// What contacts took between the samples is theirs, and their motions'.
void Remover::addContacts(RemovalSummary& out) const {
  out.contacts = found_contacts_;
  if (shaved_.empty()) return;
  const double unit = kVolumeUnit * impl_.h * impl_.h * impl_.h;
  for (Contact& contact : out.contacts) {
    if (contact.volume_mm3 > 0.0) continue;
    PROVEOUT_ASSERT(contact.motion <= contact.last && contact.last < shaved_.size());
    for (MotionId m = contact.motion; m <= contact.last; ++m) {
      const double taken = static_cast<double>(shaved_[m].load()) * unit;
      contact.volume_mm3 += taken;
      if (removed_[m].load() == 0) out.removed_mm3[m] = toFloat(taken);
    }
  }
}

RemovalSummary Remover::summary() const {
  RemovalSummary out;
  addLost(out);
  out.narrow_cuts = findNarrowCuts(impl_, table_, path_);
  out.voxel_evaluations = evaluations_;
  const double unit = kVolumeUnit * impl_.h * impl_.h * impl_.h;
  out.removed_mm3.reserve(removed_.size());
  bool any = false;
  for (const auto& r : removed_) {
    any = any || r.load() > 0;
    out.removed_mm3.push_back(toFloat(static_cast<double>(r.load()) * unit));
  }
  addContacts(out);
  if (!any) countCrossings(out.removed_mm3, toFloat(unit));
  return out;
}

}  // namespace

double countedVolume(const RemovalSummary& removal) {
  return std::accumulate(removal.removed_mm3.begin(), removal.removed_mm3.end(), 0.0);
}

void fitRemovedVolume(RemovalSummary& summary, double exact_total_mm3) {
  const double sum = countedVolume(summary);
  if (sum <= 0.0) return;
  for (float& r : summary.removed_mm3) r = toFloat(r * (exact_total_mm3 / sum));
}

Result<RemovalSummary> Stock::remove(const Toolpath& path, const std::vector<Tool>& tools,
                                     const RemovalOptions& options, Progress& progress) {
  const ThreadLimit limit(options.threads);
  try {
    Remover remover(*impl_, path, tools, options, progress);
    if (Status status = remover.preparePasses(); !status) return status.error();
    if (Status status = remover.run(); !status) return status.error();
    return remover.summary();
  } catch (const std::bad_alloc&) {
    return gridAllocationError(options, impl_->h);
  } catch (const std::exception& e) {
    return Error{ErrorKind::kInternal, fmt::format("removing material failed: {}", e.what())};
  }
}

}  // namespace proveout
