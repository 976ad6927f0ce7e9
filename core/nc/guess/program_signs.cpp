#include "core/nc/guess/program_signs.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/nc/guess/sign_line.h"

namespace proveout::nc::guess {
namespace {

constexpr std::size_t kMostLines = 100'000;
constexpr std::size_t kMostText = 40;  // characters of a block in a reason

constexpr std::string_view kNames[] = {
    "HAAS",      "FANUC",    "LINUXCNC", "EMC2",    "GRBL",     "MACH3",      "MACH 3",    "MACH2",
    "UCCNC",     "ESTLCAM",  "SHAPEOKO", "CARBIDE", "EASEL",    "OPENBUILDS", "CNCJS",     "TORMACH",
    "PATHPILOT", "WL4",      "FLEXNC",   "FLEX NC", "NCT",      "LATHE",      "WIRE EDM",  "MASTERCAM",
    "MCX FILE",  "SOLIDCAM", "VCARVE",   "CUT2D",   "SHEETCAM", "VECTRIC",    "BLENDERCAM"};

bool isDigitOf(char c) { return c >= '0' && c <= '9'; }
bool isAlnumOf(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.remove_suffix(1);
  return text;
}

/// `text` as words of their own: not a part of a longer one.
bool standsIn(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const bool before = at == 0 || !isAlnumOf(text[at - 1]);
    const std::size_t end = at + name.size();
    if (before && (end == text.size() || std::isalpha(static_cast<unsigned char>(text[end])) == 0))
      return true;
  }
  return false;
}

bool isAxis(char letter) { return std::string_view("XYZUVW").find(letter) != std::string_view::npos; }

class SignReader {
 public:
  ProgramSigns run(const std::vector<std::string_view>& lines) {
    for (std::size_t i = 0; i < std::min(lines.size(), kMostLines); ++i) {
      line_ = static_cast<int>(i) + 1;
      text_ = trimmed(lines[i]);
      if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
      if (text_.empty()) continue;
      if (text_.front() == '%')
        percent();
      else
        block(SignLine(text_));
    }
    conclude();
    return std::move(out_);
  }

 private:
  void see(Sign sign) { out_.of(sign).add(line_, text_); }
  void see(Sign sign, bool seen) {
    if (seen) see(sign);
  }

  void percent() {
    const std::string_view behind = trimmed(text_.substr(1));
    const bool first = std::exchange(first_, false);
    if (behind.empty()) return see(Sign::kPercent);
    const char c = static_cast<char>(std::toupper(static_cast<unsigned char>(behind.front())));
    if ((c == 'O' || c == ':') && behind.size() > 1 && isDigitOf(behind[1])) {
      see(Sign::kPercentNumber);
      ++numbers_;
    } else if (first && (isAlnumOf(c) || c == '_')) {
      see(Sign::kPercentName);
    }
  }

  void comment(const SignLine& line) {
    see(Sign::kSemicolonComment, line.semicolon_comment);
    see(Sign::kDollarComment, line.dollar_comment);
    see(Sign::kSlashComment, line.slash_comment);
    for (const std::string_view active : {"AXIS,", "DEBUG,", "PRINT,", "LOGOPEN,", "LOG,", "PROBEOPEN"})
      see(Sign::kActiveComment, line.comment.starts_with(active));
    see(Sign::kMessage, line.comment.starts_with("MSG,"));
    for (const std::string_view name : kNames) {
      if (standsIn(line.comment, name)) out_.names[std::string(name)].add(line_, text_);
    }
  }

  void block(const SignLine& line) {
    comment(line);
    if (line.code.empty()) return;
    if (line.code.front() == '$' || line.code == "~" || line.code == "?" || line.code == "!")
      return see(Sign::kSenderCommand);
    first_ = false;
    ++out_.blocks;
    lower_ += line.lower;
    upper_ += line.upper;
    if (line.semicolon_end) ++ends_;
    if (heads(line)) return;
    formulas(line);
    for (const SignWord& word : line.words) readWord(line, word);
    calls(line);
    tools(line);
    homes(line);
    cycles(line);
    modes(line);
    const bool moves = std::any_of(line.words.begin(), line.words.end(), [](const SignWord& word) {
      return isAxis(word.letter) && !word.value.empty();
    });
    if (moves) ++out_.motions;
  }

