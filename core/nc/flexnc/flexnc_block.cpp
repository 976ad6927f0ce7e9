#include "core/nc/flexnc/flexnc_block.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/characters.h"
#include "core/nc/macro/expression.h"

namespace proveout::nc {

namespace {

constexpr int kLastLabel = 99'999'999;
constexpr int kMostRepeats = 1'000'000;
/// Beyond this no word has a meaning, mm, seconds or 1/min.
constexpr double kMostValue = 1e7;

/// G and M have numbers with one decimal at most.
void readCode(FlexWord& word) {
  if (word.address != 'G' && word.address != 'M') return;
  const double tenths = 10.0 * word.value, rounded = std::round(tenths);
  if (word.value >= 0.0 && word.value < 1000.0 && std::abs(tenths - rounded) < 1e-6)
    word.tenths = static_cast<int>(rounded);
}

}  // namespace

std::int64_t flexLabelOf(std::string_view line) {
  std::size_t pos = line.find_first_not_of(" \t");
  if (pos == std::string_view::npos || upper(line[pos]) != 'N') return -1;
  std::int64_t number = -1;
  const char* const first = line.data() + pos + 1;
  const auto parsed = std::from_chars(first, line.data() + line.size(), number);
  return parsed.ec == std::errc() && isDigit(*first) && number <= kLastLabel ? number : -1;
}

bool FlexReader::fail(const char* code, std::string message, std::size_t from, std::size_t to) {
  error_ = {code, std::move(message), flexColumns(from, to)};
  return false;
}

void FlexReader::skipBlanks() {
  while (isBlank(peek()) || peek() == '\r') ++at_;
}

bool FlexReader::atEnd() {
  skipBlanks();
  return at_ >= line_.size() || (peek() == '/' && peek(1) == '/');
}

bool FlexReader::keyword(std::string_view word) {
  if (!keywordAt(line_, at_, word)) return false;
  at_ += word.size();
  return true;
}

bool FlexReader::label(std::int64_t& out) {
  int number = 0;
  if (!evaluator_.whole(line_, at_, kLastLabel, number)) {
    error_ = evaluator_.error();
    error_.message = "the number of a label stands here: " + error_.message;
    return false;
  }
  out = number;
  return true;
}

bool FlexReader::read(std::string_view line, FlexBlock& block) {
  line_ = line;
  at_ = 0;
  block.text = line;
  block.number = -1;
  block.words.clear();
  block.jump.reset();
  block.assigns = false;
  block.odd_variable = {};
  if (!atEnd() && upper(peek()) == 'N') {
    ++at_;
    if (!label(block.number)) return false;
  }
  while (!atEnd()) {
    if (!statement(block)) return false;
  }
  return true;
}

bool FlexReader::statement(FlexBlock& block) {
  const std::size_t from = at_;
  if (block.jump) return fail("fnc-syntax", "GOSUB, RET and REPEAT end their block", from, line_.size());
  if (keyword("GOSUB")) return call(block);
  if (keyword("REPEAT")) return repeat(block);
  if (keyword("RETURN") || keyword("RET")) {
    block.jump = FlexJump{.columns = flexColumns(from, at_)};
    return true;
  }
  bool is_assignment = false;
  if (!assignment(block, is_assignment)) return false;
  return is_assignment || word(block);
}

bool FlexReader::call(FlexBlock& block) {
  FlexJump jump;
  const std::size_t from = at_ - 5;
  skipBlanks();
  jump.kind = FlexJump::Kind::kCall;
  if (!label(jump.label)) return false;
  jump.columns = flexColumns(from, at_);
  block.jump = jump;
  return true;
}

/// REPEATn(Pv)FROMlabel
bool FlexReader::repeat(FlexBlock& block) {
  FlexJump jump;
  const std::size_t from = at_ - 6;
  jump.kind = FlexJump::Kind::kRepeat;
  skipBlanks();
  if (!evaluator_.whole(line_, at_, kMostRepeats, jump.count) || jump.count < 1) {
    return fail("fnc-repeat",
                fmt::format("REPEAT needs the number of repeats, 1 to {}: REPEAT3FROM600", kMostRepeats),
                from, at_);
  }
  skipBlanks();
  if (peek() == '(') {
    ++at_;
    const bool named = upper(peek()) == 'P';
    ++at_;
    if (!named || !evaluator_.whole(line_, at_, FlexVariables::kLast, jump.counter) || peek() != ')')
      return fail("fnc-repeat", "the counter of REPEAT is a variable in parentheses: (P293)", from, at_);
    ++at_;
    skipBlanks();
  }
  if (!keyword("FROM")) return fail("fnc-repeat", "FROM and a label are missing: REPEAT3FROM600", from, at_);
  skipBlanks();
  if (!label(jump.label)) return false;
  jump.columns = flexColumns(from, at_);
  block.jump = jump;
  return true;
}

/// `P1100=...`; `is_one` false: something else stands here.
bool FlexReader::assignment(FlexBlock& block, bool& is_one) {
  if (upper(peek()) != 'P') return true;
  const std::size_t from = at_;
  std::size_t behind = at_ + 1;
  while (behind < line_.size() && isDigit(line_[behind])) ++behind;
  const std::size_t digits_end = behind;
  while (behind < line_.size() && isBlank(line_[behind])) ++behind;
  if (digits_end == at_ + 1 || behind >= line_.size() || line_[behind] != '=') return true;
  is_one = true;
  if (!block.words.empty())
    return fail("fnc-syntax", "an assignment stands in a block without other words", from, behind);
  int number = 0;
  ++at_;
  if (!evaluator_.whole(line_, at_, FlexVariables::kLast, number)) return notRead(from);
  at_ = behind + 1;
  double value = 0.0;
  if (!evaluator_.expression(line_, at_, value)) return notRead(from);
  noteVariables(block, from);
  if (!FlexVariables::ofPrograms(number)) block.odd_variable = flexColumns(from, digits_end);
  const Columns columns = flexColumns(from, at_);
  variables_.assign(number, value, origins_.assigned(columns, value, evaluator_.reads()));
  block.assigns = true;
  return true;
}

bool FlexReader::notRead(std::size_t from) {
  error_ = evaluator_.error();
  if (error_.columns.begin == 0) error_.columns = flexColumns(from, at_);
  return false;
}

void FlexReader::noteVariables(FlexBlock& block, std::size_t from) {
  if (evaluator_.oddVariable() >= 0 && block.odd_variable.begin == 0)
    block.odd_variable = flexColumns(from, at_);
}

bool FlexReader::word(FlexBlock& block) {
  const std::size_t from = at_;
  FlexWord word;
  word.address = upper(peek());
  if (peek() == '[') {
    return fail("fnc-syntax",
                "[name] is a parameter of a template that nobody has filled in: make the program with "
                "'proveout template'",
                from, from + 1);
  }
  if (peek() == ';') {
    at_ = line_.size();
    if (std::exchange(semicolon_told_, true)) return true;
    return fail("fnc-syntax",
                "';' ends a block or begins a comment on other controls, here // begins one (told once)", from, from + 1);
  }
  if (!isLetter(word.address)) {
    // All of a character of several bytes.
    do ++at_;
    while ((static_cast<unsigned char>(peek()) & 0xC0U) == 0x80U);
    return fail("fnc-syntax",
                fmt::format("'{}' is no address of this control", line_.substr(from, at_ - from)), from, at_);
  }
  if (block.assigns)
    return fail("fnc-syntax", "words stand in a block without an assignment", from, from + 1);
  ++at_;
  const char sign = peek();
  if (sign == '-' || sign == '+') ++at_;
  if (!evaluator_.plainValue(line_, at_, word.value)) return notRead(from);
  if (sign == '-') word.value = -word.value;
  noteVariables(block, from);
  word.columns = flexColumns(from, at_);
  word.reads = evaluator_.reads();
  if (!(std::abs(word.value) <= kMostValue)) {
    return fail("fnc-num",
                fmt::format("{} is out of range: at most {:g} is allowed", word.address, kMostValue), from,
                at_);
  }
  readCode(word);
  block.words.push_back(word);
  return true;
}

}  // namespace proveout::nc
