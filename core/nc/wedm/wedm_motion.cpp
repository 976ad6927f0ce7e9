// Motions of the wire EDM control: from words to elements of both planes (digest wedm, D2.3, D5, D8).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/wedm/wedm_elements.h"

namespace proveout::nc {

namespace {

constexpr double kMostRound = 999.999;  ///< mm
constexpr double kSamePoint = 1e-9;     ///< mm

ContourElement shiftedEnds(ContourElement e, const Vec2& from, const Vec2& to) {
  e.from += from;
  e.to += to;
  e.center += from;
  return e;
}

bool stands(const ContourElement& e) { return !e.arc && (e.to - e.from).norm() < kSamePoint; }

/// Lower and upper shape (G61).
bool planShapes(WedmContext& c, WedmPlan& p, WedmRecord& record) {
  if (hasWordOf(c.block.words, "UVR") || hasWordOf(c.block.upper, "UVRA"))
    return c.report.fail("wedm-5.9-words", "U, V and R are not allowed with G61");
  if (!c.block.colon)
    c.report.warnOnce("wedm-5.9-colon", "a motion without ':' while G61 is on: both shapes go the same way");
  WedmState& s = p.next;
  for (const WedmWord& word : c.block.upper) {
    if (word.address != 'G') continue;
    if (word.code > 3)
      return c.report.fail("wedm-5.9-colon", "behind ':' only G00 to G03 may stand", word.columns);
    s.upper_motion = word.code;
  }
  if (!c.block.colon) s.upper_motion = s.motion;
  if ((s.motion == 0) != (s.upper_motion == 0))
    return c.report.fail("wedm-5.9-rapid", "both shapes go in rapid (G00) or neither does");
  const bool up = c.parameters.rise() > 0.0;
  const std::vector<WedmWord>& upper_words = c.block.colon ? c.block.upper : c.block.words;
  const auto lower = elementOf(c, s, {&c.block.words, up ? s.main : s.second, s.motion});
  if (!lower) return false;
  const auto upper = elementOf(c, s, {&upper_words, up ? s.second : s.main, s.upper_motion});
  if (!upper) return false;
  record.main = up ? *lower : *upper;
  record.second = up ? *upper : *lower;
  s.main = record.main.to;
  s.second = record.second.to;
  if (s.offsetToLeft() != 0.0 && stands(record.main) != stands(record.second))
    return c.report.fail("wedm-5.9-stands",
                         "one shape stands still while the offset is on: its side is not known; "
                         "use H of 0 or move it");
  return true;
}

/// X, Y with the lean that U and V make of it.
bool planAxes(WedmContext& c, WedmPlan& p, WedmRecord& record) {
  WedmState& s = p.next;
  const auto main = elementOf(c, s, {&c.block.words, s.main, s.motion});
  if (!main) return false;
  Vec2 lean = s.second - s.main;
  const Vec2 old_lean = lean;
  if (hasWordOf(c.block.words, "UV")) {
    if (s.motion >= 2)
      return c.report.fail("wedm-6-UV", "U and V go along lines only, not along G02 and G03");
    if (s.taper != 50)
      return c.report.fail("wedm-6-UV", "U and V are not allowed in a taper: put G50 before them");
    if (s.offsetToLeft() != 0.0)
      return c.report.fail("wedm-6-UV", "U and V are not allowed while an offset is on: put G40 before them");
    const auto uv = targetOf(c, s, c.block.words, 'U', s.uv, s.uv_origin[s.systemIndex()]);
    if (!uv) return false;
    const bool in_plane = s.four_axis == 74 && !c.parameters.uv_upper;
    lean += (*uv - s.uv) * (in_plane ? 1.0 : c.parameters.rise() / c.parameters.guides());
    s.uv = *uv;
  }
  // Told at the upper guide, X and Y are those of the lower guide.
  const bool guides = s.four_axis == 74 && c.parameters.uv_upper;
  const double share = guides ? (c.parameters.z_main - c.parameters.z_lower) / c.parameters.rise() : 0.0;
  record.main = shiftedEnds(*main, share * old_lean, share * lean);
  record.second = shiftedEnds(*main, (1.0 + share) * old_lean, (1.0 + share) * lean);
  s.main = main->to;
  s.second = main->to + lean;
  return true;
}

bool planRound(WedmContext& c, const WedmState& s, WedmRecord& record) {
  std::vector<double> radii;
  for (const WedmWord& word : c.block.words) {
    if (word.address != 'R') continue;
    const auto value = wedmLength(c, s, word.terms, word.columns);
    if (!value) return false;
    if (!(*value >= 0.0 && *value <= kMostRound))
      return c.report.fail("wedm-1.4-ranges", "R is 0 to 999.999 mm", word.columns);
    radii.push_back(*value);
  }
  if (radii.empty()) return true;
  if (s.four_axis == 74) return c.report.fail("wedm-14-R", "R is not allowed with G74");
  if (s.offset == 40 || s.motion == 0) {
    c.report.warnOnce("wedm-14-R", "R has no effect without G41 or G42, nor with G00");
    return true;
  }
  record.round = radii[0];
  if (radii.size() < 2) return true;
  if (s.taper == 50) {
    c.report.warnOnce("wedm-7.4-RR", "the second R has no effect without G51 or G52");
  } else {
    record.round_2 = radii[1];
  }
  return true;
}

/// What must hold when the wire cuts.
bool checkCutting(WedmContext& c, const WedmState& s) {
  if (s.threaded == 0)
    return c.report.fail("wedm-8.5-M50", "the wire is cut (M50): thread it with M60 before cutting");
  if (s.fluid == 0 || s.wire_runs == 0)
    c.report.warnOnce("wedm-15-T84",
                      "cutting without fluid or running wire, which breaks it: put T84 and T86 before");
  if (s.condition == 0 && c.parameters.feedOf(0) <= 0.0)
    return c.report.fail("wedm-9-C", "cutting needs a condition: put C001 to C100 before it");
  return true;
}

void takeModes(WedmContext& c, const WedmState& s, WedmRecord& record) {
  record.offset_on = s.offset != 40;
  record.offset = s.offsetToLeft();
  record.taper_on = s.taper != 50;
  if (record.taper_on)
    record.lean = (s.taper == 51 ? 1.0 : -1.0) * c.parameters.rise() * std::tan(degToRad(s.angle_deg));
  record.outer = s.corner == 28 ? OuterJoin::kArc : c.parameters.straight_join;
  record.extension = s.motion == 1 ? s.extension : 0.0;
  record.columns = c.report.blockColumns();
  record.pace.rapid = s.motion == 0;
  record.pace.slow_end = s.slow == 34 && s.motion != 0;
  record.pace.condition = s.condition;
  record.pace.wire = {s.threaded != 0, c.state.by_hand != 0 && record.pace.rapid, s.wire_runs != 0,
                      s.fluid != 0, s.condition != 0};
  if (s.overcut <= 0.0 || s.motion == 0) return;
  if (record.offset == 0.0)
    c.report.warnOnce("wedm-5.5.5-offset", "the corner overcut G37 has no effect without an offset");
  if (record.taper_on || s.shape == 61 || s.four_axis == 74) {
    c.report.warnOnce("wedm-5.5.5-G37", "the corner overcut G37 has no effect with taper, G61 or G74");
  } else {
    record.overcut = s.overcut;
    record.overcut_dwell = s.overcut_dwell;
  }
}

bool checkWords(WedmContext& c, const WedmPlan& p, bool moves) {
  if (c.block.colon && p.next.shape != 61)
    return c.report.fail("wedm-5.9-colon", "':' stands between lower and upper shape, while G61 is on",
                         c.block.colon_at);
  for (const WedmWord& word : c.block.upper) {
    if (word.argument || std::string_view("GXYIJUVRA").find(word.address) == std::string_view::npos)
      return c.report.fail("wedm-5.9-colon", "behind ':' only G00 to G03, X, Y, I and J may stand",
                           word.columns);
  }
  if (!moves && hasWordOf(c.block.words, "R"))
    return c.report.fail("wedm-14-R", "R stands in a block with a motion");
  if (moves && p.dwell_s) return c.report.fail("wedm-5-G04", "G04 stands in a block without a motion");
  return true;
}

}  // namespace

bool planWedmPoint(WedmContext& c, WedmPlan& p) {
  WedmState& s = p.next;
  if (s.taper != 50 || c.state.taper != 50)
    return c.report.fail("wedm-5.11-taper", "G92 is not allowed in a taper: put G50 before it");
  if (hasWordOf(c.block.words, "IJR")) return c.report.fail("wedm-5.11-G92", "G92 takes X, Y, U and V only");
  if (s.shape == 61 && (s.main - s.second).norm() > kSamePoint)
    return c.report.fail("wedm-5.11-G92", "G92 with G61 needs both shapes at one point");
  // The first one says where the wire stands, the others what that point is called.
  const bool first = s.placed == 0 && s.moved == 0;
  WedmState absolute = s;
  absolute.distance = 90;
  const auto name = [&](char axis, Vec2& at, Vec2& origin) {
    const auto named = targetOf(c, absolute, c.block.words, axis, at, origin);
    if (named && !first) origin += at - *named;
    if (named && first) at = *named;
    return named.has_value();
  };
  if (!name('X', s.main, s.origin[s.systemIndex()]) || !name('U', s.uv, s.uv_origin[s.systemIndex()]))
    return false;
  if (first) s.second = s.main;
  s.placed = 1;
  p.sets_point = true;
  return true;
}

bool planWedmMotion(WedmContext& c, WedmPlan& p) {
  WedmState& s = p.next;
  const bool moves =
      !p.sets_point && (hasWordOf(c.block.words, "XYUVIJ") || hasWordOf(c.block.upper, "XYUVIJ"));
  if (!checkWords(c, p, moves)) return false;
  const bool lean = (s.second - s.main).norm() > kSamePoint;
  if (lean && s.taper != 50 && c.state.taper == 50)
    return c.report.fail("wedm-7.2-lean", "a taper starts with an upright wire: bring U and V to 0 before");
  if (lean && c.parameters.uv_upper && s.four_axis != c.state.four_axis)
    return c.report.fail("wedm-5.9.1-lean",
                         "G74 and G75 need an upright wire here: bring U and V to 0 before");
  if (lean && s.shape == 60 && c.state.shape == 61)
    c.report.warn("wedm-5.9-G60", "both shapes end at different points: the wire keeps leaning");
  if (!moves) return true;
  if (s.four_axis == 74 && s.motion >= 2)
    return c.report.fail("wedm-5.9.1-excl", "G02 and G03 are not allowed with G74: put G01 into the block");
  WedmRecord record;
  takeModes(c, s, record);
  if (!(s.shape == 61 ? planShapes(c, p, record) : planAxes(c, p, record)) || !planRound(c, s, record))
    return false;
  if (stands(record.main) && stands(record.second)) return true;
  if (!record.pace.rapid && !checkCutting(c, s)) return false;
  if (s.placed == 0)
    c.report.warnOnce("wedm-5.11-G92", "motion without a G92 before it: the wire is taken to start at X0 Y0");
  s.moved = 1;
  if (!record.pace.rapid) s.by_hand = p.has('M', 0) ? 1 : 0;
  p.motion = std::move(record);
  return true;
}

}  // namespace proveout::nc
