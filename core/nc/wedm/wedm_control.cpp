#include "core/nc/wedm/wedm_control.h"

#include <fmt/core.h>

#include "core/nc/text/program_likeness.h"

namespace proveout::nc {

namespace {

constexpr std::size_t kMostNestedCalls = 9;

/// What a loop may change: the points of the wire, and variables.
std::vector<LoopBudget::Named> loopState(const WedmContext& c) {
  std::vector<LoopBudget::Named> state;
  for (int h = 0; h < kWedmOffsets; ++h) {
    if (c.variables.assigned(h)) state.push_back({fmt::format("H{}", h), c.variables.value(h)});
  }
  state.push_back({"X", c.state.main.x()});
  state.push_back({"Y", c.state.main.y()});
  state.push_back({"U", c.state.uv.x()});
  state.push_back({"V", c.state.uv.y()});
  return state;
}

}  // namespace

WedmControl::WedmControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                         Progress* progress)
    : c_(source, settings, sink, progress), loops_(settings.block_limit, [this] { return loopState(c_); }) {}

InterpretSummary WedmControl::run() {
  c_.summary.end = ProgramEnd::kAlarm;
  if (start()) runFrom(0);
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

WedmControl::Go WedmControl::runFrom(std::size_t first, const WedmLevel::Call& call) {
  c_.levels.push_back({first, -1, call});
  c_.recorder.enter(0, static_cast<std::uint16_t>(c_.levels.size() - 1), true);
  Go go = Go::kOn;
  for (std::size_t k = first; go == Go::kOn; ++k) {
    if (k >= c_.program.count()) {
      go = endOfText();
      break;
    }
    go = block(k);
    if (go == Go::kOn && until_hit_ && c_.levels.size() == 1) go = finish("until", ProgramEnd::kUntil);
  }
  c_.levels.pop_back();
  if (!c_.levels.empty()) c_.recorder.enter(0, static_cast<std::uint16_t>(c_.levels.size() - 1), true);
  return go;
}

WedmControl::Go WedmControl::endOfText() {
  c_.levels.back().block = c_.program.count() - 1;
  if (c_.levels.size() > 1) {
    c_.report.fail("wedm-8.4-M99", "the subprogram ends without M99");
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.report.warn("wedm-8.2-M02", "the program ends without M02: is the file cut short?");
  return finish("end of text", ProgramEnd::kEndOfProgram);
}

bool WedmControl::workOver() {
  const double done = static_cast<double>(c_.levels.front().block) / static_cast<double>(c_.program.count());
  const std::size_t line = c_.program.place(c_.levels.back().block).line;
  const BlockWatch::Over over = c_.watch.count({done, c_.levels.size(), line});
  if (over == BlockWatch::Over::kLimit) c_.report.fail("wedm-block-limit", c_.watch.message());
  return over != BlockWatch::Over::kNo;
}

/// Whether calls are repeated without an end in sight: reported then.
bool WedmControl::goesOn() {
  const WedmLevel& level = c_.levels.back();
  const std::size_t line = c_.program.place(level.block).line;
  const bool over = loops_.arrives(
      {c_.levels.size(), level.block, line, level.call.number, level.call.repetition, level.call.repetitions},
      {static_cast<double>(c_.summary.blocks),
       static_cast<double>(c_.summary.motions) + static_cast<double>(c_.chain.kept())});
  if (!over) return false;
  c_.report.fail("wedm-endless-loop", loops_.message());
  c_.summary.end = ProgramEnd::kBlockLimit;
  return true;
}

WedmControl::Go WedmControl::block(std::size_t index) {
  WedmLevel& level = c_.levels.back();
  level.block = index;
  level.number = -1;
  const WedmProgram::Place& place = c_.program.place(index);
  c_.recorder.begin(place.line + 1, -1);
  const bool good = c_.reader.read(c_.program.line(index), place.begin, place.end, c_.block);
  level.number = c_.block.number;
  // Blocks that do nothing count: loops of them must have an end.
  if (workOver() || goesOn()) return Go::kStop;
  if (c_.block.skip && c_.state.skip == 11) return Go::kOn;
  if (good && c_.block.empty()) {
    until_hit_ = until_hit_ || reachedUntil();
    return Go::kOn;
  }
  ++c_.summary.blocks;
  c_.recorder.begin(place.line + 1, c_.block.number);
  c_.recorder.clear(KindSet::of(OriginKind::kI, OriginKind::kJ));
  if (!good) {
    c_.report.fail("wedm-syntax", c_.reader.error().message, c_.reader.error().columns);
    return failed();
  }
  if (!place.closed) c_.report.warnOnce("wedm-2.1-block", "a block without ';' at its end: the line ends it");
  return execute();
}

WedmControl::Go WedmControl::execute() {
  WedmPlan p(c_.state);
  c_.variables.mark();
  if (!planWedmBlock(c_, p)) {
    c_.variables.takeBack();
    return failed();
  }
  const bool reached = reachedUntil();
  if (!perform(p)) {
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  c_.state = p.next;
  const Go go = flow(p);
  until_hit_ = until_hit_ || reached;
  return go;
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

WedmControl::Go WedmControl::flow(const WedmPlan& p) {
  if (p.has('M', 2)) {
    if (closedBehindEnd()) return finish("M02", ProgramEnd::kEndOfProgram);
    c_.chain.flush();
    c_.summary.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  if (p.has('M', 99)) {
    if (c_.levels.size() > 1) return Go::kReturn;
    c_.report.fail("wedm-8.4-M99", "M99 stands at the end of a subprogram: the main program ends with M02");
    return failed();
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

WedmControl::Go WedmControl::call(const WedmCall& call) {
  if (c_.levels.size() > kMostNestedCalls) {
    c_.report.fail("wedm-10-nest", "subprograms are nested 9 deep at most: this call would be the tenth");
    return failed();
  }
  const auto first = c_.program.subprogram(call.label);
  if (!first) {
    c_.report.fail("wedm-10-P",
                   fmt::format("there is no block N{:04} behind the M02 of the main program: write the "
                               "subprogram there, with M99 at its end",
                               call.label));
    return failed();
  }
  const std::uint64_t number = ++calls_;
  for (int k = 0; k < call.times; ++k) {
    c_.recorder.openCall();
    const Go go = runFrom(*first, {number, k, call.times});
    c_.recorder.closeCall();
    if (go == Go::kStop) return go;
  }
  return Go::kOn;
}

WedmControl::Go WedmControl::finish(const char* code, ProgramEnd end) {
  c_.summary.end = ProgramEnd::kAlarm;
  if (c_.state.overcut_on != 0)
    c_.report.warnOnce("wedm-5.5.5-G36",
                       "the corner overcut G37 is still on: put G36 before leaving the contour");
  if (!c_.chain.flush()) return Go::kStop;
  if (c_.settings.until && !until_hit_) {
    c_.report.fail("wedm-until", "the program ends here; the block to stop after was not reached");
    return Go::kStop;
  }
  c_.summary.end = end;
  c_.output.event(event::End{code}, 0.0, c_.report.here());
  return Go::kStop;
}

WedmControl::Go WedmControl::failed() {
  if (c_.summary.end == ProgramEnd::kCancelled || c_.summary.end == ProgramEnd::kBlockLimit) return Go::kStop;
  if (c_.summary.errors < c_.settings.max_errors && mayBeProgram(c_.program.text())) return Go::kOn;
  // What was good before the error is cut.
  c_.chain.flush();
  c_.summary.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

bool WedmControl::reachedUntil() const {
  if (!c_.settings.until || c_.levels.size() != 1) return false;
  const WedmLevel& main = c_.levels.back();
  return c_.settings.until->reachedBy(main.number, c_.program.place(main.block).line);
}

}  // namespace proveout::nc
