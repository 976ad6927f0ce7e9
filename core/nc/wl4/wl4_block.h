// A block of the WL4 control and how it is read (digest wl4, 2 and 3.4 to 3.6).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/nc/text/block.h"
#include "core/nc/wl4/macro/wl4_expression.h"

namespace proveout::nc {

/// Words of a block; of an address that stands twice the last one. Values are fixed when they are read.
struct Wl4Block {
  static constexpr std::size_t kMaxCodes = 16;
  struct Code {
    int number = 0;
    Columns columns;
    ReadList reads = 0;  ///< by its expression
  };
  template <std::size_t N>
  struct CodeList {
    std::array<Code, N> at{};
    std::size_t count = 0;
    const Code* begin() const { return at.data(); }
    const Code* end() const { return at.data() + count; }
  };

  std::string_view text;
  std::int64_t number = -1;          ///< N at the start, or -1
  bool conditional = false;          ///< a `/` stands at the start
  std::optional<std::int64_t> jump;  ///< N elsewhere
  Columns jump_columns;
  CodeList<kMaxCodes> g, m;
  AddressSet present;  ///< letters besides G, M, N
  std::array<double, 26> values{};
  std::array<Columns, 26> columns{};
  std::array<ReadList, 26> reads{};      ///< by the expression of the word
  std::array<std::uint8_t, 26> order{};  ///< place of the word among all: of X and U the later one counts
  std::uint8_t words = 0;
  bool assigns = false;      ///< the block assigns variables
  bool plain = true;         ///< letters with plain numbers: the text alone shows the words
  std::string_view comment;  ///< behind `$` or `.`, without blanks

  bool has(char letter) const { return present.has(letter); }
  double value(char letter) const { return values[static_cast<std::size_t>(letter - 'A')]; }
  const Columns& at(char letter) const { return columns[static_cast<std::size_t>(letter - 'A')]; }
  ReadList readsOf(char letter) const { return reads[static_cast<std::size_t>(letter - 'A')]; }
  /// Does the word of the first letter stand behind that of the second?
  bool later(char letter, char other) const {
    return order[static_cast<std::size_t>(letter - 'A')] > order[static_cast<std::size_t>(other - 'A')];
  }
  std::optional<double> find(char letter) const {
    return has(letter) ? std::optional(value(letter)) : std::nullopt;
  }
  bool hasCode(int g_number) const;
  /// Only a number, or nothing.
  bool empty() const { return words == 0 && !jump; }
};

/// Reads lines from left to right: assignments take effect for what stands to their right.
class Wl4Reader {
 public:
  explicit Wl4Reader(Wl4Evaluator& evaluator) : evaluator_(evaluator) {}

  /// False: see error(). What was assigned stays assigned.
  bool read(std::string_view line, Wl4Block& block);
  struct Error {
    std::string message;
    Columns columns;
  };
  const Error& error() const { return error_; }

 private:
  bool word(Wl4Block& block, std::size_t& pos);
  bool blockNumber(Wl4Block& block, std::size_t& pos);
  bool assignment(Wl4Block& block, std::size_t& pos);
  bool condition(std::size_t& pos, bool& holds);
  bool value(std::size_t& pos, double& out);
  bool integer(char letter, double value, Columns at, std::int64_t& out);
  bool fail(std::string message, std::size_t from, std::size_t to);

  Wl4Evaluator& evaluator_;
  std::string_view line_;
  bool semicolon_told_ = false;  ///< what stands behind a further ; is left out
  Error error_;
};

/// The number of the label at the start of a line (`N010`, blanks and `/` may stand before it), or -1.
std::int64_t labelOf(std::string_view line);
/// The number of the block at the start of a line, label or not, or -1.
std::int64_t blockNumberOf(std::string_view line);

}  // namespace proveout::nc
