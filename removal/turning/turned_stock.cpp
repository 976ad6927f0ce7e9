#include "removal/turning/turned_stock.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/assert.h"
#include "core/geometry/to_float.h"
#include "removal/turning/parting.h"
#include "removal/turning/section/section_area.h"
#include "removal/turning/section/section_depth.h"
#include "removal/turning/threads/thread_cover.h"
#include "removal/turning/threads/thread_sections.h"
#include "removal/turning/turning_tool.h"

namespace proveout {

namespace {

/// Contacts thinner than this are touches, mm.
constexpr double kTouch = 1e-3;
/// Off the plane or the axis by less than this is rounding, mm.
constexpr double kOff = 1e-6;
/// Half-planes in which the volume of threads is estimated.
constexpr int kThreadPlanes = 4;
/// Motions that are looked at as one stroke, at most.
constexpr MotionId kLongestStroke = 64;
/// A thread of more turns is a slip in the program, and would take minutes.
constexpr double kMostTurns = 2000.0;

Vec2 inPlane(const Vec3& p) { return {p.x(), p.z()}; }

PlaneWay planeWay(const Motion& motion, const ArcGeometry* arc) {
  PlaneWay way;
  way.from = inPlane(motion.from);
  way.to = inPlane(motion.to);
  if (arc == nullptr) return way;
  way.arc = true;
  way.center = inPlane(arc->center);
  // About +Y by the right-hand rule is from +Z towards +X.
  way.sweep_rad = arc->normal.y() > 0.0 ? -arc->sweep_rad : arc->sweep_rad;
  return way;
}

const ArcGeometry* arcOf(const Toolpath& path, const Motion& motion) {
  if (motion.arc < 0) return nullptr;
  PROVEOUT_ASSERT(static_cast<std::size_t>(motion.arc) < path.arcs.size());
  return &path.arcs[static_cast<std::size_t>(motion.arc)];
}

Vec3 inSpace(const Vec2& p) { return {p.x(), 0.0, p.y()}; }

/// What outlines sweep on both sides of the axis.
std::vector<SectionPath> bothSides(const std::vector<ConvexOutline>& outlines, const PlaneWay& way) {
  std::vector<SectionPath> sweeps;
  for (const ConvexOutline& outline : outlines) {
    for (SectionPath& path : sweptPaths(outline, way)) sweeps.push_back(std::move(path));
  }
  for (SectionPath& path : mirroredPaths(sweeps)) sweeps.push_back(std::move(path));
  return sweeps;
}

/// Gathers contacts: one for each unbroken run of motions of a kind, a tool and a block.
class ContactList {
 public:
  explicit ContactList(const Toolpath& path) : path_(path) {}

  /// `area`: the material before; pieces that only touch are left out.
  void add(ContactKind kind, MotionId id, const SectionArea& area, const std::vector<SectionPiece>& pieces) {
    Contact now;
    now.kind = kind;
    now.motion = now.last = id;
    for (const SectionPiece& piece : pieces) {
      if (piece.thickness_mm < kTouch) continue;
      now.volume_mm3 += piece.volume_mm3;
      const SectionDepth deepest = contactDepth(area, piece.outline);
      if (deepest.depth_mm <= now.depth_mm) continue;
      now.depth_mm = deepest.depth_mm;
      now.where = inSpace(deepest.at);
    }
    if (now.volume_mm3 <= 0.0) return;
    Run& run = runs_[static_cast<std::size_t>(kind)];
    const bool goes_on = run.contact && run.last + 1 >= id && sameBlock(list_[*run.contact].motion, id);
    run.last = id;
    if (!goes_on) {
      run.contact = list_.size();
      list_.push_back(now);
      return;
    }
    Contact& known = list_[*run.contact];
    known.last = id;
    known.volume_mm3 += now.volume_mm3;
    if (now.depth_mm > known.depth_mm) {
      known.depth_mm = now.depth_mm;
      known.where = now.where;
    }
  }

  std::vector<Contact> take() {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const Contact& a, const Contact& b) { return a.motion < b.motion; });
    return std::move(list_);
  }

 private:
  struct Run {
    std::optional<std::size_t> contact;
    MotionId last = 0;
  };
  bool sameBlock(MotionId a, MotionId b) const {
    PROVEOUT_ASSERT(a < path_.motions.size() && b < path_.motions.size());
    const Motion &m = path_.motions[a], &n = path_.motions[b];
    return m.tool == n.tool && m.source.file == n.source.file && m.source.line == n.source.line &&
           m.source.block == n.source.block;
  }

