#include "removal/sweep/motion_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "core/path/posed_way.h"

namespace proveout {

namespace {

/// Curved motions are cut as chords that lie this close to them, mm: far below the smallest error that the
/// surface has elsewhere. On helices about z, whose crossings are those of the curve itself, chords decide
/// samples only, and a crossing that lies that close to one may be off by as much: there this share of the
/// grid will do. Level arcs of one radius have a closed form and need none.
constexpr double kChordShare = 1e-3, kChordMm = 5e-5;
/// The same for parts of the tool that do not cut: below what counts as contact.
constexpr double kContactChordMm = 5e-4;
constexpr double kMostChords = 1e6, kMostTurns = 1e5;
/// The ball of a tool that turns goes along chords this close to its way, mm; where a stretch needs more than
/// so many, all of the tool is searched for.
constexpr double kBallChordMm = 3e-5, kMostBallChords = 256.0;
/// Above the ids of all elements of a tool: a face belongs to one body.
constexpr int kBallIds = ConvexProfile::kEdgeIds / 2;
/// Level arcs whose radius and height change by less than this are circles, mm.
constexpr double kSameRadiusMm = 1e-7;
/// Curves with a smaller radius, mm, or angle are cut as chords.
constexpr double kLeastCurve = 1e-3;

/// Chords of a ball's way on one stretch.
double chordsOn(const PosedStretch& stretch, const SolidParts::Ball& ball) {
  const double bend = stretch.tip[1] + ball.solid.radius * stretch.axis[1];
  return std::max(1.0, std::ceil(std::sqrt(bend / (2.0 * kBallChordMm))));
}

bool hasFewChords(const PosedSweep& sweep, const SolidParts::Ball& ball) {
  return std::all_of(sweep.stretches().begin(), sweep.stretches().end(),
                     [&](const PosedStretch& stretch) { return chordsOn(stretch, ball) <= kMostBallChords; });
}

/// The ball that is a body by itself; null: none. Of what is watched there is one body.
const SolidParts::Ball* ballToPart(const SolidParts& parts, const PartUse& part) {
  return part.takes && parts.ball ? &*parts.ball : nullptr;
}

/// From the tip of a tool to the lowest point of its ball.
Vec3 lowestOf(const SolidParts::Ball& ball, const Vec3& axis) {
  return ball.solid.radius * (axis - Vec3::UnitZ());
}

/// The ball at the lower end of a solid, if all of it lies in the solid.
std::optional<SolidParts::Ball> ballOf(const ConvexProfile& profile) {
  constexpr double kIn = 1e-9;
  const ConvexProfile::Element& end = profile.element(0);
  if (!end.arc || end.cr != 0.0 || end.ar != 0.0 || end.az != 0.0 || profile.elementCount() < 2)
    return std::nullopt;
  if (profile.sample(0.0, end.cz).value > kIn - end.radius) return std::nullopt;
  SolidParts::Ball ball;
  ball.profile.start(0.0, 0.0);
  ball.profile.arcTo(0.0, end.radius, 0.0, 2.0 * end.radius);
  ball.profile.setFirstElementId(profile.firstElementId() + kBallIds);
  ball.solid = columnSolid(ball.profile);
  ball.rest.start(0.0, end.bz);
  ball.rest.lineTo(end.br, end.bz);
  for (int i = 1; i < profile.elementCount(); ++i) {
    const ConvexProfile::Element& e = profile.element(i);
    if (e.arc) {
      ball.rest.arcTo(e.cr, e.cz, e.br, e.bz);
    } else {
      ball.rest.lineTo(e.br, e.bz);
    }
  }
  ball.rest.setFirstElementId(profile.firstElementId());
  ball.rest_poses = poseSolid(ball.rest);
  return ball;
}

}  // namespace

SweptField motionField(const ConvexProfile& profile, const MotionWay& way) {
  if (way.turns()) return SweptField(profile, way);
  const Motion& m = way.motion;
  if (way.leans()) return SweptField(profile, ToolFrame(way.direction()), m.from, m.to, way.arc);
  return SweptField(profile, m.from, m.to, way.arc);
}

/// Of a part whose tip stands still while its axis turns as on the way.
static Box3 turningBounds(const ConvexProfile& profile, const MotionWay& way) {
  constexpr double kMostTurn = 0.25;  // rad, to both sides of an axis that is looked at
  constexpr int kMostLooks = 16;
  const double reach = farthestFromTip(profile);
  const PosedWay posed(way.motion, way.arc, *way.axis);
  const double turn = 0.5 * posed.boundsOn(0.0, 1.0).axis.velocity, looks = std::ceil(turn / kMostTurn);
  if (looks > kMostLooks) return Box3{Vec3::Constant(-reach), Vec3::Constant(reach)};
  Box3 box;
  const int count = std::max(1, static_cast<int>(looks));
  for (int i = 0; i < count; ++i)
    box.extend(
        leaningBounds(profile, ToolFrame(posed.at((i + 0.5) / count).axis)).inflated(reach * turn / count));
  return box;
}

Box3 partBounds(const ConvexProfile& profile, const MotionWay& way, const Box3& tip, double slack) {
  const double r = profile.maxRadius();
  if (way.turns()) {
    const Box3 part = turningBounds(profile, way);
    return Box3{tip.min + part.min, tip.max + part.max}.inflated(slack);
  }
  const Box3 part = way.leans() ? leaningBounds(profile, ToolFrame(way.direction()))
                                : Box3{Vec3(-r, -r, profile.zMin()), Vec3(r, r, profile.zMax())};
  return Box3{tip.min + part.min, tip.max + part.max}.inflated(slack);
}

const std::vector<MotionBody>& BodyMaker::make(MotionId id, const PartUse& part) {
  PROVEOUT_ASSERT(id < path_.motions.size() && part.profile != nullptr && part.solid != nullptr);
  bodies_.clear();
  const Motion& m = path_.motions[id];
  if (const MotionWay way = wayOf(path_, m); way.turns()) {
    addPosed(way, part);
    return bodies_;
  } else if (way.leans()) {
    addLeaning(way, part);
    return bodies_;
  }
  if (m.arc < 0) {
    bodies_.push_back({SweptBody(*part.profile, LineBody(columnLine(*part.solid, m.from, m.to)))});
    return bodies_;
  }
  PROVEOUT_ASSERT(static_cast<std::size_t>(m.arc) < path_.arcs.size());
  const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
  const SweptField& curve = store_.fields.emplace_back(motionField(*part.profile, wayOf(path_, m)));
  const ArcFrame frame = arcFrame(m.from, m.to, arc);
  if (isLevelArc(arc, frame)) {
    bodies_.push_back(
        {SweptBody(*part.profile, LevelArcBody(columnArc(*part.solid, m.from, m.to, arc)), &curve)});
  } else if (!addTurns(m, frame, part, curve) && !addWay(id, part, curve)) {
    addChords(m, frame, part, curve);
  }
  return bodies_;
}

void BodyMaker::addLeaning(const MotionWay& way, const PartUse& part) {
  const Motion& m = way.motion;
  const ToolFrame tool(way.direction());
  if (way.arc == nullptr) {
    const SolidParts& parts = partsOf(*part.profile);
    const SolidParts::Ball* const ball = ballToPart(parts, part);
    const ConvexProfile& profile = ball != nullptr ? ball->rest : *part.profile;
    bodies_.push_back({SweptBody(
        profile, LeanLineBody(store_.lean_lines.emplace_back(
                     profile, tool, m.from, m.to, ball != nullptr ? ball->rest_poses : parts.poses)))});
    if (ball == nullptr) return;
    const Vec3 lowest = lowestOf(*ball, tool.axis());
    bodies_.push_back(
        {SweptBody(ball->profile, LineBody(columnLine(ball->solid, m.from + lowest, m.to + lowest)))});
    return;
  }
  const SweptField& curve = store_.fields.emplace_back(motionField(*part.profile, way));
  const ArcGeometry arc = tool.toTool(*way.arc);
  if (isLevelArc(arc, arcFrame(tool.toTool(m.from), tool.toTool(m.to), arc))) {
    addLeanArc(way, tool, part, curve);
  } else {
    addLeanChords(way, tool, part, curve);
  }
}

/// A circle about the tool's axis, and the intervals in which a column may meet it.
void BodyMaker::addLeanArc(const MotionWay& way, const ToolFrame& tool, const PartUse& part,
                           const SweptField& curve) {
  const Motion& m = way.motion;
  const LeanArc whole(*part.profile, tool, m.from, m.to, *way.arc, partsOf(*part.profile).poses);
  const std::size_t first = store_.lean_arcs.size();
  whole.cut(store_.lean_arcs);
  for (std::size_t i = first; i < store_.lean_arcs.size(); ++i) {
    for (int number = 0; number < LeanArc::kMostSpans; ++number)
      bodies_.push_back({SweptBody(*part.profile, LeanArcBody(store_.lean_arcs[i], number), &curve)});
  }
}

/// Chords of helices about the tool's axis and of arcs about other axes.
void BodyMaker::addLeanChords(const MotionWay& way, const ToolFrame& tool, const PartUse& part,
                              const SweptField& curve) {
  const Motion& m = way.motion;
  const ArcFrame frame = arcFrame(m.from, m.to, *way.arc);
  const double radius = std::max({frame.radius_start, frame.radius_end, 1e-6});
  const double within = std::min(part.cuts ? kChordMm : kContactChordMm, radius);
  const double step = std::sqrt(8.0 * within / radius);
  const PoseSolid& solid = partsOf(*part.profile).poses;
  const int count =
      static_cast<int>(std::clamp(std::ceil(std::abs(way.arc->sweep_rad) / step), 1.0, kMostChords));
  Vec3 from = m.from;
  for (int i = 0; i < count; ++i) {
    const Vec3 to = i + 1 == count ? m.to : arcPoint(frame, *way.arc, (i + 1.0) / count);
    const LeanLine& line = store_.lean_lines.emplace_back(*part.profile, tool, from, to, solid);
    from = to;
    bodies_.push_back({SweptBody(*part.profile, LeanChordBody(line), &curve)});
  }
}

/// What a tool sweeps whose axis turns: its ball by itself, where it has one, and the rest.
void BodyMaker::addPosed(const MotionWay& way, const PartUse& part) {
  const SolidParts& parts = partsOf(*part.profile);
  const SolidParts::Ball* const ball = ballToPart(parts, part);
  const PosedSweep whole(*part.profile, way);
  if (ball == nullptr || !hasFewChords(whole, *ball)) return addStretches(whole, parts.poses);
  // The ball last: what stands above it is gone then.
  addStretches(PosedSweep(ball->rest, whole), ball->rest_poses);
  addBallChords(PosedSweep(ball->profile, whole), *ball);
}

/// The ball's way in chords.
void BodyMaker::addBallChords(const PosedSweep& sweep, const SolidParts::Ball& ball) {
  const SweptField& whole = store_.fields.emplace_back(sweep);
  const auto lowest = [&](const PosedStretch& s, double t) {
    const PosedStretch::Pose pose = s.poseAt(t);
    return Vec3(pose.tip + lowestOf(ball, pose.axis));
  };
  for (const PosedStretch& s : sweep.stretches()) {
    const int count = static_cast<int>(chordsOn(s, ball));
    Vec3 from = lowest(s, -1.0);
    for (int i = 1; i <= count; ++i) {
      const Vec3 to = lowest(s, 2.0 * i / count - 1.0);
      bodies_.push_back({SweptBody(ball.profile, ChordBody(columnLine(ball.solid, from, to)), &whole)});
      from = to;
    }
  }
}

/// Poses of each stretch, or the intervals in which a column may meet it. `solid`: of the sweep's profile.
void BodyMaker::addStretches(PosedSweep of, const PoseSolid& solid) {
  const SweptField& whole = store_.fields.emplace_back(std::move(of));
  const PosedSweep& sweep = *whole.posed();
  if (PosePiece::serves(sweep)) {
    const std::size_t first = store_.pose_pieces.size();
    for (const PosedStretch& stretch : sweep.stretches())
      PosePiece::cut(sweep, stretch, solid, store_.pose_pieces);
    for (std::size_t k = first; k < store_.pose_pieces.size(); ++k)
      bodies_.push_back({SweptBody(sweep.profile(), PoseRunBody(store_.pose_pieces[k]), &whole)});
    return;
  }
  for (std::size_t i = 0; i < sweep.stretches().size(); ++i) {
    const PosedPiece& piece = store_.posed_pieces.emplace_back(sweep, i, solid);
    for (int number = 0; number < PosedPiece::kMostSpans; ++number)
      bodies_.push_back({SweptBody(sweep.profile(), PosedBody(piece, number), &whole)});
  }
}

const SolidParts& BodyMaker::partsOf(const ConvexProfile& profile) {
  const auto [at, fresh] = store_.parts.try_emplace(&profile);
  if (fresh) at->second = {poseSolid(profile), ballOf(profile)};
  return at->second;
}

bool BodyMaker::isLevelArc(const ArcGeometry& arc, const ArcFrame& frame) const {
  return arc.normal.head<2>().squaredNorm() < 1e-24 && std::abs(frame.rise) < kSameRadiusMm &&
         std::abs(frame.radius_end - frame.radius_start) < kSameRadiusMm &&
         frame.radius_start > kSameRadiusMm;
}

/// Turns of a helix about z, or the two halves of an upright arc. False for curves that have neither.
bool BodyMaker::addTurns(const Motion& m, const ArcFrame& frame, const PartUse& part,
                         const SweptField& curve) {
  const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
  const double growth = std::abs(frame.radius_end - frame.radius_start), sweep = std::abs(arc.sweep_rad);
  if (growth > 2.0 * kChordMm || std::min(frame.radius_start, sweep) < kLeastCurve) return false;
  if (sweep > 2.0 * kPi * kMostChords) return false;
  const bool about_z = arc.normal.head<2>().squaredNorm() < 1e-24;
  const bool upright = std::abs(arc.normal.z()) < 1e-12 && std::abs(frame.rise) < kSameRadiusMm;
  if (about_z) {
    addTurnsAboutZ(m, part, curve);
  } else if (upright) {
    for (const UprightSweep& half : columnUprights(*part.solid, m.from, m.to, arc))
      bodies_.push_back({SweptBody(*part.profile, UprightBody(half), &curve)});
  }
  return about_z || upright;
}

/// Turns lie under each other: where a lower one covers all of the blank that the next does, this is left
/// out.
void BodyMaker::addTurnsAboutZ(const Motion& m, const PartUse& part, const SweptField& curve) {
  const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
  const std::vector<TurnSweep> turns = columnTurns(*part.solid, m.from, m.to, arc);
  const double blank_top = blank_top_ + h_;
  const bool falls = m.to.z() < m.from.z(), takes = part.takes && hasLevelTop(*part.solid);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const std::size_t below = falls ? i + 1 : i - 1;
    const bool has_lower = takes && below < turns.size() && isWholeTurn(turns[below]);
    if (has_lower && TurnBody(turns[below]).coveredTop() >= blank_top) continue;
    bodies_.push_back(
        {SweptBody(*part.profile, TurnBody(turns[i]), &curve), has_lower ? (falls ? 1 : -1) : 0});
  }
}

