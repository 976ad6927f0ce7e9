#include "core/nc/lexer.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace proveout::nc {
namespace {

constexpr bool isBlank(char c) { return c == ' ' || c == '\t'; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
constexpr bool isLetter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

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

bool Lexer::fail(const char* code, std::string message, std::size_t begin, std::size_t end) {
  error_ = {code, std::move(message), {static_cast<int>(begin) + 1, static_cast<int>(end) + 1}};
  return false;
}

bool Lexer::lex(std::string_view line, Block& block) {
  block.clear();
  block.text = line;
  std::size_t i = 0;
  while (i < line.size()) {
    const char c = line[i];
    if (in_comment_) {
      in_comment_ = c != ')';
      ++i;
    } else if (isBlank(c)) {
      ++i;
    } else if (c == '(') {
      in_comment_ = true;
      ++i;
    } else if (isLetter(c) || c == ',') {
      if (!lexWord(line, i, block)) return false;
    } else if (c == '/') {
      if (!lexSkip(line, i, block)) return false;
    } else if (c == '<') {
      if (!lexFile(line, i, block)) return false;
    } else if (c == '%') {
      if (!block.empty() || block.number >= 0) {
        return fail("nct-2064", "% stands alone at the start of a line", i, i + 1);
      }
      block.percent = true;
      ++i;
    } else if ((c == '#' || c == '[') && rules_.expressions == nullptr) {
      return fail("nct-2123", "macro variables and expressions are not supported", i, line.size());
    } else {
      return fail("nct-2064", "syntax error: " + shown(c) + " does not start a word", i, i + 1);
    }
  }
  return true;
}

bool Lexer::lexSkip(std::string_view line, std::size_t& i, Block& block) {
  const std::size_t begin = i++;
  int n = 1;
  if (i < line.size() && isDigit(line[i])) n = line[i++] - '0';
  if (n == 0 || (i < line.size() && isDigit(line[i]))) {
    return fail("nct-2002", "optional skip is /1 to /9", begin, i + 1);
  }
  if (!block.empty() || block.number >= 0 || block.program >= 0 || block.skip != 0) {
    return fail("nct-2064", "optional skip must stand at the start of the block", begin, i);
  }
  block.skip = n;
  return true;
}

bool Lexer::lexFile(std::string_view line, std::size_t& i, Block& block) {
  const std::size_t begin = i;
  const std::size_t close = line.find('>', i);
  if (close == std::string_view::npos) return fail("nct-2064", "'<' without '>'", begin, line.size());
  if (block.has_file) return fail("nct-2064", "two file names in one block", begin, close + 1);
  block.has_file = true;
  block.file_arg = line.substr(begin + 1, close - begin - 1);
  block.file_columns = {static_cast<int>(begin) + 1, static_cast<int>(close) + 2};
  i = close + 1;
  return true;
}

bool Lexer::lexAddress(std::string_view line, std::size_t& i, Word& word) {
  const std::size_t begin = i;
  if (line[i] != ',') {
    word.address = upper(line[i++]);
    return true;
  }
  ++i;
  while (i < line.size() && isBlank(line[i])) ++i;
  const char c = i < line.size() ? upper(line[i]) : '\0';
  if (!rules_.comma_addresses || (c != 'C' && c != 'R' && c != 'A')) {
    return fail("nct-2064", "a comma must be followed by C, R or A", begin, i);
  }
  word.address = c == 'C' ? kCommaChamfer : c == 'R' ? kCommaRounding : kCommaDirection;
  ++i;
  return true;
}

bool Lexer::lexWord(std::string_view line, std::size_t& i, Block& block) {
  const std::size_t begin = i;
  Word word;
  if (!lexAddress(line, i, word)) return false;
  if (rules_.incremental_operator && i < line.size() && upper(line[i]) == 'I' &&
      rules_.incremental_addresses.has(word.address)) {
    word.incremental = true;
    ++i;
  }
  while (i < line.size() && isBlank(line[i])) ++i;
  if (!lexValue(line, i, word)) {
    error_.columns.begin = static_cast<int>(begin) + 1;
    return false;
  }
  word.columns = {static_cast<int>(begin) + 1, static_cast<int>(i) + 1};
  word.is_integer = word.value == std::floor(word.value);
  return store(word, block);
}

bool Lexer::lexValue(std::string_view line, std::size_t& i, Word& word) {
  const std::size_t begin = i;
  const char c = i < line.size() ? line[i] : '\0';
  const auto name = addressText(word.address);
  if (c == '#' || c == '[') {
    if (rules_.expressions == nullptr) {
      return fail("nct-2123", "macro variables and expressions are not supported", begin, line.size());
    }
    std::string message;
    if (!rules_.expressions->evaluate(line, i, word.value, message))
      return fail("nct-2064", message, begin, i);
    return true;
  }
  if (c == '=') {
    return fail("nct-2064", fmt::format("'=' after {}: no axis or spindle of that name is configured", name),
                begin, i + 1);
  }
  if (!lexNumber(line, i, word)) return false;
  if (i < line.size() && line[i] == '=') {
    return fail("nct-2064", "'=': no axis or spindle of that name is configured", begin, i + 1);
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
      if (point) return fail("nct-2064", fmt::format("{}: second decimal point", name), begin, i + 1);
      point = true;
      continue;
    }
    if (!isDigit(c)) break;
    ++digits;
    if (point) ++fraction;
    if (significant > 0 || c != '0') ++significant;
    if (significant <= kExactDigits) mantissa = mantissa * 10 + static_cast<unsigned>(c - '0');
  }
  if (digits == 0)
    return fail("nct-2064", fmt::format("{} has no value", name), begin, std::max(i, begin + 1));
  if (significant - fraction > kExactDigits) {
    return fail("nct-2002", fmt::format("{}: number has more than 15 digits", name), begin, i);
  }
  if (significant <= kExactDigits && fraction <= kExactDigits) {
    word.value = static_cast<double>(mantissa) / kPowersOfTen[fraction];
  } else {
    const char* first = line.data() + digits_begin;
    std::from_chars(first, line.data() + i, word.value, std::chars_format::fixed);
  }
  if (word.value > kMaxValue) return fail("nct-2002", fmt::format("{}: value out of range", name), begin, i);
  if (negative && rules_.unsigned_addresses.has(word.address)) {
    return fail("nct-2002", fmt::format("{} takes no minus sign", name), begin, i);
  }
  if (negative && word.value != 0.0) word.value = -word.value;
  return true;
}

bool Lexer::store(const Word& word, Block& block) {
  const auto integer = [&](std::int64_t max) {
    return word.is_integer && word.value <= static_cast<double>(max);
  };
  const auto begin = static_cast<std::size_t>(word.columns.begin - 1);
  const auto end = static_cast<std::size_t>(word.columns.end - 1);
  if (word.address == 'N') {
    if (!integer(99999999))
      return fail("nct-2002", "N: block numbers are integers up to 99999999", begin, end);
    if (block.number >= 0) return fail("nct-2064", "two N words in one block", begin, end);
    block.number = static_cast<std::int64_t>(word.value);
    block.number_columns = word.columns;
    return true;
  }
  if (word.address == 'O') {
    if (!integer(99999999))
      return fail("nct-2002", "O: program numbers are integers up to 99999999", begin, end);
    if (block.program >= 0) return fail("nct-2064", "two O words in one block", begin, end);
    block.program = static_cast<std::int64_t>(word.value);
    block.program_columns = word.columns;
    return true;
  }
  if (block.present.has(word.address) && !rules_.repeatable.has(word.address)) {
    return fail("nct-duplicate-word", fmt::format("two {} in one block", addressText(word.address)), begin,
                end);
  }
  block.present.add(word.address);
  block.words.push_back(word);
  return true;
}

}  // namespace proveout::nc