  const Toolpath& path_;
  std::vector<Contact> list_;
  std::array<Run, kContactKinds> runs_;
};

}  // namespace

const char* turningObstacle(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
  if (std::abs(motion.from.y()) > kOff || std::abs(motion.to.y()) > kOff)
    return "the tool leaves the plane of the spindle axis (Y is not 0)";
  if (axis != nullptr && !axis->alongZ()) return "the tool is tilted";
  if (arc == nullptr) return nullptr;
  if (std::abs(std::abs(arc->normal.y()) - 1.0) > 1e-9)
    return "the arc is not in the plane of the spindle axis";
  return motion.kind == MotionKind::kThread ? "a thread along an arc" : nullptr;
}

Status turnable(const Toolpath& path, const std::vector<Tool>& tools) {
  for (const Motion& motion : path.motions) {
    const AxisSweep* axis = motion.axis < 0 ? nullptr : &path.axes[static_cast<std::size_t>(motion.axis)];
    const auto same = [&](const Tool& tool) { return tool.number == motion.tool; };
    const bool defined = std::any_of(tools.begin(), tools.end(), same);
    const char* obstacle =
        defined ? turningObstacle(motion, arcOf(path, motion), axis) : "a tool that is not defined";
    if (motion.kind == MotionKind::kThread && !(threadTurns(path, motion) <= kMostTurns))
      obstacle = "a thread of more than 2000 turns";
    if (obstacle == nullptr || motion.kind == MotionKind::kProbe) continue;
    return inputError(fmt::format("{}:{}: {}: this cannot be turned", path.files[motion.source.file],
                                  motion.source.line, obstacle));
  }
  return Done{};
}

struct TurnedStock::Impl {
  SectionArea area;                 ///< held by the chuck
  std::vector<SectionBody> parted;  ///< cut off so far
  std::vector<ThreadSweep> threads;
  std::vector<std::shared_ptr<const ConvexOutline>> outlines;
  double initial_volume = 0.0;
  Box3 bounds;
};

namespace {

/// Cuts one path; what lives as long as that.
class Turning {
 public:
  Turning(const Toolpath& path, const std::vector<Tool>& tools, SectionArea& area,
          std::vector<SectionBody>& parted, std::vector<ThreadSweep>& threads,
          std::vector<std::shared_ptr<const ConvexOutline>>& outlines)
      : path_(path), area_(area), parted_(parted), threads_(threads), outlines_(outlines), contacts_(path) {
    for (const Tool& tool : tools) tools_.try_emplace(tool.number, tool);
    if (!threads.empty()) makePlanes();
    removed_.resize(path.motions.size(), 0.0f);
  }

  void motion(MotionId id) {
    const Motion& motion = path_.motions[id];
    if (motion.kind == MotionKind::kProbe) return;
    bool behind = false;
    const ToolWay on = placed(id, behind);
    const bool grooves = motion.kind == MotionKind::kThread && on.tool->insert;
    // What leaves a thread takes pieces of its way alone.
    const bool at_end = grooves || (thread_way_ && motion.kind == MotionKind::kRapid);
    Sections before{area_, planes_};
    if (grooves) {
      thread(id, *on.tool, on.way, behind);
    } else {
      cut(id, *on.tool, on.way);
      if (motion.kind != MotionKind::kRapid || motion.tool != thread_tool_) thread_way_.reset();
    }
    holder(id, *on.tool, on.way);
    if (!area_.apart()) return;
    if (at_end)
      removed_[id] += toFloat(part(id, on, {}));
    else
      partAlong(id, on, std::move(before));
  }

  RemovalSummary summary() {
    RemovalSummary summary;
    summary.removed_mm3 = std::move(removed_);
    summary.contacts = contacts_.take();
    return summary;
  }

 private:
  /// The section, and the planes that stand for threads.
  struct Sections {
    SectionArea area;
    std::vector<SectionArea> planes;
  };
  /// A piece that was cut off.
  struct PartedArea {
    SectionArea area;     ///< what later motions may meet
    MotionId stroke_end;  ///< the last motion of the stroke that cut it off
  };

  /// `behind`: the tool is on the other side of the axis, which tool and way are mirrored for.
  ToolWay placed(MotionId id, bool& behind) {
    const Motion& motion = path_.motions[id];
    const PlaneWay way = planeWay(motion, arcOf(path_, motion));
    const TurningTool& tool = tools_.at(motion.tool);
    behind = tool.worksBehind(way);
    if (behind) return {&mirroredTool(motion.tool), way.mirrored()};
    return {&tool, way};
  }

