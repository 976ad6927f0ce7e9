// The run loop: lines, header, end of text, reports.
#include "core/nc/nct/nct_control.h"

#include <fmt/core.h>

#include <utility>

namespace proveout::nc {

NctControl::NctControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
                       Progress* progress)
    : source_(source),
      settings_(settings),
      sink_(sink),
      progress_(progress),
      emitter_(settings, sink, summary_),
      lexer_(LexRules{}),
      length_table_(settings.length_offsets),
      radius_table_(settings.radius_offsets) {
  frames_.common.offset = settings.common_offset;
  for (std::size_t i = 0; i < frames_.basic.size(); ++i) {
    frames_.basic[i] = {settings.work_offsets[i], settings.work_rotations_deg[i]};
  }
  for (const auto& [p, offset] : settings.extended_offsets) frames_.extended[p].offset = offset;
}

void NctControl::resetState() {
  NctState s;
  s.active.fill(0);
  const auto flag = [&](NctParam p) { return parameters_.flag(p); };
  s.active[kGroupMotion] = flag(NctParam::kDefaultG1) ? 10 : 0;
  s.active[kGroupPlane] = flag(NctParam::kDefaultG18) ? 180 : flag(NctParam::kDefaultG19) ? 190 : 170;
  s.active[kGroupDistance] = flag(NctParam::kDefaultG91) ? 910 : 900;
  s.active[4] = 230;
  s.active[kGroupFeedMode] = flag(NctParam::kDefaultG95) ? 950 : 940;
  s.active[kGroupUnits] = settings_.units == LengthUnit::kInch ? 200 : 210;
  s.active[kGroupRadiusComp] = 400;
  s.active[kGroupLengthComp] = flag(NctParam::kDefaultG43) ? 430 : flag(NctParam::kDefaultG44) ? 440 : 490;
  s.active[kGroupCycle] = 800;
  s.active[kGroupReturn] = 980;
  s.active[kGroupScaling] = 500;
  s.active[kGroupMacro] = 670;
  s.active[kGroupSurfaceSpeed] = 970;
  s.active[kGroupWorkSystem] = 540;
  s.active[kGroupCutting] = 640;
  s.active[kGroupRotation] = 690;
  s.active[kGroupPolarData] = 150;
  s.active[kGroupTilt] = 691;
  s.active[kGroupPolarInterpolation] = 131;
  s.active[kGroupMirror] = 501;
  s.feed = parameters_[s.perTurn() ? NctParam::kDefaultFeedPerTurn : NctParam::kDefaultFeedPerMinute];
  state_ = s;
  chain_ = frames_.chain(state_.work_system, state_.length);
  machine_ = emitter_.machine();
  position_ = chain_.toProgram(machine_);
}

InterpretSummary NctControl::run() {
  const Status known = parameters_.set(settings_.parameters);
  if (!known.ok()) {
    fail("nct-parameter", known.error().message);
    summary_.end = ProgramEnd::kAlarm;
    return summary_;
  }
  if (!(settings_.rapid_mm_min.minCoeff() > 0.0) || !settings_.start.allFinite()) {
    fail("nct-settings", "rapid rates must be above 0 and the start position finite");
    summary_.end = ProgramEnd::kAlarm;
    return summary_;
  }
  resetState();
  if (!loadMain()) {
    summary_.end = ProgramEnd::kAlarm;
    return summary_;
  }
  while (step() == Go::kOn) {
  }
  return summary_;
}

SourceText* NctControl::load(const ProgramText& text, std::uint32_t& file) {
  const auto known = text_by_path_.find(text.path);
  if (known != text_by_path_.end()) {
    file = known->second;
    return texts_[file].get();
  }
  std::string encoding;
  Result<std::string> utf8 = decodeText(text.bytes, settings_.encoding, &encoding);
  if (!utf8.ok()) {
    fail("nct-encoding", text.name + ": " + utf8.error().message);
    return nullptr;
  }
  file = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::make_unique<SourceText>(text.name, text.path, std::move(*utf8)));
  texts_.back()->setEncoding(encoding);
  text_by_path_[text.path] = file;
  sink_.file(file, text.name);
  return texts_.back().get();
}

bool NctControl::loadMain() {
  const Result<ProgramText> text = source_.mainProgram();
  if (!text.ok()) return fail("nct-2132", text.error().message);
  CallFrame frame;
  frame.text = load(*text, frame.file);
  if (frame.text == nullptr) return false;
  stack_.push_back(frame);
  bool any = false;
  for (const auto line : frame.text->lines())
    any = any || line.find_first_not_of(" \t%") != std::string_view::npos;
  if (!any) return fail("nct-empty", frame.text->name() + ": the program is empty");
  return true;
}

/// How often cancellation is looked at and progress told, in blocks.
constexpr std::uint64_t kBlocksPerCheck = 1024;

