// Lines and statements of LinuxCNC.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/flow/run_loop.h"
#include "core/nc/iso/context/context.h"
#include "core/nc/iso/model/language.h"
#include "core/nc/linuxcnc/files/lcn_settings.h"
#include "core/nc/linuxcnc/flavours/grbl.h"
#include "core/nc/linuxcnc/macro/lcn_expression.h"
#include "core/nc/linuxcnc/macro/lcn_o_words.h"
#include "core/nc/linuxcnc/macro/lcn_variables.h"
#include "core/nc/linuxcnc/model/channel.h"
#include "core/nc/linuxcnc/program/lcn_system_values.h"
#include "core/nc/linuxcnc/text/lcn_line.h"

namespace proveout::nc {

/// Programs that may be open at once, the main program counted.
inline constexpr std::size_t kLcnLevels = 10;

/// Reads lines with their expressions (LinuxCNC documentation, "G-code overview") and carries out O-words,
/// assignments and active comments.
class LinuxCncLanguage final : public IsoLanguage, private LcnNames {
 public:
  /// `c` must outlive the language.
  explicit LinuxCncLanguage(IsoContext& c);

  bool read(const SourceText& text, std::size_t line, Block& block, LexError& error) override;
  std::optional<Go> statement(StatementFlow& flow) override;
  std::optional<Go> endOfText(StatementFlow& flow) override;
  void left(const CallFrame& frame) override;
  std::uint64_t fingerprint() const override;

  LcnVariables& variables() { return variables_; }
  /// Mist and coolant are off.
  void programEnds() { run_.mist = run_.flood = false; }
  bool coolant() const { return run_.mist || run_.flood; }

 private:
  // LcnNames
  bool hasParameter(int number) const override;
  Value parameter(int number) override;
  bool named(std::string_view name, Value& out) override;

  bool ofMachine(std::string_view name, Value& out) const;
  bool start(StatementFlow& flow);
  std::optional<Go> words(StatementFlow& flow);
  void loadTools();
  void takeKept();
  void assign(int number, const Value& value);

  // program/lcn_reader.cpp
  struct Assignment {
    LcnParameter to;
    Value value;
  };
  GrblFault plainGrblFault() const;
  bool readItems(std::size_t pos, Block& block);
  bool readNumber(std::size_t& pos, Block& block);
  bool readWord(std::size_t& pos, Block& block);
  bool otherUse(char letter) const;
  bool plainValue(std::size_t& pos, Word& word) const;
  bool evaluatedValue(std::size_t& pos, Word& word);
  bool readAssignment(std::size_t& pos);
  bool readPercent(const SourceText& text, std::size_t line, Block& block);
  bool takeCode(Word& word, std::size_t begin, std::size_t end);
  bool storeWord(const Word& word, std::size_t begin, std::size_t end, Block& block);
  bool checkCodes(const Block& block);
  bool fault(const char* name, std::string message, std::size_t begin, std::size_t end);
  std::size_t indexOf(int column) const;

  // program/lcn_comments.cpp
  bool activeComment(std::string_view& kind, std::string_view& rest) const;
  bool comment();
  std::string withValues(std::string_view text);

  // program/lcn_functions.cpp
  bool functions(StatementFlow& flow);
  static bool isOwn(int m);
  bool function(const Word& m, StatementFlow& flow);
  const Word* functionWord(Address letter);
  void dropWords(const std::vector<Word>& own);
  bool functionFails(const Word& m, const char* name, std::string message);
  bool spindleNumber();
  bool stopAtChange();
  bool override(const Word& m);
  bool output(const Word& m);
  bool input(const Word& m);
  bool toolNumber(const Word& m);
  bool knowsTool(int tool) const;
  bool unknownTool(const Word& w);
  bool selects(const Word& t);
  bool orient(const Word& m);
  bool userFunction(const Word& m);

  // program/lcn_remap.cpp
  const Word* remappedWord(std::string& code) const;
  std::optional<Go> remapped(StatementFlow& flow);

  // program/lcn_contour.cpp
  bool inContour() const;
  bool contourDone();
  std::optional<Go> openContour(StatementFlow& flow);
  void contourGoesTo();
  void takeContourLine();

