#include "core/nc/wedm/wedm_control.h"

#include <fmt/core.h>

namespace proveout::nc {

namespace {

constexpr std::size_t kMostNestedCalls = 9;

}  // namespace

WedmControl::WedmControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                         Progress* progress)
    : c_(source, settings, sink, progress), loop_(*this, c_.levels, c_.summary, c_.settings) {}

InterpretSummary WedmControl::run() {
  c_.summary.end = ProgramEnd::kAlarm;
  if (start() && loop_.openMain(programFrom(0))) loop_.run();
  return c_.summary;
}

bool WedmControl::start() {
  if (const Status good = c_.parameters.set(c_.settings.parameters); !good.ok())
    return c_.report.fail("wedm-parameter", good.error().message);
  if (!(c_.settings.rapid_mm_min.minCoeff() > 0.0))
    return c_.report.fail("wedm-settings", "rapid rates must be above 0");
  if (const Status loaded = c_.program.load(c_.source, c_.settings.encoding, c_.sink); !loaded.ok())
    return c_.report.fail("wedm-program", loaded.error().message);
  c_.variables.start(c_.parameters.offsets());
  for (std::size_t k = 0; k < c_.state.origin.size(); ++k)
    c_.state.origin[k] = (c_.settings.work_offsets[k] - c_.settings.work_offsets[0]).head<2>();
  if (c_.settings.units == LengthUnit::kInch) c_.state.units = 20;
  return true;
}

FlowFrame WedmControl::programFrom(std::size_t block) const {
  FlowFrame frame;
  frame.first = block;
  frame.end = c_.program.count();
  return frame;
}

bool WedmControl::opens() {
  c_.recorder.openCall();
  return true;
}

bool WedmControl::opened() {
  c_.recorder.enter(0, static_cast<std::uint16_t>(c_.levels.size() - 1), true);
  return true;
}

void WedmControl::closed(const FlowFrame& /*left*/) {
  c_.recorder.enter(0, static_cast<std::uint16_t>(c_.levels.size() - 1), true);
  c_.recorder.closeCall();
}

