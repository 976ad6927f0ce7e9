// One line of a program of an unknown control: its comment apart from its words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proveout::nc::guess {

/// A letter with what stands behind it.
struct SignWord {
  char letter = 0;         ///< upper case
  std::string_view value;  ///< "10.", "-.5", "#12", "[#1+2]", "(26/2)"; empty: nothing
  bool assigned = false;   ///< "P1100=20": value is "1100"
  bool comma = false;      ///< ",R5"

  bool isNumber() const;
  bool hasPoint() const { return value.find('.') != std::string_view::npos; }
  /// Digits, a sign perhaps, no point.
  bool isWhole() const;
  /// 0 where it is no number.
  double number() const;
};

struct SignLine {
  std::string code;                ///< without comments and blanks, upper case
  std::string comment;             ///< all of them, upper case, one blank between
  bool semicolon_end = false;      ///< ends in ';' and nothing else
  bool semicolon_comment = false;  ///< "; text"
  bool dollar_comment = false;
  bool slash_comment = false;
  int lower = 0, upper = 0;     ///< letters of the words
  std::vector<SignWord> words;  ///< of `code`, which they point into

  explicit SignLine(std::string_view line);
  SignLine(const SignLine&) = delete;
  SignLine& operator=(const SignLine&) = delete;

  /// First word of that letter; null: none.
  const SignWord* word(char letter) const;
  bool has(char letter) const { return word(letter) != nullptr; }
  /// The G code (letter 'G') or M code with this number, in tenths.
  bool hasCode(char letter, int tenths) const;
  bool contains(std::string_view text) const { return code.find(text) != std::string::npos; }

 private:
  void split(std::string_view line);
  void readWords();
};

/// Ten times the number of a code, -1: none.
int codeTenths(const SignWord& word);

}  // namespace proveout::nc::guess
