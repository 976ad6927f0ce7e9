#include "removal/wire/wire_stock.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <variant>

#include "core/base/assert.h"
#include "core/geometry/to_float.h"
#include "core/mesh/shells.h"
#include "removal/wire/contact/wire_contacts.h"
#include "removal/wire/contact/wire_handling.h"
#include "removal/wire/falls/lean_falls.h"
#include "removal/wire/falls/wire_bridges.h"
#include "removal/wire/section/kerf_section.h"
#include "removal/wire/section/prism_mesh.h"

namespace proveout {
namespace {

/// Way of a leaning wire within which it is known when a piece came free, mm: by the chords of its walls.
constexpr double kFallWayMm = 2e-3;

/// Joins the contacts of one motion at several heights.
void addContact(Contact contact, double z, double share, std::map<MotionId, Contact>& found) {
  contact.where.z() = z;
  contact.volume_mm3 *= share;
  const auto [known, is_new] = found.emplace(contact.motion, contact);
  if (is_new) return;
  const double volume = known->second.volume_mm3 + contact.volume_mm3;
  if (contact.depth_mm > known->second.depth_mm) known->second = contact;
  known->second.volume_mm3 = volume;
}

/// What a leaning wire does besides cutting, seen at its bottom, half way and at its top.
class LeanHandling {
 public:
  LeanHandling(const PrismBlank& blank, const Toolpath& path, const std::vector<Tool>& tools)
      : blank_(blank), path_(path), tools_(tools) {}

  void look(const WireWork& work, const WireHolding& holding, double z, double share, Progress& progress) {
    std::vector<Contact> contacts = rapidContacts(blank_, work, holding, progress);
    tellByHand(path_, contacts);
    const std::vector<ThreadingPlace> places = threadingPlaces(path_, tools_, work, contacts, z);
    for (const ThreadingFault& fault : threadingFaults(blank_, work, places, holding, progress))
      faults_.emplace(fault.next, fault);
    for (const Contact& contact : contacts) addContact(contact, z, share, contacts_);
  }

  void tell(RemovalSummary& summary) const {
    for (const auto& [motion, contact] : contacts_) summary.contacts.push_back(contact);
    for (const auto& [motion, fault] : faults_) summary.threading.push_back(fault);
  }

 private:
  const PrismBlank& blank_;
  const Toolpath& path_;
  const std::vector<Tool>& tools_;
  std::map<MotionId, Contact> contacts_;
  std::map<MotionId, ThreadingFault> faults_;
};

/// What the motions took, estimated from a section.
void addRemoved(const PrismBlank& blank, const std::vector<WireStretch>& cuts,
                const std::vector<FreePiece>& fallen, RemovalSummary& summary) {
  const std::vector<double> areas = removedAreas(blank, cuts, fallen);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    PROVEOUT_ASSERT(cuts[i].motion < summary.removed_mm3.size());
    summary.removed_mm3[cuts[i].motion] += toFloat(areas[i] * blank.height());
  }
}

/// The body of a solid at a place; none: nothing is there.
std::optional<std::size_t> bodyAt(const LeanSolid& solid, const Vec2& at, double z) {
  for (std::size_t k = 0; k < solid.bodies.size(); ++k)
    if (holds(outlineOf(solid, k, z), at)) return k;
  return std::nullopt;
}

/// Whether a piece can leave when it comes free, past what is held then: body `body` of `then`.
void judgeExit(const LeanSolid& then, std::size_t body, double z, const std::vector<LeanFall>& falls,
               LeanFall& fall) {
  fall.falls = fall.lifts = true;
  for (std::size_t k = 0; k < then.bodies.size(); ++k) {
    const PlanePolygons outline = outlineOf(then, k, z);
    const auto freed = [&](const LeanFall& other) {
      return other.fell <= fall.fell && holds(other.half_way.region, placeIn(outline));
    };
    if (k == body || (!outline.empty() && std::any_of(falls.begin(), falls.end(), freed))) continue;
    const BodyExit exit = exitOf(then, body, then, k);
    fall.falls = fall.falls && exit.down;
    fall.lifts = fall.lifts && exit.up;
  }
}

}  // namespace