  /// How many motions behind one go on in its direction, with its tool: a block that was cut in two is one.
  MotionId strokeEnd(MotionId id) const {
    const Motion& first = path_.motions[id];
    PlaneWay before = planeWay(first, arcOf(path_, first));
    MotionId end = id;
    for (MotionId k = id + 1; k < path_.motions.size() && k - id <= kLongestStroke; ++k) {
      const Motion& next = path_.motions[k];
      if (next.kind != first.kind || next.tool != first.tool) break;
      const PlaneWay way = planeWay(next, arcOf(path_, next));
      if (way.length() <= 0.0) continue;
      if (!goesOn(before, way)) break;
      before = way;
      end = k;
    }
    return end;
  }
  std::vector<ToolWay> strokeBehind(MotionId id) {
    std::vector<ToolWay> stroke;
    bool behind = false;
    for (MotionId k = id + 1; k <= strokeEnd(id); ++k) stroke.push_back(placed(k, behind));
    return stroke;
  }

  const TurningTool& mirroredTool(int number) {
    const auto known = mirrored_tools_.find(number);
    if (known != mirrored_tools_.end()) return known->second;
    return mirrored_tools_.emplace(number, tools_.at(number).mirrored()).first->second;
  }

  void cut(MotionId id, const TurningTool& tool, const PlaneWay& way) {
    const Motion& motion = path_.motions[id];
    const bool rapid = motion.kind == MotionKind::kRapid;
    std::vector<SectionPath> sweeps = tool.swept(way);
    // A thread tool that leaves its groove stands in it: the section knows no groove.
    std::vector<SectionPath> spared;
    if (thread_way_ && rapid) spared = tool.swept(*thread_way_);
    const std::vector<SectionPath> beyond = mirroredPaths(sweeps);
    if (rapid) {
      const std::vector<SectionPath> met = rapidContact(id, tool, sweeps, spared);
      if (met.empty() && beyond.empty()) return;
      if (thread_way_) sweeps = met;
    }
    if (!rapid) {
      if (motion.spindle == 0.0) contact(ContactKind::kSpindleOff, id, sweeps, spared);
      for (const PartedArea& piece : parted_areas_) {
        if (id > piece.stroke_end)
          contacts_.add(ContactKind::kPartedOff, id, piece.area, piece.area.common(sweeps, spared));
      }
    }
    if (tool.insert) {
      // What a rapid motion touches is told as such already.
      if (const auto backs = rapid ? std::vector<SectionPath>{} : tool.sweptBacks(way); area_.mayMeet(backs))
        contact(ContactKind::kInsertBack, id, backs, tool.sweptEdges(way));
      if (!rapid) endOfEdge(id, tool, way);
    } else if (std::max(std::abs(way.from.x()), std::abs(way.to.x())) > kTouch) {
      contact(ContactKind::kAxis, id, sweeps, {});
    }
    double taken = take(sweeps, id, spared);
    if (!beyond.empty()) {
      if (tool.insert) contact(ContactKind::kAxis, id, beyond, {});
      taken += take(beyond, id, {});
    }
    removed_[id] += toFloat(taken);
  }

  /// Cuts the section, and the planes that stand for threads if there are any. Returns the volume, mm3.
  double take(const std::vector<SectionPath>& sweeps, MotionId id, const std::vector<SectionPath>& spared) {
    const double taken = area_.subtract(sweeps, id, spared);
    if (taken > 0.0) standing_.cut(sweeps, id, spared);
    if (planes_.empty()) return taken;
    PROVEOUT_ASSERT(planes_.size() == kThreadPlanes);
    double sum = 0.0;
    for (SectionArea& plane : planes_) sum += plane.subtract(sweeps, id, spared);
    return sum / kThreadPlanes;
  }

