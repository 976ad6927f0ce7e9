#include "removal/wire/falls/lean_falls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "removal/wire/falls/body_exit.h"
#include "removal/wire/falls/wire_work.h"

namespace proveout {
namespace {

/// The regions of a level as bodies of straight edges.
std::vector<PlaneBody> bodiesAt(const LevelSection& level) {
  std::vector<PlaneBody> bodies;
  for (const LevelRegion& region : level.regions) {
    PlaneBody body;
    for (const std::uint32_t k : region.loops) {
      const LevelLoop& loop = level.loops[k];
      PlaneLoop& out = body.loops.emplace_back();
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        out.edges.push_back({loop.points[i], Vec2::Zero(), 0.0, loop.motions[i]});
    }
    body.area_mm2 = areaOf(body.loops);
    bodies.push_back(std::move(body));
  }
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const PlaneBody& a, const PlaneBody& b) { return a.area_mm2 > b.area_mm2; });
  return bodies;
}

/// What is free at one height, and which bodies of the solid have it there.
class LevelFalls {
 public:
  LevelFalls(const PrismBlank& blank, const std::vector<LeanStretch>& cuts, const LeanSolid& solid, double z)
      : solid_(solid), z_(solid.levels[levelAt(solid, z)].z) {
    LeanWork work;
    work.cuts = cuts;
    const std::vector<WireStretch> level = work.atHeight({blank.z_low, blank.z_high}, z_).cuts;
    std::vector<PlaneBody> last = bodiesAt(solid.levels[levelAt(solid, z)]);
    const WireHolding holding(blank.held_at, blank.loops, level, last);
    pieces_ = findFalls(blank.loops, level, std::move(last), holding).pieces;
    for (const FreePiece& piece : pieces_) regions_.push_back(polygonsOf(piece.body.loops, kChordMm));
  }

  /// None: the body does not reach here.
  std::optional<Vec2> placeOf(std::size_t body) const {
    const PlanePolygons outline = outlineOf(solid_, body, z_);
    return outline.empty() ? std::nullopt : std::optional(placeIn(outline));
  }
  /// The free piece at a place; null: what is there is held.
  const FreePiece* pieceAt(const Vec2& p) const {
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      if (holds(regions_[k], p)) return &pieces_[k];
    return nullptr;
  }

 private:
  static constexpr double kChordMm = 1e-3;
  const LeanSolid& solid_;
  double z_;
  std::vector<FreePiece> pieces_;
  std::vector<PlanePolygons> regions_;
};

/// When one body is free; none if it is held somewhere.
std::optional<LeanFall> fallOf(const std::vector<LevelFalls>& heights, std::size_t body) {
  LeanFall fall;
  fall.bodies = {body};
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const std::optional<Vec2> at = heights[k].placeOf(body);
    if (!at) continue;
    const FreePiece* piece = heights[k].pieceAt(*at);
    if (piece == nullptr) return std::nullopt;
    fall.fell = std::max(fall.fell, piece->fell);
    fall.passed_over = fall.passed_over || piece->passed_over;
    if (k == 1 || fall.half_way.body.loops.empty()) fall.half_way = *piece;
  }
  return fall.fell > CutTime{} ? std::optional(std::move(fall)) : std::nullopt;
}

/// Bodies that are left of one piece, free at the same time and in the same place, make one fall.
void join(LeanFall fall, std::vector<LeanFall>& falls) {
  const auto same = std::find_if(falls.begin(), falls.end(), [&](const LeanFall& other) {
    return other.passed_over && fall.passed_over && other.fell == fall.fell &&
           !other.half_way.region.empty() && holds(other.half_way.region, placeIn(fall.half_way.body));
  });
  if (same == falls.end())
    falls.push_back(std::move(fall));
  else
    same->bodies.insert(same->bodies.end(), fall.bodies.begin(), fall.bodies.end());
}

}  // namespace

std::vector<LeanFall> leanFalls(const PrismBlank& blank, const std::vector<LeanStretch>& cuts,
                                const LeanSolid& solid) {
  std::vector<LeanFall> falls;
  if (solid.bodies.size() < 2 || cuts.empty()) return falls;
  std::vector<LevelFalls> heights;
  for (const double z : {blank.z_low, 0.5 * (blank.z_low + blank.z_high), blank.z_high})
    heights.emplace_back(blank, cuts, solid, z);
  std::vector<std::size_t> held;
  for (std::size_t k = 0; k < solid.bodies.size(); ++k) {
    if (std::optional<LeanFall> fall = fallOf(heights, k))
      join(std::move(*fall), falls);
    else
      held.push_back(k);
  }
  for (LeanFall& fall : falls) {
    for (const std::size_t body : fall.bodies) {
      fall.volume_mm3 += solid.bodies[body].volume_mm3;
      for (const std::size_t other : held) {
        const BodyExit exit = exitOf(solid, body, solid, other);
        fall.falls = fall.falls && exit.down;
        fall.lifts = fall.lifts && exit.up;
      }
    }
  }
  std::stable_sort(falls.begin(), falls.end(),
                   [](const LeanFall& a, const LeanFall& b) { return a.fell < b.fell; });
  return falls;
}

}  // namespace proveout
