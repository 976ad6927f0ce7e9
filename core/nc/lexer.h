// Lexer of address-word programs: one line in, one block out. No regular expressions, no copies.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/nc/block.h"

namespace proveout::nc {

/// Value of a word that is not a plain number (macro variables, brackets). A macro language implements it.
class ExpressionHook {
 public:
  virtual ~ExpressionHook() = default;
  /// `text[pos]` is '#', '[' or a letter behind an address. Evaluates, moves `pos` behind the expression.
  /// False: `message` says why (then the block is in error from the word on).
  virtual bool evaluate(std::string_view text, std::size_t& pos, double& value, std::string& message) = 0;
};

/// What differs from grammar to grammar.
struct LexRules {
  ExpressionHook* expressions = nullptr;  ///< null: '#' and '[' are errors
  bool incremental_operator = true;       ///< XI40
  bool comma_addresses = true;            ///< ,C ,R ,A
  AddressSet incremental_addresses = "XYZUVWABCR";
  AddressSet unsigned_addresses = "ONGFTHDLM";  ///< '-' is an error
  AddressSet repeatable = "GM";                 ///< may occur more than once in a block
};

struct LexError {
  std::string code;  ///< "nct-2064"
  std::string message;
  Columns columns;
};

/// Largest magnitude of a value; far beyond any machine, near enough to keep arithmetic exact to 1e-6.
inline constexpr double kMaxValue = 1e9;

class Lexer {
 public:
  explicit Lexer(const LexRules& rules) : rules_(rules) {}
  /// Fills `block` with the words of `line`. False: error() says why. Comments may go on from line to line.
  bool lex(std::string_view line, Block& block);
  const LexError& error() const { return error_; }
  bool inComment() const { return in_comment_; }
  void setInComment(bool in_comment) { in_comment_ = in_comment; }

 private:
  bool lexWord(std::string_view line, std::size_t& i, Block& block);
  bool lexSkip(std::string_view line, std::size_t& i, Block& block);
  bool lexFile(std::string_view line, std::size_t& i, Block& block);
  bool lexAddress(std::string_view line, std::size_t& i, Word& word);
  bool lexValue(std::string_view line, std::size_t& i, Word& word);
  bool lexNumber(std::string_view line, std::size_t& i, Word& word);
  bool store(const Word& word, Block& block);
  bool fail(const char* code, std::string message, std::size_t begin, std::size_t end);

  LexRules rules_;
  LexError error_;
  bool in_comment_ = false;
};

}  // namespace proveout::nc
