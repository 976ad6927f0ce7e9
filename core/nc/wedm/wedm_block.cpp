#include "core/nc/wedm/wedm_block.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/base/characters.h"

namespace proveout::nc {

namespace {

/// How the number of an address is written.
struct WedmAddress {
  char letter;
  enum class Value { kWhole, kNumber, kExpression } value;
  int least = 0, most = 0;  ///< digits of whole numbers
};
using WedmValue = WedmAddress::Value;
constexpr WedmAddress kWedmAddresses[] = {
    {'N', WedmValue::kWhole, 1, 4}, {'G', WedmValue::kWhole, 1, 2}, {'M', WedmValue::kWhole, 1, 2},
    {'T', WedmValue::kWhole, 1, 2}, {'P', WedmValue::kWhole, 1, 4}, {'L', WedmValue::kWhole, 1, 3},
    {'C', WedmValue::kWhole, 3, 3}, {'X', WedmValue::kExpression},  {'Y', WedmValue::kExpression},
    {'U', WedmValue::kExpression},  {'V', WedmValue::kExpression},  {'I', WedmValue::kExpression},
    {'J', WedmValue::kExpression},  {'R', WedmValue::kNumber},      {'A', WedmValue::kNumber},
};

const WedmAddress* addressOf(char letter) {
  const auto* const found =
      std::find_if(std::begin(kWedmAddresses), std::end(kWedmAddresses),
                   [&](const WedmAddress& address) { return address.letter == letter; });
  return found == std::end(kWedmAddresses) ? nullptr : found;
}

}  // namespace

const WedmWord* WedmBlock::find(char address) const {
  for (const WedmWord& word : words) {
    if (word.address == address && !word.argument) return &word;
  }
  return nullptr;
}

bool WedmReader::fail(std::string message, std::size_t from, std::size_t to) {
  error_ = {std::move(message), columns(from, std::max(to, from + 1))};
  return false;
}

/// Comments are blanks.
void WedmReader::skipBlanks() {
  while (at_ < end_) {
    if (line_[at_] == '(') {
      const std::size_t close = line_.find(')', at_);
      at_ = close == std::string_view::npos ? end_ : close + 1;
    } else if (isBlank(line_[at_])) {
      ++at_;
    } else {
      return;
    }
  }
}

bool WedmReader::read(std::string_view line, std::size_t begin, std::size_t end, WedmBlock& block) {
  line_ = line;
  at_ = begin;
  end_ = end;
  wants_ = '\0';
  dwell_may_follow_ = false;
  block.skip = block.colon = false;
  block.number = -1;
  block.words.clear();
  block.upper.clear();
  block.assignments.clear();
  if (!atEnd() && peek() == '/') {
    block.skip = true;
    ++at_;
  }
  if (const std::size_t open = line.rfind('('); open != std::string_view::npos && open >= begin && open < end &&
                                                line.find(')', open) == std::string_view::npos)
    return fail("the comment is not closed: ')' is missing", open, open + 1);
  while (!atEnd()) {
    if (!word(block)) return false;
  }
  if (wants_ == 'X') return fail("the code needs an X directly behind it: G04 X, G31 X, G37 X", at_, at_ + 1);
  return true;
}

bool WedmReader::word(WedmBlock& block) {
  const std::size_t from = at_;
  const char letter = upper(peek());
  if (letter == ':') {
    if (block.colon) return fail("a block has one ':' at most", from, from + 1);
    block.colon = true;
    block.colon_at = columns(from, from + 1);
    ++at_;
    return true;
  }
  if (letter == '/') return fail("/ stands at the start of a block only", from, from + 1);
  ++at_;
  if (letter == 'H') return hWord(block, from);
  if (letter == 'Z') return fail("the machine has no motion along Z: remove the word", from, at_);
  const WedmAddress* const address = addressOf(letter);
  if (address == nullptr) {
    // All of a character of several bytes.
    while (at_ < end_ && (static_cast<unsigned char>(line_[at_]) & 0xC0U) == 0x80U) ++at_;
    return fail(fmt::format("'{}' is no address of this control", line_.substr(from, at_ - from)), from, at_);
  }
  if (isBlank(peek()))
    return fail(fmt::format("no blank may stand between {} and its number", letter), from, at_ + 1);
  WedmWord word;
  word.address = letter;
  word.argument = wants_ == letter || (letter == 'T' && dwell_may_follow_);
  const bool by_terms = address->value != WedmValue::kWhole || word.argument;
  if (by_terms ? !terms(word.terms, address->value == WedmValue::kExpression, letter, from)
               : !whole(word, from))
    return false;
  word.columns = columns(from, at_);
  if (wants_ == 'X' && !word.argument)
    return fail("the code in front of this word needs an X directly behind it", from, at_);
  if (letter == 'N') return number(block, word.code, from);
  put(block, std::move(word));
  return true;
}

/// G04, G31 and G37 take the X behind them, G37 a T behind that.
void WedmReader::put(WedmBlock& block, WedmWord word) {
  dwell_may_follow_ = word.argument && word.address == 'X' && dwell_may_follow_;
  wants_ = '\0';
  if (word.address == 'G' && (word.code == 4 || word.code == 31 || word.code == 37)) {
    wants_ = 'X';
    dwell_may_follow_ = word.code == 37;
  }
  (block.colon ? block.upper : block.words).push_back(std::move(word));
}

bool WedmReader::number(WedmBlock& block, int number, std::size_t from) {
  if (!block.empty() || block.number >= 0) return fail("N stands at the start of a block only", from, at_);
  block.number = number;
  return true;
}

bool WedmReader::whole(WedmWord& word, std::size_t from) {
  const WedmAddress& address = *addressOf(word.address);
  const std::size_t first = at_;
  while (isDigit(peek())) ++at_;
  const auto digits = static_cast<int>(at_ - first);
  if (digits < address.least || digits > address.most) {
    const std::string many = address.least == address.most
                                 ? fmt::format("{}", address.most)
                                 : fmt::format("{} to {}", address.least, address.most);
    return fail(fmt::format("{} needs {} digits directly behind it", word.address, many), from, at_);
  }
  std::from_chars(line_.data() + first, line_.data() + at_, word.code);
  return true;
}

bool WedmReader::threeDigits(int& out) {
  if (!isDigit(peek()) || !isDigit(peek(1)) || !isDigit(peek(2)) || isDigit(peek(3))) return false;
  std::from_chars(line_.data() + at_, line_.data() + at_ + 3, out);
  at_ += 3;
  return true;
}

bool WedmReader::hWord(WedmBlock& block, std::size_t from) {
  WedmWord word;
  word.address = 'H';
  if (!threeDigits(word.code)) return fail("H needs 3 digits directly behind it, H001", from, at_ + 1);
  if (wants_ == 'X') return fail("the code in front of this word needs an X directly behind it", from, at_);
  skipBlanks();
  if (peek() != '=') {
    word.columns = columns(from, at_);
    put(block, std::move(word));
    return true;
  }
  ++at_;
  skipBlanks();
  WedmAssignment assignment;
  assignment.h = word.code;
  if (!terms(assignment.terms, true, 'H', from)) return false;
  assignment.columns = columns(from, at_);
  block.assignments.push_back(std::move(assignment));
  return true;
}

bool WedmReader::terms(std::vector<WedmTerm>& out, bool expression, char address, std::size_t from) {
  out.emplace_back();
  if (!term(out.back(), expression, address, from)) return false;
  while (expression && (peek() == '+' || peek() == '-')) {
    out.emplace_back();
    if (!term(out.back(), expression, address, from)) return false;
  }
  return true;
}

/// [sign] number, H, or a digit that is multiplied with the H directly behind it.
bool WedmReader::term(WedmTerm& out, bool expression, char address, std::size_t from) {
  const std::size_t begin = at_;
  double sign = 1.0;
  if (peek() == '+' || peek() == '-') sign = line_[at_++] == '-' ? -1.0 : 1.0;
  const auto is_h = [&](std::size_t ahead) {
    return upper(peek(ahead)) == 'H' && isDigit(peek(ahead + 1)) && isDigit(peek(ahead + 2)) &&
           isDigit(peek(ahead + 3));
  };
  if (expression && (is_h(0) || (isDigit(peek()) && is_h(1)))) {
    out.number = sign * (isDigit(peek()) ? line_[at_++] - '0' : 1);
    ++at_;
    if (!threeDigits(out.h)) return fail("H needs 3 digits, H001", begin, at_ + 4);
  } else {
    const std::size_t first = at_;
    while (isDigit(peek()) || peek() == '.') out.point = (line_[at_++] == '.') || out.point;
    const std::string_view text = line_.substr(first, at_ - first);
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), out.number);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
      return fail(fmt::format("{} needs a number directly behind it", address), from, at_ + 1);
    out.number *= sign;
  }
  out.columns = columns(begin, at_);
  return true;
}

}  // namespace proveout::nc
