#include "removal/process/wire_grid_piece.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/assert.h"
#include "core/base/stopwatch.h"
#include "core/geometry/plane.h"
#include "core/geometry/to_float.h"
#include "core/tool/tool_table.h"
#include "removal/grid/stock_impl.h"
#include "removal/process/milled_piece.h"
#include "removal/process/wire_part.h"
#include "removal/wire/contact/wire_handling.h"
#include "removal/wire/falls/wire_work.h"
#include "removal/wire/section/stretch_index.h"
#include "removal/wire/wire_stock.h"

namespace proveout {
namespace {

/// The box about a workpiece reaches beyond it by so much, and above and below it, mm: faces of both do not
/// coincide. Leaning walls may meet not far above it.
constexpr double kAround = 1.0, kAbove = 0.01;
/// Places along a motion, at most, and across its kerf, at which is asked what it meets.
constexpr int kMostStations = 256, kAcross = 3;
/// What is counted so may be off by this factor.
constexpr double kCountedError = 1.25;
/// Heights at which is asked.
constexpr int kHeights = 9;

PrismBlank boxAbout(const Box3& bounds) {
  PrismBlank blank;
  blank.loops.push_back(rectangleLoop(bounds.min.head<2>() - Vec2::Constant(kAround),
                                      bounds.max.head<2>() + Vec2::Constant(kAround)));
  blank.z_low = bounds.min.z() - kAbove;
  blank.z_high = bounds.max.z() + kAbove;
  return blank;
}

/// The sample nearest to a point.
Coord sampleAt(const Stock::Impl& stock, const Vec3& p) {
  const Vec3 at = (p - stock.origin) / stock.h;
  return Coord(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())),
               static_cast<int>(std::lround(at.z())));
}

/// Asks the grid what motions of the wire meet, each with what those before it left.
class GridWireMeeting {
 public:
  GridWireMeeting(const Stock& stock, const LeanWork& work, const HeightSpan& span)
      : stock_(stock.inside()), reader_(stock_) {
    const Box3 bounds = stock.bounds();
    for (int k = 0; k < kHeights; ++k) {
      heights_.push_back(bounds.min.z() + (k + 0.5) / kHeights * (bounds.max.z() - bounds.min.z()));
      works_.push_back(std::make_unique<WireWork>(work.atHeight(span, heights_.back())));
      PROVEOUT_ASSERT(works_.back()->cuts.size() == work.cuts.size() &&
                      works_.back()->rapids.size() == work.rapids.size());
      indices_.push_back(std::make_unique<StretchIndex>(works_.back()->cuts));
    }
    slice_mm_ = (bounds.max.z() - bounds.min.z()) / kHeights;
  }

  /// mm3, about.
  double takenBy(std::uint32_t cut) {
    double sum = 0.0;
    for (int k = 0; k < kHeights; ++k) sum += volumeAt(k, works_[k]->cuts[cut], cut, nullptr);
    return sum;
  }
  /// The contact of a rapid, if it meets material.
  std::optional<Contact> contactOf(std::size_t rapid, std::uint32_t after) {
    Contact contact;
    for (int k = 0; k < kHeights; ++k)
      contact.volume_mm3 += volumeAt(k, works_[k]->rapids[rapid].stretch, after, &contact.where);
    if (contact.volume_mm3 <= 0.0) return std::nullopt;
    const WireStretch& stretch = works_.front()->rapids[rapid].stretch;
    contact.motion = contact.last = stretch.motion;
    contact.depth_mm = 2.0 * stretch.kerf_mm;
    return contact;
  }
  /// Where a wire that is threaded touches material, the first place of each motion behind it.
  std::vector<ThreadingFault> threadingFaults(const Toolpath& path, const std::vector<Tool>& tools,
                                              const std::vector<Contact>& contacts) {
    std::map<MotionId, ThreadingFault> faults;
    for (int k = kHeights - 1; k >= 0; --k) {
      for (const ThreadingPlace& place : threadingPlaces(path, tools, *works_[k], contacts, heights_[k])) {
        if (!touchesAt(k, place)) continue;
        ThreadingFault fault;
        fault.next = place.next;
        fault.where = Vec3(place.at.x(), place.at.y(), heights_[k]);
        fault.wire_mm = fault.needs_mm = place.wire_mm;
        faults.emplace(place.next, fault);
      }
    }
    std::vector<ThreadingFault> out;
    for (const auto& [motion, fault] : faults) out.push_back(fault);
    return out;
  }

