// The run loop of the WL4 control: blocks in their order, calls, jumps.
#include "core/nc/wl4/wl4_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "core/nc/text/program_likeness.h"
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
    : c_(lathe, source, settings, sink, progress, host) {}

InterpretSummary Wl4Control::run() {
  c_.summary.end = ProgramEnd::kAlarm;
  if (start()) {
    const Result<const Wl4Program*> main = c_.programs.main();
    if (!main) {
      c_.report.fail("wl4-program", main.error().message);
    } else {
      runProgram(**main, {});
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

Wl4Control::Go Wl4Control::runProgram(const Wl4Program& program, const Wl4Level::Call& call) {
  c_.levels.push_back({&program, program.first, -1, runs_++, call});
  if (program.label_count > Wl4Programs::kMostLabels) {
    c_.report.fail("wl4-labels", fmt::format("{} labels in a program: at most {} are allowed",
                                             program.label_count, Wl4Programs::kMostLabels));
    return Go::kStop;
  }
  Go go = Go::kOn;
  for (std::size_t line = program.first; go == Go::kOn;) {
    if (line >= program.last) {
      go = endOfText(program);
      break;
    }
    c_.levels.back().line = line++;
    c_.levels.back().number = -1;
    go = block(line);
    if (go == Go::kOn && until_hit_ && c_.levels.size() == 1) go = finish("until", ProgramEnd::kUntil);
  }
  c_.levels.pop_back();
  return go;
}

Wl4Control::Go Wl4Control::endOfText(const Wl4Program& program) {
  if (program.last > program.first) c_.levels.back().line = program.last - 1;
  if (c_.levels.size() > 1) {
    c_.report.warnOnce("no M99 " + program.name, "wl4-no-m99",
                       "the subprogram ends without M99: taken as M99");
    return Go::kReturn;
  }
  c_.report.warn("wl4-no-end", "the program ends without M2 or M30: is the file cut short?");
  return finish("end of text", ProgramEnd::kEndOfProgram);
}

Wl4Control::Go Wl4Control::block(std::size_t& next_line) {
  const std::string_view line = c_.levels.back().program->line(c_.levels.back().line);
  const std::size_t first = behindBlanks(line, 0);
  if (line.substr(first, 1) == "/" && !c_.setup.parameters.conditional) return Go::kOn;
  // The text is UTF-8: bytes that go on with a character are none.
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const auto length = static_cast<std::size_t>(std::count_if(line.begin(), line.end(), begins));
  if (length > kLongestBlock) {
    c_.report.warnOnce(
        "long", "wl4-long-block",
        fmt::format("the block has {} characters: the control takes {}", length, kLongestBlock));
  }
  c_.variables.mark();
  c_.origins.beginBlock(line);
  const bool good = c_.reader.read(line, c_.block);
  c_.levels.back().number = c_.block.number;
  if (good && c_.block.empty()) {
    until_hit_ = until_hit_ || reachedUntil();
    return Go::kOn;
  }
  if (c_.watch.workOver() || endless()) return Go::kStop;
  ++c_.summary.blocks;
  if (!good) {
    c_.variables.takeBack();
    c_.report.fail("wl4-syntax", c_.reader.error().message, c_.reader.error().columns);
    return failed();
  }
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
  if (isOwnError(c_.levels.back().line)) {
    const std::string text(c_.block.comment.empty() ? std::string_view("the program stops itself")
                                                    : c_.block.comment);
    c_.report.fail(fmt::format("wl4-err-N{}", c_.block.number), text);
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  return execute(next_line);
}

/// Whether the program is in a loop without an end: reported then.
bool Wl4Control::endless() {
  return c_.watch.goesRound(c_.variables.fingerprint(),
                            {LoopWatch::bytesOf(c_.state), LoopWatch::bytesOf(c_.machine)}) ||
         c_.watch.goesOn();
}

/// `N010 M0 N10 .text`: a program reports an error by stopping for ever.
bool Wl4Control::isOwnError(std::size_t here) const {
  if (!c_.block.jump) return false;
  const auto& labels = c_.levels.back().program->labels;
  const auto target = labels.find(*c_.block.jump);
  if (target == labels.end() || target->second != here) return false;
  return std::any_of(c_.block.m.begin(), c_.block.m.end(), [](const auto& m) { return m.number == 0; });
}

Wl4Control::Go Wl4Control::execute(std::size_t& next_line) {
  Wl4BlockPlan p;
  if (!goToToolChange(c_) || !planBlock(c_, p)) {
    c_.variables.takeBack();
    return failed();
  }
  const bool reached = reachedUntil();
  c_.origins.recordWords(p);
  if (!performFunctions(c_, p, Wl4Phase::kStart) || !carryOut(p)) return failed();
  commit(p);
  Go go = cycles(p);
  if (go != Go::kOn) return go;
  if (!performFunctions(c_, p, Wl4Phase::kEnd)) return failed();
  if (c_.block.has('L')) go = subprograms();
  if (go != Go::kOn) return go;
  until_hit_ = until_hit_ || reached;
  return flow(next_line);
}

/// The deed of the block, or its motion.
bool Wl4Control::carryOut(Wl4BlockPlan& p) {
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
Wl4Control::Go Wl4Control::cycles(const Wl4BlockPlan& p) {
  if (p.deed != nullptr) {
    if (p.deed->program.empty() || p.contour) return Go::kOn;
    c_.state.open_cycle = p.deed->code;
    const OriginRecorder::Slot fixed_cycle = c_.recorder.slot(OriginKind::kCycle);
    c_.origins.recordOpenCycle(p);
    const Go go = call(std::string(p.deed->program), 1);
    c_.recorder.put(OriginKind::kCycle, fixed_cycle);
    return go;
  }
  if (c_.state.cycle == 80 || in_cycle_ || !p.named.any()) return Go::kOn;
  in_cycle_ = true;
  c_.origins.recordFixedCycle();
  const Go go = call(std::string(wl4GCode(c_.state.cycle)->program), 1);
  in_cycle_ = false;
  return go;
}

/// Ends, returns and jumps of the block.
Wl4Control::Go Wl4Control::flow(std::size_t& next_line) {
  for (const Wl4Block::Code& m : c_.block.m) {
    const Wl4Flow flow = wl4MCode(m.number).flow;
    if (flow == Wl4Flow::kOn) continue;
    if (flow == Wl4Flow::kReturn) {
      if (c_.levels.size() > 1) return Go::kReturn;
      c_.report.warn("wl4-main-m99", "M99 in the main program: taken as its end", {}, Severity::kNote);
    }
    return finish(fmt::format("M{}", m.number), ProgramEnd::kEndOfProgram);
  }
  return c_.block.jump ? jump(*c_.block.jump, next_line) : Go::kOn;
}

Wl4Control::Go Wl4Control::failed() {
  if (c_.summary.end == ProgramEnd::kCancelled || c_.summary.end == ProgramEnd::kBlockLimit) return Go::kStop;
  c_.pipe.clear();
  c_.machine = c_.emitter.machine();
  const bool told_whole = !c_.levels.empty() && !mayBeProgram(*c_.levels.back().program->text);
  if (c_.summary.errors < c_.setup.settings.max_errors && !told_whole) return Go::kOn;
  c_.summary.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

Wl4Control::Go Wl4Control::finish(const std::string& code, ProgramEnd end) {
  if (!c_.pipe.flush(FlushReason::kEnd)) {
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  if (c_.setup.settings.until && !until_hit_) {
    c_.report.fail("wl4-until", "the program ends here; the block to stop after was not reached");
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.summary.end = end;
  c_.emitter.event(event::End{code}, 0.0, c_.report.here());
  return Go::kStop;
}

bool Wl4Control::reachedUntil() const {
  if (!c_.setup.settings.until || c_.levels.size() != 1) return false;
  return c_.setup.settings.until->reachedBy(c_.levels.back().number, c_.levels.back().line);
}

Wl4Control::Go Wl4Control::subprograms() {
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

Wl4Control::Go Wl4Control::call(const std::string& name, int times) {
  if (c_.levels.size() > kMostNested) {
    c_.report.fail("wl4-nesting",
                   fmt::format("program {} is the sixth level of calls: five are allowed", name));
    return failed();
  }
  const Result<const Wl4Program*> program = c_.programs.find(name);
  if (!program) {
    c_.report.fail("wl4-program", program.error().message);
    return failed();
  }
  const Wl4Block caller = c_.block;  // the program reads its own
  const std::uint64_t number = ++calls_;
  for (int k = 0; k < times; ++k) {
    if (c_.watch.workOver()) return Go::kStop;  // the program may be empty
    c_.variables.open();
    c_.recorder.openCall();
    const Go go = runProgram(**program, {number, k, times});
    c_.recorder.closeCall();
    c_.variables.close();
    if (go == Go::kStop) return go;
    c_.block = caller;
    c_.origins.beginBlock(c_.block.text);
  }
  return Go::kOn;
}

Wl4Control::Go Wl4Control::jump(std::int64_t label, std::size_t& next_line) {
  const auto& labels = c_.levels.back().program->labels;
  const auto target = labels.find(label);
  if (target == labels.end()) {
    c_.report.fail("wl4-label", fmt::format("there is no label N0{} in this program", label),
                   c_.block.jump_columns);
    return failed();
  }
  next_line = target->second;
  return Go::kOn;
}

}  // namespace proveout::nc
