#include "core/nc/wl4/wl4_block.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/characters.h"

namespace proveout::nc {

namespace {

constexpr std::int64_t kMaxBlockNumber = 65535;

/// The range that the control takes at an address (digest wl4, table 2).
struct Range {
  char letter;
  double low, high;
};
constexpr double kTravel = 9999.999;
constexpr std::array<Range, 22> kRanges = {{
    {'A', -kTravel, kTravel},
    {'B', -kTravel, kTravel},
    {'C', -kTravel, kTravel},
    {'D', 0, 127},
    {'E', 0, 99999.999},
    {'F', 0, 99999.999},
    {'H', 0, 127},
    {'I', -kTravel, kTravel},
    {'J', -kTravel, kTravel},
    {'K', -kTravel, kTravel},
    {'L', 0, 9999},
    {'P', 0, kMaxBlockNumber},
    {'Q', 0, kMaxBlockNumber},
    {'R', -99999.999, 99999.999},
    {'S', 0, 65535},
    {'T', 0, 127},
    {'U', -2 * kTravel, 2 * kTravel},
    {'V', -2 * kTravel, 2 * kTravel},
    {'W', -2 * kTravel, 2 * kTravel},
    {'X', -2 * kTravel, 2 * kTravel},
    {'Y', -kTravel, kTravel},
    {'Z', -kTravel, kTravel},
}};

const Range* rangeOf(char letter) {
  const auto at =
      std::find_if(kRanges.begin(), kRanges.end(), [&](const Range& r) { return r.letter == letter; });
  return at == kRanges.end() ? nullptr : &*at;
}

bool wholeNumbered(char letter) { return std::string_view("DHLT").find(letter) != std::string_view::npos; }

/// A sign at most.
bool isSign(std::string_view text) {
  if (text.empty()) return true;
  std::size_t pos = behindBlanks(text, 0);
  if (pos < text.size() && (text[pos] == '-' || text[pos] == '+')) ++pos;
  return behindBlanks(text, pos) == text.size();
}

/// Behind blanks and `/` at the start of the line.
std::size_t startOf(std::string_view line) {
  std::size_t pos = behindBlanks(line, 0);
  if (pos < line.size() && line[pos] == '/') pos = behindBlanks(line, pos + 1);
  return pos;
}

}  // namespace

bool Wl4Block::hasCode(int g_number) const {
  return std::any_of(g.begin(), g.end(), [&](const Code& code) { return code.number == g_number; });
}

std::int64_t blockNumberOf(std::string_view line) {
  std::size_t pos = startOf(line);
  if (line.substr(pos, 1) != "N") return -1;
  std::int64_t number = 0;
  const std::size_t first = ++pos;
  while (pos < line.size() && isDigit(line[pos]) && number <= kMaxBlockNumber) {
    number = 10 * number + (line[pos++] - '0');
  }
  return pos == first ? -1 : number;
}

std::int64_t labelOf(std::string_view line) {
  const std::size_t pos = startOf(line);
  return line.substr(pos, 2) == "N0" ? blockNumberOf(line) : -1;
}

bool Wl4Reader::fail(std::string message, std::size_t from, std::size_t to) {
  error_ = {std::move(message), {static_cast<int>(from) + 1, static_cast<int>(to) + 1}};
  return false;
}

bool Wl4Reader::read(std::string_view line, Wl4Block& block) {
  block = {};
  block.text = line_ = line;
  std::size_t pos = startOf(line);
  block.conditional = line.substr(0, pos).find('/') != std::string_view::npos;
  bool first = true;
  for (pos = behindBlanks(line, pos); pos < line.size(); pos = behindBlanks(line, pos), first = false) {
    const char c = line[pos];
    if (c == '$' || c == '.') {
      const std::size_t from = line.find_first_not_of(" \t*", pos + 1);
      if (from != std::string_view::npos)
        block.comment = line.substr(from, line.find_last_not_of(" \t\r") + 1 - from);
      return true;
    }
    if (c == ';') {
      if (std::exchange(semicolon_told_, true)) return true;
      return fail("';' ends a block or begins a comment on other controls, here $ begins one (told once)", pos, pos + 1);
    }
    if (c == 'N' && first) {
      if (!blockNumber(block, pos)) return false;
    } else if (line.substr(pos, 2) == "IF") {
      bool holds = false;
      block.plain = false;
      if (!condition(pos, holds)) return false;
      if (!holds) return true;
    } else if (!word(block, pos)) {
      return false;
    }
  }
  return true;
}

bool Wl4Reader::blockNumber(Wl4Block& block, std::size_t& pos) {
  const std::size_t from = pos++;
  while (pos < line_.size() && isDigit(line_[pos])) ++pos;
  block.number = blockNumberOf(line_);
  if (block.number < 0) return fail("the number of the block is missing behind N", from, pos);
  return block.number <= kMaxBlockNumber || fail("block numbers go up to 65535", from, pos);
}

bool Wl4Reader::value(std::size_t& pos, double& out) {
  if (evaluator_.evaluate(line_, pos, out)) return true;
  error_ = {evaluator_.error().message, evaluator_.error().columns};
  return false;
}

bool Wl4Reader::condition(std::size_t& pos, bool& holds) {
  const std::size_t from = pos;
  pos += 2;
  int decimals = -1;
  for (; pos < line_.size() && isDigit(line_[pos]); ++pos) {
    decimals = std::min(99, 10 * std::max(decimals, 0) + (line_[pos] - '0'));
  }
  pos = behindBlanks(line_, pos);
  if (line_.substr(pos, 1) != "(") return fail("the condition is missing behind IF: IF(#1>#2)", from, pos);
  if (decimals >= 0) evaluator_.setDecimals(decimals);
  double result = 0.0;
  // The condition is one parenthesis: what stands behind it are words.
  const std::size_t end = pos;
  int depth = 0;
  std::size_t close = end;
  for (; close < line_.size(); ++close) {
    depth += line_[close] == '(' ? 1 : line_[close] == ')' ? -1 : 0;
    if (depth == 0) break;
  }
  const std::string_view whole = line_;
  line_ = line_.substr(0, std::min(close + 1, line_.size()));
  const bool good = value(pos, result);
  line_ = whole;
  if (good) {
    holds = evaluator_.isTrue(result);
    evaluator_.tellLoops(line_.data() + from, result, holds);
  }
  evaluator_.setFullPrecision();
  if (good && std::isnan(result)) return fail("the condition has no value", from, pos);
  return good;
}

bool Wl4Reader::assignment(Wl4Block& block, std::size_t& pos) {
  const std::size_t from = pos++;
  int number = 0;
  double result = 0.0;
  if (!evaluator_.reference(line_, pos, number)) {
    error_ = {evaluator_.error().message, evaluator_.error().columns};
    return false;
  }
  pos = behindBlanks(line_, pos);
  if (line_.substr(pos, 1) != "=") return fail("'=' is missing behind the variable", from, pos);
  ++pos;
  if (!value(pos, result)) return false;
  block.assigns = true;
  block.plain = false;
  ++block.words;
  if (evaluator_.assign(number, result, from, pos)) return true;
  error_ = {evaluator_.error().message, evaluator_.error().columns};
  return false;
}

bool Wl4Reader::integer(char letter, double value, Columns at, std::int64_t& out) {
  if (!(std::abs(value) < 1e9)) {
    error_ = {fmt::format("{} needs a whole number", letter), at};
    return false;
  }
  out = std::llround(value);
  return true;
}

bool Wl4Reader::word(Wl4Block& block, std::size_t& pos) {
  const char letter = line_[pos];
  if (letter == '#') return assignment(block, pos);
  if (letter < 'A' || letter > 'Z') {
    return fail(
        letter >= 'a' && letter <= 'z' ? "addresses are capital letters"
        : letter == '('                ? "a word cannot begin like this; comments begin with $ on this control"
                                       : "a word cannot begin like this",
        pos, pos + 1);
  }
  const std::size_t from = pos++;
  double number = 0.0;
  if (!value(pos, number)) return false;
  const Columns at{static_cast<int>(from) + 1, static_cast<int>(pos) + 1};
  const Wl4Evaluator::Stretch& last = evaluator_.lastNumber();
  const bool bare = last.end == pos && isSign(line_.substr(from + 1, last.begin - from - 1));
  block.plain = block.plain && bare;
  if (block.words < 255) ++block.words;
  std::int64_t whole = 0;
  if (letter == 'N') {
    if (!integer(letter, number, at, whole)) return false;
    block.jump = whole;
    block.jump_columns = at;
    return true;
  }
  if (letter == 'G' || letter == 'M') {
    auto& list = letter == 'G' ? block.g : block.m;
    if (!integer(letter, number, at, whole)) return false;
    if (whole < 0 || whole > 99) return fail(fmt::format("there is no {}{}", letter, whole), from, pos);
    if (list.count == list.at.size()) return fail(fmt::format("too many {} words", letter), from, pos);
    list.at[list.count++] = {static_cast<int>(whole), at, evaluator_.reads()};
    return true;
  }
  const Range* range = rangeOf(letter);
  if (range == nullptr) return fail(fmt::format("the control has no address {}", letter), from, pos);
  if (wholeNumbered(letter)) number = std::round(number);
  if (!(number >= range->low && number <= range->high)) {
    return fail(fmt::format("{}: {} is out of the range {} to {}", letter, number, range->low, range->high),
                from, pos);
  }
  const auto k = static_cast<std::size_t>(letter - 'A');
  block.present.add(letter);
  block.values[k] = number;
  block.columns[k] = at;
  block.reads[k] = evaluator_.reads();
  block.order[k] = block.words;
  return true;
}

}  // namespace proveout::nc
