#include "core/nc/wedm/wedm_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace proveout::nc {

namespace {

constexpr double kMostH = 99999.999;
constexpr double kMostAngle = 45.0;  ///< degrees, and beyond

bool planCode(WedmContext& c, WedmPlan& p, const WedmWord& word) {
  const WedmGCode* const code = wedmGCode(word.code);
  if (code == nullptr)
    return c.report.fail("wedm-13-code", fmt::format("the control has no G{:02}: remove it", word.code),
                         word.columns);
  for (const WedmGCode* other : p.codes) {
    if (other->group != code->group || code->group == WedmGroup::kMirror) continue;
    if (code->group == WedmGroup::kOneShot && other->code != code->code) continue;
    const bool motion = code->group == WedmGroup::kMotion;
    return c.report.fail(
        motion ? "wedm-2.2-onemotion" : "wedm-2.2-twice",
        fmt::format("{} in one block: G{:02} and G{:02} exclude each other, make two blocks of it",
                    motion ? "two motion codes" : "two codes of one kind", other->code, code->code),
        word.columns);
  }
  p.codes.push_back(code);
  if (code->mode != nullptr) p.next.*code->mode = code->code;
  if (code->set != nullptr) code->set(p.next);
  return true;
}

bool planFunction(WedmContext& c, WedmPlan& p, const WedmWord& word) {
  const WedmFunction* const function = wedmFunction(word.address, word.code);
  if (function == nullptr) {
    return c.report.fail(
        "wedm-13-code",
        fmt::format("the control has no {}{:02}: it has M00 M02 M50 M60 M98 M99 and T84 to T87", word.address,
                    word.code),
        word.columns);
  }
  if (word.address == 'M') {
    for (const WedmFunction* other : p.functions) {
      if (other->address == 'M')
        return c.report.fail("wedm-2.2-twice", "a block has one M code at most: make two blocks of it",
                             word.columns);
    }
  }
  p.functions.push_back(function);
  if (function->flag != nullptr) p.next.*function->flag = function->value;
  return true;
}

bool planCondition(WedmContext& c, WedmPlan& p, const WedmWord& word) {
  if (word.code < 1 || word.code > kWedmConditions || c.parameters.feedOf(word.code) <= 0.0)
    return c.report.fail("wedm-9-C",
                         fmt::format("the machine has no condition C{:03}: C001 to C100, less those that "
                                     "the job calls ABSENT",
                                     word.code),
                         word.columns);
  p.next.condition = word.code;
  return true;
}

/// Every code of the block on the copy of the state.
bool planCodes(WedmContext& c, WedmPlan& p) {
  for (const WedmWord& word : c.block.words) {
    if (word.argument) continue;
    if (word.address == 'G' && !planCode(c, p, word)) return false;
    if ((word.address == 'M' || word.address == 'T') && !planFunction(c, p, word)) return false;
    if (word.address == 'C' && !planCondition(c, p, word)) return false;
  }
  return true;
}

/// An axis or a modal number twice.
bool checkRepeats(WedmContext& c, const std::vector<WedmWord>& words) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    const WedmWord& word = words[k];
    if (word.argument || std::string_view("GMTR").find(word.address) != std::string_view::npos) continue;
    for (std::size_t other = 0; other < k; ++other) {
      if (words[other].argument || words[other].address != word.address) continue;
      return c.report.fail("wedm-2.2-dupaxis", fmt::format("{} stands twice in the block", word.address),
                           word.columns);
    }
  }
  const auto rounds =
      std::count_if(words.begin(), words.end(), [](const WedmWord& w) { return w.address == 'R'; });
  return rounds <= 2 || c.report.fail("wedm-2.2-dupaxis",
                                      "a block has two R at most: of the main plane and of the "
                                      "secondary plane");
}

bool assign(WedmContext& c, WedmPlan& p) {
  for (const WedmAssignment& assignment : c.block.assignments) {
    const auto value = wedmLength(c, p.next, assignment.terms, assignment.columns);
    if (!value) return false;
    if (std::abs(*value) > kMostH)
      return c.report.fail("wedm-12-H", fmt::format("the value {} is beyond 99999.999", *value),
                           assignment.columns);
    if (assignment.h > 99)
      c.report.warnOnce("wedm-12-H-range", "the control has H000 to H099", assignment.columns);
    c.variables.assign(assignment.h, *value);
  }
  return true;
}

/// X of G04, G31 and G37, T of G37.
bool planArguments(WedmContext& c, WedmPlan& p) {
  int code = 0;
  for (const WedmWord& word : c.block.words) {
    if (word.address == 'G') code = word.code;
    if (!word.argument) continue;
    const bool time = code == 4 || word.address == 'T';
    const auto value = time ? wedmSeconds(c, p.next, word.terms, word.columns)
                            : wedmLength(c, p.next, word.terms, word.columns);
    if (!value) return false;
    if (*value < 0.0) return c.report.fail("wedm-5.5.3-X", "the distance cannot be negative", word.columns);
    if (code == 4) p.dwell_s = *value;
    if (code == 31) p.next.extension = *value;
    if (code == 37 && word.address == 'T') p.next.overcut_dwell = *value;
    if (code == 37 && word.address == 'X') {
      p.next.overcut = *value;
      p.next.overcut_dwell = 0.0;
      p.next.overcut_on = *value > 0.0 ? 1 : 0;
    }
  }
  return true;
}