/// Parts of a spiral about z, of a helix whose radius changes, and of arcs and helices about axes that lean.
/// Parts that vectors serve for all columns are bodies; others are searched column by column, which is slower
/// than chords where these have closed forms, and on arcs that lean.
bool BodyMaker::addWay(MotionId id, const PartUse& part, const SweptField& curve) {
  const Motion& m = path_.motions[id];
  const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
  const double sweep = std::abs(arc.sweep_rad);
  const bool leans = arc.normal.head<2>().squaredNorm() > 1e-24;
  if (leans && !hasPlainEnds(*part.solid)) return false;
  const bool level = std::abs(m.to.z() - m.from.z()) < kSameRadiusMm;
  const bool closed_form = part.solid->flat || part.solid->ball;
  if (sweep < kLeastCurve || sweep > 2.0 * kPi * kMostTurns) return false;
  if (way_of_ != id) store_.ways.push_back(curveWay(m.from, m.to, arc));
  way_of_ = id;
  for (const WaySweep& columns : columnParts(*part.solid, store_.ways.back())) {
    const bool chords = (leans || (closed_form && !level)) && !isPlainPart(columns);
    if (chords && !columns.again) addWayChords(part, columns, curve);
    if (!chords) bodies_.push_back({SweptBody(*part.profile, WayBody(columns), &curve)});
  }
  return true;
}