 private:
  bool touchesAt(int height, const ThreadingPlace& place) {
    constexpr int kSides = 8;
    for (int k = 0; k <= kSides; ++k) {
      const Vec2 off = turnedBy(Vec2(0.5 * place.wire_mm, 0.0), 2.0 * kPi * k / kSides);
      const Vec2 p = k < kSides ? Vec2(place.at + off) : place.at;
      if (isMaterial(Vec3(p.x(), p.y(), heights_[height])) &&
          indices_[height]->nearest(p, 0.0, place.after).stretch == StretchIndex::kNone)
        return true;
    }
    return false;
  }

  double volumeAt(int height, const WireStretch& s, std::uint32_t before, Vec3* where) {
    const int stations = std::clamp(static_cast<int>(s.length() / stock_.h), 1, kMostStations);
    int met = 0;
    for (int k = 0; k < stations; ++k) {
      for (int a = 0; a < kAcross; ++a) {
        const Vec2 p = onFront(s, (k + 0.5) / stations, 2.0 * (a + 0.5) / kAcross - 1.0);
        const Vec3 at(p.x(), p.y(), heights_[height]);
        if (!isMaterial(at) || indices_[height]->nearest(p, 0.0, before).stretch != StretchIndex::kNone)
          continue;
        if (where != nullptr) *where = at;
        ++met;
      }
    }
    return 2.0 * s.kerf_mm * s.length() * slice_mm_ * met / (stations * kAcross);
  }

  bool isMaterial(const Vec3& p) { return reader_.isMaterial(sampleAt(stock_, p)); }

  const Stock::Impl& stock_;
  SampleReader reader_;
  std::vector<double> heights_;
  std::vector<std::unique_ptr<WireWork>> works_;  ///< by height; the indices hold on to them
  std::vector<std::unique_ptr<StretchIndex>> indices_;
  double slice_mm_ = 0.0;
};

/// What the motions take and meet, estimated at the grid's points.
RemovalSummary meetingOf(const Stock& stock, const Toolpath& path, const std::vector<Tool>& tools,
                         const LeanWork& work, const HeightSpan& span) {
  RemovalSummary summary;
  summary.removed_mm3.assign(path.motions.size(), 0.0F);
  GridWireMeeting meeting(stock, work, span);
  for (std::uint32_t i = 0; i < work.cuts.size(); ++i) {
    PROVEOUT_ASSERT(work.cuts[i].motion < summary.removed_mm3.size());
    summary.removed_mm3[work.cuts[i].motion] += toFloat(meeting.takenBy(i));
  }
  for (std::size_t i = 0; i < work.rapids.size(); ++i) {
    if (const auto contact = meeting.contactOf(i, work.rapids[i].after)) summary.contacts.push_back(*contact);
  }
  tellByHand(path, summary.contacts);
  summary.threading = meeting.threadingFaults(path, tools, summary.contacts);
  return summary;
}

struct GridBody {
  Stock stock;
  StockSurface surface;
  Box3 bounds;
};

/// Whether a kerf may come to what lies within these bounds.
bool reaches(const std::vector<LeanStretch>& cuts, const Box3& bounds) {
  constexpr double kLeaning = 4.0;  // a kerf's ellipse is no longer, in its half widths
  return std::any_of(cuts.begin(), cuts.end(), [&](const LeanStretch& cut) {
    Box3 box;
    for (const Vec2& p : {cut.from_low, cut.to_low, cut.from_high, cut.to_high})
      box.extend(Vec3(p.x(), p.y(), bounds.center().z()));
    return box.inflated(kLeaning * cut.radius_mm).overlaps(bounds);
  });
}

/// What each body of the box has of the workpiece, the largest first.
Result<std::vector<GridBody>> bodiesOf(const Stock& stock, const WireStock& box, const PieceOptions& options,
                                       Progress& progress) {
  std::vector<GridBody> out;
  for (std::size_t k = 0; k < box.bodies().size(); ++k) {
    if (!box.bodies()[k].bounds.overlaps(stock.bounds())) continue;
    Stock own = stock.crossingsAlone();
    const MeshShape shape{box.mesh({k}, options.facet_mm), "what the wire leaves"};
    if (const Status kept = own.keepWithin(shape); !kept) return kept.error();
    Result<StockSurface> surface = own.surface(options.surface, progress);
    if (!surface) return surface.error();
    if (surface->mesh.triangles.empty()) continue;
    const Box3 bounds = meshBounds(surface->mesh);
    out.push_back({std::move(own), std::move(*surface), bounds});
  }
  std::stable_sort(out.begin(), out.end(), [](const GridBody& a, const GridBody& b) {
    return a.surface.volume_mm3 > b.surface.volume_mm3;
  });
  return out;
}

