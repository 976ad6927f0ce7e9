#include "core/nc/flexnc/flexnc_control.h"

#include <fmt/core.h>

#include <cmath>

#include "core/nc/flexnc/cycles/flexnc_cycles.h"
#include "core/nc/flexnc/flexnc_origins.h"
#include "core/nc/flexnc/flexnc_watch.h"
#include "core/nc/flexnc/flexnc_words.h"
#include "core/nc/text/program_likeness.h"

namespace proveout::nc {

namespace {

constexpr std::size_t kMostNested = 15;  ///< subprograms below the main program

}  // namespace

InterpretSummary FlexControl::run() {
  c_.summary.end = ProgramEnd::kAlarm;
  if (start()) runFrom(0);
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

FlexControl::Go FlexControl::runFrom(std::size_t first) {
  c_.levels.push_back({first, -1, runs_++});
  Go go = Go::kOn;
  for (std::size_t line = first; go == Go::kOn;) {
    if (line >= c_.program.count()) {
      go = endOfText();
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

FlexControl::Go FlexControl::endOfText() {
  c_.levels.back().line = c_.program.count() - 1;
  beginFlexLine(c_);
  if (c_.levels.size() > 1) {
    c_.report.fail("fnc-ret", "the program ends inside a subprogram: RET is missing at its end");
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.report.warn("fnc-no-m02", "the program ends without M02: is the file cut short?");
  return finish("end of text", ProgramEnd::kEndOfProgram);
}

FlexControl::Go FlexControl::block(std::size_t& next_line) {
  const std::string_view line = c_.program.line(c_.levels.back().line);
  c_.variables.mark();
  c_.levels.back().number = flexLabelOf(line);
  beginFlexLine(c_);
  const bool good = c_.reader.read(line, c_.block);
  if (good && c_.block.empty()) {
    until_hit_ = until_hit_ || reachedUntil();
    return Go::kOn;
  }
  if (flexWorkOver(c_) || flexGoesOn(c_)) return Go::kStop;
  ++c_.summary.blocks;
  if (!good) {
    c_.variables.takeBack();
    c_.report.fail(c_.reader.error().code, c_.reader.error().message, c_.reader.error().columns);
    return failed();
  }
  if (c_.block.odd_variable.begin > 0) {
    c_.report.warnOnce("odd variable", "fnc-variable",
                       fmt::format("programs have the variables P{} to P{}: others are the control's own",
                                   FlexVariables::kFirstOfPrograms, FlexVariables::kLastOfPrograms),
                       c_.block.odd_variable);
  }
  return execute(next_line);
}

FlexControl::Go FlexControl::execute(std::size_t& next_line) {
  const FlexState before = c_.state;
  FlexCursor cursor;
  const bool ends_contours = !c_.block.words.empty() && !goesOnWithContour(c_);
  if (!checkFlexWords(c_) || (ends_contours && !endFlexContours(c_)) || !performFlexWords(c_, cursor)) {
    c_.variables.takeBack();
    c_.state = before;
    return failed();
  }
  const bool reached = reachedUntil();
  Go go = Go::kOn;
  if (cursor.ends && c_.levels.size() > 1) {
    c_.report.fail("fnc-ret", "M02 inside a subprogram: RET ends it");
    return failed();
  }
  if (cursor.ends) return finish("M02", ProgramEnd::kEndOfProgram);
  if (c_.block.jump) go = jump(FlexJump(*c_.block.jump), next_line);
  until_hit_ = until_hit_ || reached;
  return go;
}

FlexControl::Go FlexControl::jump(const FlexJump& jump, std::size_t& next_line) {
  if (jump.kind == FlexJump::Kind::kCall) return call(jump);
  if (jump.kind == FlexJump::Kind::kRepeat) return repeat(jump, next_line);
  if (c_.levels.size() > 1) return Go::kReturn;
  c_.report.fail("fnc-ret", "RET without a GOSUB: the main program ends with M02", jump.columns);
  return failed();
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

FlexControl::Go FlexControl::call(const FlexJump& jump) {
  std::size_t line = 0;
  if (!findLabel(jump, line)) return failed();
  if (c_.levels.size() > kMostNested) {
    c_.report.fail("fnc-gosub",
                   fmt::format("subprograms are nested {} deep at most: does one call itself?", kMostNested),
                   jump.columns);
    return failed();
  }
  c_.recorder.openCall();
  const Go go = runFrom(line);
  c_.recorder.closeCall();
  return go == Go::kReturn ? Go::kOn : go;
}

/// What is still to be repeated; the statement's first arrival arms it.
double FlexControl::repeatsLeft(const FlexJump& jump, Repeat& repeat, bool first) {
  if (first) {
    repeat = {jump.count, jump.counter};
    if (jump.counter >= 0) c_.variables.assign(jump.counter, jump.count, 0);
  }
  return jump.counter >= 0 ? c_.variables.value(jump.counter) : repeat.left;
}

FlexControl::Go FlexControl::repeat(const FlexJump& jump, std::size_t& next_line) {
  const std::size_t here = c_.levels.back().line;
  std::size_t line = 0;
  if (!findLabel(jump, line)) return failed();
  if (line > here) {
    c_.report.fail("fnc-repeat",
                   fmt::format("the label N{} stands below the REPEAT: it has to be above", jump.label),
                   jump.columns);
    return failed();
  }
  for (const auto& [other, repeat] : repeats_) {
    if (other == here || jump.counter < 0 || repeat.counter != jump.counter) continue;
    c_.report.fail("fnc-repeat",
                   fmt::format("P{} counts the REPEAT of line {} already: nested ones need counters of "
                               "their own",
                               jump.counter, other + 1),
                   jump.columns);
    return failed();
  }
  const auto [place, first] = repeats_.try_emplace(here);
  const double left = repeatsLeft(jump, place->second, first);
  c_.loop_budget.asked(here, std::abs(left), left > 0.0);
  if (!(left > 0.0)) {
    repeats_.erase(place);
    return Go::kOn;
  }
  if (jump.counter >= 0) {
    c_.variables.assign(jump.counter, left - 1.0, 0);
  } else {
    place->second.left -= 1;
  }
  next_line = line;
  std::uint64_t counters = 0;
  for (const auto& [other, repeat] : repeats_)
    counters += mixBits((static_cast<std::uint64_t>(other) << 32U) + static_cast<std::uint64_t>(repeat.left));
  return flexGoesRound(c_, counters) ? Go::kStop : Go::kOn;
}

FlexControl::Go FlexControl::finish(const char* code, ProgramEnd end) {
  c_.summary.end = ProgramEnd::kAlarm;
  if (c_.state.comp != 40 && end == ProgramEnd::kEndOfProgram) {
    c_.report.warn("fnc-comp-end",
                   "the program ends while compensation is on: its last motion ends on the programmed point; "
                   "put G40 with a motion, or G81, before M02");
  }
  if (!endFlexContours(c_) || !c_.pipe.flush(FlushReason::kEnd)) return Go::kStop;
  if (c_.settings.until && !until_hit_) {
    if (!reachedUntil()) {
      c_.report.fail("fnc-until", "the program ends here; the block to stop after was not reached");
      return Go::kStop;
    }
  }
  c_.summary.end = end;
  c_.emitter.event(event::End{code}, 0.0, c_.report.here());
  return Go::kStop;
}

FlexControl::Go FlexControl::failed() {
  if (c_.summary.end == ProgramEnd::kCancelled || c_.summary.end == ProgramEnd::kBlockLimit) return Go::kStop;
  c_.pipe.clear();
  c_.machine = c_.emitter.machine();
  c_.cycle = {};
  if (c_.summary.errors < c_.settings.max_errors && mayBeProgram(c_.program.text())) return Go::kOn;
  c_.summary.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

bool FlexControl::reachedUntil() const {
  if (!c_.settings.until || c_.levels.size() != 1) return false;
  return c_.settings.until->reachedBy(c_.levels.back().number, c_.levels.back().line);
}

}  // namespace proveout::nc