  /// Program numbers and O-words; true: the line is nothing else.
  bool heads(const SignLine& line) {
    const std::string& code = line.code;
    if (code.front() == ':' && code.size() > 1 && isDigitOf(code[1])) {
      see(Sign::kColonNumber);
      ++numbers_;
      return true;
    }
    if (code.front() == '<') return see(Sign::kNameInBrackets), true;
    if (code.front() != 'O' || code.size() < 2) return false;
    std::size_t end = 1;
    if (code[1] == '<') {
      end = std::min(code.find('>'), code.size() - 1) + 1;
    } else {
      while (end < code.size() && (isDigitOf(code[end]) || code[end] == '#')) ++end;
      if (end == 1) return false;
    }
    const std::string_view behind = std::string_view(code).substr(end);
    for (const std::string_view keyword :
         {"SUB", "ENDSUB", "CALL", "IF", "ELSE", "ELSEIF", "ENDIF", "WHILE", "ENDWHILE", "DO", "REPEAT",
          "ENDREPEAT", "RETURN", "BREAK", "CONTINUE"}) {
      if (behind.starts_with(keyword)) return see(Sign::kOWord), true;
    }
    if (code[1] == '<') return see(Sign::kNameInBrackets), true;
    see(Sign::kProgramNumber);
    if (end == 6) see(Sign::kFiveDigitNumber);
    ++numbers_;
    see(Sign::kOtherPrograms, numbers_ > 1);
    return behind.empty();
  }

  void formulas(const SignLine& line) {
    const std::string& code = line.code;
    see(Sign::kNamedVariable, line.contains("#<"));
    see(Sign::kVariable, line.contains("#"));
    see(Sign::kParenIf, line.contains("IF("));
    see(Sign::kParenFormula, line.contains("(") && !line.contains("IF("));
    const bool flow = (line.contains("IF[") && (line.contains("]GOTO") || line.contains("]THEN"))) ||
                      (line.contains("WHILE[") && line.contains("]DO"));
    see(Sign::kMacroFlow, flow);
    see(Sign::kRound,
        line.contains("ROUND[") || line.contains("BIN[") || line.contains("BCD[") || line.contains("ADP["));
    see(Sign::kPower, line.contains("**"));
    see(Sign::kExists, line.contains("EXISTS["));
    see(Sign::kRepeat, code.starts_with("REPEAT") || code.starts_with("GOSUB") || code == "RET");
    see(Sign::kColonPair, code.find(':', 1) != std::string::npos);
    const SignWord* first = line.words.empty() ? nullptr : &line.words.front();
    if (first != nullptr && first->assigned && first->isWhole()) {
      see(Sign::kPointVariable, first->letter == 'P' && first->value.size() >= 3);
      see(Sign::kOffsetRow, first->letter == 'H' && first->value.size() == 3);
    }
    if (code.front() == 'N' && line.contains(".") && line.contains("=") && line.contains("N1"))
      see(Sign::kParameterBlock);
    const std::size_t hash = code.find('#');
    see(Sign::kCycleVariables, hash != std::string::npos && hash > 1 && code.front() == 'G' &&
                                   isDigitOf(code[hash - 1]) && code.find('=', hash) != std::string::npos);
  }

  void readWord(const SignLine& line, const SignWord& word) {
    const int tenths = codeTenths(word);
    const bool angle = isTemplate(line) && &word != line.word('G');  // G may be an argument there
    if (word.letter == 'G' && tenths >= 0 && !angle) {
      out_.codes[tenths].add(line_, "G" + std::string(word.value));
      if (tenths < 100 && word.value.size() > 1 && word.value[0] == '0') see(Sign::kPaddedCodes);
      if (tenths < 100 && word.value.size() == 1) see(Sign::kUnpaddedCodes);
    }
    if (word.letter == 'M' && (tenths == 1040 || tenths == 1090 || tenths == 1400 || tenths == 1900) &&
        line.has('S') && !line.has('T'))
      out_.printer.add(line_, text_);
    if (word.letter == 'E' && word.hasPoint() && (line.hasCode('G', 10) || line.hasCode('G', 920)) &&
        line.has('X') && line.has('Y'))
      out_.printer.add(line_, text_);
    if (std::string_view("XYZ").find(word.letter) != std::string_view::npos && !dwells(line)) {
      if (word.isWhole() && std::abs(word.number()) >= 1.0) whole_.add(line_, text_);
      if (word.isNumber() && word.value.back() == '.') point_.add(line_, text_);
      if (word.isNumber() && word.hasPoint()) ++pointed_;
    }
    if (word.letter == 'Y' && !word.value.empty()) see(Sign::kY);
    see(Sign::kCornerWords, word.comma && (word.letter == 'R' || word.letter == 'C'));
    if (word.letter == 'I' && word.isNumber() && &word != &line.words.front() && (&word)[-1].value.empty() &&
        std::string_view("XYZUVWRABC").find((&word)[-1].letter) != std::string_view::npos)
      see(Sign::kIncrementalOperator);
    if (word.letter == 'T' && word.isWhole()) {
      const double number = word.number();
      see(Sign::kThreadingCodes, number >= 84 && number <= 87 && word.value.size() == 2 && !line.has('M'));
    }
  }

