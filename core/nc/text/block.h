// A block: the words of one program line with their places in it.
#pragma once

#include <bitset>
#include <cstdint>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Address of a word: 'A'..'Z', or one of these for the comma addresses.
using Address = char;
inline constexpr Address kCommaChamfer = 'c';    ///< ,C
inline constexpr Address kCommaRounding = 'r';   ///< ,R
inline constexpr Address kCommaDirection = 'a';  ///< ,A
inline constexpr Address kPolarAngle = '^';      ///< of LinuxCNC; its @ is kNamedWord
inline constexpr Address kSpindleNumber = '$';   ///< of LinuxCNC
inline constexpr Address kNamedWord = '@';       ///< an axis or spindle with a name of several characters

/// A set of addresses.
class AddressSet {
 public:
  constexpr AddressSet() = default;
  consteval AddressSet(const char* letters) {  // NOLINT: implicit on purpose, tables read better
    for (; *letters; ++letters) bits_ |= bit(*letters);
  }
  constexpr bool has(Address a) const { return (bits_ & bit(a)) != 0; }
  constexpr void add(Address a) { bits_ |= bit(a); }
  constexpr AddressSet operator|(AddressSet other) const { return AddressSet(bits_ | other.bits_); }
  constexpr AddressSet operator&(AddressSet other) const { return AddressSet(bits_ & other.bits_); }
  constexpr AddressSet without(AddressSet other) const { return AddressSet(bits_ & ~other.bits_); }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool operator==(const AddressSet&) const = default;
  constexpr std::uint64_t bits() const { return bits_; }

 private:
  constexpr explicit AddressSet(std::uint64_t bits) : bits_(bits) {}
  /// '@'..'Z' take bits 0..31, '`'..'z' bits 32..63.
  static constexpr std::uint64_t bit(Address a) {
    const unsigned low = static_cast<unsigned>(a) & 31u;
    return std::uint64_t{1} << ((static_cast<unsigned>(a) & 32u) ? low + 32u : low);
  }
  std::uint64_t bits_ = 0;
};

/// "X" or ",C": the address as the program writes it.
inline std::string_view addressText(Address a) {
  static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  switch (a) {
    case kCommaChamfer:
      return ",C";
    case kCommaRounding:
      return ",R";
    case kCommaDirection:
      return ",A";
    case kPolarAngle:
      return "^";
    case kSpindleNumber:
      return "$";
    default:
      return a >= 'A' && a <= 'Z' ? kLetters.substr(static_cast<std::size_t>(a - 'A'), 1) : "?";
  }
}

/// Columns of the line, from 1; `end` is one past the last.
struct Columns {
  int begin = 0;
  int end = 0;
};

struct Word {
  Address address = '?';
  bool incremental = false;      ///< operator I behind the address (XI40)
  bool is_integer = false;       ///< the value has no fractional part
  bool from_expression = false;  ///< the value was computed: alarms tell it
  bool minus = false;            ///< it has a minus sign
  bool point = false;            ///< a plain number with a decimal point
  std::uint8_t decimals = 0;     ///< of a plain number: digits behind the point, 255 at most
  double value = 0.0;            ///< as programmed, no unit conversion
  Columns columns;
  std::int8_t axis = -1;     ///< index of the axis of that name, or -1
  std::int8_t spindle = -1;  ///< index of the spindle of that name, or -1
  std::uint32_t reads = 0;   ///< with from_expression: what it read, see ValueOrigins
};

/// What a line is.
enum class LineKind : std::uint8_t {
  kBlock,       ///< words
  kAssignment,  ///< #100=...
  kIf,          ///< IF[...] GOTO / THEN / words
  kWhile,       ///< WHILE[...] DO
  kDo,
  kEnd,
  kGoto,
  kOutput,  ///< POPEN PCLOS FOPEN FCLOS BPRNT DPRNT
  kNames,   ///< SETVN
  kOwn      ///< a statement of the control's own language (IsoLanguage)
};

/// Reused from line to line; the views point into the program text.
struct Block {
  std::vector<Word> words;    ///< in order, without N and O
  AddressSet present;         ///< addresses in `words`
  std::string_view text;      ///< the line
  std::string_view file_arg;  ///< what stands between < and > (M98 <file>)
  Columns file_columns;
  std::int64_t number = -1;   ///< N, or -1
  std::int64_t program = -1;  ///< O, or -1
  Columns number_columns, program_columns;
  int skip = 0;           ///< 1..9: optional skip `/n`; 0: none
  bool percent = false;   ///< the line is a % line
  bool has_file = false;  ///< `<...>` present
  bool steps = false;     ///< a word has the operator I: XI40
  bool plain = true;      ///< one line of letters with plain numbers: its text alone shows its words
  /// A statement of the macro language starts at `statement` (index into `text`); words before it are N and
  /// skip only.
  LineKind kind = LineKind::kBlock;
  std::size_t statement = 0;
  AddressSet repeated;  ///< addresses that occur again although they may not (LexRules::keep_repeats)
  Columns repeated_at;  ///< the first such word
  AddressSet negative;  ///< addresses with a minus sign although they take none (LexRules::keep_repeats)
  Columns negative_at;  ///< the first such word
  /// With LexRules::comments_end_in_line: the first ( inside of a comment, and the ( of one that nobody has
  /// closed; begin 0: there is none.
  Columns nested_at, open_at;

  void clear() {
    words.clear();
    present = {};
    text = file_arg = {};
    number = program = -1;
    skip = 0;
    percent = has_file = false;
    plain = true;
    steps = false;
    kind = LineKind::kBlock;
    repeated = negative = {};
    nested_at = open_at = {};
  }
  bool empty() const { return words.empty() && !has_file && kind == LineKind::kBlock; }
  /// The word at that address, or null. Addresses that may repeat (G, M): the first.
  const Word* find(Address a) const {
    if (!present.has(a)) return nullptr;
    for (const Word& w : words) {
      if (w.address == a) return &w;
    }
    return nullptr;
  }
  /// The word of an axis, or null.
  const Word* findAxis(int axis) const {
    for (const Word& w : words) {
      if (w.axis == axis) return &w;
    }
    return nullptr;
  }
};

/// The name under which the program wrote the word: "X", ",C", "Z1".
inline std::string_view wordName(const Word& word, const Block& block) {
  if (word.address != kNamedWord) return addressText(word.address);
  const auto begin = static_cast<std::size_t>(word.columns.begin - 1);
  const auto length = static_cast<std::size_t>(word.columns.end - word.columns.begin);
  const std::string_view text = block.text.substr(begin, length);
  const std::size_t equals = text.find('=');
  return text.substr(0, equals != std::string_view::npos ? equals : text.find_first_of("-+.0123456789#[ "));
}

}  // namespace proveout::nc
