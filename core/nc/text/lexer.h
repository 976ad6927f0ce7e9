// Lexer of address-word programs: one line in, one block out. No regular expressions, no copies.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/nc/macro/value.h"
#include "core/nc/text/alarms.h"
#include "core/nc/text/block.h"
#include "core/nc/text/lex_names.h"

namespace proveout::nc {

struct LexError {
  std::string code;  ///< "nct-2064"
  std::string message;
  Columns columns;
};

/// Value of a word that is not a plain number (macro variables, brackets). A macro language implements it.
class ExpressionHook {
 public:
  virtual ~ExpressionHook() = default;
  /// `text[pos]` is '#', '[', a sign before one of them, or a letter behind an address. Evaluates, moves
  /// `pos` behind the expression. A vacant value leaves the word out. False: `error` says why, with its
  /// columns.
  virtual bool evaluate(std::string_view text, std::size_t& pos, Value& value, LexError& error) = 0;
  /// The same for the value of a word of that address.
  virtual bool evaluateWord(Address /*address*/, std::string_view text, std::size_t& pos, Value& value,
                            LexError& error) {
    return evaluate(text, pos, value, error);
  }
};

/// What differs from grammar to grammar.
struct LexRules {
  ExpressionHook* expressions = nullptr;  ///< null: '#' and '[' are errors, and there are no statements
  const LexNames* names = nullptr;        ///< axes and spindles by name; null: letters only
  /// Repeated words are kept and marked in the block, a second N becomes a word, and words may have a sign
  /// that takes none: calls take them as arguments, and the control refuses them elsewhere. False: they are
  /// errors at once.
  bool keep_repeats = false;
  bool incremental_operator = true;  ///< XI40
  bool comma_addresses = true;       ///< ,C ,R ,A
  bool short_while = false;          ///< WH[...] is WHILE[...]
  bool names_variables = false;      ///< SETVN is a statement
  AddressSet incremental_addresses = "XYZUVWABCR";
  AddressSet unsigned_addresses = "ONGFTHDLM";  ///< '-' is an error
  AddressSet repeatable = "GM";                 ///< may occur more than once in a block
  bool comments_end_in_line = false;  ///< a comment that nobody closes ends with its line; the block tells it
  bool semicolon_ends_block = false;  ///< ; ends a block; see blockEnd()
  bool colon_program = false;         ///< :1234 is O1234
  bool named_programs = false;        ///< O<NAME>
  /// Numbers without digits, misplaced signs and points, and characters that start no word have alarms of
  /// their own. False: they are syntax errors.
  bool number_alarms = false;
  /// A slash may stand inside of a block: the words behind it are left out while its switch is on. False: it
  /// stands in front only.
  bool skip_anywhere = false;
  std::uint16_t skip_switches = 0;  ///< with skip_anywhere: bit n - 1 is the switch of /n
};

/// How N counts.
enum class LexMode : std::uint8_t {
  kBlock,  ///< block number
  kData    ///< data: N becomes a word (parameter and tool data input)
};

/// What starts at `text[pos]`, the first thing of a line behind N and skip.
LineKind classify(std::string_view text, std::size_t pos);

/// Where the block of `line` that starts at `from` ends: at its first ; outside of comments, or with the
/// line.
std::size_t blockEnd(std::string_view line, std::size_t from);
/// Does the text read as a block: words, or a statement of the macro language? Nothing is evaluated.
bool readsAsBlock(std::string_view text);

/// Largest magnitude of a value; far beyond any machine, near enough to keep arithmetic exact to 1e-6.
inline constexpr double kMaxValue = 1e9;

class Lexer {
 public:
  /// `alarms` must outlive the lexer.
  Lexer(const LexRules& rules, const AlarmTable& alarms) : rules_(rules), alarms_(alarms) {}
  /// Fills `block` with the words of `line`. False: error() says why. Comments may go on from line to line.
  /// What stands behind % is a name and no words, but for comments and a program number. `from`: the block
  /// begins there; the text in front of it is that of other blocks.
  bool lex(std::string_view line, Block& block, std::size_t from = 0);
  /// Goes on at `pos` of `block.text` and adds the words from there (behind IF[...] or THEN). The block then
  /// counts as a block of words.
  bool lexRest(std::size_t pos, Block& block);
  const LexError& error() const { return error_; }
  void setMode(LexMode mode) { mode_ = mode; }
  bool inComment() const { return in_comment_; }
  void setInComment(bool in_comment) { in_comment_ = in_comment; }

 private:
  bool foreignSign(std::string_view line, std::size_t i, bool& comment);
  bool lexItems(std::string_view line, std::size_t i, Block& block, bool head);
  void leaveStatement(std::string_view rest);
  bool lexNamed(std::string_view line, std::size_t& i, Word& word, bool& named);
  bool lexAxisByNumber(std::string_view line, std::size_t& i, Word& word);
  bool lexWord(std::string_view line, std::size_t& i, Block& block);
  bool lexSkip(std::string_view line, std::size_t& i, Block& block);
  bool lexFile(std::string_view line, std::size_t& i, Block& block);
  bool lexAddress(std::string_view line, std::size_t& i, Word& word);
  bool lexValue(std::string_view line, std::size_t& i, Word& word, bool& vacant);
  bool lexNumber(std::string_view line, std::size_t& i, Word& word);
  bool noWord(std::string_view line, std::size_t value);
  bool evaluate(std::string_view line, std::size_t& i, Word& word, bool& vacant);
  bool keepMinus(const Word& word, Block& block);
  bool store(const Word& word, Block& block);
  bool fail(SharedAlarm alarm, std::string_view subject, std::string_view detail, std::size_t begin,
            std::size_t end);
  bool syntax(std::string_view detail, std::size_t begin, std::size_t end);
  /// A fault with an alarm of its own where the control has one (LexRules::number_alarms), else `usual`.
  bool failNumber(SharedAlarm alarm, SharedAlarm usual, std::string_view subject, std::string_view detail,
                  std::size_t begin, std::size_t end);
  void endComment(Block& block, std::size_t from);

  LexRules rules_;
  const AlarmTable& alarms_;
  LexError error_;
  bool in_comment_ = false;
  bool nested_ = false;          ///< a comment of the line in hand has a ( inside
  bool semicolon_told_ = false;  ///< what stands behind a further ; is left out
  bool* plain_ = nullptr;        ///< of the block in hand
  LexMode mode_ = LexMode::kBlock;
};

}  // namespace proveout::nc