  static bool isTemplate(const SignLine& line) {
    return line.has('G') && line.has('A') && line.has('P') && line.has('C') && !line.has('I');
  }
  static bool dwells(const SignLine& line) { return line.hasCode('G', 40); }

  void calls(const SignLine& line) {
    const SignWord* p = line.word('P');
    if (line.hasCode('M', 970) && p != nullptr) see(Sign::kLocalCall);
    if (line.hasCode('M', 980) && p != nullptr) {
      see(Sign::kRepeatedCall, p->isWhole() && p->value.size() > 4 && !line.has('L'));
      see(Sign::kCallWithL, line.has('L'));
    }
    see(Sign::kSystemMacro, line.hasCode('G', 650) && p != nullptr && p->value == "9999");
    if (!dwells(line)) return;
    see(Sign::kDwellX, line.has('X') || line.has('U'));
    see(Sign::kDwellE, line.has('E'));
    if (p == nullptr || !p->isNumber()) return;
    see(Sign::kDwellMilliseconds, p->isWhole() && p->number() >= 50);
    see(Sign::kDwellSeconds, p->hasPoint());
  }

  void tools(const SignLine& line) {
    const SignWord* t = line.word('T');
    const bool change = line.hasCode('M', 60);
    see(Sign::kToolChange, change);
    if (t != nullptr && t->isWhole()) {
      const bool alone = !change && !line.has('D');
      see(Sign::kTurretTool, alone && t->value.size() == 4);
      see(Sign::kHaasTurretTool,
          alone && t->value.size() == 3 && t->value[0] == t->value[2] && t->value[1] == '0');
      see(Sign::kToolWithOffset, change && line.has('D') && line.words.front().letter == 'T');
    }
    if (!line.hasCode('G', 430)) return;
    see(line.has('H') ? Sign::kLengthOffset : Sign::kLengthOffsetAlone);
  }

  void homes(const SignLine& line) {
    if (line.hasCode('G', 280)) {
      const bool named = std::any_of(line.words.begin(), line.words.end(),
                                     [](const SignWord& w) { return isAxis(w.letter) || w.letter == 'H'; });
      see(Sign::kHomeAlone, !named && !line.hasCode('G', 910));
      see(Sign::kHomeIncremental, named && line.hasCode('G', 910));
      see(Sign::kHomeUW, line.has('U') || line.has('W'));
    }
    const SignWord* z = line.word('Z');
    see(Sign::kMachineTop, line.hasCode('G', 530) && z != nullptr && z->number() == 0.0 && z->isNumber());
  }

  void cycles(const SignLine& line) {
    for (const int tenths : {730, 810, 820, 830, 840, 850, 860, 880, 890}) {
      if (line.hasCode('G', tenths) && (line.has('Z') || line.has('R'))) return see(Sign::kDrillCycle);
    }
    const bool contour = line.has('P') && line.has('Q');
    if (line.hasCode('G', 700) && contour) see(Sign::kTurningCycle);
    if (line.hasCode('G', 710) || line.hasCode('G', 720)) {
      see(Sign::kTurningCycle, contour);
      see(Sign::kOneLineCycle, contour && line.has('D'));
      see(Sign::kTwoLineCycle,
          !contour && line.has('R') && (line.has('U') || line.has('W')) && !line.has('X'));
    }
    see(Sign::kContourCycle, contour && (line.hasCode('G', 770) || line.hasCode('G', 780)));
    if (line.hasCode('G', 760)) threads(line);
  }

  void threads(const SignLine& line) {
    const SignWord* p = line.word('P');
    if (p == nullptr) return see(Sign::kHaasThread, line.has('K') && line.has('D') && line.has('X'));
    see(Sign::kNgcThread, line.has('I') && line.has('J') && line.has('K'));
    see(Sign::kHaasThread, line.has('K') && line.has('D') && line.has('X'));
    see(Sign::kFanucThread, !line.has('K') && line.has('Q') && (p->value.size() == 6 || line.has('X')));
  }

