// The run loop of the WL4 control: blocks in their order, calls, jumps.
#include "core/nc/wl4/wl4_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace proveout::nc {

namespace {

constexpr std::size_t kMostNested = 5;  ///< subprograms below the main program
constexpr std::uint64_t kWorkPerCheck = 4096;
constexpr std::size_t kLongestBlock = 80;

}  // namespace

Wl4Control::Wl4Control(bool lathe, const ProgramSource& source, const ControlSettings& settings,
                       MotionSink& sink, Progress* progress, const ControlHost& host)
    : lathe_(lathe),
      settings_(settings),
      progress_(progress),
      host_(host),
      axes_(settings_),
      emitter_(settings_, axes_, sink, summary_),
      programs_(source, settings_.encoding, sink),
      variables_(*this),
      evaluator_(variables_),
      reader_(evaluator_),
      origins_(sink),
      corner_stage_(pipe_, *this),
      comp_stage_(pipe_, *this),
      frame_stage_(chain_),
      emit_stage_(emitter_, settings_.tool_change_s),
      budget_(settings_.block_limit) {
  evaluator_.setOrigins(origins_);
  pipe_.link(frame_stage_);
  pipe_.link(emit_stage_);
}

InterpretSummary Wl4Control::run() {
  summary_.end = ProgramEnd::kAlarm;
  if (start()) {
    const Result<const Wl4Program*> main = programs_.main();
    if (!main) {
      fail("wl4-program", main.error().message);
    } else {
      runProgram(**main);
    }
  }
  emitter_.time().flush();
  return summary_;
}

bool Wl4Control::start() {
  if (const Status known = parameters_.set(settings_.parameters, lathe_); !known.ok()) {
    return fail("wl4-parameter", known.error().message);
  }
  if (!(settings_.rapid_mm_min.minCoeff() > 0.0) || !settings_.start.allFinite()) {
    return fail("wl4-settings", "rapid rates must be above 0 and the start position finite");
  }
  if (const std::string bad = checkAxes(settings_); !bad.empty()) return fail("wl4-settings", bad);
  MotionLimits limits;
  for (int k = 0; k < axes_.count(); ++k) {
    limits.axes[static_cast<std::size_t>(k)].acceleration = axes_.at(k).acceleration;
    limits.accelerations = limits.accelerations || axes_.at(k).acceleration > 0.0;
  }
  limits.bell_time_s = settings_.bell_time_s;
  emitter_.time().configure(limits, axes_.count());
  for (const auto& [number, tool] : parameters_.tools()) {
    if (tool.at_center) emitter_.countFromNose(number);
  }
  machine_ = emitter_.machine();
  state_.plane = lathe_ ? 18 : 17;
  return true;
}

Wl4Control::Go Wl4Control::runProgram(const Wl4Program& program) {
  levels_.push_back({&program, program.first, -1, runs_++});
  if (program.label_count > Wl4Programs::kMostLabels) {
    fail("wl4-labels", fmt::format("{} labels in a program: at most {} are allowed", program.label_count,
                                   Wl4Programs::kMostLabels));
    return Go::kStop;
  }
  Go go = Go::kOn;
  for (std::size_t line = program.first; go == Go::kOn;) {
    if (line >= program.last) {
      go = endOfText(program);
      break;
    }
    levels_.back().line = line++;
    levels_.back().number = -1;
    go = block(line);
    if (go == Go::kOn && until_hit_ && levels_.size() == 1) go = finish("until", ProgramEnd::kUntil);
  }
  levels_.pop_back();
  return go;
}

Wl4Control::Go Wl4Control::endOfText(const Wl4Program& program) {
  if (program.last > program.first) levels_.back().line = program.last - 1;
  if (levels_.size() > 1) {
    warnOnce("no M99 " + program.name, "wl4-no-m99", "the subprogram ends without M99: taken as M99");
    return Go::kReturn;
  }
  warn("wl4-no-end", "the program ends without M2 or M30: is the file cut short?");
  return finish("end of text", ProgramEnd::kEndOfProgram);
}

