// M codes that the interpreter carries out ahead of the motion of their line: outputs, inputs, overrides,
// tool number, coolant, orientation, and those of the user.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/iso/tools/tools.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {
namespace {

/// Does a G code of the block, or the motion in force, use that letter itself?
bool lcnNeededByG(const IsoContext& c, Address letter) {
  const auto takes = [&](int code10) {
    const GCode* const code = c.codes.g(code10);
    return code != nullptr && code->words.has(letter);
  };
  bool moves = false;
  for (const Word& w : c.block.words) {
    if (w.address == 'G' && takes(static_cast<int>(std::round(w.value * 10.0)))) return true;
    moves = moves || w.axis >= 0;
  }
  return moves && takes(c.state.active[kGroupMotion]);
}

std::string lcnNumber(double value) {
  std::string text = fmt::format("{:.6f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

const Word* LinuxCncLanguage::functionWord(Address letter) {
  taken_.add(letter);
  return c_.block.find(letter);
}

bool LinuxCncLanguage::functionFails(const Word& m, const char* name, std::string message) {
  return c_.failWord(name, std::move(message), m);
}

/// The block's own functions in the order of execution, which then are none of the words any more. False:
/// reported.
bool LinuxCncLanguage::functions(StatementFlow& flow) {
  if (!c_.block.present.has('M') && !c_.block.present.has(kSpindleNumber)) return true;
  if (!spindleNumber()) return false;
  for (const Word& w : c_.block.words) {
    if (w.address != 'M') continue;
    if (w.value == 8.0) run_.flood = true;
    if (w.value == 9.0) run_.flood = run_.mist = false;
    if (w.value == 6.0 && !stopAtChange()) return false;
  }
  taken_ = {};
  std::vector<Word> own;
  for (const Word& w : c_.block.words)
    if (w.address == 'M' && isOwn(static_cast<int>(w.value))) own.push_back(w);
  if (own.empty()) return true;
  const auto order = [](const Word& w) {
    const auto m = static_cast<int>(w.value);
    return m >= 62 && m <= 68   ? 0
           : m == 61            ? 1
           : m == 19            ? 2
           : m >= 70 && m <= 73 ? 3
           : m == 7             ? 4
           : m < 54             ? 5
                                : 6;
  };
  std::stable_sort(own.begin(), own.end(), [&](const Word& a, const Word& b) { return order(a) < order(b); });
  for (const Word& w : own)
    if (!function(w, flow)) return false;
  dropWords(own);
  return true;
}

bool LinuxCncLanguage::isOwn(int m) {
  return m == 7 || m == 19 || (m >= 48 && m <= 53) || (m >= 61 && m <= 68) || (m >= 70 && m <= 73) ||
         m >= 100;
}

void LinuxCncLanguage::dropWords(const std::vector<Word>& own) {
  Block& block = c_.block;
  const auto done = [&](const Word& w) {
    if (w.address == 'M')
      return std::any_of(own.begin(), own.end(),
                         [&](const Word& o) { return o.columns.begin == w.columns.begin; });
    return taken_.has(w.address) && !lcnNeededByG(c_, w.address);
  };
  std::erase_if(block.words, done);
  block.present = {};
  for (const Word& w : block.words) block.present.add(w.address);
}

/// M6 stops the spindle, unless the INI file says otherwise; what M3 says in the line comes behind it.
bool LinuxCncLanguage::stopAtChange() {
  const LinuxCncFlavour flavour = linuxCncFlavour(c_);
  const bool stops = flavour == LinuxCncFlavour::kLinuxCnc || flavour == LinuxCncFlavour::kPathPilot;
  if (!stops || machine_.changes_with_spindle_on || c_.state.spindle_direction == 0 || c_.state.compOn())
    return true;
  return c_.flushPipe() && turnMain(c_, 0, c_.state.spindle_rpm);
}

/// `$`: the job has one spindle, $0; -1 means all of them.
bool LinuxCncLanguage::spindleNumber() {
  const Word* const w = c_.block.find(kSpindleNumber);
  if (w == nullptr) return true;
  std::int64_t number = 0;
  if (!lcnInteger(w->value, number)) return functionFails(*w, "integer", "Non integer value for integer");
  if (number != 0 && number != -1) {
    return functionFails(
        *w, "spindle",
        fmt::format("Spindle ($) number out of range: the simulated machine has spindle $0, not ${}",
                    number));
  }
  const auto uses = [](const Word& word) {
    constexpr std::array<int, 5> kM{3, 4, 5, 19, 51};
    constexpr std::array<int, 6> kG{330, 331, 760, 950, 960, 970};
    const auto code = static_cast<int>(std::round(word.value * (word.address == 'G' ? 10.0 : 1.0)));
    if (word.address == 'G') return std::find(kG.begin(), kG.end(), code) != kG.end();
    return word.address == 'S' || (word.address == 'M' && std::find(kM.begin(), kM.end(), code) != kM.end());
  };
  if (std::none_of(c_.block.words.begin(), c_.block.words.end(), uses)) {
    return functionFails(
        *w, "unused-word",
        "$ (spindle selection) word with no M3, M4, M5, M19, M51, G33, G33.1, G76, G95, G96 or "
        "G97 to use it");
  }
  std::erase_if(c_.block.words, [](const Word& word) { return word.address == kSpindleNumber; });
  c_.block.present = c_.block.present.without(AddressSet("$"));
  return true;
}

bool LinuxCncLanguage::function(const Word& m, StatementFlow& flow) {
  const auto number = static_cast<int>(m.value);
  switch (number) {
    case 7:
      run_.mist = true;
      return sendEvent(c_, event::Coolant{"M7", true});
    case 19:
      return orient(m);
    case 61:
      return toolNumber(m);
    case 66:
      return input(m);
    case 70:
    case 71:
    case 72:
    case 73:
      return savedState(m, flow);
    default:
      break;
  }
  if (number >= 48 && number <= 53) return override(m);
  return number < 100 ? output(m) : userFunction(m);
}

/// M48 to M53: P0 off, else on. Feeds of the simulation have no overrides.
bool LinuxCncLanguage::override(const Word& m) {
  const auto number = static_cast<int>(m.value);
  const Word* const p = number >= 50 ? functionWord('P') : nullptr;
  return sendEvent(c_, event::Function{p == nullptr ? fmt::format("M{}", number)
                                                    : fmt::format("M{} P{}", number, lcnNumber(p->value)),
                                       {}});
}

/// M62 to M65 P; M67 and M68 E Q.
bool LinuxCncLanguage::output(const Word& m) {
  const auto number = static_cast<int>(m.value);
  if (number <= 65) {
    const Word* const p = functionWord('P');
    if (p == nullptr)
      return functionFails(m, "missing-word", fmt::format("No valid P word with M{}", number));
    return sendEvent(c_, event::Function{fmt::format("M{} P{}", number, lcnNumber(p->value)), {}});
  }
  const Word* const e = functionWord('E');
  const Word* const q = functionWord('Q');
  if (e == nullptr || e->value < 0.0)
    return functionFails(m, "missing-word", fmt::format("Invalid analog index with M{}", number));
  return sendEvent(c_, event::Function{fmt::format("M{} E{} Q{}", number, lcnNumber(e->value),
                                                   lcnNumber(q == nullptr ? -1.0 : q->value)),
                                       {}});
}

/// M66: the answer of the job, else a time-out.
bool LinuxCncLanguage::input(const Word& m) {
  const Word* const p = functionWord('P');
  const Word* const e = functionWord('E');
  const Word* const l = functionWord('L');
  const Word* const q = functionWord('Q');
  const bool digital = p != nullptr && p->value >= 0.0, analog = e != nullptr && e->value >= 0.0;
  if (digital && analog)
    return functionFails(m, "input", "Invalid to select both a digital and an analog input with M66");
  if (!digital && !analog)
    return functionFails(m, "input", "Need to have either a valid P or a valid E word with M66");
  const double wait = l == nullptr ? 0.0 : std::round(l->value);
  if (!(wait >= 0.0 && wait <= 4.0)) return functionFails(m, "input", "L of M66 is 0 to 4");
  if (analog && wait != 0.0)
    return functionFails(m, "input", "Can't select analog input with wait type != immediate return");
  if (wait != 0.0 && (q == nullptr || q->value <= 0.0))
    return functionFails(m, "input", "Zero timeout with wait type != immediate return");
  const Word& which = digital ? *p : *e;
  const std::string name =
      fmt::format("{}{}", digital ? 'P' : 'E', static_cast<int>(std::round(which.value)));
  double answer = -1.0, time = wait == 0.0 || q == nullptr ? 0.0 : q->value;
  const auto told = machine_.inputs.find(name);
  if (told != machine_.inputs.end()) {
    const bool high = told->second != 0.0;
    // A rise or fall that the job promises comes at once.
    const bool met = wait == 0.0 || ((wait == 1.0 || wait == 3.0) == high);
    if (met) {
      answer = told->second;
      time = 0.0;
    }
  }
  if (!c_.flushPipe()) return false;
  variables_.put(5399, answer);
  if (told == machine_.inputs.end() && c_.firstTime("input " + name)) {
    c_.warn("input",
            fmt::format("M66 {}: the job has no answer of this input ([control.linuxcnc] inputs), so that "
                        "it times out: #5399 is -1",
                        name),
            m.columns, Severity::kNote);
  }
  return sendEvent(c_, event::Function{fmt::format("M66 {}", name), {}}, time);
}

/// M61 Q: the tool in the spindle is called so from now on.
bool LinuxCncLanguage::toolNumber(const Word& m) {
  const Word* const q = functionWord('Q');
  std::int64_t number = -1;
  if (q == nullptr || q->value < 0.0)
    return functionFails(m, "missing-word", "Need non-negative Q-word to specify tool number with M61");
  if (!lcnInteger(q->value, number)) return functionFails(*q, "integer", "Non integer value for integer");
  if (!knowsTool(static_cast<int>(number))) return unknownTool(*q);
  if (c_.state.compOn())
    return functionFails(m, "comp", "Cannot change tools with cutter radius compensation on");
  return lcnTakeStanding(c_) && sendToolChange(c_, static_cast<int>(number), 0);
}

bool LinuxCncLanguage::unknownTool(const Word& w) {
  return functionFails(w, "tool",
                       fmt::format("Requested tool {} not found in the tool table", lcnNumber(w.value)));
}

bool LinuxCncLanguage::knowsTool(int tool) const {
  return tool == 0 || !machine_.has_tools || tools_.contains(tool);
}

/// M19 R P: the spindle stands at an angle.
bool LinuxCncLanguage::orient(const Word& m) {
  const Word* const r = functionWord('R');
  const Word* const p = functionWord('P');
  const Word* const q = functionWord('Q');
  const double angle = r == nullptr ? 0.0 : r->value;
  if (!(angle >= 0.0 && angle <= 360.0))
    return functionFails(m, "orient", "R value must be within 0..360 with M19");
  const double way = p == nullptr ? 0.0 : p->value;
  if (way != 0.0 && way != 1.0 && way != 2.0)
    return functionFails(m, "orient", "P value must be 0,1,or 2 with M19");
  if (q != nullptr && !(q->value > 0.0)) return functionFails(m, "orient", "Q value must be > 0 with M19");
  return closeMainLoop(c_, true) &&
         sendEvent(c_, event::Function{fmt::format("M19 R{}", lcnNumber(angle)), {}});
}

/// M100 to M199 run programs of the machine, which the simulation never does.
bool LinuxCncLanguage::userFunction(const Word& m) {
  const auto number = static_cast<int>(m.value);
  const Word* const p = functionWord('P');
  const Word* const q = functionWord('Q');
  std::string code = fmt::format("M{}", number);
  if (p != nullptr) code += " P" + lcnNumber(p->value);
  if (q != nullptr) code += " Q" + lcnNumber(q->value);
  c_.warnOnce(fmt::format("user M{}", number), "m-function",
              fmt::format("M{} runs a program of the machine: it has no effect in the simulation", number),
              m.columns);
  return sendEvent(c_, event::Function{code, {}});
}

}  // namespace proveout::nc