  void modes(const SignLine& line) {
    const auto hasOneOf = [&](char letter, std::initializer_list<int> all) {
      return std::any_of(all.begin(), all.end(), [&](int tenths) { return line.hasCode(letter, tenths); });
    };
    see(Sign::kSpeedLimit, line.hasCode('G', 500) && line.has('S'));
    see(Sign::kTemplate, isTemplate(line));
    see(Sign::kSurfaceSpeed, line.hasCode('G', 960));
    see(Sign::kPathTolerance, line.hasCode('G', 640) && line.has('P'));
    see(Sign::kArcMode, hasOneOf('G', {901, 911}));
    see(Sign::kMachHead, line.contains("G94G91.1G40"));
    see(Sign::kOutputs, hasOneOf('M', {620, 630, 640, 650, 660, 670, 680}) &&
                            (line.has('P') || line.has('E') || line.has('Q')));
    see(Sign::kCompensation, hasOneOf('G', {410, 420}));
    see(Sign::kTurnsL, hasOneOf('G', {20, 30}) && line.has('L'));
    see(Sign::kTaperWords, hasOneOf('G', {510, 520}) && line.has('A') && !line.has('Z'));
    see(Sign::kChipConveyor, hasOneOf('M', {310, 330}));
    const SignWord* c = line.word('C');
    see(Sign::kThreadingCodes,
        c != nullptr && line.words.size() == 1 && c->isWhole() && c->value.size() == 3 && c->value[0] == '0');
  }

  /// What only the whole program shows.
  void conclude() {
    const auto most = [&](int count, int of) { return count > 0 && 5 * count >= 4 * of; };
    const auto set = [&](Sign sign, const Seen& seen) { out_.of(sign) = seen; };
    if (most(ends_, out_.blocks)) out_.of(Sign::kEndOfBlock) = {ends_, 0, ""};
    if (most(lower_, lower_ + upper_)) out_.of(Sign::kLowerCase) = {lower_, 0, ""};
    if (point_.count >= 3 && 10 * whole_.count <= point_.count) set(Sign::kPointAtEnd, point_);
    if (whole_.count >= 3 && 4 * whole_.count >= pointed_) set(Sign::kWholeNumbers, whole_);
    const bool turned = out_.motions >= 6 && out_.of(Sign::kY).count == 0;
    if (turned) out_.of(Sign::kNoY) = {out_.motions, 0, ""};
    const bool head = numbers_ > 0 || out_.of(Sign::kPercent).count > 0 ||
                      out_.of(Sign::kPercentName).count > 0 || out_.of(Sign::kNameInBrackets).count > 0;
    if (!head && out_.blocks >= 8) out_.of(Sign::kNoHead) = {1, 0, ""};
    if (isRouter()) out_.of(Sign::kRouter) = {out_.motions, 0, ""};
  }

  bool isRouter() const {
    for (const Sign sign :
         {Sign::kProgramNumber, Sign::kPercentNumber, Sign::kPercentName, Sign::kColonNumber,
          Sign::kNameInBrackets, Sign::kOWord, Sign::kVariable, Sign::kParenFormula, Sign::kToolChange,
          Sign::kLengthOffset, Sign::kLengthOffsetAlone, Sign::kDrillCycle, Sign::kCompensation,
          Sign::kTurretTool, Sign::kDollarComment, Sign::kSlashComment, Sign::kEndOfBlock}) {
      if (out_.of(sign).count > 0) return false;
    }
    const bool simple = std::all_of(out_.codes.begin(), out_.codes.end(), [](const auto& code) {
      for (const int tenths :
           {0, 10, 20, 30, 40, 170, 180, 190, 200, 210, 280, 530, 540, 800, 900, 910, 940}) {
        if (code.first == tenths) return true;
      }
      return false;
    });
    return simple && out_.motions >= 6 && out_.of(Sign::kY).count > 0;
  }

  ProgramSigns out_;
  std::string_view text_;
  int line_ = 0;
  bool first_ = true;
  int numbers_ = 0, ends_ = 0, lower_ = 0, upper_ = 0, pointed_ = 0;
  Seen whole_, point_;
};

}  // namespace

void Seen::add(int at, std::string_view what) {
  if (count++ > 0) return;
  line = at;
  text = what.substr(0, kMostText);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) >= 0x7F) c = '?';
  }
}

std::vector<std::string_view> namesInComments() { return {std::begin(kNames), std::end(kNames)}; }

ProgramSigns readSigns(const std::vector<std::string_view>& lines) { return SignReader().run(lines); }

}  // namespace proveout::nc::guess