bool planOffset(WedmContext& c, WedmPlan& p) {
  const WedmWord* const h = c.block.find('H');
  if (!p.has(40) && !p.has(41) && !p.has(42)) {
    return h == nullptr ||
           c.report.fail("wedm-5.6.1-H",
                         "H stands with G40, G41 or G42, or is given a value with =", h->columns);
  }
  if (p.has(40)) {
    if (p.next.overcut_on != 0)
      c.report.warnOnce("wedm-5.5.5-G36",
                        "the corner overcut G37 is still on: put G36 before leaving the contour");
    return true;
  }
  if (h != nullptr) p.next.h = h->code;
  if (p.next.h < 0) return c.report.fail("wedm-5.6.1-H", "G41 and G42 need the number of an offset, H001");
  const std::vector<WedmTerm> value{{1.0, false, p.next.h, h != nullptr ? h->columns : Columns{}}};
  const auto radius = wedmLength(c, p.next, value, value.front().columns);
  if (!radius) return false;
  p.next.radius = *radius;
  if (*radius < 0.0)
    c.report.warn("wedm-5.6.1-negative",
                  fmt::format("H{:03} is negative: the wire goes on the other side", p.next.h));
  return true;
}

bool planTaper(WedmContext& c, WedmPlan& p) {
  const WedmWord* const a = c.block.find('A');
  if (p.has(50)) p.next.angle_deg = 0.0;
  if (a == nullptr) {
    if (p.next.taper != 50 && c.state.taper == 50)
      c.report.warnOnce("wedm-5.7-upright", "G51 or G52 without A: the wire stays upright until A is given");
    return true;
  }
  const double angle = a->terms.front().number;
  if (p.next.taper == 50)
    return (p.has(50) && angle == 0.0) || c.report.fail("wedm-5.7-A", "A needs G51 or G52", a->columns);
  if (!(std::abs(angle) < kMostAngle))
    return c.report.fail("wedm-5.7-A", "the taper angle is in degrees, below 45", a->columns);
  p.next.angle_deg = angle;
  return true;
}

/// Modes that exclude each other.
bool checkModes(WedmContext& c, const WedmPlan& p) {
  const WedmState &now = c.state, &next = p.next;
  const bool taper_code = p.has(50) || p.has(51) || p.has(52);
  const bool shape = now.shape == 61 || next.shape == 61;
  if (shape && (p.has(74) || p.has(75) || taper_code || next.taper != 50 || next.four_axis == 74))
    return c.report.fail("wedm-5.9-excl",
                         "G50 G51 G52 G74 G75 are not allowed with G61: put G60 before them");
  const bool four = now.four_axis == 74 || next.four_axis == 74;
  if (four && (p.has(2) || p.has(3) || taper_code || p.has(60) || p.has(61) || next.taper != 50))
    return c.report.fail("wedm-5.9.1-excl",
                         "G02 G03 G50 G51 G52 G60 G61 are not allowed with G74: put G75 before them");
  if (next.four_axis == 74 && next.offset != 40 && next.radius != 0.0)
    return c.report.fail("wedm-5.9.1-offset",
                         "an offset is not allowed with G74: cancel it with G40 or use H of 0");
  const bool frame = now.system != next.system || now.units != next.units || now.mirror_x != next.mirror_x ||
                     now.mirror_y != next.mirror_y || now.swap != next.swap;
  if (frame && now.offset != 40 && next.offset != 40)
    return c.report.fail("wedm-5.6-frame",
                         "G54 to G59, G05 to G09, G20 and G21 are not allowed while an offset is on: "
                         "put G40 before them");
  if (now.system != next.system && next.placed == 0 && lacksWorkOffset(c.settings, next.system - 53))
    c.report.warnOnce("wedm-offset-missing",
                      fmt::format("G{0} has no value in the job: 0 is taken (--offset G{0}=X,Y,Z)", next.system));
  const bool sided = p.has(41) || p.has(42) || p.has(51) || p.has(52);
  if (sided && next.reflected())
    c.report.warnOnce("wedm-5.4-side",
                      "left and right are seen along the mirrored motion: the wire is on the other "
                      "side of the shape");
  if (next.swap != 0 && (next.mirror_x != 0 || next.mirror_y != 0) && frame)
    c.report.warnOnce("wedm-5.4-order", "mirror and change of places together: values are mirrored first");
  return true;
}

bool planCall(WedmContext& c, WedmPlan& p) {
  const WedmWord *const label = c.block.find('P'), *const times = c.block.find('L');
  if (!p.has('M', 98)) {
    const WedmWord* const lost = label != nullptr ? label : times;
    return lost == nullptr || c.report.fail("wedm-10-P", "P and L stand with M98", lost->columns);
  }
  if (label == nullptr) return c.report.fail("wedm-10-P", "M98 needs the number of the subprogram, P0010");
  for (const WedmWord& word : c.block.words) {
    if (std::string_view("MPL").find(word.address) == std::string_view::npos)
      return c.report.fail("wedm-8.3-M98", "M98 stands alone with P and L", word.columns);
  }
  p.call = WedmCall{label->code, times != nullptr ? times->code : 1};
  return true;
}

}  // namespace

bool planWedmBlock(WedmContext& c, WedmPlan& p) {
  if (!checkRepeats(c, c.block.words) || !checkRepeats(c, c.block.upper) || !planCodes(c, p) ||
      !planArguments(c, p) || !assign(c, p))
    return false;
  if (!planCall(c, p) || (p.has(92) && !planWedmPoint(c, p)) || !planOffset(c, p) || !planTaper(c, p))
    return false;
  if (p.has(61) && c.state.shape == 60) p.next.upper_motion = p.next.motion;
  return checkModes(c, p) && planWedmMotion(c, p);
}

}  // namespace proveout::nc