WireStock::WireStock(PrismBlank blank) : blank_(std::move(blank)) {
  setSections(cutSection(blank_.loops, {}));
}

Result<RemovalSummary> WireStock::remove(const Toolpath& path, const std::vector<Tool>& tools,
                                         double tolerance, Progress& progress) {
  progress.report("removing", 0.0);
  RemovalSummary summary;
  summary.removed_mm3.assign(path.motions.size(), 0.0F);
  const Wanted all{&summary, &summary};
  const Status done = standsUpright(path) ? cutUpright(path, tools, all, progress)
                                          : cutLeaning(path, tools, tolerance, all, progress);
  if (!done) return done.error();
  return summary;
}

Status WireStock::cut(const Toolpath& path, const std::vector<Tool>& tools, double tolerance,
                      Progress& progress, RemovalSummary* pieces) {
  progress.report("removing", 0.0);
  const Wanted wanted{nullptr, pieces};
  return standsUpright(path) ? cutUpright(path, tools, wanted, progress)
                             : cutLeaning(path, tools, tolerance, wanted, progress);
}

Status WireStock::cutUpright(const Toolpath& path, const std::vector<Tool>& tools, const Wanted& wanted,
                             Progress& progress) {
  const Result<WireWork> work = wireWork(path, tools);
  if (!work) return work.error();
  std::vector<PlaneBody> last = cutSection(blank_.loops, work->cuts);
  const WireHolding holding(blank_.held_at, blank_.loops, work->cuts, last);
  WireFalls falls = findFalls(blank_.loops, work->cuts, std::move(last), holding);
  if (RemovalSummary* summary = wanted.motions; summary != nullptr && !progress.cancelled()) {
    addRemoved(blank_, work->cuts, falls.pieces, *summary);
    summary->contacts = rapidContacts(blank_, *work, holding, progress);
    tellByHand(path, summary->contacts);
    const std::vector<ThreadingPlace> places =
        threadingPlaces(path, tools, *work, summary->contacts, blank_.z_low);
    summary->threading = threadingFaults(blank_, *work, places, holding, progress);
  }
  if (wanted.pieces != nullptr) {
    wanted.pieces->fallen = fallenPieces(path, *work, blank_.height(), falls.pieces);
    wanted.pieces->bridges = findBridges(falls.bodies, cutEnds(path, *work), blank_.height(), blank_.z_high);
  }
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  setSections(std::move(falls.bodies));
  return Done{};
}

Status WireStock::cutLeaning(const Toolpath& path, const std::vector<Tool>& tools, double tolerance,
                             const Wanted& wanted, Progress& progress) {
  const HeightSpan span{blank_.z_low, blank_.z_high};
  const Result<LeanWork> work = leanWork(path, tools, span, tolerance);
  if (!work) return work.error();
  Result<LeanSolid> solid = leanSolid(blank_.loops, span, work->cuts, tolerance, progress);
  if (!solid) return solid.error();
  solids_.clear();
  solids_.push_back(std::move(*solid));
  std::vector<LeanFall> falls = leanFalls(blank_, work->cuts, solids_.front());
  if (const Status kept = keepFallen(work->cuts, falls, tolerance, progress); !kept) return kept;
  if (wanted.motions != nullptr) handleLeaning(path, tools, *work, falls, *wanted.motions, progress);
  if (wanted.pieces != nullptr) tellPieces(path, *work, falls, *wanted.pieces);
  if (progress.cancelled()) return Error{ErrorKind::kInterrupted, "interrupted"};
  setBodies();
  return Done{};
}

bool WireStock::anyHolds(const std::vector<InSolid>& pieces, const Vec2& at, double z) const {
  return std::any_of(pieces.begin(), pieces.end(), [&](const InSolid& piece) {
    return holds(outlineOf(solids_[piece.solid], piece.body, z), at);
  });
}

/// Whether a body of the last solid is what later motions would have cut off a piece that fell before.
bool WireStock::isOfPiece(std::size_t body, const std::vector<InSolid>& fallen) const {
  if (fallen.empty()) return false;
  const double z = meshBounds(solids_.front().bodies[body].mesh).center().z();
  const PlanePolygons outline = outlineOf(solids_.front(), body, z);
  if (outline.empty()) return false;
  const Vec2 at = placeIn(outline);
  return anyHolds(fallen, at, z);
}

