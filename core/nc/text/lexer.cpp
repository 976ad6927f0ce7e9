#include "core/nc/text/lexer.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/characters.h"
#include "core/nc/macro/loop_index.h"

namespace proveout::nc {
namespace {

constexpr double kPowersOfTen[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
/// Digits that an exact 64-bit integer mantissa and one exact division turn into the nearest double.
constexpr int kExactDigits = 15;

std::string shown(char c) {
  const auto u = static_cast<unsigned char>(c);
  if (u >= 0x20 && u < 0x7F) return fmt::format("'{}'", c);
  return fmt::format("byte 0x{:02X}", u);
}

}  // namespace

bool Lexer::fail(SharedAlarm alarm, std::string_view subject, std::string_view detail, std::size_t begin,
                 std::size_t end) {
  error_ = {alarms_.code(alarm),
            alarms_.message(alarm, subject, detail),
            {static_cast<int>(begin) + 1, static_cast<int>(end) + 1}};
  return false;
}

bool Lexer::syntax(std::string_view detail, std::size_t begin, std::size_t end) {
  return fail(SharedAlarm::kSyntax, {}, detail, begin, end);
}

bool Lexer::failNumber(SharedAlarm alarm, SharedAlarm usual, std::string_view subject,
                       std::string_view detail, std::size_t begin, std::size_t end) {
  if (rules_.number_alarms) return fail(alarm, subject, {}, begin, end);
  return fail(usual, usual == SharedAlarm::kSyntax ? std::string_view() : subject, detail, begin, end);
}

namespace {

bool keyword(std::string_view text, std::size_t pos, std::string_view word) {
  if (pos + word.size() > text.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (upper(text[pos + k]) != word[k]) return false;
  }
  return true;
}

}  // namespace

LineKind classify(std::string_view text, std::size_t pos) {
  if (pos >= text.size()) return LineKind::kBlock;
  const auto is = [&](std::string_view word) { return keyword(text, pos, word); };
  switch (upper(text[pos])) {
    case '#':
      return LineKind::kAssignment;
    case 'I':
      return is("IF") ? LineKind::kIf : LineKind::kBlock;
    case 'W':
      return is("WHILE") ? LineKind::kWhile : LineKind::kBlock;
    case 'D':
      return is("DO") ? LineKind::kDo : is("DPRNT") ? LineKind::kOutput : LineKind::kBlock;
    case 'E':
      return is("END") ? LineKind::kEnd : LineKind::kBlock;
    case 'G':
      return is("GOTO") ? LineKind::kGoto : LineKind::kBlock;
    case 'B':
      return is("BPRNT") ? LineKind::kOutput : LineKind::kBlock;
    case 'P':
      return is("POPEN") || is("PCLOS") ? LineKind::kOutput : LineKind::kBlock;
    case 'F':
      return is("FOPEN") || is("FCLOS") ? LineKind::kOutput : LineKind::kBlock;
    default:
      return LineKind::kBlock;
  }
}

bool Lexer::lex(std::string_view line, Block& block, std::size_t from) {
  block.clear();
  block.text = line;
  block.plain = !in_comment_ && from == 0;
  plain_ = &block.plain;
  nested_ = false;
  const bool good = lexItems(line, from, block, rules_.expressions != nullptr && mode_ == LexMode::kBlock);
  if (rules_.comments_end_in_line) endComment(block, from);
  if (good) return true;
  if (!nested_ || rules_.comments_end_in_line) return false;
  const auto at = static_cast<std::size_t>(error_.columns.begin - 1);
  return syntax("comments do not nest: a ( stands inside of one, and the first ) has closed it", at,
                static_cast<std::size_t>(error_.columns.end - 1));
}

/// Tells what is odd about the comments of the line, and ends one that is open.
void Lexer::endComment(Block& block, std::size_t from) {
  in_comment_ = false;
  if (block.text.find('(', from) == std::string_view::npos) return;
  std::size_t open = std::string_view::npos;
  const auto columns = [](std::size_t at) {
    return Columns{static_cast<int>(at) + 1, static_cast<int>(at) + 2};
  };
  for (std::size_t i = from; i < block.text.size(); ++i) {
    const char c = block.text[i];
    const bool inside = open != std::string_view::npos;
    if (c == '(' && inside && block.nested_at.begin == 0) block.nested_at = columns(i);
    if (c == '(' && !inside) open = i;
    if (c == ')') open = std::string_view::npos;
  }
  if (open != std::string_view::npos) block.open_at = columns(open);
}

/// What starts no word here but does on other controls. `comment`: the rest of the line is to be left out.
bool Lexer::foreignSign(std::string_view line, std::size_t i, bool& comment) {
  comment = line[i] == ';' && semicolon_told_;
  if (comment) return true;
  if (rules_.number_alarms && line[i] != '#')
    return fail(SharedAlarm::kCharacter, shown(line[i]), {}, i, i + 1);
  if (line[i] == ')') return syntax("')' without '('", i, i + 1);
  if (line[i] == '#' && rules_.expressions != nullptr)
    return fail(SharedAlarm::kMixedBlock, {}, "'#' does not start a word", i, i + 1);
  if (line[i] != ';') return syntax(shown(line[i]) + " does not start a word", i, i + 1);
  semicolon_told_ = true;
  return syntax(
      "';' ends a block or begins a comment on other controls, here comments stand in ( ) (told once)", i,
      i + 1);
}

bool Lexer::lexRest(std::size_t pos, Block& block) {
  block.kind = LineKind::kBlock;
  block.plain = false;
  plain_ = &block.plain;
  in_comment_ = false;
  return lexItems(block.text, pos, block, false);
}

void Lexer::leaveStatement(std::string_view rest) {
  for (const char c : rest) in_comment_ = in_comment_ ? c != ')' : c == '(';
}

bool Lexer::lexItems(std::string_view line, std::size_t i, Block& block, bool head) {
  while (i < line.size()) {
    const char c = line[i];
    if (in_comment_) {
      in_comment_ = c != ')';
      nested_ = nested_ || c == '(';
      ++i;
    } else if (isBlank(c)) {
      ++i;
    } else if (c == '(') {
      in_comment_ = true;
      ++i;
    } else if (isLetter(c) || c == ',' || (c == '#' && head)) {
      if (head && upper(c) != 'N' && upper(c) != 'O') {
        head = false;
        block.kind = classify(line, i);
        if (rules_.short_while && whileLength(line, i) == 2) block.kind = LineKind::kWhile;
        if (rules_.names_variables && upper(c) == 'S' && keyword(line, i, "SETVN"))
          block.kind = LineKind::kNames;
        if (block.kind != LineKind::kBlock) {
          block.statement = i;
          leaveStatement(line.substr(i));
          return true;
        }
      }
      if (!lexWord(line, i, block)) return false;
    } else if (c == ':' && rules_.colon_program) {
      if (!lexWord(line, i, block)) return false;
    } else if (c == '/') {
      if (!lexSkip(line, i, block)) return false;
      if (i == line.size()) return true;
    } else if (c == '<') {
      if (!lexFile(line, i, block)) return false;
    } else if (c == '%') {
      if (!block.empty() || block.number >= 0) {
        return syntax("% stands alone at the start of a line", i, i + 1);
      }
      block.percent = true;
      const std::size_t name = line.find_first_not_of(" \t", i + 1);
      const bool number = name != std::string_view::npos && upper(line[name]) == 'O' &&
                          name + 1 < line.size() && isDigit(line[name + 1]);
      if (name != std::string_view::npos && line[name] != '(' && line[name] != '%' && !number) return true;
      ++i;
    } else if ((c == '#' || c == '[') && rules_.expressions == nullptr) {
      return fail(SharedAlarm::kNotImplemented, "macro variables and expressions", {}, i, line.size());
    } else {
      bool comment = false;
      if (!foreignSign(line, i, comment)) return false;
      if (comment) return true;
    }
  }
  return true;
}

bool Lexer::lexSkip(std::string_view line, std::size_t& i, Block& block) {
  const std::size_t begin = i++;
  int n = 1;
  if (i < line.size() && isDigit(line[i])) n = line[i++] - '0';
  if (n == 0 || (i < line.size() && isDigit(line[i]))) {
    return fail(SharedAlarm::kOutOfRange, "/", "optional skip is /1 to /9", begin, i + 1);
  }
  const bool inside = !block.empty() || block.number >= 0 || block.program >= 0 || block.skip != 0;
  if (inside && rules_.skip_anywhere) {
    block.plain = false;
    if ((rules_.skip_switches >> (n - 1) & 1) != 0) i = line.size();
    return true;
  }
  if (!block.empty() || block.number >= 0 || block.program >= 0 || block.skip != 0) {
    return syntax("optional skip must stand at the start of the block", begin, i);
  }
  block.skip = n;
  return true;
}

bool Lexer::lexFile(std::string_view line, std::size_t& i, Block& block) {
  const std::size_t begin = i;
  const std::size_t close = line.find('>', i);
  if (close == std::string_view::npos) return syntax("'<' without '>'", begin, line.size());
  if (block.has_file) return syntax("two file names in one block", begin, close + 1);
  block.has_file = true;
  block.file_arg = line.substr(begin + 1, close - begin - 1);
  block.file_columns = {static_cast<int>(begin) + 1, static_cast<int>(close) + 2};
  i = close + 1;
  return true;
}

bool Lexer::lexAddress(std::string_view line, std::size_t& i, Word& word) {
  const std::size_t begin = i;
  if (line[i] != ',') {
    word.address = line[i] == ':' ? 'O' : upper(line[i]);
    ++i;
    return true;
  }
  ++i;
  while (i < line.size() && isBlank(line[i])) ++i;
  const char c = i < line.size() ? upper(line[i]) : '\0';
  if (!rules_.comma_addresses || (c != 'C' && c != 'R' && c != 'A')) {
    return syntax("a comma must be followed by C, R or A", begin, i);
  }
  word.address = c == 'C' ? kCommaChamfer : c == 'R' ? kCommaRounding : kCommaDirection;
  ++i;
  return true;
}

bool Lexer::lexAxisByNumber(std::string_view line, std::size_t& i, Word& word) {
  const std::size_t begin = i;
  i += 2;  // AX
  Value value;
  if (!rules_.expressions->evaluate(line, i, value, error_)) return false;
  const bool whole =
      !value.vacant && value.number == std::floor(value.number) && std::abs(value.number) < 1e6;
  const int axis = whole ? rules_.names->axisByNumber(static_cast<int>(value.number)) : -1;
  if (axis < 0) {
    return fail(SharedAlarm::kAxisNumber, fmt::format("{}", value.number), {}, begin, i);
  }
  word.axis = static_cast<std::int8_t>(axis);
  word.address = rules_.names->addressOf(axis);
  while (i < line.size() && isBlank(line[i])) ++i;
  if (i >= line.size() || line[i] != '=') {
    return syntax("AX[number] is followed by '='", begin, i);
  }
  ++i;
  return true;
}

/// Names of several characters. `named` tells whether one stands here.
bool Lexer::lexNamed(std::string_view line, std::size_t& i, Word& word, bool& named) {
  named = false;
  if (rules_.expressions && keyword(line, i, "AX[")) {
    named = true;
    return lexAxisByNumber(line, i, word);
  }
  const LexNames::Name* name = rules_.names->match(line, i);
  if (name == nullptr) return true;
  std::size_t next = i + name->text.size();
  while (next < line.size() && isBlank(line[next])) ++next;
  const bool equals = next < line.size() && line[next] == '=';
  // Without '=' the digit belongs to a value: with a spindle S1, S1500 is a speed of plain S.
  if (!equals && name->endsInDigit()) return true;
  named = true;
  word.axis = name->axis;
  word.spindle = name->spindle;
  word.address = kNamedWord;
  i = equals ? next + 1 : i + name->text.size();
  return true;
}

bool Lexer::lexWord(std::string_view line, std::size_t& i, Block& block) {
  const std::size_t begin = i;
  Word word;
  bool named = false;
  if (rules_.names != nullptr && line[i] != ',' && !lexNamed(line, i, word, named)) return false;
  if (named) {
    block.plain = false;
  } else if (!lexAddress(line, i, word)) {
    return false;
  }
  if (!named && rules_.names != nullptr && word.address >= 'A' && word.address <= 'Z') {
    word.axis = static_cast<std::int8_t>(rules_.names->axisOfLetter(word.address));
  }
  if (rules_.incremental_operator && i < line.size() && upper(line[i]) == 'I' &&
      (word.axis >= 0 || word.spindle >= 0 || rules_.incremental_addresses.has(word.address))) {
    word.incremental = true;
    block.steps = true;
    ++i;
  }
  while (i < line.size() && isBlank(line[i])) ++i;
  if (word.address == 'O' && rules_.named_programs && i < line.size() && line[i] == '<')
    return lexFile(line, i, block);
  bool vacant = false;
  if (!lexValue(line, i, word, vacant)) {
    error_.columns.begin = static_cast<int>(begin) + 1;
    return false;
  }
  if (vacant) return true;  // as if it were not there (manual 23.1.6)
  word.columns = {static_cast<int>(begin) + 1, static_cast<int>(i) + 1};
  if (word.minus && rules_.unsigned_addresses.has(word.address) && !keepMinus(word, block)) return false;
  word.is_integer = word.value == std::floor(word.value);
  return store(word, block);
}

bool Lexer::keepMinus(const Word& word, Block& block) {
  if (!rules_.keep_repeats || word.address == 'O' || (word.address == 'N' && block.number < 0)) {
    return failNumber(SharedAlarm::kSign, SharedAlarm::kOutOfRange, addressText(word.address),
                      "no minus sign here", static_cast<std::size_t>(word.columns.begin - 1),
                      static_cast<std::size_t>(word.columns.end - 1));
  }
  if (block.negative.empty()) block.negative_at = word.columns;
  block.negative.add(word.address);
  return true;
}

/// The letters around `value`, which stands where the value of a word should, are no word and no function.
bool Lexer::noWord(std::string_view line, std::size_t value) {
  std::size_t begin = value, end = value;
  while (begin > 0 && isBlank(line[begin - 1])) --begin;
  if (begin > 0) --begin;  // the address
  while (end < line.size() && isLetter(line[end])) ++end;
  std::string name;
  for (std::size_t k = begin; k < end; ++k) {
    if (!isBlank(line[k])) name += upper(line[k]);
  }
  if (name.starts_with("PRM")) {
    return fail(SharedAlarm::kIllegalAddress, "PRM",
                "parameters are read on the right of an assignment only; G10 L52 writes "
                "them",
                begin, end);
  }
  for (const std::string_view statement : {"GOTO", "IF", "THEN", "WHILE", "DO", "END"}) {
    if (name != statement) continue;
    return fail(SharedAlarm::kMixedBlock, {}, fmt::format("{} cannot stand behind other words", name), begin,
                end);
  }
  const std::string what =
      fmt::format("{} is no word: a word is a letter with a number, text stands in ( )", name);
  if (rules_.number_alarms) return fail(SharedAlarm::kNumberMissing, name.substr(0, 1), what, begin, end);
  return syntax(what, begin, end);
}

bool Lexer::evaluate(std::string_view line, std::size_t& i, Word& word, bool& vacant) {
  const std::size_t begin = i;
  if (word.address == 'N' && mode_ == LexMode::kBlock) {
    return syntax("a block number is a plain number", begin, i + 1);
  }
  Value value;
  error_ = {};
  if (!rules_.expressions->evaluateWord(word.address, line, i, value, error_)) {
    if (isLetter(line[begin]) && error_.code == alarms_.code(SharedAlarm::kSyntax) &&
        error_.columns.begin == static_cast<int>(begin) + 1) {
      return noWord(line, begin);
    }
    if (error_.columns.end == 0) error_.columns.end = static_cast<int>(std::max(i, begin + 1)) + 1;
    return false;
  }
  *plain_ = false;
  word.from_expression = true;
  word.reads = value.origin;
  vacant = value.vacant;
  word.value = value.number == 0.0 ? 0.0 : value.number;  // no -0
  word.minus = word.value < 0.0;
  if (vacant) return true;
  const auto name = addressText(word.address);
  if (!(std::abs(word.value) <= kMaxValue)) {
    return fail(SharedAlarm::kOutOfRange, name, {}, begin, i);
  }
  return true;
}

namespace {

/// Does an expression start at `i`: '#', '[', a function's letter, or a sign before one of them?
bool startsExpression(std::string_view line, std::size_t i) {
  if (i < line.size() && (line[i] == '-' || line[i] == '+')) ++i;
  while (i < line.size() && isBlank(line[i])) ++i;
  return i < line.size() && (line[i] == '#' || line[i] == '[' || isLetter(line[i]));
}

}  // namespace

bool Lexer::lexValue(std::string_view line, std::size_t& i, Word& word, bool& vacant) {
  const std::size_t begin = i;
  const char c = i < line.size() ? line[i] : '\0';
  const auto name = addressText(word.address);
  if (c == '#' || c == '[') {
    if (rules_.expressions == nullptr) {
      return fail(SharedAlarm::kNotImplemented, "macro variables and expressions", {}, begin, line.size());
    }
  }
  if (rules_.expressions != nullptr && !isDigit(c) && startsExpression(line, i)) {
    return evaluate(line, i, word, vacant);
  }
  if (c == '=') {
    return syntax(fmt::format("'=' after {}: no axis or spindle of that name is configured", name), begin,
                  i + 1);
  }
  if (!lexNumber(line, i, word)) return false;
  if (i < line.size() && line[i] == '=') {
    return syntax("'=': no axis or spindle of that name is configured", begin, i + 1);
  }
  return true;
}

bool Lexer::lexNumber(std::string_view line, std::size_t& i, Word& word) {
  const std::size_t begin = i;
  const auto name = addressText(word.address);
  bool negative = false;
  if (i < line.size() && (line[i] == '+' || line[i] == '-')) negative = line[i++] == '-';
  const std::size_t digits_begin = i;
  std::uint64_t mantissa = 0;
  int digits = 0, significant = 0, fraction = 0;
  bool point = false;
  for (; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '.') {
      if (point) {
        return failNumber(SharedAlarm::kPoint, SharedAlarm::kSyntax, name,
                          fmt::format("{}: second decimal point", name), begin, i + 1);
      }
      point = true;
      continue;
    }
    if (!isDigit(c)) break;
    ++digits;
    if (point) ++fraction;
    if (significant > 0 || c != '0') ++significant;
    if (significant <= kExactDigits) mantissa = mantissa * 10 + static_cast<unsigned>(c - '0');
  }
  if (digits == 0) {
    const bool sign = i > begin && i < line.size() && (line[i] == '-' || line[i] == '+');
    return failNumber(sign ? SharedAlarm::kSign : SharedAlarm::kNumberMissing, SharedAlarm::kSyntax, name,
                      fmt::format("{} has no value", name), begin, std::max(i, begin + 1));
  }
  if (rules_.number_alarms && i < line.size() && (line[i] == '-' || line[i] == '+'))
    return fail(SharedAlarm::kSign, name, {}, begin, i + 1);
  word.point = point;
  word.decimals = static_cast<std::uint8_t>(std::min(fraction, 255));
  if (significant - fraction > kExactDigits) {
    return fail(SharedAlarm::kOutOfRange, name, "more than 15 digits", begin, i);
  }
  if (significant <= kExactDigits && fraction <= kExactDigits) {
    word.value = static_cast<double>(mantissa) / kPowersOfTen[fraction];
  } else {
    const char* first = line.data() + digits_begin;
    std::from_chars(first, line.data() + i, word.value, std::chars_format::fixed);
  }
  if (word.value > kMaxValue) return fail(SharedAlarm::kOutOfRange, name, {}, begin, i);
  word.minus = negative;
  if (negative && word.value != 0.0) word.value = -word.value;
  return true;
}

std::size_t blockEnd(std::string_view line, std::size_t from) {
  if (line.find(';', from) == std::string_view::npos) return line.size();
  bool comment = false;
  for (std::size_t i = from; i < line.size(); ++i) {
    if (!comment && line[i] == ';') return i;
    comment = comment ? line[i] != ')' : line[i] == '(';
  }
  return line.size();
}

namespace {

/// Moves `i` behind the value that stands there: a number, a variable, a formula in brackets. False: none
/// does.
bool passValue(std::string_view text, std::size_t& i) {
  const auto blanks = [&] {
    while (i < text.size() && isBlank(text[i])) ++i;
  };
  blanks();
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  blanks();
  while (i < text.size() && text[i] == '#') {
    ++i;
    blanks();
  }
  if (i < text.size() && text[i] == '[') {
    int depth = 0;
    for (; i < text.size(); ++i) {
      if (text[i] == '[') ++depth;
      if (text[i] == ']' && --depth == 0) {
        ++i;
        return true;
      }
    }
    return false;
  }
  int digits = 0;
  for (; i < text.size() && (isDigit(text[i]) || text[i] == '.'); ++i) digits += isDigit(text[i]) ? 1 : 0;
  return digits > 0;
}

/// A statement keeps to this: enough to tell it from a remark.
bool readsAsStatement(std::string_view text, std::size_t i) {
  if (text[i] == '#') {
    const std::size_t equals = text.find('=', i);
    return passValue(text, i) && equals != std::string_view::npos &&
           text.find_first_not_of(" \t", i) == equals;
  }
  if (keyword(text, i, "PCLOS") || keyword(text, i, "POPEN")) return true;
  for (const std::string_view word : {"IF", "WHILE", "GOTO", "DO", "END", "DPRNT", "BPRNT"}) {
    if (!keyword(text, i, word)) continue;
    i += word.size();
    return passValue(text, i);
  }
  return false;
}

}  // namespace

bool readsAsBlock(std::string_view text) {
  bool comment = false, any = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (comment || c == '(' || isBlank(c)) {
      comment = comment ? c != ')' : c == '(';
      ++i;
      continue;
    }
    if (c == '#' || (isLetter(c) && classify(text, i) != LineKind::kBlock)) return readsAsStatement(text, i);
    if (c == '/') {
      ++i;
      while (i < text.size() && isDigit(text[i])) ++i;
      continue;
    }
    if (c == '<') {
      const std::size_t close = text.find('>', i);
      if (close == std::string_view::npos) return false;
      i = close + 1;
      continue;
    }
    if (c == ',') ++i;
    while (i < text.size() && isBlank(text[i])) ++i;
    if (i >= text.size() || !isLetter(text[i])) return false;
    ++i;
    if (!passValue(text, i)) return false;
    any = true;
  }
  return any;
}