bool NctControl::overLimit() {
  if (work_++ % kBlocksPerCheck == 0 && progress_ != nullptr) {
    const CallFrame& main = stack_.front();
    progress_->report("interpreting",
                      static_cast<double>(main.line) / static_cast<double>(main.text->lines().size()));
    if (progress_->cancelled()) {
      summary_.end = ProgramEnd::kCancelled;
      return true;
    }
  }
  if (work_ <= settings_.block_limit) return false;
  fail("nct-block-limit",
       fmt::format("{} blocks executed without an end: endless loop? (the limit is a setting)",
                   settings_.block_limit));
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

NctControl::Go NctControl::step() {
  if (until_hit_ && stack_.size() == 1) return finish("until", ProgramEnd::kUntil);
  CallFrame& frame = stack_.back();
  if (frame.line >= frame.text->lines().size()) return endOfText();
  line_index_ = frame.line++;
  const bool lexed = lexer_.lex(frame.text->lines()[line_index_], block_);
  if (block_.skip > 0 && !skipKeepsLookAhead()) return alarm();
  if (block_.skip > 0 && settings_.skip_switches[static_cast<std::size_t>(block_.skip - 1)]) return Go::kOn;
  bool good = lexed || fail(lexer_.error().code, lexer_.error().message, lexer_.error().columns);
  if (good && block_.percent) {
    if (!onlyHeaderAbove()) return endOfText();
    if (block_.empty()) return Go::kOn;
  }
  good = good && checkHeader();
  if (good && block_.empty()) {
    until_hit_ = until_hit_ || reachedUntil();
    return Go::kOn;
  }
  if (overLimit()) return Go::kStop;
  ++summary_.blocks;
  if (good) return execute();
  if (summary_.errors < settings_.max_errors) return Go::kOn;
  summary_.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

bool NctControl::skipKeepsLookAhead() {
  if (!comp_engaged_ || parameters_.flag(NctParam::kSkipKeepsLookAhead)) return true;
  if (!flushComp()) return false;  // CBB = 0: the switch is read when the block before is done
  rebaseComp();
  return true;
}

bool NctControl::onlyHeaderAbove() const {
  for (std::size_t k = 0; k < line_index_; ++k) {
    const auto line = stack_.back().text->lines()[k];
    const auto first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && line[first] != '%' && line[first] != '(') return false;
  }
  return true;
}

bool NctControl::checkHeader() {
  // Only in front of everything else: a second O word would start another program in the same text.
  if (block_.program < 0 || onlyHeaderAbove()) return true;
  return fail("nct-2017",
              "illegal address O: a program number stands at the head of the text; subprograms are files of "
              "their own",
              block_.program_columns);
}

NctControl::Go NctControl::endOfText() {
  CallFrame& frame = stack_.back();
  if (lexer_.inComment()) {
    lexer_.setInComment(false);
    line_index_ = frame.text->lines().empty() ? 0 : frame.text->lines().size() - 1;
    fail("nct-open-comment", "the text ends inside a comment: ')' is missing");
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  if (stack_.size() == 1) {
    warn("nct-no-end", "the program ends without M2 or M30: is the file cut short?");
    return finish("end of text", ProgramEnd::kEndOfProgram);
  }
  warn("nct-no-m99", "the subprogram ends without M99: taken as M99");
  block_.clear();
  return returnFrom();
}

NctControl::Go NctControl::execute() {
  BlockPlan plan;
  const bool good = planBlock(plan) && perform(plan);
  if (summary_.end == ProgramEnd::kCancelled || summary_.end == ProgramEnd::kBlockLimit) return Go::kStop;
  if (!good) {
    if (summary_.errors < settings_.max_errors) return Go::kOn;
    summary_.end = ProgramEnd::kAlarm;
    return Go::kStop;
  }
  until_hit_ = until_hit_ || reachedUntil();  // a called subprogram still runs
  return plan.flow ? flow(plan) : Go::kOn;
}

bool NctControl::reachedUntil() const {
  if (!settings_.until || stack_.size() != 1) return false;
  const UntilBlock& until = *settings_.until;
  if (until.block && block_.number == *until.block) return true;
  return until.line && static_cast<int>(line_index_) + 1 >= *until.line;
}

SourceRef NctControl::here() const {
  SourceRef ref;
  if (stack_.empty()) return ref;
  ref.file = stack_.back().file;
  ref.line = static_cast<std::uint32_t>(line_index_ + 1);
  ref.block = block_.number;
  ref.depth = static_cast<std::uint16_t>(stack_.size() - 1);
  return ref;
}

Diagnostic NctControl::diagnosticAt(Severity severity, std::string code, std::string message,
                                    const SourceRef& at, Columns columns) const {
  Diagnostic d;
  d.severity = severity;
  d.code = std::move(code);
  d.message = std::move(message);
  if (stack_.empty() || at.line == 0) return d;
  const SourceText& text = *texts_[at.file];
  d.where.file = text.name();
  d.where.line = static_cast<int>(at.line);
  if (at.line <= text.lines().size()) d.source_line = std::string(text.lines()[at.line - 1]);
  d.where.column = columns.begin;
  d.where.column_end = columns.end;
  if (columns.begin == 0 && !d.source_line.empty()) {
    d.where.column = static_cast<int>(d.source_line.find_first_not_of(" \t")) + 1;
    d.where.column_end = static_cast<int>(d.source_line.find_last_not_of(" \t")) + 2;
  }
  for (std::size_t level = stack_.size(); level-- > 1;) {
    const CallFrame& caller = stack_[level - 1];
    d.notes.push_back(fmt::format("called from {}:{}", caller.text->name(), caller.line));
  }
  return d;
}

bool NctControl::fail(std::string code, std::string message, Columns columns) {
  report(Severity::kError, std::move(code), std::move(message), columns);
  return false;
}

void NctControl::warn(std::string code, std::string message, Columns columns, Severity severity) {
  report(severity, std::move(code), std::move(message), columns);
}

void NctControl::warnOnce(const std::string& key, std::string code, std::string message, Columns columns) {
  if (warned_.insert(key).second) report(Severity::kWarning, std::move(code), std::move(message), columns);
}

void NctControl::report(Severity severity, std::string code, std::string message, Columns columns) {
  emitter_.diagnostic(diagnosticAt(severity, std::move(code), std::move(message), here(), columns));
}

}  // namespace proveout::nc
