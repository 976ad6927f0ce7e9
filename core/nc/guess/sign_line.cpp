#include "core/nc/guess/sign_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace proveout::nc::guess {
namespace {

// Of a line: what is longer is no block that a post wrote.
constexpr std::size_t kMostCharacters = 2000, kMostWords = 60;

bool isDigitChar(char c) { return c >= '0' && c <= '9'; }
bool isLetterChar(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isBlankChar(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\x1a'; }
char upperChar(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

/// "(26/2)" behind an address or an operator is a formula, everything else in parentheses a comment.
bool opensFormula(std::string_view line, std::size_t at, std::size_t end, const std::string& code) {
  const std::string_view inside = line.substr(at + 1, end - at - 1);
  const auto of_formulas = [](char c) {
    return isDigitChar(c) || isLetterChar(c) || isBlankChar(c) ||
           std::string_view("#.+-*/()<>=").find(c) != std::string_view::npos;
  };
  if (inside.empty() || !std::all_of(inside.begin(), inside.end(), of_formulas)) return false;
  if (code.ends_with("IF") || code.ends_with("=")) return true;
  return at > 0 && !code.empty() && (isLetterChar(line[at - 1]) || line[at - 1] == '(') &&
         std::any_of(inside.begin(), inside.end(), [](char c) { return isDigitChar(c) || c == '#'; });
}

/// Behind a ';' without a blank: the next block, no comment.
bool beginsBlock(std::string_view rest) {
  return rest.size() > 1 && isLetterChar(rest[0]) &&
         (isDigitChar(rest[1]) || std::string_view("+-.#[").find(rest[1]) != std::string_view::npos);
}

/// What GRBL's senders write behind '$': "H", "J=..", "110=2000", "$".
bool isSenderWord(std::string_view rest) {
  while (!rest.empty() && isBlankChar(rest.back())) rest.remove_suffix(1);
  if (rest.empty()) return false;
  if (rest.starts_with("J=") || rest.starts_with("RST=") || rest == "SLP") return true;
  if (rest.size() == 1)
    return std::string_view("HXGINC$#").find(upperChar(rest[0])) != std::string_view::npos;
  const std::size_t digits = rest.find_first_not_of("0123456789");
  return digits != 0 && (digits == std::string_view::npos || rest[digits] == '=');
}

std::size_t closingOf(std::string_view line, std::size_t at) {
  int depth = 0;
  for (std::size_t i = at; i < line.size(); ++i) {
    if (line[i] == '(') ++depth;
    if (line[i] == ')' && --depth == 0) return i;
  }
  return std::string_view::npos;
}

}  // namespace

bool SignWord::isNumber() const {
  return std::any_of(value.begin(), value.end(), isDigitChar) &&
         std::all_of(value.begin(), value.end(),
                     [](char c) { return isDigitChar(c) || c == '.' || c == '+' || c == '-'; });
}

bool SignWord::isWhole() const { return isNumber() && !hasPoint(); }

double SignWord::number() const {
  if (!isNumber()) return 0.0;
  std::string_view text = value;
  if (text.front() == '+') text.remove_prefix(1);
  double result = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

int codeTenths(const SignWord& word) {
  const double number = word.number();
  if (!word.isNumber() || number < 0.0 || number > 9999.0) return -1;
  return static_cast<int>(std::lround(10.0 * number));
}

SignLine::SignLine(std::string_view line) {
  split(line.substr(0, kMostCharacters));
  readWords();
}

void SignLine::split(std::string_view line) {
  const auto addComment = [&](std::string_view text) {
    if (!comment.empty()) comment += ' ';
    for (const char c : text) comment += upperChar(c);
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const std::string_view rest = line.substr(i + 1);
    const bool text_behind = std::any_of(rest.begin(), rest.end(), [](char b) { return !isBlankChar(b); });
    if (c == '(') {
      const std::size_t end = std::min(closingOf(line, i), line.size());
      if (!opensFormula(line, i, end, code)) {
        addComment(line.substr(i + 1, end - i - 1));
        i = end;
        continue;
      }
      for (; i <= end && i < line.size(); ++i) {
        if (!isBlankChar(line[i])) code += upperChar(line[i]);
      }
      --i;
    } else if (c == ';') {
      if (text_behind && !beginsBlock(rest)) {
        semicolon_comment = true;
        addComment(rest);
        return;
      }
      semicolon_end = semicolon_end || !text_behind;
    } else if (c == '$' && !(code.empty() && isSenderWord(rest))) {
      dollar_comment = true;
      addComment(rest);
      return;
    } else if (c == '/' && rest.starts_with('/')) {
      slash_comment = true;
      addComment(rest.substr(1));
      return;
    } else if (!isBlankChar(c)) {
      if (isLetterChar(c)) ++(std::islower(static_cast<unsigned char>(c)) != 0 ? lower : upper);
      code += upperChar(c);
    }
  }
}

void SignLine::readWords() {
  const std::string_view text = code;
  bool comma = false;
  for (std::size_t i = 0; i < text.size() && words.size() < kMostWords;) {
    const char c = text[i];
    if (c == '#' || c == '[' || c == '<') break;  // an assignment, or a name
    if (!isLetterChar(c)) {
      comma = c == ',';
      ++i;
      continue;
    }
    SignWord word;
    word.letter = c;
    word.comma = comma;
    comma = false;
    std::size_t end = ++i;
    while (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
    if (end < text.size() && (text[end] == '[' || text[end] == '(')) {
      const char open = text[end], close = open == '[' ? ']' : ')';
      int depth = 0;
      for (; end < text.size(); ++end) {
        if (text[end] == open) ++depth;
        if (text[end] == close && --depth == 0) break;
      }
      end = std::min(end + 1, text.size());
    } else if (end < text.size() && text[end] == '#') {
      while (end < text.size() && (text[end] == '#' || isDigitChar(text[end]))) ++end;
    } else {
      while (end < text.size() && (isDigitChar(text[end]) || text[end] == '.')) ++end;
    }
    word.value = text.substr(i, end - i);
    i = end;
    if (i < text.size() && text[i] == '=') {
      word.assigned = true;
      words.push_back(word);
      break;
    }
    words.push_back(word);
  }
}

const SignWord* SignLine::word(char letter) const {
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const SignWord& w) { return w.letter == letter; });
  return found == words.end() ? nullptr : &*found;
}

bool SignLine::hasCode(char letter, int tenths) const {
  return std::any_of(words.begin(), words.end(),
                     [&](const SignWord& w) { return w.letter == letter && codeTenths(w) == tenths; });
}

}  // namespace proveout::nc::guess
