// From a line to words and assignments.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/base/characters.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/flavours/grbl.h"
#include "core/nc/linuxcnc/program/lcn_language.h"
#include "core/nc/linuxcnc/text/lcn_groups.h"
#include "core/nc/macro/formula_text.h"

namespace proveout::nc {
namespace {

/// Address of a small letter or sign that begins a word; '\0': none does.
Address lcnAddress(char c) {
  if (c == '@') return kNamedWord;
  if (c == '^') return kPolarAngle;
  if (c == '$') return kSpindleNumber;
  return c >= 'a' && c <= 'z' && c != 'n' && c != 'o' ? upper(c) : '\0';
}

}  // namespace

bool LinuxCncLanguage::fault(const char* name, std::string message, std::size_t begin, std::size_t end) {
  fault_ = {name, std::move(message), begin, end};
  return false;
}

bool LinuxCncLanguage::read(const SourceText& text, std::size_t line, Block& block, LexError& error) {
  block.clear();
  block.text = text.lines()[line];
  assignments_.clear();
  o_word_.reset();
  calls_ = false;
  Columns at;
  const bool grbl = isGrbl(c_);
  const std::size_t first = grbl ? block.text.find_first_not_of(" \t") : std::string_view::npos;
  const bool command = first != std::string_view::npos &&
                       std::string_view("$?!~").find(block.text[first]) != std::string_view::npos;
  bool good = !command && takeLcnLine(block.text, line_, fault_);
  if (command) {
    fault("sender-command", "a command of the sender, which no program has: leave the line out", first,
          first + 1);
    at = {static_cast<int>(first) + 1, static_cast<int>(first) + 2};
  } else if (!good) {
    at = {static_cast<int>(fault_.begin) + 1, static_cast<int>(fault_.end) + 1};
  } else if (const GrblFault grbl_fault = plainGrblFault(); grbl_fault.number != 0) {
    error = {c_.alarms.table().code(DiagnosticName(fmt::format("error-{}", grbl_fault.number))),
             fmt::format("error:{} {}", grbl_fault.number, grblMeaning(grbl_fault.number)),
             line_.columnsOf(grbl_fault.begin, grbl_fault.end)};
    return false;
  } else {
    good = line_.text.starts_with('%') ? readPercent(text, line, block) : readItems(0, block);
    if (!good) at = line_.columnsOf(fault_.begin, fault_.end);
  }
  if (good) return true;
  if (const int number = grbl ? grblError(fault_.name) : 0; number != 0) {
    error = {c_.alarms.table().code(DiagnosticName(fmt::format("error-{}", number))),
             fmt::format("error:{} {}", number, fault_.message), at};
    return false;
  }
  error = {c_.alarms.table().code(DiagnosticName(fault_.name)), fault_.message, at};
  return false;
}

/// What GRBL refuses of the line; it takes no %, but senders do not send it.
GrblFault LinuxCncLanguage::plainGrblFault() const {
  if (!isPlainGrbl(c_) || line_.text.starts_with('%')) return {};
  std::string axes;
  for (int axis = kMainAxes; axis < c_.axes.count(); ++axis)
    for (const char letter : c_.axes.at(axis).name) axes += static_cast<char>(letter | 32);
  return grblLineFault(line_.text, axes);
}

/// A % opens a text in its first line that is not blank, and then closes it.
bool LinuxCncLanguage::readPercent(const SourceText& text, std::size_t line, Block& block) {
  const auto& lines = text.lines();
  const auto blank = [](std::string_view l) {
    return l.find_first_not_of(" \t\r") == std::string_view::npos;
  };
  const auto first =
      static_cast<std::size_t>(std::find_if_not(lines.begin(), lines.end(), blank) - lines.begin());
  if (line == first) return true;
  const auto [known, fresh] = percent_.emplace(&text, false);
  if (fresh) known->second = lines[first].substr(lines[first].find_first_not_of(" \t")).starts_with('%');
  if (!known->second) return fault("bad-character", "Bad character '%' used", 0, 1);
  block.percent = true;
  return true;
}

bool LinuxCncLanguage::readItems(std::size_t pos, Block& block) {
  const std::string& text = line_.text;
  if (pos < text.size() && text[pos] == '/') {
    block.skip = isGrbl(c_) ? 0 : 1;  // GRBL drops the sign
    ++pos;
  }
  if (pos < text.size() && text[pos] == 'n' && !readNumber(pos, block)) return false;
  if (pos < text.size() && text[pos] == 'o') {
    block.kind = LineKind::kOwn;
    block.plain = false;
    o_word_.emplace();
    if (!takeLcnOWord(text, pos + 1, *o_word_))
      return fault("o-word", "O-word without a number or a <name>", pos, text.size());
    const bool label = o_word_->keyword == LcnKeyword::kLabel;
    return label || linuxCncFlavour(c_) != LinuxCncFlavour::kMach3 ||
           fault("o-word", "Mach3 has O with a number for M98, and no other O-words", pos, text.size());
  }
  while (pos < text.size()) {
    // GRBL takes N anywhere, and of T what stands in front of the point.
    if (text[pos] == 'n' && isPlainGrbl(c_)) {
      if (!readNumber(pos, block)) return false;
      continue;
    }
    if (text[pos] == '#' ? !readAssignment(pos) : !readWord(pos, block)) return false;
  }
  if (!assignments_.empty()) block.kind = LineKind::kAssignment;
  std::string_view kind, rest;
  if (line_.has_comment && activeComment(kind, rest)) block.kind = LineKind::kOwn;
  if (linuxCncFlavour(c_) == LinuxCncFlavour::kMach3) takeMach3Codes(block);
  return checkCodes(block);
}

bool LinuxCncLanguage::readNumber(std::size_t& pos, Block& block) {
  constexpr std::int64_t kMost = 99'999'999;
  const std::size_t begin = pos++;
  const std::string& text = line_.text;
  std::int64_t number = -1;
  for (; pos < text.size() && isDigit(text[pos]); ++pos)
    number = std::min(kMost, std::max<std::int64_t>(number, 0) * 10 + (text[pos] - '0'));
  if (number < 0)
    return fault("line-number", "Bad format unsigned integer: a line number is N with digits", begin,
                 pos + 1);
  if (pos < text.size() && text[pos] == '.') {  // a part behind the point is allowed and means nothing
    for (++pos; pos < text.size() && isDigit(text[pos]);) ++pos;
  }
  block.number = number;
  block.number_columns = line_.columnsOf(begin, pos);
  return true;
}

bool LinuxCncLanguage::readWord(std::size_t& pos, Block& block) {
  const std::size_t begin = pos;
  const char c = line_.text[pos];
  Word word;
  word.address = lcnAddress(c);
  const bool main = c >= 'x' && c <= 'z';
  const bool further = (c >= 'a' && c <= 'c') || (c >= 'u' && c <= 'w');
  if (main || further) word.axis = static_cast<std::int8_t>(c_.axes.names().axisOfLetter(word.address));
  if (word.address == '\0')
    return fault("bad-character", fmt::format("Bad character '{}' used", c), pos, pos + 1);
  if (further && word.axis < 0 && !otherUse(c)) {
    return fault(
        "bad-character",
        fmt::format("Bad character '{}' used: the machine of the job has no axis {} ([machine], or `axes` of "
                    "[control.linuxcnc])",
                    c, word.address),
        pos, pos + 1);
  }
  ++pos;
  if (!plainValue(pos, word) && !evaluatedValue(pos, word)) {
    fault_.begin = begin;
    return false;
  }
  if (c == 't' && isPlainGrbl(c_)) word.value = std::trunc(word.value);
  word.minus = word.value < 0.0;
  word.columns = line_.columnsOf(begin, pos);
  if (!(std::abs(word.value) <= kMaxValue)) {
    return fault("out-of-range",
                 fmt::format("{} is beyond all machines", line_.text.substr(begin + 1, pos - begin - 1)),
                 begin, pos);
  }
  const bool apart = word.columns.end - word.columns.begin != static_cast<int>(pos - begin);
  if (word.from_expression || apart || main != (word.axis >= 0)) block.plain = false;
  if ((c == 'g' || c == 'm') && !takeCode(word, begin, pos)) return false;
  word.is_integer = word.value == std::floor(word.value);
  return storeWord(word, begin, pos, block);
}

/// Whether the letter of an axis that the machine has not means something else here.
bool LinuxCncLanguage::otherUse(char letter) const {
  // A and B of G68 in Mach3 are the centre; in a contour A and C are corners, U and W steps.
  const bool centre = letter == 'a' || letter == 'b';
  if (centre && linuxCncFlavour(c_) == LinuxCncFlavour::kMach3) return true;
  return letter != 'b' && letter != 'v' && inContour();
}

/// A number with a sign or none, the most common value. False: something else stands there, nothing is read.
bool LinuxCncLanguage::plainValue(std::size_t& pos, Word& word) const {
  const std::string& text = line_.text;
  const char sign = pos < text.size() ? text[pos] : '\0';
  const bool minus = sign == '-';
  const PlainNumber number = plainNumberAt(text, minus || sign == '+' ? pos + 1 : pos);
  const bool goes_on = number.end < text.size() && text[number.end] == '.';
  if (number.digits == 0 || !number.exact() || goes_on) return false;
  const double value = number.value();
  word.value = minus && value != 0.0 ? -value : value;  // no -0
  pos = number.end;
  return true;
}

/// Any other value.
bool LinuxCncLanguage::evaluatedValue(std::size_t& pos, Word& word) {
  const std::size_t begin = pos;
  LcnEvaluator evaluator(line_.text, *this);
  Value value;
  if (!evaluator.value(pos, value)) {
    fault_ = evaluator.fault();
    return false;
  }
  const std::string_view written = std::string_view(line_.text).substr(begin, pos - begin);
  word.from_expression = written.find_first_not_of("0123456789.+-") != std::string_view::npos;
  word.value = value.number == 0.0 ? 0.0 : value.number;  // no -0
  if (word.from_expression) word.reads = c_.origins.listOf(evaluator.reads());
  return true;
}

/// G and M numbers are what lies near.
bool LinuxCncLanguage::takeCode(Word& word, std::size_t begin, std::size_t end) {
  if (word.address == 'G') {
    const double tenfold = std::round(word.value * 10.0);
    if (tenfold < 0.0 || tenfold > 999.0) return fault("g-range", "G-code out of range", begin, end);
    if (std::abs(tenfold - word.value * 10.0) > 1e-3)
      return fault("unknown-code", "Unknown g code used: it has one decimal at most", begin, end);
    word.value = tenfold / 10.0;
    return true;
  }
  std::int64_t number = 0;
  if (!lcnInteger(word.value, number)) return fault("integer", "Non integer value for integer", begin, end);
  if (number == 998 && linuxCncFlavour(c_) == LinuxCncFlavour::kPathPilot)
    return fault("unknown-code",
                 "M998 of PathPilot, to the place of tool changes, is not simulated: program G30", begin,
                 end);
  if ((number < 0 || number > 199) && !machine_.remaps.contains(fmt::format("M{}", number)))
    return fault(
        "m-range",
        fmt::format("M-code greater than 199: M{}; subs for codes of the machine are given by `remap` or "
                    "`ini` of [control.linuxcnc]",
                    number),
        begin, end);
  word.value = static_cast<double>(number);
  return true;
}

bool LinuxCncLanguage::storeWord(const Word& word, std::size_t begin, std::size_t end, Block& block) {
  const bool code = word.address == 'G' || word.address == 'M';
  if (!code && block.present.has(word.address)) {
    return fault("duplicate-word", fmt::format("Multiple {} words on one line", line_.text[begin]), begin,
                 end);
  }
  block.present.add(word.address);
  block.words.push_back(word);
  if (word.address == 'M') calls_ = calls_ || word.value == 98.0 || word.value == 99.0;
  return true;
}

bool LinuxCncLanguage::readAssignment(std::size_t& pos) {
  const std::size_t begin = pos;
  LcnEvaluator evaluator(line_.text, *this);
  Assignment assignment;
  if (!evaluator.parameter(pos, assignment.to)) {
    fault_ = evaluator.fault();
    return false;
  }
  if (pos >= line_.text.size() || line_.text[pos] != '=')
    return fault("equal-sign", "Equal sign missing in parameter setting", begin, pos + 1);
  evaluator.forget();
  if (!evaluator.value(++pos, assignment.value)) {
    fault_ = evaluator.fault();
    return false;
  }
  const LcnParameter& to = assignment.to;
  if (to.number >= 0 ? lcnReadOnly(to.number) : lcnPredefined(c_, run_, to.name).has_value()) {
    return fault("read-only",
                 to.number >= 0 ? fmt::format("Parameter is readonly: #{}", to.number)
                                : fmt::format("Cannot assign to read-only parameter #<{}>", to.name),
                 begin, pos);
  }
  assignment.value.vacant = false;
  assignment.value.origin = c_.origins.assigned(line_.columnsOf(begin, pos), assignment.value.number,
                                                c_.origins.listOf(evaluator.reads()));
  assignments_.push_back(assignment);
  return true;
}

/// Codes of one modal group, and codes that nobody knows.
bool LinuxCncLanguage::checkCodes(const Block& block) {
  if (!block.present.has('G') && !block.present.has('M')) return true;
  std::uint32_t g_groups = 0, m_groups = 0;
  for (const Word& w : block.words) {
    if (w.address != 'G' && w.address != 'M') continue;
    const bool g = w.address == 'G';
    const int group = g ? lcnGroupOfG(static_cast<int>(std::round(w.value * 10.0)))
                        : lcnGroupOfM(static_cast<int>(w.value));
    if (group < 0) continue;  // the code table tells
    std::uint32_t& seen = g ? g_groups : m_groups;
    if ((seen >> group & 1u) != 0) {
      fault("group-clash", fmt::format("Two {} codes used from same modal group", g ? "g" : "m"), 0, 0);
      fault_.begin = indexOf(w.columns.begin);
      fault_.end = indexOf(w.columns.end - 1) + 1;
      return false;
    }
    seen |= 1u << group;
  }
  return true;
}

std::size_t LinuxCncLanguage::indexOf(int column) const {
  const auto found = std::lower_bound(line_.columns.begin(), line_.columns.end(), column);
  return static_cast<std::size_t>(found - line_.columns.begin());
}

}  // namespace proveout::nc