  /// `behind`: the tool is on the other side of the axis, which tool and way are mirrored for.
  void thread(MotionId id, const TurningTool& tool, const PlaneWay& way, bool behind) {
    const Motion& motion = path_.motions[id];
    const double turns = threadTurns(path_, motion), side = motion.spindle < 0.0 ? 1.0 : -1.0;
    ThreadSweep sweep;
    sweep.outline = tool.thread.get();
    sweep.from = way.from;
    sweep.to = way.to;
    sweep.start_rad = side * degToRad(static_cast<double>(motion.thread_start_deg)) + (behind ? kPi : 0.0);
    sweep.turns = side * turns;
    const double along = (way.to - way.from).cwiseAbs().maxCoeff();
    if (along > 0.0)
      sweep.bend = 0.5 * static_cast<double>(motion.thread_pitch_change) * turns * turns / along;
    sweep.motion = id;
    thread_way_ = way;
    thread_end_rad_ = sweep.start_rad + 2.0 * kPi * sweep.turns;
    thread_tool_ = motion.tool;
    if (motion.spindle == 0.0) {
      contact(ContactKind::kSpindleOff, id, tool.swept(way), {});
      return;
    }
    if (area_.common(tool.swept(way)).empty()) return;
    endOfEdge(id, tool, way);
    if (std::find(outlines_.begin(), outlines_.end(), tool.thread) == outlines_.end())
      outlines_.push_back(tool.thread);
    if (planes_.empty()) makePlanes();
    threads_.push_back(sweep);
    removed_[id] += toFloat(takeThread(sweep));
  }

  /// A blade or a tooth that is in deeper than its edge is long.
  void endOfEdge(MotionId id, const TurningTool& tool, const PlaneWay& way) {
    if (const auto ends = tool.sweptEndOfEdge(way); area_.mayMeet(ends))
      contact(ContactKind::kInsertBack, id, ends, tool.swept(way));
  }

  void makePlanes() {
    planes_.assign(kThreadPlanes, area_);
    for (const ThreadSweep& known : threads_) takeThread(known);
  }

  /// Returns the mean volume over the planes, mm3.
  double takeThread(const ThreadSweep& sweep) {
    PROVEOUT_ASSERT(planes_.size() == kThreadPlanes && sweep.outline != nullptr);
    double sum = 0.0;
    for (int k = 0; k < kThreadPlanes; ++k) {
      const double angle = 2.0 * kPi * k / kThreadPlanes;
      sum += planes_[static_cast<std::size_t>(k)].subtractMany(passesThrough(sweep, angle), sweep.motion);
    }
    return sum / kThreadPlanes;
  }

  void holder(MotionId id, const TurningTool& tool, const PlaneWay& way) {
    for (const auto& [kind, outlines] :
         {std::pair{ContactKind::kShank, &tool.shank}, std::pair{ContactKind::kHolder, &tool.holder}}) {
      contact(kind, id, bothSides(*outlines, way), {});
    }
  }

  /// What of the material is in the way. Facing to X0 leaves a pip at the axis, smaller than the nose, which
  /// the tool takes along as it leaves. Behind a thread the grooves count where the tool stands: it leaves
  /// through what the passes before have cut.
  std::vector<SectionPath> rapidContact(MotionId id, const TurningTool& tool,
                                        const std::vector<SectionPath>& sweeps,
                                        const std::vector<SectionPath>& spared) {
    std::vector<SectionPiece> pieces = area_.common(sweeps, spared);
    if (!pieces.empty() && thread_way_)
      pieces = standing_.at(thread_end_rad_, sweeps, area_, threads_).common(sweeps, spared);
    std::vector<SectionPath> met;
    for (const SectionPiece& piece : pieces) {
      if (piece.thickness_mm >= kTouch || !thread_way_) met.push_back(piece.outline);
    }
    std::erase_if(pieces, [&](const SectionPiece& piece) {
      return std::all_of(piece.outline.begin(), piece.outline.end(),
                         [&](const Vec2& p) { return p.x() <= tool.nose_mm + kTouch; });
    });
    contacts_.add(ContactKind::kRapid, id, area_, pieces);
    return met;
  }

  /// False where there is none, not even by rounding.
  bool contact(ContactKind kind, MotionId id, const std::vector<SectionPath>& sweeps,
               const std::vector<SectionPath>& spared) {
    const std::vector<SectionPiece> pieces = area_.common(sweeps, spared);
    contacts_.add(kind, id, area_, pieces);
    return !pieces.empty();
  }

  /// The same way once more, as far as it goes until a piece comes free, and so on: what follows does not cut
  /// that. `before`: the sections before the way.
  void partAlong(MotionId id, const ToolWay& on, Sections&& before) {
    const std::vector<ToolWay> stroke = strokeBehind(id);
    double at = 0.0, taken = 0.0, rest = 0.0;
    while (!freedIn(area_, stroke).falls.empty()) {
      area_ = std::move(before.area);
      planes_ = std::move(before.planes);
      const ToolWay left = on.between(at, 1.0);
      const double free = freedAt(area_, left, stroke);
      taken += takeAlong(id, left.between(0.0, free));
      std::vector<ToolWay> behind{left.between(free, 1.0)};
      behind.insert(behind.end(), stroke.begin(), stroke.end());
      rest = 0.0;
      at = free < 1.0 ? at + free * (1.0 - at) : 1.0;
      taken += part(id, on, free < 1.0 ? behind : stroke);
      if (at >= 1.0) break;
      before = {area_, planes_};
      rest = takeAlong(id, on.between(at, 1.0));
    }
    if (at > 0.0) removed_[id] = toFloat(taken + rest);
  }

