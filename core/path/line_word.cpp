#include "core/path/line_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/characters.h"

namespace proveout {
namespace {

/// The words of a line, one by one.
class Scanner {
 public:
  explicit Scanner(std::string_view line) : line_(line) {}

  char address = '\0';  ///< upper case; 'c', 'r', 'a' behind a comma
  LineWord word;

  bool next() {
    while (pos_ < line_.size()) {
      const char c = line_[pos_];
      if (c == '(') {
        pos_ = std::min(line_.find(')', pos_), line_.size() - 1) + 1;
      } else if (c == '$' || c == '.') {
        return false;  // comments of WL4
      } else if (isLetter(c) || c == ',') {
        if (take()) return true;
      } else {
        ++pos_;
      }
    }
    return false;
  }

 private:
  char peek() const { return pos_ < line_.size() ? line_[pos_] : '\0'; }
  void skipBlanks() {
    while (isBlank(peek())) ++pos_;
  }

  bool take() {
    const std::size_t begin = pos_;
    const bool comma = line_[pos_] == ',';
    if (comma) {
      ++pos_;
      skipBlanks();
    }
    if (!isLetter(peek())) return false;
    address = upper(line_[pos_++]);
    if (comma) address = static_cast<char>(address + ('a' - 'A'));
    if (upper(peek()) == 'I') ++pos_;  // operator of one incremental word: XI40
    skipBlanks();
    const bool minus = peek() == '-';
    if (minus || peek() == '+') {
      ++pos_;
      skipBlanks();
    }
    const std::size_t digits = pos_;
    while (isDigit(peek()) || peek() == '.') ++pos_;
    if (pos_ == digits) return false;
    double value = 0.0;
    std::from_chars(line_.data() + digits, line_.data() + pos_, value, std::chars_format::fixed);
    word.begin = static_cast<std::uint16_t>(begin + 1);
    word.end = static_cast<std::uint16_t>(pos_ + 1);
    word.value = minus ? -value : value;
    return true;
  }

  std::string_view line_;
  std::size_t pos_ = 0;
};

/// G codes, tenfold, that are of one kind: `first` goes before `second` if both are in a line.
struct CodeRange {
  OriginKind kind;
  int first, last;
  bool second_choice = false;
};
constexpr auto kCodes = std::to_array<CodeRange>({
    {OriginKind::kMotionCode, 0, 0},
    {OriginKind::kMotionCode, 10, 10},
    {OriginKind::kMotionCode, 20, 20},
    {OriginKind::kMotionCode, 30, 30},
    {OriginKind::kMotionCode, 120, 120},
    {OriginKind::kMotionCode, 130, 130},
    {OriginKind::kMotionCode, 320, 330},
    {OriginKind::kVirtualPlane, 71, 71},
    {OriginKind::kVirtualPlane, 121, 121},
    {OriginKind::kVirtualPlane, 131, 131},
    {OriginKind::kDiameter, 109, 109},
    {OriginKind::kPolar, 150, 160},
    {OriginKind::kPlane, 170, 190},
    {OriginKind::kUnits, 200, 210},
    {OriginKind::kCycle, 310, 310},
    {OriginKind::kCompensation, 400, 420},
    {OriginKind::kLengthCode, 430, 449},
    {OriginKind::kLengthCode, 490, 490},
    {OriginKind::kScaling, 500, 500},
    {OriginKind::kScaling, 510, 510},
    {OriginKind::kMirror, 501, 501},
    {OriginKind::kMirror, 511, 511},
    {OriginKind::kMirror, 500, 500, true},
    {OriginKind::kMirror, 510, 510, true},
    {OriginKind::kShift, 520, 520},
    {OriginKind::kShift, 920, 920},
    {OriginKind::kWorkOffset, 540, 590},
    {OriginKind::kWorkOffset, 530, 530, true},
    {OriginKind::kWorkOffset, 920, 920, true},
    {OriginKind::kRotation, 680, 690},
    {OriginKind::kCycle, 700, 799},
    {OriginKind::kCycle, 801, 899},
    {OriginKind::kDistance, 900, 910},
    {OriginKind::kFeedMode, 930, 950},
    {OriginKind::kSpindleMode, 960, 970},
    {OriginKind::kCycleReturn, 980, 990},
});

/// Addresses of a kind, the best one first.
std::string_view addresses(OriginKind kind) {
  switch (kind) {
    case OriginKind::kX:
      return "XU";
    case OriginKind::kY:
      return "YV";
    case OriginKind::kZ:
    case OriginKind::kCycleDepth:
      return "ZW";
    case OriginKind::kA:
      return "A";
    case OriginKind::kB:
      return "B";
    case OriginKind::kC:
      return "C";
    case OriginKind::kU:
      return "U";
    case OriginKind::kV:
      return "V";
    case OriginKind::kW:
      return "W";
    case OriginKind::kI:
      return "I";
    case OriginKind::kJ:
      return "J";
    case OriginKind::kK:
      return "K";
    case OriginKind::kArcRadius:
    case OriginKind::kCyclePlane:
      return "R";
    case OriginKind::kAngle:
      return "a";
    case OriginKind::kCorner:
      return "crB";
    case OriginKind::kCycleStep:
      return "Q";
    case OriginKind::kCycleShift:
      return "IJK";
    case OriginKind::kTool:
    case OriginKind::kNextTool:
      return "T";
    case OriginKind::kLengthOffset:
      return "H";
    case OriginKind::kRadiusOffset:
      return "D";
    case OriginKind::kFeed:
      return "F";
    case OriginKind::kThreadLead:
      return "FE";
    case OriginKind::kSpindle:
      return "S";
    default:
      return {};
  }
}

/// How well a word suits a kind: 0 best, -1 not at all.
int rank(OriginKind kind, char address, double value) {
  if (address == 'G') {
    const double tenfold = std::round(10.0 * value);
    for (const CodeRange& codes : kCodes) {
      if (codes.kind == kind && tenfold >= codes.first && tenfold <= codes.last)
        return codes.second_choice ? 1 : 0;
    }
    return -1;
  }
  if (address == 'M') {
    const bool spindle = value == 3.0 || value == 4.0 || value == 5.0 || value == 19.0;
    return kind == OriginKind::kSpindleDirection && spindle ? 0 : -1;
  }
  const std::size_t at = addresses(kind).find(address);
  if (at == std::string_view::npos) return -1;
  return kind == OriginKind::kCycleShift ? 0 : static_cast<int>(at);
}

}  // namespace

std::optional<LineWord> findWord(std::string_view line, OriginKind kind) {
  std::optional<LineWord> found;
  int best = 0;
  for (Scanner scanner(line); scanner.next();) {
    const int own = rank(kind, scanner.address, scanner.word.value);
    if (own < 0 || (found && own > best)) continue;
    best = own;
    found = scanner.word;
  }
  return found;
}

std::int64_t blockNumberIn(std::string_view line) {
  Scanner scanner(line);
  return scanner.next() && scanner.address == 'N' ? static_cast<std::int64_t>(scanner.word.value) : -1;
}

}  // namespace proveout
