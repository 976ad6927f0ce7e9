// Blocks of the WL4 control: cycles, calls, jumps, ends.
#include "core/nc/wl4/wl4_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/nc/wl4/wl4_codes.h"
#include "core/nc/wl4/wl4_functions.h"
#include "core/nc/wl4/wl4_motion.h"
#include "core/nc/wl4/wl4_plan.h"

namespace proveout::nc {

namespace {

constexpr std::size_t kMostNested = 5;  ///< subprograms below the main program
constexpr std::size_t kLongestBlock = 80;

}  // namespace

Wl4Control::Wl4Control(bool lathe, const ProgramSource& source, const ControlSettings& settings,
                       MotionSink& sink, Progress* progress, const ControlHost& host)
    : c_(lathe, source, settings, sink, progress, host),
      loop_(*this, c_.levels, c_.summary, c_.setup.settings) {}

InterpretSummary Wl4Control::run() {
  c_.summary.end = ProgramEnd::kAlarm;
  if (start()) {
    const Result<const Wl4Program*> main = c_.programs.main();
    if (!main) {
      c_.report.fail("wl4-program", main.error().message);
    } else if (loop_.openMain(Wl4Level(**main))) {
      loop_.run();
    }
  }
  c_.emitter.time().flush();
  return c_.summary;
}

bool Wl4Control::start() {
  Wl4Setup& setup = c_.setup;
  const ControlSettings& settings = setup.settings;
  if (const Status known = setup.parameters.set(settings.parameters, setup.lathe); !known.ok()) {
    return c_.report.fail("wl4-parameter", known.error().message);
  }
  if (!(settings.rapid_mm_min.minCoeff() > 0.0) || !settings.start.allFinite()) {
    return c_.report.fail("wl4-settings", "rapid rates must be above 0 and the start position finite");
  }
  if (const std::string bad = checkAxes(settings); !bad.empty()) return c_.report.fail("wl4-settings", bad);
  c_.emitter.time().configure(accelerationLimits(setup.axes, settings.bell_time_s), setup.axes.count());
  for (const auto& [number, tool] : setup.parameters.tools()) {
    if (tool.at_center) c_.emitter.countFromNose(number);
  }
  c_.machine = c_.emitter.machine();
  c_.state.plane = setup.lathe ? 18 : 17;
  return true;
}

bool Wl4Control::opens() {
  if (c_.watch.workOver(flowPlace(c_.levels))) return false;  // the program may be empty
  c_.variables.open();
  c_.recorder.openCall();
  return true;
}

bool Wl4Control::opened() {
  const Wl4Program& program = *c_.levels.back().program;
  return program.label_count <= Wl4Programs::kMostLabels ||
         c_.report.fail("wl4-labels", fmt::format("{} labels in a program: at most {} are allowed",
                                                  program.label_count, Wl4Programs::kMostLabels));
}

void Wl4Control::closed(const Wl4Level& /*left*/) {
  c_.recorder.closeCall();
  c_.variables.close();
  c_.block = interrupted_.back().block;
  c_.origins.beginBlock(c_.block.text);
}

Go Wl4Control::endOfText() {
  Wl4Level& level = c_.levels.back();
  if (level.end > level.first) level.block = level.end - 1;
  if (c_.levels.size() > 1) {
    c_.report.warnOnce("no M99 " + level.program->name, "wl4-no-m99",
                       "the subprogram ends without M99: taken as M99");
    return Go::kReturn;
  }
  c_.report.warn("wl4-no-end", "the program ends without M2 or M30: is the file cut short?");
  return loop_.finish("end of text", ProgramEnd::kEndOfProgram);
}

Reading Wl4Control::read() {
  Wl4Level& level = c_.levels.back();
  const std::string_view line = level.program->line(level.block);
  const std::size_t first = behindBlanks(line, 0);
  if (line.substr(first, 1) == "/" && !c_.setup.parameters.conditional) return Reading::kSkipped;
  warnOfLength(line);
  c_.variables.mark();
  c_.origins.beginBlock(line);
  const bool good = c_.reader.read(line, c_.block);
  level.number = c_.block.number;
  if (!good) return Reading::kBad;
  return c_.block.empty() ? Reading::kEmpty : Reading::kBlock;
}

void Wl4Control::warnOfLength(std::string_view line) {
  // The text is UTF-8: bytes that go on with a character are none.
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const auto length = static_cast<std::size_t>(std::count_if(line.begin(), line.end(), begins));
  if (length <= kLongestBlock) return;
  c_.report.warnOnce("long", "wl4-long-block",
                     fmt::format("the block has {} characters: the control takes {}", length, kLongestBlock));
}

bool Wl4Control::workOver() {
  const FlowPlace at = flowPlace(c_.levels);
  return c_.watch.workOver(at) ||
         c_.watch.goesRound(at, c_.variables.fingerprint(),
                            {LoopWatch::bytesOf(c_.state), LoopWatch::bytesOf(c_.machine)}) ||
         c_.watch.goesOn(at);
}

void Wl4Control::refuse() {
  c_.variables.takeBack();
  c_.report.fail("wl4-syntax", c_.reader.error().message, c_.reader.error().columns);
}

void Wl4Control::warnOfOrder() {
  if (c_.evaluator.mixedPower()) {
    c_.report.warnOnce("power", "wl4-power",
                       "** beside * / MOD without parentheses: they go from left to right");
  }
  if (c_.evaluator.mixedClasses()) {
    c_.report.warnOnce(
        "classes", "wl4-order",
        "operators of several kinds without parentheses: taken here are + and - first, then "
        "comparisons, then AND, OR and XOR; the manual names no order among them but from left "
        "to right, which gives another value: put parentheses");
  }
}

/// `N010 M0 N10 .text`: a program reports an error by stopping for ever.
bool Wl4Control::isOwnError(std::size_t here) const {
  if (!c_.block.jump) return false;
  const auto& labels = c_.levels.back().program->labels;
  const auto target = labels.find(*c_.block.jump);
  if (target == labels.end() || target->second != here) return false;
  return std::any_of(c_.block.m.begin(), c_.block.m.end(), [](const auto& m) { return m.number == 0; });
}

Go Wl4Control::carryOut() {
  warnOfOrder();
  if (isOwnError(c_.levels.back().block)) {
    const std::string text(c_.block.comment.empty() ? std::string_view("the program stops itself")
                                                    : c_.block.comment);
    c_.report.fail(fmt::format("wl4-err-N{}", c_.block.number), text);
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  Wl4BlockPlan p;
  if (!goToToolChange(c_) || !planBlock(c_, p)) {
    c_.variables.takeBack();
    return loop_.failed();
  }
  c_.origins.recordWords(p);
  if (!performFunctions(c_, p, Wl4Phase::kStart) || !perform(p)) return loop_.failed();
  commit(p);
  return goOn(p, Part::kMotion);
}

/// The block from behind `done` on: its cycle, its functions and subprograms, its end or jump.
Go Wl4Control::goOn(Wl4BlockPlan& p, Part done) {
  if (done == Part::kMotion) {
    if (const Go go = cycles(p); go != Go::kOn) return go;
    done = Part::kCycle;
  }
  if (done == Part::kCycle) {
    if (!performFunctions(c_, p, Wl4Phase::kEnd)) return loop_.failed();
    const Go go = c_.block.has('L') ? subprograms() : Go::kOn;
    if (go == Go::kCalls) interrupted_.push_back({c_.block, p, Part::kSubprograms, {}});
    if (go != Go::kOn) return go;
  }
  loop_.blockDone();
  return flow();
}

Go Wl4Control::resume() {
  Interrupted block = std::move(interrupted_.back());
  interrupted_.pop_back();
  if (block.done == Part::kCycle) {
    if (block.fixed_cycle) {
      c_.recorder.put(OriginKind::kCycle, *block.fixed_cycle);
    } else {
      in_cycle_ = false;
    }
  }
  return goOn(block.plan, block.done);
}

/// The deed of the block, or its motion.
bool Wl4Control::perform(Wl4BlockPlan& p) {
  if (p.deed == nullptr) return !p.moves || performMotion(c_, p);
  return p.deed->perform == nullptr || p.deed->perform(c_, p);
}

/// The plan's state is that of the run; what functions of the block have set stays.
void Wl4Control::commit(Wl4BlockPlan& p) {
  p.next.spindle = c_.state.spindle;
  p.next.coolant = c_.state.coolant;
  p.next.gear = c_.state.gear;
  p.next.tool = c_.state.tool;
  c_.state = p.next;
}

/// The program of the deed, or of the fixed cycle in force behind a motion.
Go Wl4Control::cycles(const Wl4BlockPlan& p) {
  if (p.deed != nullptr) {
    if (p.deed->program.empty() || p.contour) return Go::kOn;
    c_.state.open_cycle = p.deed->code;
    const OriginRecorder::Slot fixed_cycle = c_.recorder.slot(OriginKind::kCycle);
    c_.origins.recordOpenCycle(p);
    const Go go = call(std::string(p.deed->program), 1);
    if (go == Go::kCalls) interrupted_.push_back({c_.block, p, Part::kCycle, fixed_cycle});
    if (go == Go::kOn) c_.recorder.put(OriginKind::kCycle, fixed_cycle);
    return go;
  }
  if (c_.state.cycle == 80 || in_cycle_ || !p.named.any()) return Go::kOn;
  c_.origins.recordFixedCycle();
  const Go go = call(std::string(wl4GCode(c_.state.cycle)->program), 1);
  in_cycle_ = go == Go::kCalls;
  if (in_cycle_) interrupted_.push_back({c_.block, p, Part::kCycle, {}});
  return go;
}

/// Ends, returns and jumps of the block.
Go Wl4Control::flow() {
  for (const Wl4Block::Code& m : c_.block.m) {
    const Wl4Flow flow = wl4MCode(m.number).flow;
    if (flow == Wl4Flow::kOn) continue;
    if (flow == Wl4Flow::kReturn) {
      if (c_.levels.size() > 1) return Go::kReturn;
      c_.report.warn("wl4-main-m99", "M99 in the main program: taken as its end", {}, Severity::kNote);
    }
    return loop_.finish(fmt::format("M{}", m.number), ProgramEnd::kEndOfProgram);
  }
  return c_.block.jump ? jump(*c_.block.jump) : Go::kOn;
}

void Wl4Control::recover() {
  c_.pipe.clear();
  c_.machine = c_.emitter.machine();
}

bool Wl4Control::flush(ProgramEnd /*end*/) { return c_.pipe.flush(FlushReason::kEnd); }

void Wl4Control::sendEnd(const std::string& code) {
  c_.emitter.event(event::End{code}, 0.0, c_.report.here());
}

void Wl4Control::tell(const char* what, const std::string& message) {
  c_.report.fail(fmt::format("wl4-{}", what), message);
}

Go Wl4Control::subprograms() {
  // By digits: two for the program, the rest are repetitions; the value has lost leading zeros.
  const Columns at = c_.block.at('L');
  const std::string_view text = c_.block.text.substr(static_cast<std::size_t>(at.begin),
                                                     static_cast<std::size_t>(at.end - at.begin) - 1);
  std::string digits(text);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) {
    const int value = static_cast<int>(c_.block.value('L'));
    digits = value < 100 ? fmt::format("{:02}", value) : fmt::format("{:04}", value);
  }
  if (digits.size() == 1) digits.insert(0, "0");
  const std::string name = digits.substr(0, 2);
  const int times = digits.size() > 2 ? std::atoi(digits.c_str() + 2) : 1;
  if (times == 0) {
    c_.report.warn(
        "wl4-no-repetition",
        fmt::format("L{} calls program {} no time: the digits behind the first two are repetitions", digits,
                    name),
        c_.block.at('L'));
  }
  return call(name, times);
}

/// Behind an error here the block goes on.
Go Wl4Control::call(const std::string& name, int times) {
  if (c_.levels.size() > kMostNested) {
    c_.report.fail("wl4-nesting",
                   fmt::format("program {} is the sixth level of calls: five are allowed", name));
    return loop_.failed(Go::kOn);
  }
  const Result<const Wl4Program*> program = c_.programs.find(name);
  if (!program) {
    c_.report.fail("wl4-program", program.error().message);
    return loop_.failed(Go::kOn);
  }
  return loop_.call(Wl4Level(**program), times);
}

Go Wl4Control::jump(std::int64_t label) {
  const auto& labels = c_.levels.back().program->labels;
  const auto target = labels.find(label);
  if (target == labels.end()) {
    c_.report.fail("wl4-label", fmt::format("there is no label N0{} in this program", label),
                   c_.block.jump_columns);
    return loop_.failed();
  }
  loop_.jump(target->second);
  return Go::kOn;
}

}  // namespace proveout::nc