/// Places in the bodies that are held to the end.
std::vector<Vec2> WireStock::heldPlaces(const std::vector<LeanFall>& falls, double z) const {
  std::vector<Vec2> places;
  for (std::size_t k = 0; k < solids_.front().bodies.size(); ++k) {
    const auto has = [k](const LeanFall& fall) {
      return std::ranges::find(fall.bodies, k) != fall.bodies.end();
    };
    const PlanePolygons outline = outlineOf(solids_.front(), k, z);
    if (!outline.empty() && std::ranges::none_of(falls, has)) places.push_back(placeIn(outline));
  }
  return places;
}

/// Pieces that fell before the wire passed over them stay as they were then. Pieces that cannot leave remain
/// in place, and what is finally left of one may be several bodies.
Status WireStock::keepFallen(const std::vector<LeanStretch>& cuts, std::vector<LeanFall>& falls,
                             double tolerance, Progress& progress) {
  const HeightSpan span{blank_.z_low, blank_.z_high};
  const double z = solids_.front().levels[levelAt(solids_.front(), 0.5 * (span.low + span.high))].z;
  std::vector<bool> replaced(solids_.front().bodies.size(), false);
  std::map<CutTime, std::size_t> solid_at;
  const std::vector<Vec2> held = heldPlaces(falls, z);
  std::vector<LeanFall> told;
  placed_.clear();
  error_mm3_ = 0.0;
  for (LeanFall& fall : falls) {
    const Vec2 at = placeIn(fall.half_way.body);
    const auto replace = [&] {
      for (const std::size_t body : fall.bodies) replaced[body] = true;
    };
    if (anyHolds(placed_, at, z)) {  // another body of what fell as one piece
      replace();
      continue;
    }
    // A piece that cannot leave at the end could not leave earlier, when there was more of it and of its
    // holder.
    if (fall.passed_over && fall.falls) {
      if (!solid_at.contains(fall.fell)) {
        Result<LeanSolid> then =
            leanSolid(blank_.loops, span, cutUntil(cuts, fall.fell), tolerance, progress);
        if (!then) return then.error();
        solid_at[fall.fell] = solids_.size();
        solids_.push_back(std::move(*then));
      }
      const std::size_t number = solid_at[fall.fell];
      const std::optional<std::size_t> body = bodyAt(solids_[number], at, z);
      // Where it is one with what is held, walls between the heights that were looked at hold it still.
      if (body && std::ranges::none_of(held, [&](const Vec2& place) {
            return holds(outlineOf(solids_[number], *body, z), place);
          })) {
        judgeExit(solids_[number], *body, z, falls, fall);
        if (fall.falls) {
          placed_.push_back({number, *body});
          fall.volume_mm3 = solids_[number].bodies[*body].volume_mm3;
          error_mm3_ += kFallWayMm * 2.0 * cuts[fall.fell.last()].radius_mm * span.length();
          replace();
        }
      }
    }
    told.push_back(fall);
  }
  falls = std::move(told);
  const std::vector<InSolid> fallen = placed_;
  for (std::size_t k = 0; k < replaced.size(); ++k)
    if (!replaced[k] && !isOfPiece(k, fallen)) placed_.push_back({0, k});
  std::stable_sort(placed_.begin(), placed_.end(), [&](const InSolid& a, const InSolid& b) {
    return solids_[a.solid].bodies[a.body].volume_mm3 > solids_[b.solid].bodies[b.body].volume_mm3;
  });
  return Done{};
}

void WireStock::handleLeaning(const Toolpath& path, const std::vector<Tool>& tools, const LeanWork& work,
                              const std::vector<LeanFall>& falls, RemovalSummary& summary,
                              Progress& progress) const {
  const HeightSpan span{blank_.z_low, blank_.z_high};
  LeanHandling handling(blank_, path, tools);
  const auto look = [&](const WireWork& level, double z, double share) {
    const WireHolding holding(blank_.held_at, blank_.loops, level.cuts,
                              [&] { return cutSection(blank_.loops, level.cuts); });
    handling.look(level, holding, z, share, progress);
  };
  look(work.atHeight(span, span.low), span.low, 1.0 / 6.0);
  const double z = span.low + 0.5 * span.length();
  const WireWork level = work.atHeight(span, z);
  look(level, z, 4.0 / 6.0);
  std::vector<FreePiece> fallen;
  for (const LeanFall& fall : falls)
    if (fall.falls) fallen.push_back(fall.half_way);
  addRemoved(blank_, level.cuts, fallen, summary);
  look(work.atHeight(span, span.high), span.high, 1.0 / 6.0);
  handling.tell(summary);
}

