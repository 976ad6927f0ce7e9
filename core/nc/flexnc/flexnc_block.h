// A block of the FlexNC control: one line (digest flexnc, 2.1).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/nc/flexnc/flexnc_expression.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

struct FlexWord {
  char address = '?';
  double value = 0.0;
  int tenths = -1;  ///< of G and M: the code in tenths, G81.1 is 811; -1: the number is none
  Columns columns;
  ReadList reads = 0;
};

/// GOSUB, RET and REPEAT.
struct FlexJump {
  enum class Kind : std::uint8_t { kCall, kReturn, kRepeat } kind = Kind::kReturn;
  std::int64_t label = 0;
  int count = 0;     ///< of REPEAT
  int counter = -1;  ///< number of the variable that counts, or -1
  Columns columns;
};

struct FlexBlock {
  std::string_view text;
  std::int64_t number = -1;  ///< N, a label
  std::vector<FlexWord> words;
  std::optional<FlexJump> jump;  ///< behind the words
  bool assigns = false;
  Columns odd_variable;  ///< of a variable that is not one of the programs'; begin 0: none

  bool empty() const { return words.empty() && !jump && !assigns; }
  bool has(char address) const {
    for (const FlexWord& word : words) {
      if (word.address == address) return true;
    }
    return false;
  }
};

/// Reads lines; variables are assigned on the way.
class FlexReader {
 public:
  /// All must outlive the reader.
  FlexReader(FlexVariables& variables, FlexEvaluator& evaluator, ValueOrigins& origins)
      : variables_(variables), evaluator_(evaluator), origins_(origins) {}

  /// False: see error(); what was read of the line is in the block.
  bool read(std::string_view line, FlexBlock& block);
  const FlexSyntaxError& error() const { return error_; }

 private:
  bool statement(FlexBlock& block);
  bool word(FlexBlock& block);
  bool assignment(FlexBlock& block, bool& is_one);
  bool call(FlexBlock& block);
  bool repeat(FlexBlock& block);
  bool label(std::int64_t& out);
  bool notRead(std::size_t from);
  void noteVariables(FlexBlock& block, std::size_t from);
  void skipBlanks();
  bool atEnd();
  bool keyword(std::string_view word);
  char peek(std::size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }
  bool fail(const char* code, std::string message, std::size_t from, std::size_t to);

  FlexVariables& variables_;
  FlexEvaluator& evaluator_;
  ValueOrigins& origins_;
  std::string_view line_;
  std::size_t at_ = 0;
  bool semicolon_told_ = false;  ///< what stands behind a further ; is left out
  FlexSyntaxError error_;
};

/// The number of the label that the line begins with, or -1.
std::int64_t flexLabelOf(std::string_view line);

}  // namespace proveout::nc