Result<std::vector<GridBody>> untouched(Stock stock, const PieceOptions& options, Progress& progress) {
  std::vector<GridBody> out;
  Result<StockSurface> surface = stock.surface(options.surface, progress);
  if (!surface) return surface.error();
  const Box3 bounds = meshBounds(surface->mesh);
  if (!surface->mesh.triangles.empty()) out.push_back({std::move(stock), std::move(*surface), bounds});
  return out;
}

/// The body that holds the point, is most like the nominal, or is the largest.
Result<PartChoice> partOf(const std::vector<GridBody>& bodies, const PieceOptions& options) {
  if (options.part_point) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      SampleReader reader(bodies[k].stock.inside());
      if (reader.isMaterial(sampleAt(bodies[k].stock.inside(), *options.part_point)))
        return PartChoice{k, {}};
    }
    return inputError(pointInNoBody(*options.part_point));
  }
  std::vector<Box3> bounds;
  std::vector<double> volumes;
  for (const GridBody& body : bodies) {
    bounds.push_back(body.bounds);
    volumes.push_back(body.surface.volume_mm3);
  }
  const PartChoice largest = largestOf(volumes);
  if (!options.part) return largest;
  const std::size_t like = bodyLike(bounds, *options.part);
  if (volumes[like] < kNotableShare * volumes[largest.body]) return doubted(like, volumes);
  return PartChoice{like, {}};
}

/// What came free and hangs on in the box is so in the workpiece, whose share of its height is `share`.
void takePieces(RemovalSummary&& box, double share, RemovalSummary& summary) {
  PROVEOUT_ASSERT(share >= 0.0 && share <= 1.0);
  summary.fallen = std::move(box.fallen);
  summary.stuck = std::move(box.stuck);
  summary.bridges = std::move(box.bridges);
  for (std::vector<FallenPiece>* pieces : {&summary.fallen, &summary.stuck})
    for (FallenPiece& piece : *pieces) piece.volume_mm3 *= share;
  for (UncutBridge& bridge : summary.bridges) bridge.volume_mm3 *= share;
}

/// Kerfs that the grid cannot hold.
void tellNarrow(const Toolpath& path, const std::vector<Tool>& tools, double h, RemovalSummary& summary) {
  const ToolTable table(tools);
  for (MotionId id = 0; id < path.motions.size(); ++id) {
    const Motion& motion = path.motions[id];
    if (motion.wire < 0 || motion.kind != MotionKind::kFeed || summary.removed_mm3[id] <= 0.0F) continue;
    const Tool* tool = table.ofMotion(motion.tool);
    if (tool == nullptr) continue;
    const double width = tool->diameter + 2.0 * tool->spark_gap, length = path.length(motion);
    if (width >= h) continue;
    if (summary.narrow_cuts.empty()) summary.narrow_cuts.push_back({id, motion.from, width, 0.0, 0.0});
    summary.narrow_cuts.back().length_mm += length;
    summary.narrow_cuts.back().area_mm2 += length * width;
  }
}

}  // namespace

WireGridPiece::WireGridPiece(Stock stock, double left_mm3, double own_mm3, std::vector<StockBody> apart)
    : stock_(std::move(stock)), left_mm3_(left_mm3), own_mm3_(own_mm3), apart_(std::move(apart)) {}

