#include "core/nc/text/program_likeness.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>

namespace proveout::nc {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Reads one line from left to right. Whatever a control might take is a word; values need not be right.
class LineReader {
 public:
  explicit LineReader(std::string_view line) : rest_(line) {}

  enum class Kind { kNothing, kBlock, kOther };
  Kind read() {
    int words = 0;
    for (skipEmpty(); !rest_.empty(); skipEmpty(), ++words) {
      if (statement()) return Kind::kBlock;
      if (!word() && !mark()) return Kind::kOther;
    }
    return words > 0 ? Kind::kBlock : Kind::kNothing;
  }

 private:
  char at(std::size_t i) const { return i < rest_.size() ? rest_[i] : '\0'; }
  void drop(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }

  /// Blanks, comments, the marks around and between blocks.
  void skipEmpty() {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '(')
        drop(rest_.find(')') == std::string_view::npos ? rest_.size() : rest_.find(')') + 1);
      else if (c == '$' || c == '!' || c == '%' || rest_.starts_with("//"))
        drop(rest_.size());
      else if (isBlank(c) || c == ';' || c == '*' || c == '\x1a')
        drop(1);
      else
        return;
    }
  }

  /// An assignment, or a keyword of the macro languages with what may stand behind it.
  bool statement() const {
    if (at(0) == '#') {
      std::size_t i = 1;
      while (at(i) == '#') ++i;
      const bool variable = isDigit(at(i)) || std::string_view("[_<").find(at(i)) != std::string_view::npos;
      return variable && i < rest_.size() && rest_.find('=', i) != std::string_view::npos;
    }
    return keyword({"IF", "WHILE"}, "[#") || keyword({"GOTO", "DO", "END", "CALL"}, "0123456789[#") ||
           keyword({"POPEN", "PCLOS", "BPRNT", "DPRNT", "FOPEN", "FCLOS", "SETVN"}, "0123456789[#<");
  }

  /// One of them, and behind it one of the characters; a long one may stand alone.
  bool keyword(std::initializer_list<std::string_view> words, std::string_view behind) const {
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
      std::size_t i = 0;
      while (i < word.size() && std::toupper(static_cast<unsigned char>(at(i))) == word[i]) ++i;
      if (i < word.size()) return false;
      while (i < rest_.size() && isBlank(rest_[i])) ++i;
      return i == rest_.size() ? word.size() > 4 : behind.find(rest_[i]) != std::string_view::npos;
    });
  }

  /// One or two letters and a number, a variable or a formula: "X-1.5", "G 01", "R1=[#2+1]", "X=#3", "N10.".
  bool word() {
    std::size_t i = 0;
    while (i < 2 && isLetter(at(i))) ++i;
    if (i == 0) return false;
    if (i == 1)
      while (isBlank(at(i)) && i < rest_.size()) ++i;
    while (at(i) == '=' || at(i) == '+' || at(i) == '-') ++i;
    if (at(i) == '[' || at(i) == '(') return formula(i);
    const std::size_t first = i;
    while (at(i) == '#') ++i;
    while (isDigit(at(i)) || at(i) == '.') ++i;
    if (i == first) return false;
    if (at(i) == '=') i = rest_.size();  // "P1100=2+3": whatever is assigned
    drop(i);
    return true;
  }

  bool formula(std::size_t from) {
    const char open = at(from), close = open == '[' ? ']' : ')';
    int depth = 0;
    for (std::size_t i = from; i < rest_.size(); ++i) {
      if (rest_[i] == open) ++depth;
      if (rest_[i] == close && --depth == 0) return drop(i + 1), true;
    }
    return false;
  }

  /// Optional skip "/2", program number ":12", file name "<sub.nc>".
  bool mark() {
    if (at(0) == '<') {
      const std::size_t end = rest_.find('>');
      drop(end == std::string_view::npos ? 0 : end + 1);
      return end != std::string_view::npos;
    }
    if ((at(0) != '/' && at(0) != ':') || (at(0) == ':' && !isDigit(at(1)))) return false;
    std::size_t i = 1;
    while (isDigit(at(i))) ++i;
    drop(i);
    return true;
  }

  std::string_view rest_;
};

/// Programs may hold some: tabs, form feeds, the codes of tape readers (DC1 to DC4), the end of file of DOS.
bool isForeign(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\t' && c != '\f' && c != '\x1a' && !(code >= 0x11 && code <= 0x14)) ||
         code == 0x7F;
}

