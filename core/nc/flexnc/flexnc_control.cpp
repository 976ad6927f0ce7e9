#include "core/nc/flexnc/flexnc_control.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/flexnc/cycles/flexnc_cycles.h"
#include "core/nc/flexnc/flexnc_origins.h"
#include "core/nc/flexnc/flexnc_words.h"

namespace proveout::nc {

namespace {

constexpr std::size_t kMostNested = 15;  ///< subprograms below the main program

}  // namespace

InterpretSummary FlexControl::run() {
  c_.summary.end = ProgramEnd::kAlarm;
  if (start() && loop_.openMain(programFrom(0))) loop_.run();
  c_.emitter.time().flush();
  return c_.summary;
}

bool FlexControl::start() {
  const ControlSettings& settings = c_.settings;
  if (const Status known = c_.parameters.set(settings.parameters); !known.ok())
    return c_.report.fail("fnc-parameter", known.error().message);
  if (!(settings.rapid_mm_min.minCoeff() > 0.0) || !settings.start.allFinite()) {
    return c_.report.fail("fnc-settings", "rapid rates must be above 0 and the start position finite");
  }
  if (const std::string bad = checkAxes(settings); !bad.empty()) return c_.report.fail("fnc-settings", bad);
  if (const Status loaded = c_.program.load(c_.source, settings.encoding, c_.sink); !loaded.ok())
    return c_.report.fail("fnc-program", loaded.error().message);
  c_.emitter.time().configure(accelerationLimits(c_.axes, settings.bell_time_s), c_.axes.count());
  c_.machine = c_.emitter.machine();
  recordFlexData(c_);
  return true;
}

FlowFrame FlexControl::programFrom(std::size_t line) const {
  FlowFrame frame;
  frame.first = line;
  frame.end = c_.program.count();
  return frame;
}

Go FlexControl::endOfText() {
  c_.levels.back().block = c_.program.count() - 1;
  beginFlexLine(c_);
  if (c_.levels.size() > 1) {
    c_.report.fail("fnc-ret", "the program ends inside a subprogram: RET is missing at its end");
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.report.warn("fnc-no-m02", "the program ends without M02: is the file cut short?");
  return end("end of text");
}

/// The block that ends the program may be the one to stop behind.
Go FlexControl::end(const char* code) {
  loop_.blockDone();
  return loop_.finish(code, ProgramEnd::kEndOfProgram);
}

Reading FlexControl::read() {
  FlowFrame& level = c_.levels.back();
  const std::string_view line = c_.program.line(level.block);
  c_.variables.mark();
  level.number = flexLabelOf(line);
  beginFlexLine(c_);
  if (!c_.reader.read(line, c_.block)) return Reading::kBad;
  return c_.block.empty() ? Reading::kEmpty : Reading::kBlock;
}

bool FlexControl::workOver() {
  const FlowPlace at = flowPlace(c_.levels);
  return c_.watch.workOver(at) || c_.watch.goesOn(at);
}

void FlexControl::refuse() {
  c_.variables.takeBack();
  c_.report.fail(c_.reader.error().code, c_.reader.error().message, c_.reader.error().columns);
}

Go FlexControl::carryOut() {
  if (c_.block.odd_variable.begin > 0) {
    c_.report.warnOnce("odd variable", "fnc-variable",
                       fmt::format("programs have the variables P{} to P{}: others are the control's own",
                                   FlexVariables::kFirstOfPrograms, FlexVariables::kLastOfPrograms),
                       c_.block.odd_variable);
  }
  const FlexState before = c_.state;
  FlexCursor cursor;
  const bool ends_contours = !c_.block.words.empty() && !goesOnWithContour(c_);
  if (!checkFlexWords(c_) || (ends_contours && !endFlexContours(c_)) || !performFlexWords(c_, cursor)) {
    c_.variables.takeBack();
    c_.state = before;
    return loop_.failed();
  }
  if (cursor.ends && c_.levels.size() > 1) {
    c_.report.fail("fnc-ret", "M02 inside a subprogram: RET ends it");
    return loop_.failed();
  }
  if (cursor.ends) return end("M02");
  return c_.block.jump ? jump(FlexJump(*c_.block.jump)) : Go::kOn;
}

/// Behind an error here the block counts as done.
Go FlexControl::jump(const FlexJump& jump) {
  if (jump.kind == FlexJump::Kind::kCall) return call(jump);
  if (jump.kind == FlexJump::Kind::kRepeat) return repeat(jump);
  if (c_.levels.size() > 1) return Go::kReturn;
  c_.report.fail("fnc-ret", "RET without a GOSUB: the main program ends with M02", jump.columns);
  return loop_.failed(Go::kOn);
}

/// False: there is none, or several, reported.
bool FlexControl::findLabel(const FlexJump& jump, std::size_t& line) {
  const FlexProgram::Label* const label = c_.program.label(jump.label);
  if (label == nullptr)
    return c_.report.fail("fnc-label", fmt::format("there is no label N{} in the program", jump.label),
                          jump.columns);
  if (label->count > 1) {
    return c_.report.fail(
        "fnc-label",
        fmt::format("the label N{} stands {} times: which one is meant?", jump.label, label->count),
        jump.columns);
  }
  line = label->line;
  return true;
}

Go FlexControl::call(const FlexJump& jump) {
  std::size_t line = 0;
  if (!findLabel(jump, line)) return loop_.failed(Go::kOn);
  if (c_.levels.size() > kMostNested) {
    c_.report.fail("fnc-gosub",
                   fmt::format("subprograms are nested {} deep at most: does one call itself?", kMostNested),
                   jump.columns);
    return loop_.failed(Go::kOn);
  }
  return loop_.call(programFrom(line), 1);
}

bool FlexControl::opens() {
  c_.recorder.openCall();
  return true;
}

void FlexControl::closed(const FlowFrame& /*left*/) { c_.recorder.closeCall(); }

/// What is still to be repeated; the statement's first arrival arms it.
double FlexControl::repeatsLeft(const FlexJump& jump, Repeat& repeat, bool first) {
  if (first) {
    repeat = {jump.count, jump.counter};
    if (jump.counter >= 0) c_.variables.assign(jump.counter, jump.count, 0);
  }
  return jump.counter >= 0 ? c_.variables.value(jump.counter) : repeat.left;
}

/// Where the loop of a REPEAT begins. False: it has none, or another one has its counter, reported.
bool FlexControl::findRepeat(const FlexJump& jump, std::size_t& line) {
  const std::size_t here = c_.levels.back().block;
  if (!findLabel(jump, line)) return false;
  if (line > here) {
    return c_.report.fail(
        "fnc-repeat", fmt::format("the label N{} stands below the REPEAT: it has to be above", jump.label),
        jump.columns);
  }
  for (const auto& [other, repeat] : repeats_) {
    if (other == here || jump.counter < 0 || repeat.counter != jump.counter) continue;
    return c_.report.fail("fnc-repeat",
                          fmt::format("P{} counts the REPEAT of line {} already: nested ones need counters "
                                      "of their own",
                                      jump.counter, other + 1),
                          jump.columns);
  }
  return true;
}

Go FlexControl::repeat(const FlexJump& jump) {
  const std::size_t here = c_.levels.back().block;
  std::size_t line = 0;
  if (!findRepeat(jump, line)) return loop_.failed(Go::kOn);
  const auto [place, first] = repeats_.try_emplace(here);
  const double left = repeatsLeft(jump, place->second, first);
  c_.watch.budget().asked(here, std::abs(left), left > 0.0);
  if (!(left > 0.0)) {
    repeats_.erase(place);
    return Go::kOn;
  }
  if (jump.counter >= 0) {
    c_.variables.assign(jump.counter, left - 1.0, 0);
  } else {
    place->second.left -= 1;
  }
  loop_.jump(line);
  std::uint64_t counters = 0;
  for (const auto& [other, repeat] : repeats_)
    counters += mixBits((static_cast<std::uint64_t>(other) << 32U) + static_cast<std::uint64_t>(repeat.left));
  const bool endless = c_.watch.goesRound(flowPlace(c_.levels), c_.variables.fingerprint() + counters,
                                          {LoopWatch::bytesOf(c_.state), LoopWatch::bytesOf(c_.machine)});
  return endless ? Go::kStop : Go::kOn;
}

void FlexControl::recover() {
  c_.pipe.clear();
  c_.machine = c_.emitter.machine();
  c_.cycle = {};
}

bool FlexControl::flush(ProgramEnd end) {
  if (c_.state.comp != 40 && end == ProgramEnd::kEndOfProgram) {
    c_.report.warn("fnc-comp-end",
                   "the program ends while compensation is on: its last motion ends on the programmed point; "
                   "put G40 with a motion, or G81, before M02");
  }
  return endFlexContours(c_) && c_.pipe.flush(FlushReason::kEnd);
}

void FlexControl::sendEnd(const std::string& code) {
  c_.emitter.event(event::End{code}, 0.0, c_.report.here());
}

void FlexControl::tell(const char* what, const std::string& message) {
  c_.report.fail(fmt::format("fnc-{}", what), message);
}

}  // namespace proveout::nc