void WireStock::tellPieces(const Toolpath& path, const LeanWork& work, const std::vector<LeanFall>& falls,
                           RemovalSummary& summary) const {
  const HeightSpan span{blank_.z_low, blank_.z_high};
  const double z = span.low + 0.5 * span.length();
  const WireWork level = work.atHeight(span, z);
  for (const LeanFall& fall : falls) {
    FallenPiece piece = fallenPieces(path, level, blank_.height(), {fall.half_way}).front();
    piece.lifts = fall.lifts;
    piece.volume_mm3 = fall.volume_mm3;
    (fall.falls ? summary.fallen : summary.stuck).push_back(piece);
  }
  const std::vector<CutEnd> ends = cutEnds(path, level);
  if (!ends.empty())
    summary.bridges = findBridges(cutSection(blank_.loops, level.cuts), ends, blank_.height(), z);
}

std::vector<PlanePolygons> WireStock::outlinesAt(double z) const {
  constexpr double kOutlineChordMm = 1e-4;
  std::vector<PlanePolygons> out(bodies_.size());
  if (z < blank_.z_low || z > blank_.z_high) return out;
  PROVEOUT_ASSERT((placed_.empty() ? sections_.size() : placed_.size()) == bodies_.size());
  if (placed_.empty()) {
    for (std::size_t k = 0; k < sections_.size(); ++k)
      out[k] = polygonsOf(sections_[k].loops, kOutlineChordMm);
    return out;
  }
  for (std::size_t k = 0; k < placed_.size(); ++k)
    out[k] = outlineOf(solids_[placed_[k].solid], placed_[k].body, z);
  return out;
}

void WireStock::setSections(std::vector<PlaneBody> sections) {
  sections_ = std::move(sections);
  bodies_.clear();
  for (const PlaneBody& section : sections_) {
    PROVEOUT_ASSERT(!section.loops.empty());
    Box3 bounds = boundsOf(section.loops.front());
    bounds.min.z() = blank_.z_low;
    bounds.max.z() = blank_.z_high;
    bodies_.push_back({section.area_mm2 * blank_.height(), bounds});
  }
}

void WireStock::setBodies() {
  sections_.clear();
  bodies_.clear();
  for (const auto& [solid, k] : placed_) {
    const LeanBody& body = solids_[solid].bodies[k];
    bodies_.push_back({body.volume_mm3, meshBounds(body.mesh)});
  }
}

TriMesh WireStock::mesh(const std::vector<std::size_t>& bodies, double tolerance) const {
  TriMesh out;
  if (placed_.empty()) {
    std::vector<PlaneBody> sections;
    for (const std::size_t body : bodies) {
      PROVEOUT_ASSERT(body < sections_.size());
      sections.push_back(sections_[body]);
    }
    return prismMesh(sections, blank_.z_low, blank_.z_high, tolerance);
  }
  for (const std::size_t body : bodies) {
    PROVEOUT_ASSERT(body < placed_.size());
    append(out, solids_[placed_[body].solid].bodies[placed_[body].body].mesh);
  }
  return out;
}

BodyExit WireStock::exit(std::size_t body, std::size_t past) const {
  if (placed_.empty()) return {};
  PROVEOUT_ASSERT(body < placed_.size() && past < placed_.size());
  const InSolid &own = placed_[body], &other = placed_[past];
  return exitOf(solids_[own.solid], own.body, solids_[other.solid], other.body);
}

double WireStock::initialVolume() const { return areaOf(blank_.loops) * blank_.height(); }

double WireStock::volume() const {
  return std::accumulate(bodies_.begin(), bodies_.end(), 0.0,
                         [](double sum, const WireBody& body) { return sum + body.volume_mm3; });
}

}  // namespace proveout