/// Behind blanks and the number of the block: "10 L X+5" and "N10 CYCLE83(" alike.
std::string_view behindNumber(std::string_view line) {
  std::size_t i = 0;
  while (i < line.size() && isBlank(line[i])) ++i;
  const std::size_t first = i;
  if (i < line.size() && (line[i] == 'N' || line[i] == 'n')) ++i;
  const std::size_t digits = i;
  while (i < line.size() && isDigit(line[i])) ++i;
  if (i == digits) i = first;
  while (i < line.size() && isBlank(line[i])) ++i;
  return line.substr(i);
}

/// Signs of a language at the start of its blocks; `#` stands for a digit. One that is `sure` is enough, of
/// the others three lines are.
struct ForeignSign {
  std::string_view begins;
  bool sure = false;
};
struct ForeignLanguage {
  std::string_view name;
  std::initializer_list<ForeignSign> signs;
};
const ForeignLanguage kForeignLanguages[] = {
    {"a dialogue program of Heidenhain (.H, such as BEGIN PGM, TOOL CALL, L X+10 FMAX), which TNC controls "
     "read",
     {{"BEGIN PGM", true},
      {"END PGM", true},
      {"BLK FORM", true},
      {"TOOL CALL", true},
      {"TOOL DEF"},
      {"CYCL DEF"},
      {"CYCL CALL"},
      {"LBL #"},
      {"CALL LBL"},
      {"L X"},
      {"L Y"},
      {"L Z"},
      {"L IX"},
      {"L IY"},
      {"L IZ"},
      {"CC X"},
      {"CC Y"},
      {"FN #"}}},
    {"a program of Sinumerik (such as WORKPIECE(), CYCLE83(), DEF REAL, T=\"NAME\"), which Siemens controls "
     "read",
     {{"%_N_", true},
      {";$PATH", true},
      {"WORKPIECE(", true},
      {"CYCLE##", true},
      {"MCALL", true},
      {"DEF REAL", true},
      {"DEF INT", true},
      {"PROC ", true},
      {"EXTERN ", true},
      {"MSG(\""},
      {"T=\""},
      {"TRANS "},
      {"TRANS\r"},
      {"ATRANS "},
      {"ROT "},
      {"AROT "},
      {"SUPA"},
      {"G0 SUPA"},
      {"TRAORI"}}},
};

bool beginsWith(std::string_view line, std::string_view sign) {
  if (line.size() < sign.size()) return false;
  for (std::size_t i = 0; i < sign.size(); ++i) {
    const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(line[i])));
    if (sign[i] == '#' ? !isDigit(c) : c != sign[i]) return false;
  }
  return true;
}

}  // namespace

std::string foreignLanguage(const std::vector<std::string_view>& lines) {
  constexpr std::size_t kLooked = 2000, kEnough = 3;
  for (const ForeignLanguage& language : kForeignLanguages) {
    std::size_t signs = 0;
    for (std::size_t k = 0; k < std::min(lines.size(), kLooked) && signs < kEnough; ++k) {
      const std::string_view line = behindNumber(lines[k]);
      for (const ForeignSign& sign : language.signs) {
        if (!beginsWith(line, sign.begins)) continue;
        signs += sign.sure ? kEnough : 1;
        break;
      }
    }
    if (signs >= kEnough) return std::string(language.name);
  }
  return {};
}

bool mayBeProgram(const std::vector<std::string_view>& lines) {
  constexpr std::size_t kForeignShare = 50;  // one foreign character in so many is no accident
  constexpr std::size_t kBlockShare = 20;    // one block in so many lines is one, as in a text about programs
  std::size_t size = 0, foreign = 0, blocks = 0, others = 0;
  for (const std::string_view line : lines) {
    size += line.size() + 1;
    foreign += static_cast<std::size_t>(std::count_if(line.begin(), line.end(), isForeign));
    const LineReader::Kind kind = LineReader(line).read();
    if (kind == LineReader::Kind::kBlock) ++blocks;
    if (kind == LineReader::Kind::kOther) ++others;
  }
  return foreignLanguage(lines).empty() && foreign * kForeignShare <= size && blocks * kBlockShare >= others;
}

}  // namespace proveout::nc