  double takeAlong(MotionId id, const ToolWay& on) {
    const std::vector<SectionPath> sweeps = on.tool->swept(on.way), beyond = mirroredPaths(sweeps);
    const double taken = take(sweeps, id, {});
    return beyond.empty() ? taken : taken + take(beyond, id, {});
  }

  /// Bodies that hang on the chuck no longer leave; nothing cuts them any more. `stroke`: the way that the
  /// tool still goes on. Returns what it takes off their corners, mm3.
  double part(MotionId id, const ToolWay& on, const std::vector<ToolWay>& stroke) {
    Freed freed = freedIn(area_, stroke);
    if (freed.falls.empty()) return 0.0;
    PROVEOUT_ASSERT(id < removed_.size());
    double trimmed = 0.0;
    std::vector<SectionLoop> held;
    for (SectionBody& body : freed.held)
      std::move(body.loops.begin(), body.loops.end(), std::back_inserter(held));
    area_ = SectionArea(held);
    standing_.clear();
    std::vector<SectionPath> gone;
    const bool feeds = path_.motions[id].kind == MotionKind::kFeed;
    for (SectionBody& body : freed.falls) {
      body.parted_by = id;
      body.by_parting = feeds && isPartedBy(on, body);
      gone.push_back(body.loops.front().points);
      trimmed += trimCorners(body, stroke, id);
      parted_areas_.push_back({besideStroke(body, stroke), strokeEnd(id)});
      parted_.push_back(std::move(body));
    }
    for (SectionArea& plane : planes_) plane.subtract(gone, id);
    return trimmed;
  }

  const Toolpath& path_;
  SectionArea& area_;
  std::vector<SectionBody>& parted_;
  std::vector<ThreadSweep>& threads_;
  std::vector<std::shared_ptr<const ConvexOutline>>& outlines_;
  std::map<int, TurningTool> tools_, mirrored_tools_;
  std::vector<PartedArea> parted_areas_;  ///< of the bodies cut off by this path
  std::vector<float> removed_;
  ContactList contacts_;
  std::vector<SectionArea> planes_;     ///< sections with their threads, once there is one
  std::optional<PlaneWay> thread_way_;  ///< of the thread that the tool stands at the end of
  int thread_tool_ = 0;
  double thread_end_rad_ = 0.0;  ///< where about Z the tool stands there
  ThreadSections standing_;
};

}  // namespace

TurnedStock::TurnedStock(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TurnedStock::~TurnedStock() = default;
TurnedStock::TurnedStock(TurnedStock&&) noexcept = default;
TurnedStock& TurnedStock::operator=(TurnedStock&&) noexcept = default;

Result<TurnedStock> TurnedStock::create(const StockShape& shape) {
  const auto* round = std::get_if<CylinderShape>(&shape);
  if (round == nullptr || round->axis != 2 || round->base.head<2>().norm() > kOff) {
    return inputError(
        "a lathe turns a cylinder or a tube about Z: the stock must be one with its centre at X0 Y0");
  }
  auto impl = std::make_unique<Impl>();
  const double low = round->base.z(), high = low + round->length;
  SectionLoop border;
  border.points = {
      {round->inner_radius, low}, {round->radius, low}, {round->radius, high}, {round->inner_radius, high}};
  border.motion.assign(4, kNoMotion);
  impl->area = SectionArea({border});
  impl->initial_volume = impl->area.volume();
  impl->bounds = {{-round->radius, -round->radius, low}, {round->radius, round->radius, high}};
  return TurnedStock(std::move(impl));
}

Result<RemovalSummary> TurnedStock::remove(const Toolpath& path, const std::vector<Tool>& tools,
                                           Progress& progress) {
  if (Status possible = turnable(path, tools); !possible) return possible.error();
  Turning turning(path, tools, impl_->area, impl_->parted, impl_->threads, impl_->outlines);
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
    if ((id & 0xFF) == 0)
      progress.report("turning", static_cast<double>(id) / static_cast<double>(path.motions.size()));
    turning.motion(id);
  }
  return turning.summary();
}