Wl4Control::Go Wl4Control::block(std::size_t& next_line) {
  const std::string_view line = levels_.back().program->line(levels_.back().line);
  const std::size_t first = behindBlanks(line, 0);
  if (line.substr(first, 1) == "/" && !parameters_.conditional) return Go::kOn;
  // The text is UTF-8: bytes that go on with a character are none.
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const auto length = static_cast<std::size_t>(std::count_if(line.begin(), line.end(), begins));
  if (length > kLongestBlock) {
    warnOnce("long", "wl4-long-block",
             fmt::format("the block has {} characters: the control takes {}", length, kLongestBlock));
  }
  variables_.mark();
  beginBlock(line);
  const bool good = reader_.read(line, block_);
  levels_.back().number = block_.number;
  if (good && block_.empty()) {
    until_hit_ = until_hit_ || reachedUntil();
    return Go::kOn;
  }
  if (workOver() || goesRound()) return Go::kStop;
  ++summary_.blocks;
  if (!good) {
    variables_.takeBack();
    fail("wl4-syntax", reader_.error().message, reader_.error().columns);
    return failed();
  }
  if (evaluator_.mixedPower()) {
    warnOnce("power", "wl4-power", "** beside * / MOD without parentheses: they go from left to right");
  }
  if (isOwnError(levels_.back().line)) {
    const std::string text(block_.comment.empty() ? std::string_view("the program stops itself")
                                                  : block_.comment);
    fail(fmt::format("wl4-err-N{}", block_.number), text);
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  return execute(next_line);
}

/// `N010 M0 N10 .text`: a program reports an error by stopping for ever.
bool Wl4Control::isOwnError(std::size_t here) const {
  if (!block_.jump) return false;
  const auto& labels = levels_.back().program->labels;
  const auto target = labels.find(*block_.jump);
  if (target == labels.end() || target->second != here) return false;
  return std::any_of(block_.m.begin(), block_.m.end(), [](const auto& m) { return m.number == 0; });
}

Wl4Control::Go Wl4Control::execute(std::size_t& next_line) {
  Plan p;
  if (!goToToolChange() || !plan(p)) {
    variables_.takeBack();
    return failed();
  }
  const bool reached = reachedUntil();
  recordWords(p);
  if (!functions(p, Wl4Phase::kStart) || !carryOut(p)) return failed();
  const bool open_cycle = p.deed == 31 || (p.deed >= 70 && p.deed <= 79);
  p.next.spindle = state_.spindle;
  p.next.coolant = state_.coolant;
  p.next.gear = state_.gear;
  p.next.tool = state_.tool;
  state_ = p.next;
  Go go = Go::kOn;
  if (open_cycle && !isContourCycle(p.deed)) go = openCycle(p);
  if (go == Go::kOn && p.deed == 0 && p.named.any() && state_.cycle != 80 && !in_cycle_) {
    in_cycle_ = true;
    recordFixedCycle();
    go = call(fmt::format("{}", state_.cycle), 1);
    in_cycle_ = false;
  }
  if (go != Go::kOn) return go;
  if (!functions(p, Wl4Phase::kEnd)) return failed();
  if (block_.has('L')) go = subprograms();
  if (go != Go::kOn) return go;
  until_hit_ = until_hit_ || reached;
  for (const Wl4Block::Code& m : block_.m) {
    if (m.number == 99 && levels_.size() > 1) return Go::kReturn;
    if (m.number == 99)
      warn("wl4-main-m99", "M99 in the main program: taken as its end", {}, Severity::kNote);
    if (m.number == 2 || m.number == 30 || m.number == 99) {
      return finish(fmt::format("M{}", m.number), ProgramEnd::kEndOfProgram);
    }
  }
  return block_.jump ? jump(*block_.jump, next_line) : Go::kOn;
}

/// The deed of the block, or its motion.
bool Wl4Control::carryOut(Plan& p) {
  if (p.deed == 4) return dwell();
  if (p.deed == 36) return referenceMove(p);
  if (isContourCycle(p.deed)) return contourCycle(p);
  return p.deed != 0 || !p.moves || move(p);
}

Wl4Control::Go Wl4Control::failed() {
  if (summary_.end == ProgramEnd::kCancelled || summary_.end == ProgramEnd::kBlockLimit) return Go::kStop;
  recover();
  if (summary_.errors < settings_.max_errors) return Go::kOn;
  summary_.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

Wl4Control::Go Wl4Control::finish(const std::string& code, ProgramEnd end) {
  if (!pipe_.flush(FlushReason::kEnd)) {
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  if (settings_.until && !until_hit_) {
    fail("wl4-until", "the program ends here; the block to stop after was not reached");
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  summary_.end = end;
  emitter_.event(event::End{code}, 0.0, here());
  return Go::kStop;
}

bool Wl4Control::workOver() {
  budget_.spend(1, budget_.newMotions(summary_.motions) > 0);
  if ((budget_.work() - 1) % kWorkPerCheck == 0 && progress_ != nullptr) {
    const Level& main = levels_.front();
    progress_->report("interpreting", static_cast<double>(main.line - main.program->first) /
                                          static_cast<double>(main.program->last - main.program->first));
    if (progress_->cancelled()) {
      summary_.end = ProgramEnd::kCancelled;
      return true;
    }
  }
  if (!budget_.over(levels_.size(), levels_.back().line)) return false;
  fail("wl4-block-limit", budget_.message());
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

/// Whether the program is in a loop without an end: reported then.
bool Wl4Control::goesRound() {
  const Level& level = levels_.back();
  const bool endless = watch_.comesBack(level.run, levels_.size(), level.line, variables_.fingerprint(),
                                        {LoopWatch::bytesOf(state_), LoopWatch::bytesOf(machine_)});
  if (!endless) return false;
  fail("wl4-endless-loop", watch_.message());
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

bool Wl4Control::reachedUntil() const {
  if (!settings_.until || levels_.size() != 1) return false;
  const UntilBlock& until = *settings_.until;
  if (until.block && levels_.back().number == *until.block) return true;
  return until.line && static_cast<int>(levels_.back().line) + 1 >= *until.line;
}

Wl4Control::Go Wl4Control::subprograms() {
  // By digits: two for the program, the rest are repetitions; the value has lost leading zeros.
  const Columns at = block_.at('L');
  const std::string_view text =
      block_.text.substr(static_cast<std::size_t>(at.begin), static_cast<std::size_t>(at.end - at.begin) - 1);
  std::string digits(text);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) {
    const int value = static_cast<int>(block_.value('L'));
    digits = value < 100 ? fmt::format("{:02}", value) : fmt::format("{:04}", value);
  }
  if (digits.size() == 1) digits.insert(0, "0");
  const std::string name = digits.substr(0, 2);
  const int times = digits.size() > 2 ? std::atoi(digits.c_str() + 2) : 1;
  if (times == 0) {
    warn("wl4-no-repetition",
         fmt::format("L{} calls program {} no time: the digits behind the first two are repetitions", digits,
                     name),
         block_.at('L'));
  }
  return call(name, times);
}

Wl4Control::Go Wl4Control::call(const std::string& name, int times) {
  if (levels_.size() > kMostNested) {
    fail("wl4-nesting", fmt::format("program {} is the sixth level of calls: five are allowed", name));
    return failed();
  }
  const Result<const Wl4Program*> program = programs_.find(name);
  if (!program) {
    fail("wl4-program", program.error().message);
    return failed();
  }
  const Wl4Block caller = block_;  // the program reads its own
  for (int k = 0; k < times; ++k) {
    if (workOver()) return Go::kStop;  // the program may be empty
    variables_.open();
    origins_.openCall();
    const Go go = runProgram(**program);
    origins_.closeCall();
    variables_.close();
    if (go == Go::kStop) return go;
    block_ = caller;
    beginBlock(block_.text);
  }
  return Go::kOn;
}

Wl4Control::Go Wl4Control::jump(std::int64_t label, std::size_t& next_line) {
  const auto& labels = levels_.back().program->labels;
  const auto target = labels.find(label);
  if (target == labels.end()) {
    fail("wl4-label", fmt::format("there is no label N0{} in this program", label), block_.jump_columns);
    return failed();
  }
  next_line = target->second;
  return Go::kOn;
}

}  // namespace proveout::nc