/// Chords of a part.
void BodyMaker::addWayChords(const PartUse& part, const WaySweep& columns, const SweptField& curve) {
  const CurveWay& way = *columns.way;
  const double within = part.cuts ? kChordMm : kContactChordMm, wide = CurveWay::kNodesAPart * way.node_rad;
  const double step = std::sqrt(8.0 * within / std::max(way.most_bend, 1e-6));
  const int chords = static_cast<int>(std::ceil(wide / step));
  const double first = columns.part * wide;
  for (int i = 0; i < chords; ++i) {
    const Vec3 from = way.node(first + wide * i / chords).at,
               to = way.node(first + wide * (i + 1) / chords).at;
    bodies_.push_back({SweptBody(*part.profile, ChordBody(columnLine(*part.solid, from, to)), &curve)});
  }
}

/// Chords of a curve. Those of a helix about z lie under each other, turn by turn: where the lower ones cover
/// all of the blank that the upper ones do, these are left out.
void BodyMaker::addChords(const Motion& m, const ArcFrame& frame, const PartUse& part,
                          const SweptField& curve) {
  const ArcGeometry& arc = path_.arcs[static_cast<std::size_t>(m.arc)];
  const double radius = std::max({frame.radius_start, frame.radius_end, 1e-6}),
               sweep = std::abs(arc.sweep_rad);
  const bool whole =
      SweptBody(*part.profile, ChordBody(columnLine(*part.solid, m.from, m.to)), &curve).isAskedWhole();
  const double within = !part.cuts ? kContactChordMm
                        : whole    ? std::max(kChordMm, kChordShare * h_)
                                   : kChordMm;
  const double step = std::sqrt(8.0 * std::min(within, radius) / radius), turn = 2.0 * kPi;
  const bool stacked = sweep > turn && part.takes && arc.normal.head<2>().squaredNorm() < 1e-24 &&
                       frame.rise != 0.0 && std::abs(frame.radius_end - frame.radius_start) < kSameRadiusMm;
  const double wanted = std::min(stacked ? turn / std::ceil(turn / step) : step, sweep);
  const int chords = static_cast<int>(std::clamp(std::ceil(sweep / wanted - 1e-9), 1.0, kMostChords));
  PROVEOUT_ASSERT(chords >= 1);
  const bool exact = chords < kMostChords;  // else they are longer than wanted
  const double angle = stacked && exact ? wanted : sweep / chords;
  const int per_turn = stacked && exact ? static_cast<int>(std::lround(turn / angle)) : 0;
  const bool falls = frame.n.z() * frame.rise < 0.0;
  const double blank_top = blank_top_ + h_, pitch = std::abs(frame.rise) * turn / sweep;
  Vec3 from = m.from;
  for (int i = 0; i < chords; ++i) {
    const Vec3 to = i + 1 == chords ? m.to : arcPoint(frame, arc, (i + 1) * angle / sweep);
    const SweptBody chord(*part.profile, ChordBody(columnLine(*part.solid, from, to)), &curve);
    from = to;
    const bool has_lower =
        per_turn > 0 && hasLevelTop(*part.solid) && (falls ? i + per_turn + 1 < chords : i >= per_turn);
    if (has_lower && chord.coveredTop() - pitch >= blank_top) continue;
    bodies_.push_back({chord, has_lower ? (falls ? per_turn : -per_turn) : 0});
  }
}

}  // namespace proveout