  // program/lcn_saved_state.cpp
  struct Saved {
    std::size_t level = 0;   ///< programs that were open
    bool at_return = false;  ///< M73
    IsoState state;
    bool mist = false, flood = false;
    bool shift_on = false;  ///< of G92 and G52
  };
  bool savedState(const Word& m, StatementFlow& flow);
  bool restoreAtReturn(StatementFlow& flow);
  std::string restoringCodes(const IsoState& was) const;
  std::string restoringWords(const Saved& saved) const;
  bool restore(const Saved& saved, StatementFlow& flow);
  bool runLine(const std::string& words, StatementFlow& flow);

  // program/lcn_statements.cpp
  Go oWord(StatementFlow& flow);
  Go oWordFails(StatementFlow& flow, const char* name, const std::string& message);
  Go evaluationFails(StatementFlow& flow);
  Go seekingFails(StatementFlow& flow, const std::string& label);
  bool condition(std::string_view text, const LcnOWord& word, LcnEvaluator& evaluator, double& value);
  bool lineEnds(std::string_view text, std::size_t pos);
  LcnOWord oWordOn(std::size_t line, LcnLine& out) const;
  Go branch(const LcnOWords& words, std::size_t index, StatementFlow& flow);
  void missingEnd(const LcnOWords::Statement& s, const char* end);
  Go loop(const LcnOWords& words, std::size_t index, StatementFlow& flow);
  Go endDo(const LcnOWords& words, std::size_t index, bool again, StatementFlow& flow);
  Go endRepeat(std::size_t head);
  void tellLeftOver(const char* what, const char* effect);
  Go leaveLoop(const LcnOWords& words, std::size_t index, StatementFlow& flow);
  Go defineSub(const LcnOWords& words, std::size_t index, StatementFlow& flow);
  void valueOfDefinition(std::size_t line);
  Go returnValue(StatementFlow& flow);
  Go callSub(StatementFlow& flow);
  Go callNumbered(StatementFlow& flow);
  Go returnNumbered(StatementFlow& flow);
  bool isReturn() const;
  bool repeatsProgram() const;
  bool findProgram(const std::string& label, bool sub, CallFrame& frame);
  Go jumpBehind(const LcnOWords& words, std::size_t statement, StatementFlow& flow);
  bool readsOver(const LcnOWords& words, std::size_t line);
  bool evaluatesBranches(const LcnOWords& words, std::size_t index);
  LcnOWords& wordsOf(const SourceText& text);

  /// A program that a statement called.
  struct Open {
    bool sub = false;        ///< by an O-word, with a level of parameters; else by M98
    std::string remap = {};  ///< the code that stands for the call
    bool contour = false;    ///< of G70, G71, G72: its motions are gathered
  };
  /// A repeat that runs.
  struct Repeat {
    std::uint64_t run = 0;  ///< of its program (FlowFrame::run)
    std::size_t line = 0;
    std::int64_t left = 0;
  };

  /// A line with G70, G71 or G72 whose sub runs.
  struct Contour {
    std::uint64_t run = 0;  ///< of its program (FlowFrame::run)
    std::size_t line = 0;
    Block block;                      ///< its words
    double unit = 1.0, x_unit = 1.0;  ///< mm of Z and X in its lines
    bool steps = false;               ///< G91
    std::vector<LinuxCncContourLine> lines = {};
    bool done = false;  ///< the sub has returned
  };

  IsoContext& c_;
  LcnVariables variables_;
  LcnRunState run_;
  std::map<const SourceText*, std::unique_ptr<LcnOWords>> o_words_;
  std::map<const SourceText*, bool> percent_;  ///< the text opens with %
  std::vector<Open> open_;                     ///< calls, outermost first
  std::vector<Repeat> repeats_;
  std::vector<Saved> saved_;  ///< of M70 and M73
  std::optional<Contour> contour_;
  LcnMachine machine_;
  std::set<int> tools_;                ///< of the tool table
  std::deque<std::string> own_lines_;  ///< that run now and stand in no program
  bool started_ = false;
  bool seeking_ = false;  ///< the branch in hand is one that a false condition led to
  bool leaves_do_ = false;
  // What LinuxCNC 2.9 forgets to take back: a break out of a while that the end of the next do takes for its
  // own, a continue of a do that the end of the next while or repeat takes for its own.
  bool break_left_ = false, continue_left_ = false;

  // Of the line in hand.
  LcnLine line_;
  LcnFault fault_;
  std::vector<Assignment> assignments_;
  std::optional<LcnOWord> o_word_;
  bool calls_ = false;  ///< M98 or M99
  AddressSet taken_;    ///< words that belong to functions
};

/// The parameters of a channel that runs LinuxCNC.
LcnVariables& linuxCncVariables(IsoContext& c);

}  // namespace proveout::nc
