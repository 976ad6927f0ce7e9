// The run loop: lines, header, end of text.
#include "core/nc/iso/program/control.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/nc/iso/axes/axis_events.h"
#include "core/nc/iso/block/auxiliary.h"
#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/five_axis/machine_data.h"
#include "core/nc/iso/motion/axis_setup.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/perform/perform.h"
#include "core/nc/iso/program/block_ends.h"
#include "core/nc/iso/program/reset.h"
#include "core/nc/iso/spindle/spindle.h"
#include "core/nc/iso/spindle/wait.h"

namespace proveout::nc {

namespace {

LexRules lexRules(IsoContext& c) {
  LexRules rules = c.dialect.lexing;
  for (std::size_t k = 0; k < c.settings.skip_switches.size(); ++k) {
    if (c.settings.skip_switches[k]) rules.skip_switches |= static_cast<std::uint16_t>(1u << k);
  }
  rules.expressions = &c.macro;
  rules.names = &c.axes.names();
  return rules;
}

}  // namespace

IsoControl::IsoControl(const IsoDialect& dialect, const ProgramSource& source,
                       const ControlSettings& settings, MotionSink& sink, Progress* progress,
                       const ControlHost& host)
    : settings_(withAxisParameters(dialect.parameters, settings)),
      context_(dialect, source, settings_, sink, progress, host, summary_),
      run_(*this, context_.calls.frames(), summary_, settings_),
      lexer_(lexRules(context_), dialect.alarms) {
  if (dialect.maker_data != nullptr) context_.maker = dialect.maker_data(context_);
  if (dialect.system_variables != nullptr) system_variables_ = dialect.system_variables(context_);
  if (dialect.language != nullptr) language_ = dialect.language(context_);
  context_.language = language_.get();
}

InterpretSummary IsoControl::run() {
  if (!start()) {
    summary_.end = ProgramEnd::kAlarm;
    return summary_;
  }
  while (advance() == Turn::kOn) {
  }
  return summary_;
}

IsoControl::Turn IsoControl::advance() {
  const Go go = run_.advance();
  if (go == Go::kOn) return Turn::kOn;
  if (go == Go::kWaits) return Turn::kWaits;
  context_.stages.rapid.flush(FlushReason::kEnd);  // behind an alarm too: the axes come to a stand
  context_.emitter.time().flush();
  if (system_variables_) system_variables_->keep(context_);
  return Turn::kEnded;
}

bool IsoControl::start() {
  IsoContext& c = context_;
  const ControlSettings& settings = c.settings;
  const Status known = c.parameters.set(settings.parameters);
  if (!known.ok()) return c.fail("parameter", known.error().message);
  if (settings.units == LengthUnit::kInch && !c.parameters.given(MotionParam::kDefaultG20)) {
    c.parameters.put(MotionParam::kDefaultG20, 1.0);  // programs read what is in force
  }
  for (const std::string_view name : c.parameters.notedNames()) {
    c.warn("noted", fmt::format("parameter {} has no effect in the simulation", name), {}, Severity::kNote);
  }
  c.systems.update(c.parameters);
  if (!c.systems.fault().empty()) return c.fail("parameter", c.systems.fault());
  if (!(settings.rapid_mm_min.minCoeff() > 0.0) || !settings.start.allFinite()) {
    return c.fail("settings", "rapid rates must be above 0 and the start position finite");
  }
  if (!(settings.bell_time_s >= 0.0 && settings.bell_time_s <= 100.0)) {
    return c.fail("settings", "the time of the acceleration's rise must be 0 to 100 s");
  }
  if (const std::string bad = checkAxes(settings); !bad.empty()) return c.fail("settings", bad);
  if (const std::string bad = checkSpindles(settings, c.axes); !bad.empty()) return c.fail("settings", bad);
  if (!checkAuxiliary(c) || !checkWaitCodes(c)) return false;
  if (const std::string bad = checkRangeB(settings, c.axes); !bad.empty()) return c.fail("settings", bad);
  if (!takeMachineData(c) || !checkMachineAxes(c)) return false;
  levelDrives(c);
  powerOn(c);
  if (c.dialect.begin != nullptr) c.dialect.begin(c);
  configureFeeds(c);
  if (!c.stages.zone.configure()) return false;
  if (settings.start_by_default) {
    c.emitter.lowerStart(c.stages.zone.ceiling(2));
    levelDrives(c);
    c.settle(c.standing());
  }
  return loadMain();
}

bool IsoControl::loadMain() {
  IsoContext& c = context_;
  const ProgramStore::Loaded main = c.programs.main();
  if (main.text == nullptr) {
    const bool missing = main.failure == ProgramStore::Failure::kNotFound;
    return c.fail(missing ? DiagnosticName(SharedAlarm::kFileNotFound) : "encoding", main.message);
  }
  CallFrame frame;
  frame.setProgram(*main.text, main.file);
  run_.openMain(frame);
  bool any = false;
  for (const auto line : main.text->lines())
    any = any || line.find_first_not_of(" \t%") != std::string_view::npos;
  if (!any) return c.fail("empty", main.text->name() + ": the program is empty");
  return true;
}

bool IsoControl::opened() {
  IsoContext& c = context_;
  CallFrame& frame = run_.top();
  c.calls.entered();
  if (c.calls.depth() == 1) {
    c.enterProgram();
  } else if (frame.call.repetition == 0) {
    c.enteredCall();
  } else if (opensLocals(frame.kind)) {  // a macro with its arguments anew
    c.variables.enter(frame.args);
  }
  // Where the call names the block to begin with, the program goes on from there.
  const bool whole = frame.kind != CallKind::kLines && frame.first == 0;
  if (whole && language_ == nullptr) tape_.skipLeader(c, frame);
  return true;
}

void IsoControl::closed(const CallFrame& left) {
  IsoContext& c = context_;
  c.calls.left();
  if (!left.call.again()) {
    c.leftCall(left.kind);
    if (language_) language_->left(left);
    return;
  }
  if (opensLocals(left.kind)) c.variables.leave();
}

/// Opens a call that was put off, or goes on with the flow of a block that waited for such calls.
Go IsoControl::due() {
  IsoContext& c = context_;
  if (c.calls.hasDeferred()) {
    CallFrame deferred;
    return c.calls.takeDeferred(deferred) ? open(deferred) : alarm();
  }
  if (c.calls.top().waiting.code == 0) return Go::kOn;
  const FlowRequest request = std::exchange(c.calls.top().waiting, {});
  c.setBlock(request.line, request.number);
  const Go go = flow(request);
  return go == Go::kOn ? Go::kNext : go;
}

Reading IsoControl::read() {
  if (language_) return readLanguage();
  IsoContext& c = context_;
  CallFrame& frame = run_.top();
  Block& block = c.block;
  lexer_.setMode(c.data_input ? LexMode::kData : LexMode::kBlock);
  const BlockSpan span = nextSpan(c, frame);
  const bool lexed = lexer_.lex(frame.text->lines()[frame.block].substr(0, span.end), block, span.from);
  frame.number = block.number;
  c.setBlock(frame.block, block.number);
  // CBB = 0: the switch is read when the block before is done.
  const bool now = block.skip > 0 && !c.parameters.flag(MotionParam::kSkipKeepsLookAhead);
  if (now && !c.flushPipe()) return Reading::kBad;
  if (block.skip > 0 && c.settings.skip_switches[static_cast<std::size_t>(block.skip - 1)])
    return Reading::kSkipped;
  bool good = lexed || c.fail(lexer_.error());
  if (block.nested_at.begin > 0 || block.open_at.begin > 0) noteComments(c);
  if (c.dialect.lexing.named_programs && block.has_file && tape_.onlyHeaderAbove(c.calls))
    block.has_file = false;  // the name of the program
  if (good && block.percent) {
    const bool head = tape_.onlyHeaderAbove(c.calls);
    if (head) noteTapeName(c);
    if (!head) frame.next = frame.end;
    if (!head || block.empty()) return Reading::kSkipped;
  }
  macro_call_ = {};
  calls_macro_ = good && findCall(false, macro_call_);
  good = good && (calls_macro_ || (checkRepeats(c) && tape_.checkHeader(c) && takeWords(c)));
  if (good && block.empty()) return Reading::kEmpty;
  return good ? Reading::kBlock : Reading::kBad;
}

/// Other channels, and a tool whose life runs out, may end a loop that changes nothing itself.
bool IsoControl::workOver() {
  IsoContext& c = context_;
  const FlowPlace at = c.calls.place();
  if (c.watch.workOver(at)) return true;
  if (!c.channels.empty()) return c.watch.movesOn(at);
  const auto state = {LoopWatch::bytesOf(c.state), LoopWatch::bytesOf(c.position),
                      LoopWatch::bytesOf(c.machine)};
  const std::uint64_t variables =
      c.variables.fingerprint() + (language_ ? language_->fingerprint() : std::uint64_t{0});
  const bool endless = c.state.tool_row == 0 && c.watch.goesRound(at, variables, state);
  return endless || c.watch.goesOn(at);
}

Go IsoControl::carryOut() {
  if (language_) return carryOutLanguage();
  IsoContext& c = context_;
  if (calls_macro_) return callMacro(macro_call_);
  if (c.block.kind != LineKind::kBlock) return statement();
  if (c.data_input == nullptr) return execute();
  run_.blockDone();
  return dataBlock(c) ? Go::kOn : alarm();
}

Go IsoControl::endOfText() {
  IsoContext& c = context_;
  if (c.calls.top().kind == CallKind::kLines)
    return c.dialect.lines_done == nullptr || c.dialect.lines_done(c) ? Go::kReturn : alarm();
  const SourceText& text = *c.calls.top().text;
  if (language_) {
    if (const std::optional<Go> go = language_->endOfText(*this)) return *go;
  }
  if (lexer_.inComment()) {
    lexer_.setInComment(false);
    return commentLeftOpen(commentOpenAtEnd(text.lines(), 0));
  }
  if (c.calls.depth() == 1) {
    c.warn("no-end", "the program ends without M2 or M30: is the file cut short?");
    return run_.finish("end of text", ProgramEnd::kEndOfProgram);
  }
  if (c.watch.workOver(c.calls.place())) return Go::kStop;  // an empty text may be repeated without end
  if (no_return_told_.insert(c.calls.top().file).second)
    c.warn("no-m99", "the subprogram ends without M99: taken as M99");
  c.block.clear();
  return returnFrom(FlowRequest{.code = mcode::kReturn});
}

/// `open`: its place; none: not known, the last line is told.
Go IsoControl::commentLeftOpen(const std::optional<OpenComment>& open) {
  IsoContext& c = context_;
  const std::size_t lines = c.calls.top().text->lines().size();
  c.setBlock(open ? open->line : std::max<std::size_t>(lines, 1) - 1, c.block.number);
  c.fail("open-comment", "the text ends inside a comment: ')' is missing", open ? open->columns : Columns{});
  return stopAtAlarm();
}

/// Lines of the program in hand run as a part of the block.
Go IsoControl::openLines(const LineRange& lines) {
  CallFrame frame;
  frame.setProgram(*context_.calls.top().text, context_.calls.top().file);
  frame.kind = CallKind::kLines;
  frame.first = lines.first;
  frame.end = lines.end;
  return open(frame);
}

Go IsoControl::execute() {
  IsoContext& c = context_;
  const bool taken = subprograms_.take(c) && takeInterruptWords();
  BlockPlan plan(c.state);
  const bool good = taken && (c.dialect.plan ? c.dialect.plan : planBlock)(c, plan) && perform(c, plan);
  if (summary_.end == ProgramEnd::kCancelled || summary_.end == ProgramEnd::kBlockLimit) return Go::kStop;
  if (!good) return alarm();
  run_.blockDone();  // a called subprogram still runs
  if (plan.go_on) c.calls.top().next = *plan.go_on;
  if (plan.lines) return openLines(*plan.lines);
  deferCalls(plan);
  if (plan.wait_code != 0) {
    if (!performWait(c, plan)) return alarm();
    if (c.waiting.code != 0) return Go::kWaits;
  }
  if (plan.flow == nullptr) return followInterrupts();
  switchInterrupt();
  return flow(plan);
}

}  // namespace proveout::nc
