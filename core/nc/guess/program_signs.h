// What a program shows of the control that it is written for: signs, counted while its lines are read.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proveout::nc::guess {

/// In the order of the sign table, which says what each is and whom it speaks for.
enum class Sign {
  // The form of the text.
  kProgramNumber,     ///< line "O1234"
  kFiveDigitNumber,   ///< line "O00123"
  kPercentNumber,     ///< line "%O1234"
  kPercentName,       ///< line "%PLATE"
  kPercent,           ///< line "%"
  kNameInBrackets,    ///< "O<NAME>", "<NAME>"
  kColonNumber,       ///< line ":1234"
  kOWord,             ///< "o<name> sub", "o100 if"
  kNamedVariable,     ///< "#<name>"
  kEndOfBlock,        ///< blocks that end in ';', most of all
  kSemicolonComment,  ///< "; text"
  kDollarComment,     ///< "$ text"
  kSlashComment,      ///< "// text"
  kSenderCommand,     ///< "$H", "$J=", "~"
  kActiveComment,     ///< "(debug, x)"
  kMessage,           ///< "(msg, x)"
  kLowerCase,         ///< words in lower case, most of all
  kPointAtEnd,        ///< coordinates like "X10.", no whole ones without it
  kWholeNumbers,      ///< coordinates like "X10"
  kPaddedCodes,       ///< "G00", "M03"
  kUnpaddedCodes,     ///< "G0", "M3"
  // Formulas and flow.
  kParenFormula,         ///< "X(26/2)"
  kParenIf,              ///< "IF (#1<=6) N10"
  kCycleVariables,       ///< "G83 #2=2 #3=-14"
  kPointVariable,        ///< "P1100=20"
  kTemplate,             ///< "G77X20A17Y1.5Z0P2C2B2V0"
  kRepeat,               ///< REPEAT, GOSUB, RET
  kOffsetRow,            ///< "H001=150"
  kVariable,             ///< "#12"
  kMacroFlow,            ///< IF [..] GOTO, WHILE [..] DO
  kRound,                ///< ROUND[ ], BIN[ ], BCD[ ], ADP[ ]
  kPower,                ///< "**"
  kExists,               ///< EXISTS[ ]
  kIncrementalOperator,  ///< "XI10"
  kParameterBlock,       ///< "N1416.TOL"
  kColonPair,            ///< "G01 X1. : G01 X2."
  kThreadingCodes,       ///< T84 to T87, C001
  kTaperWords,           ///< "G51 A2."
  // Words.
  kDwellMilliseconds,  ///< "G4 P500"
  kDwellSeconds,       ///< "G4 P0.5"
  kDwellX,             ///< "G4 X1.5"
  kDwellE,             ///< "G4 E0.2"
  kRepeatedCall,       ///< "M98 P30012"
  kCallWithL,          ///< "M98 P1234 L2"
  kOtherPrograms,      ///< several O in the file
  kLocalCall,          ///< "M97 P100"
  kHomeAlone,          ///< "G28"
  kHomeIncremental,    ///< "G28 G91 Z0"
  kHomeUW,             ///< "G28 U0"
  kMachineTop,         ///< "G53 G0 Z0", "G0 G53 Z0"
  kLengthOffset,       ///< "G43 H1"
  kLengthOffsetAlone,  ///< "G43" without H
  kToolChange,         ///< "T1 M6"
  kTurretTool,         ///< "T0101"
  kHaasTurretTool,     ///< "T101"
  kToolWithOffset,     ///< "T1M06D11"
  kSpeedLimit,         ///< "G50 S2500"
  kTurningCycle,       ///< "G71 P10 Q20", "G70 P10 Q20"
  kContourCycle,       ///< "G77 G41 .. P200 Q209"
  kTwoLineCycle,       ///< "G71 U2. R1."
  kOneLineCycle,       ///< "G71 P10 Q20 U.. D.."
  kFanucThread,        ///< "G76 P010060 Q100 R0.05", "G76 X Z P Q F"
  kHaasThread,         ///< "G76 X Z K D F"
  kNgcThread,          ///< "G76 P Z I J K"
  kSurfaceSpeed,       ///< G96
  kNoY,                ///< X and Z are moved, and never Y
  kY,                  ///< Y is moved
  kPathTolerance,      ///< "G64 P0.01"
  kArcMode,            ///< G91.1, G90.1
  kOutputs,            ///< M62 to M68 with P, E, Q
  kDrillCycle,         ///< G73, G81 to G89 with Z
  kCompensation,       ///< G41, G42
  kTurnsL,             ///< "G2 ... L3"
  kCornerWords,        ///< ",R5" ",C2"
  kMachHead,           ///< "G90 G94 G91.1 G40 G49 G17"
  kNoHead,             ///< neither '%' nor a program number
  kRouter,             ///< nothing but lines, arcs, spindle and end
  kChipConveyor,       ///< M31, M33
  kSystemMacro,        ///< "G65 P9999"
  kCount
};

/// The first place of something that was seen.
struct Seen {
  int count = 0;
  int line = 0;      ///< from 1; 0: not of one line
  std::string text;  ///< the block or word, as the program has it, shortened
  void add(int at, std::string_view what);
};

struct ProgramSigns {
  std::array<Seen, static_cast<std::size_t>(Sign::kCount)> signs;
  std::map<int, Seen> codes;  ///< G codes, ten times their number
  std::map<std::string, Seen>
      names;        ///< of controls and posts in comments, upper case; see namesInComments()
  Seen printer;     ///< words of 3-D printers
  int blocks = 0;   ///< lines with words
  int motions = 0;  ///< blocks with X, Y, Z, U or W

  const Seen& of(Sign sign) const { return signs[static_cast<std::size_t>(sign)]; }
  Seen& of(Sign sign) { return signs[static_cast<std::size_t>(sign)]; }
};

/// Names that readSigns looks for in comments.
std::vector<std::string_view> namesInComments();

ProgramSigns readSigns(const std::vector<std::string_view>& lines);

}  // namespace proveout::nc::guess