Go WedmControl::endOfText() {
  c_.levels.back().block = c_.program.count() - 1;
  if (c_.levels.size() > 1) {
    c_.report.fail("wedm-8.4-M99", "the subprogram ends without M99");
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.report.warn("wedm-8.2-M02", "the program ends without M02: is the file cut short?");
  return loop_.finish("end of text", ProgramEnd::kEndOfProgram);
}

bool WedmControl::workOver() {
  FlowPlace at = flowPlace(c_.levels);
  at.line = line();
  return c_.watch.workOver(at) || c_.watch.goesOn(at, c_.chain.kept());
}

std::size_t WedmControl::line() const { return c_.program.place(c_.levels.back().block).line; }

Reading WedmControl::read() {
  FlowFrame& level = c_.levels.back();
  const WedmProgram::Place& place = c_.program.place(level.block);
  c_.recorder.begin(place.line + 1, -1);
  const bool good = c_.reader.read(c_.program.line(level.block), place.begin, place.end, c_.block);
  level.number = c_.block.number;
  if (c_.block.skip && c_.state.skip == 11) return Reading::kSkipped;
  if (!good) return Reading::kBad;
  return c_.block.empty() ? Reading::kEmpty : Reading::kBlock;
}

/// The words of the block in hand are recorded from here on.
void WedmControl::beginWords() {
  c_.recorder.begin(static_cast<std::uint32_t>(line() + 1), c_.block.number);
  c_.recorder.clear(KindSet::of(OriginKind::kI, OriginKind::kJ));
}

void WedmControl::refuse() {
  beginWords();
  c_.report.fail("wedm-syntax", c_.reader.error().message, c_.reader.error().columns);
}

Go WedmControl::carryOut() {
  beginWords();
  if (!c_.program.place(c_.levels.back().block).closed)
    c_.report.warnOnce("wedm-2.1-block", "a block without ';' at its end: the line ends it");
  WedmPlan p(c_.state);
  c_.variables.mark();
  if (!planWedmBlock(c_, p)) {
    c_.variables.takeBack();
    return loop_.failed();
  }
  if (!perform(p)) {
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.state = p.next;
  return flow(p);
}

/// Motion first, then what the machine is sent. False: the contour cannot be run, reported.
bool WedmControl::perform(WedmPlan& p) {
  const SourceRef here = c_.report.here();
  if (p.next.condition != c_.state.condition)
    c_.chain.event(event::Function{fmt::format("C{:03}", p.next.condition), {}}, 0.0, here);
  for (const WedmFunction* f : p.functions) {
    if (f->address == 'T')
      c_.chain.event(event::Coolant{fmt::format("T{}", f->code), f->value != 0}, 0.0, here);
  }
  if (p.sets_point && c_.state.offset != 40) c_.chain.interruptOffset();
  if (p.motion) {
    p.motion->pace.source = here;
    if (!c_.chain.add(std::move(*p.motion))) return false;
  }
  if (p.dwell_s) c_.chain.event(event::Dwell{*p.dwell_s}, *p.dwell_s, here);
  for (const int code : {50, 60}) {
    if (p.has('M', code)) c_.chain.event(event::Wire{fmt::format("M{}", code), code == 60}, 0.0, here);
  }
  if (p.has('M', 60)) p.next.by_hand = 0;
  if (p.has('M', 0)) c_.chain.event(event::Stop{"M00", ""}, 0.0, here);
  return true;
}

/// Behind an error here the block counts as done.
Go WedmControl::flow(const WedmPlan& p) {
  if (p.has('M', 2)) {
    if (closedBehindEnd()) return loop_.finish("M02", ProgramEnd::kEndOfProgram);
    c_.chain.flush();
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  if (p.has('M', 99)) {
    if (c_.levels.size() > 1) return Go::kReturn;
    c_.report.fail("wedm-8.4-M99", "M99 stands at the end of a subprogram: the main program ends with M02");
    return loop_.failed(Go::kOn);
  }
  return p.call ? call(*p.call) : Go::kOn;
}

/// Whether the comments behind M02 are closed, in subprograms that nobody has called as well. False:
/// reported.
bool WedmControl::closedBehindEnd() {
  const auto open =
      commentOpenInLine(c_.program.text().lines(), c_.program.place(c_.levels.back().block).line);
  if (!open) return true;
  while (c_.program.place(c_.levels.back().block).line < open->line) ++c_.levels.back().block;
  return c_.report.fail("wedm-syntax", "the comment is not closed: ')' is missing", open->columns);
}

Go WedmControl::call(const WedmCall& call) {
  if (c_.levels.size() > kMostNestedCalls) {
    c_.report.fail("wedm-10-nest", "subprograms are nested 9 deep at most: this call would be the tenth");
    return loop_.failed(Go::kOn);
  }
  const auto first = c_.program.subprogram(call.label);
  if (!first) {
    c_.report.fail("wedm-10-P",
                   fmt::format("there is no block N{:04} behind the M02 of the main program: write the "
                               "subprogram there, with M99 at its end",
                               call.label));
    return loop_.failed(Go::kOn);
  }
  return loop_.call(programFrom(*first), call.times);
}

bool WedmControl::flush(ProgramEnd /*end*/) {
  if (c_.state.overcut_on != 0)
    c_.report.warnOnce("wedm-5.5.5-G36",
                       "the corner overcut G37 is still on: put G36 before leaving the contour");
  return c_.chain.flush();
}

void WedmControl::sendEnd(const std::string& code) {
  c_.output.event(event::End{code}, 0.0, c_.report.here());
}

void WedmControl::tell(const char* what, const std::string& message) {
  c_.report.fail(fmt::format("wedm-{}", what), message);
}

/// What was good before the error is cut.
void WedmControl::giveUp() { c_.chain.flush(); }

}  // namespace proveout::nc