Result<std::vector<Contact>> TurnedStock::touches(const Toolpath& path, const std::vector<Tool>& tools,
                                                  Progress& progress) const {
  if (Status possible = turnable(path, tools); !possible) return possible.error();
  std::map<int, TurningTool> turning;
  for (const Tool& tool : tools) turning.try_emplace(tool.number, tool);
  ContactList contacts(path);
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
    const Motion& motion = path.motions[id];
    const TurningTool& tool = turning.at(motion.tool);
    const PlaneWay way = planeWay(motion, arcOf(path, motion));
    for (const auto& [kind, outlines] :
         {std::pair{ContactKind::kFixture, &tool.cutters}, std::pair{ContactKind::kShank, &tool.shank},
          std::pair{ContactKind::kHolder, &tool.holder}})
      contacts.add(kind, id, impl_->area, impl_->area.common(bothSides(*outlines, way)));
  }
  return contacts.take();
}

std::optional<double> TurnedStock::firstContact(const Motion& move, const ArcGeometry* arc,
                                                const Tool& tool) const {
  TurningTool turning(tool);
  PlaneWay way = planeWay(move, arc);
  if (turning.worksBehind(way)) {
    turning = turning.mirrored();
    way = way.mirrored();
  }
  const auto touches = [&](double t) {
    const std::vector<SectionPiece> pieces = impl_->area.common(turning.swept(way.between(0.0, t)));
    return std::any_of(pieces.begin(), pieces.end(),
                       [](const SectionPiece& piece) { return piece.volume_mm3 > 0.0; });
  };
  if (!touches(1.0)) return std::nullopt;
  double free = 0.0, touching = 1.0;
  for (int i = 0; i < 40 && touching - free > 1e-12; ++i) {
    const double middle = 0.5 * (free + touching);
    (touches(middle) ? touching : free) = middle;
  }
  return touching;
}

Result<TurnedStock> TurnedStock::moved(const SectionBody& body, const RigidTransform& move) const {
  const Vec3 axis = move.rotation * Vec3::UnitZ();
  const bool turned_round = axis.z() < 0.0;
  if (std::abs(std::abs(axis.z()) - 1.0) > 1e-12 || move.translation.head<2>().norm() > kOff)
    return inputError(
        "a turned part is clamped again about its own axis: turn it about X or Y by 180 degrees, or about Z, "
        "and shift it along Z");
  const Vec3 x = move.rotation * Vec3::UnitX();
  const double angle = std::atan2(x.y(), x.x()), sign = turned_round ? -1.0 : 1.0,
               shift = move.translation.z();
  const auto place = [&](const Vec2& p) { return Vec2(p.x(), sign * p.y() + shift); };
  auto impl = std::make_unique<Impl>();
  std::vector<SectionLoop> loops;
  for (const SectionLoop& loop : body.loops) {
    SectionLoop now;
    for (const Vec2& p : loop.points) now.points.push_back(place(p));
    if (turned_round) std::reverse(now.points.begin(), now.points.end());
    now.motion.assign(now.points.size(), kNoMotion);
    loops.push_back(std::move(now));
  }
  impl->area = SectionArea(loops);
  impl->initial_volume = impl->area.volume();
  for (const ThreadSweep& thread : impl_->threads) {
    ThreadSweep now = thread;
    impl->outlines.push_back(
        std::make_shared<const ConvexOutline>(turned_round ? mirrored(*thread.outline, 1) : *thread.outline));
    now.outline = impl->outlines.back().get();
    now.from = place(thread.from);
    now.to = place(thread.to);
    now.start_rad = sign * thread.start_rad + angle;
    now.turns = sign * thread.turns;
    now.motion = kNoMotion;
    impl->threads.push_back(now);
  }
  const Vec2 low = impl->area.min(), high = impl->area.max();
  impl->bounds = {{-high.x(), -high.x(), low.y()}, {high.x(), high.x(), high.y()}};
  return TurnedStock(std::move(impl));
}

TurnedShape TurnedStock::shape() const {
  TurnedShape shape;
  shape.bodies = impl_->area.bodies();
  shape.bodies.insert(shape.bodies.end(), impl_->parted.begin(), impl_->parted.end());
  shape.threads = withoutCovered(impl_->threads, shape.bodies);
  shape.outlines = impl_->outlines;
  return shape;
}

double TurnedStock::initialVolume() const { return impl_->initial_volume; }
Box3 TurnedStock::bounds() const { return impl_->bounds; }

}  // namespace proveout
