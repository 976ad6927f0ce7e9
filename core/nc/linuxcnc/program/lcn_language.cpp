#include "core/nc/linuxcnc/program/lcn_language.h"

#include <fmt/core.h>

#include "core/nc/iso/context/words.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/frames/frames.h"
#include "core/nc/linuxcnc/program/lcn_kept.h"
#include "core/nc/origins/intern_table.h"

namespace proveout::nc {

LcnVariables& linuxCncVariables(IsoContext& c) {
  return static_cast<LinuxCncLanguage*>(c.language)->variables();
}

LinuxCncLanguage::LinuxCncLanguage(IsoContext& c) : c_(c), machine_(readLcnMachine(c.settings)) {
  for (const LcnTool& tool : machine_.tools) tools_.insert(tool.number);
  loadTools();
}

/// The rows of the tool table as the file has them.
void LinuxCncLanguage::loadTools() {
  OffsetTables& table = c_.registers.offsets;
  for (const LcnTool& tool : machine_.tools) {
    if (tool.number < 1 || tool.number > OffsetTables::kRows) continue;
    const auto set = [&](OffsetColumn column, double mm) { table.set(column, tool.number, false, mm); };
    set(OffsetColumn::kLength, tool.offset[2].value_or(0.0));
    set(OffsetColumn::kX, tool.offset[0].value_or(0.0));
    set(OffsetColumn::kY, tool.offset[1].value_or(0.0));
    set(OffsetColumn::kRadius, 0.5 * tool.diameter.value_or(0.0));
    table.setTip(tool.number, tool.orientation.value_or(0));
  }
}

bool LinuxCncLanguage::hasParameter(int number) const {
  if (linuxCncFlavour(c_) == LinuxCncFlavour::kMach3) return number >= 0 && number <= LcnVariables::kMost;
  return LcnVariables::exists(number);
}

Value LinuxCncLanguage::parameter(int number) {
  const std::optional<double> told = lcnSystemValue(c_, number);
  if (told) return Value{*told};
  Value value = variables_.at(number);
  // Where the channel keeps it, the store knows only which word set it.
  const std::optional<double> kept = lcnKept(c_, number);
  if (kept && *kept != value.number) value = Value{*kept};
  return value;
}

void LinuxCncLanguage::assign(int number, const Value& value) {
  putLcnKept(c_, number, value.number);
  variables_.put(number, value);
}

bool LinuxCncLanguage::named(std::string_view name, Value& out) {
  if (const std::optional<double> told = lcnPredefined(c_, run_, name)) {
    out = Value{*told};
    return true;
  }
  if (name.starts_with("_ini[") || name.starts_with("_hal[")) return ofMachine(name, out);
  const Value* const known = variables_.named(name);
  if (known == nullptr) return false;
  out = *known;
  return true;
}

/// #<_ini[section]name> and #<_hal[pin]>.
bool LinuxCncLanguage::ofMachine(std::string_view name, Value& out) const {
  const std::size_t close = name.find(']');
  if (close == std::string_view::npos) return false;
  const std::string_view inside = name.substr(5, close - 5);
  if (name.starts_with("_ini[")) {
    const std::optional<double> value = machine_.ini.number(inside, name.substr(close + 1));
    out = Value{value.value_or(0.0)};
    return value.has_value();
  }
  const auto pin = machine_.pins.find(std::string(inside));
  if (pin == machine_.pins.end()) return false;
  out = Value{pin->second};
  return true;
}

std::optional<Go> LinuxCncLanguage::statement(StatementFlow& flow) {
  if (!started_ && !start(flow)) return flow.failed(true);
  if (o_word_) return oWord(flow);
  seeking_ = false;
  if (contourDone()) return words(flow);
  for (const Assignment& a : assignments_) {
    if (a.to.number >= 0) {
      assign(a.to.number, a.value);
    } else {
      variables_.putNamed(a.to.name, a.value);
    }
  }
  const bool contour = inContour();
  if (!contour && !comment()) return flow.failed(false);
  if (calls_) return c_.block.find('P') != nullptr || !isReturn() ? callNumbered(flow) : returnNumbered(flow);
  if (contour) {
    takeContourLine();
    return Go::kOn;
  }
  if (const std::optional<Go> go = remapped(flow)) return go;
  if (const std::optional<Go> go = openContour(flow)) return go;
  return words(flow);
}

/// The words of the line. Nothing: they are to be planned.
std::optional<Go> LinuxCncLanguage::words(StatementFlow& flow) {
  if (repeatsProgram()) {
    c_.warn("main-m99", "M47 starts the program again: one pass is simulated", {}, Severity::kNote);
    flow.statementDone();
    return flow.endRun("M47");
  }
  if (!functions(flow)) return flow.failed(false);
  if (c_.block.words.empty()) return Go::kOn;
  if (const Word* const t = c_.block.find('T'); t != nullptr && !selects(*t)) return flow.failed(false);
  return std::nullopt;
}

/// Before the first line: what the files of the machine say.
bool LinuxCncLanguage::start(StatementFlow& flow) {
  started_ = true;
  if (!machine_.faults.empty())
    return c_.fail("machine-file", "[control.linuxcnc] " + machine_.faults.front());
  takeKept();
  if (const auto axes = c_.settings.texts.find(kLcnAssumedAxes); axes != c_.settings.texts.end()) {
    c_.warn(
        "axes",
        fmt::format("the job names no axes beside X, Y, Z ([machine], axes of [control.linuxcnc]): {} of the "
                    "program turn the part about X, Y, Z for A, B, C",
                    axes->second),
        {}, Severity::kNote);
  }
  for (const std::string& line : machine_.startup)
    if (!runLine(line, flow)) return false;
  return true;
}

/// What the .var file keeps: the shift of G92, homes and frames are in force with the first line.
void LinuxCncLanguage::takeKept() {
  if (machine_.kept.empty()) return;
  for (const auto& [number, value] : machine_.kept)
    if (!lcnReadOnly(number)) assign(number, Value{value});
  LinuxCncChannel& own = linuxCncChannel(c_);
  if (own.shift_on) c_.registers.frames.shift92 = own.shift;
  for (const auto& [number, value] : machine_.kept) {
    const auto whole = static_cast<int>(value);
    if (number == 5220 && value == whole && whole >= 1 && whole <= 9)
      c_.state.work_system = linuxCncSystem(whole);
  }
  c_.chain = c_.chainOf(c_.state);
  c_.position = c_.chain.programOf(c_.machine);
  c_.rebasePipe();
}

/// Whether T names a tool of the table. False: reported.
bool LinuxCncLanguage::selects(const Word& t) {
  std::int64_t number = 0;
  if (!lcnInteger(t.value, number)) return functionFails(t, "integer", "Non integer value for integer");
  if (number < 0) return functionFails(t, "tool", "Negative tool id (tool not found)");
  return knowsTool(static_cast<int>(number)) || unknownTool(t);
}

/// M47 of Mach3.
bool LinuxCncLanguage::repeatsProgram() const {
  if (linuxCncFlavour(c_) != LinuxCncFlavour::kMach3) return false;
  for (const Word& w : c_.block.words)
    if (w.address == 'M' && w.value == 47.0) return true;
  return false;
}

bool LinuxCncLanguage::isReturn() const {
  for (const Word& w : c_.block.words)
    if (w.address == 'M' && w.value == 99.0) return true;
  return false;
}

std::optional<Go> LinuxCncLanguage::endOfText(StatementFlow& flow) {
  const SourceText& text = *c_.calls.top().text;
  if (c_.calls.depth() > 1) {
    c_.block.clear();
    c_.fail("missing-end",
            fmt::format("EOF in file:{}: the sub ends without endsub, return or M99", text.name()));
    return flow.failed(true);
  }
  const auto known = percent_.find(&text);
  if (known != percent_.end() && known->second) return flow.endRun("%");
  return {};
}

void LinuxCncLanguage::left(const CallFrame& /*frame*/) {
  if (open_.empty()) return;
  if (open_.back().sub) variables_.leave();
  if (open_.back().contour && contour_) contour_->done = true;
  open_.pop_back();
}

std::uint64_t LinuxCncLanguage::fingerprint() const {
  std::uint64_t repeats = 0;
  for (const Repeat& r : repeats_) repeats = repeats * 31 + static_cast<std::uint64_t>(r.left);
  const int contour = contour_ ? contour_->done ? 3 : 2 : 0;
  return variables_.fingerprint() + mixBits(repeats + 1) + (seeking_ ? 1 : 0) + (break_left_ ? 4 : 0) +
         (continue_left_ ? 8 : 0) + static_cast<std::uint64_t>(contour) * 16;
}

}  // namespace proveout::nc
