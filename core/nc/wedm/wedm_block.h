// A block of the wire EDM control: its words with their places (digest wedm, D3).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/text/block.h"

namespace proveout::nc {

/// One summand of a word's value: a number, or a factor times H.
struct WedmTerm {
  double number = 0.0;  ///< signed; as written
  bool point = false;   ///< written with a decimal point
  int h = -1;           ///< number of the H that it is multiplied with, or -1
  Columns columns;
};

struct WedmWord {
  char address = '?';
  /// X of G04, G31 and G37, T of G37: no axis and no function.
  bool argument = false;
  int code = 0;                 ///< addresses with whole numbers
  std::vector<WedmTerm> terms;  ///< the others
  Columns columns;
};

/// `Hnnn=...`
struct WedmAssignment {
  int h = 0;
  std::vector<WedmTerm> terms;
  Columns columns;
};

struct WedmBlock {
  bool skip = false;            ///< begins with /
  std::int64_t number = -1;     ///< N, or -1
  std::vector<WedmWord> words;  ///< in order, without N; those of the lower shape where there is a colon
  std::vector<WedmWord> upper;  ///< behind the colon
  std::vector<WedmAssignment> assignments;
  bool colon = false;
  Columns colon_at;

  bool empty() const { return words.empty() && assignments.empty() && !colon; }
  /// The first word of that address that is no argument, or null.
  const WedmWord* find(char address) const;
};

/// Reads blocks; keeps no state between them.
class WedmReader {
 public:
  /// `line`: the text of the whole line; the block stands in [begin, end). False: see error().
  bool read(std::string_view line, std::size_t begin, std::size_t end, WedmBlock& block);

  struct Error {
    std::string message;
    Columns columns;
  };
  const Error& error() const { return error_; }

 private:
  bool fail(std::string message, std::size_t from, std::size_t to);
  void skipBlanks();
  bool atEnd() { return skipBlanks(), at_ >= end_; }
  bool word(WedmBlock& block);
  bool number(WedmBlock& block, int number, std::size_t from);
  bool whole(WedmWord& word, std::size_t from);
  bool hWord(WedmBlock& block, std::size_t from);
  bool terms(std::vector<WedmTerm>& out, bool expression, char address, std::size_t from);
  bool term(WedmTerm& out, bool expression, char address, std::size_t from);
  bool threeDigits(int& out);
  void put(WedmBlock& block, WedmWord word);
  char peek(std::size_t ahead = 0) const { return at_ + ahead < end_ ? line_[at_ + ahead] : '\0'; }
  Columns columns(std::size_t from, std::size_t to) const {
    return {static_cast<int>(from) + 1, static_cast<int>(to) + 1};
  }

  std::string_view line_;
  std::size_t at_ = 0, end_ = 0;
  char wants_ = '\0';  ///< the address that the code before takes as its argument
  bool dwell_may_follow_ = false;
  Error error_;
};

}  // namespace proveout::nc