namespace {

/// Is there a word of the same axis or spindle already?
bool twiceNamed(const Word& word, const Block& block) {
  return std::any_of(block.words.begin(), block.words.end(), [&](const Word& other) {
    return other.address == kNamedWord && other.axis == word.axis && other.spindle == word.spindle;
  });
}

}  // namespace

bool Lexer::store(const Word& word, Block& block) {
  const auto integer = [&](std::int64_t max) {
    return word.is_integer && word.value <= static_cast<double>(max);
  };
  const auto begin = static_cast<std::size_t>(word.columns.begin - 1);
  const auto end = static_cast<std::size_t>(word.columns.end - 1);
  if (word.address == 'N' && mode_ == LexMode::kBlock) {
    if (block.number >= 0 && rules_.keep_repeats) {
      if (block.repeated.empty()) block.repeated_at = word.columns;
      block.repeated.add('N');
      block.words.push_back(word);
      block.present.add('N');
      return true;
    }
    if (!integer(99999999))
      return fail(SharedAlarm::kOutOfRange, "N", "block numbers are integers up to 99999999", begin, end);
    if (block.number >= 0) return syntax("two N words in one block", begin, end);
    block.number = static_cast<std::int64_t>(word.value);
    block.number_columns = word.columns;
    return true;
  }
  if (word.address == 'O') {
    if (!integer(99999999))
      return fail(SharedAlarm::kOutOfRange, "O", "program numbers are integers up to 99999999", begin, end);
    if (block.program >= 0) return syntax("two O words in one block", begin, end);
    block.program = static_cast<std::int64_t>(word.value);
    block.program_columns = word.columns;
    return true;
  }
  const bool named = word.address == kNamedWord;
  const bool there = block.present.has(word.address) && !rules_.repeatable.has(word.address);
  if (there && (!named || twiceNamed(word, block))) {
    if (rules_.keep_repeats && !named) {
      if (block.repeated.empty()) block.repeated_at = word.columns;
      block.repeated.add(word.address);
    } else {
      return fail(SharedAlarm::kDuplicateWord, wordName(word, block), {}, begin, end);
    }
  }
  block.present.add(word.address);
  block.words.push_back(word);
  return true;
}

}  // namespace proveout::nc