Result<Machined> WireGridPiece::machine(const Toolpath& path, const std::vector<Tool>& tools,
                                        const PieceOptions& options, Progress& progress) {
  Stopwatch watch;
  const PrismBlank about = boxAbout(stock_.bounds());
  const HeightSpan span{about.z_low, about.z_high};
  const Result<LeanWork> work = leanWork(path, tools, span, options.facet_mm);
  if (!work) return work.error();
  // Of a copy, as all that is left of it will be: both know the same of its faces, so that what no wire
  // reached cancels. Where none reaches anything it stays as it was.
  const bool reached = reaches(work->cuts, stock_.bounds());
  if (reached) stock_ = stock_.crossingsAlone();
  const Result<StockVolume> held = stock_.volume(options.surface, progress);
  if (!held) return held.error();
  Machined out;
  out.initial_mm3 = left_mm3_;
  out.holding = {own_mm3_, held->mm3};
  WireStock box(about);
  box.holdAt(options.held_at);
  RemovalSummary pieces;
  if (const Status cut = box.cut(path, tools, 0.5 * options.facet_mm, progress, &pieces); !cut)
    return cut.error();
  RemovalSummary met = meetingOf(stock_, path, tools, *work, span);
  // In the air beside a workpiece, or in its hollow, the box has pieces which that has not.
  if (countedVolume(met) > 0.0)
    takePieces(std::move(pieces), stock_.bounds().size().z() / about.height(), met);
  tellNarrow(path, tools, stock_.resolution(), met);
  out.remove_s = watch.lap();
  Result<std::vector<GridBody>> bodies =
      reached ? bodiesOf(stock_, box, options, progress) : untouched(std::move(stock_), options, progress);
  if (!bodies) return bodies.error();
  out.mesh_s = watch.lap();
  double after_mm3 = 0.0, error_mm3 = 0.0;
  for (const GridBody& body : *bodies) {
    after_mm3 += body.surface.volume_mm3;
    error_mm3 += body.surface.volume_error_mm3;
  }
  const double removed_mm3 = reached && bodies->empty()
                                 ? out.initial_mm3 - volumeOf(apart_)
                                 : std::clamp(held->mm3 - after_mm3, 0.0, out.initial_mm3);
  out.bodies.emplace();
  if (!bodies->empty()) {
    const Result<PartChoice> chosen = partOf(*bodies, options);
    if (!chosen) return chosen.error();
    const auto part = bodies->begin() + static_cast<std::ptrdiff_t>(chosen->body);
    std::rotate(bodies->begin(), part, part + 1);
    if (chosen->rival) out.rival = *chosen->rival + (*chosen->rival < chosen->body ? 1 : 0);
    for (const GridBody& body : *bodies)
      out.bodies->push_back({body.surface.volume_mm3, body.bounds, out.bodies->empty() ? "part" : "slug"});
    for (std::size_t k = 1; k < bodies->size(); ++k) {
      out.freed.push_back(std::move((*bodies)[k].surface.mesh));
      out.freed_self_intersections += (*bodies)[k].surface.self_intersections;
    }
    stock_ = std::move(bodies->front().stock);
    out.surface = std::move(bodies->front().surface);
  }
  if (reached) own_mm3_ = out.surface.volume_mm3;
  out.bodies->insert(out.bodies->end(), apart_.begin(), apart_.end());
  apart_.assign(out.bodies->begin() + (out.bodies->empty() ? 0 : 1), out.bodies->end());
  out.surface.volume_mm3 = out.initial_mm3 - removed_mm3;
  // What the grid holds otherwise than it is lies in the part.
  if (!out.bodies->empty()) out.bodies->front().volume_mm3 += out.surface.volume_mm3 - volumeOf(*out.bodies);
  // What the grid cannot hold of a kerf is in what the motions met, which points of the grid count.
  if (reached)
    out.surface.volume_error_mm3 = std::max(std::abs(error_mm3 - held->error_mm3),
                                            kCountedError * std::abs(countedVolume(met) - removed_mm3)) +
                                   out.holding->errorOf(removed_mm3);
  left_mm3_ = out.surface.volume_mm3;
  fitRemovedVolume(met, removed_mm3);
  out.removal = std::move(met);
  return out;
}

Status WireGridPiece::cut(const Toolpath& path, const std::vector<Tool>& tools, const PieceOptions& options,
                          Progress& progress) {
  const Result<Machined> made = machine(path, tools, options, progress);
  return made ? Status(Done{}) : Status(made.error());
}

Result<std::unique_ptr<Workpiece>> WireGridPiece::become(ProcessKind next, const RigidTransform& move,
                                                         const PieceOptions& options, Progress& progress) {
  Result<Stock> moved = stock_.moved(move, options.grid, progress);
  if (!moved) return moved.error();
  for (StockBody& body : apart_) body.bounds = move(body.bounds);
  return pieceOnGrid(next, std::move(*moved), left_mm3_, own_mm3_, std::move(apart_));
}

Result<std::unique_ptr<Workpiece>> pieceOnGrid(ProcessKind next, Stock stock, double left_mm3, double own_mm3,
                                               std::vector<StockBody> apart) {
  if (next == ProcessKind::kWire)
    return std::unique_ptr<Workpiece>(
        std::make_unique<WireGridPiece>(std::move(stock), left_mm3, own_mm3, std::move(apart)));
  if (next == ProcessKind::kMilling)
    return std::unique_ptr<Workpiece>(
        std::make_unique<MilledPiece>(std::move(stock), left_mm3, own_mm3, std::move(apart)));
  return inputError(
      "what was milled or cut with a wire cannot be turned: only bars, tubes and what is still "
      "round can");
}

}  // namespace proveout
