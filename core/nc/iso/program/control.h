// A control of the ISO family: runs a program block by block. Block life: lex, collect codes, plan (all
// checks, on a copy of the modal state), perform (emit motions and events), commit.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/progress.h"
#include "core/nc/control/control_host.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/flow/run_loop.h"
#include "core/nc/iso/context/context.h"
#include "core/nc/iso/macro/subprogram_words.h"
#include "core/nc/iso/model/system_calls.h"
#include "core/nc/iso/program/tape.h"
#include "core/nc/text/lexer.h"
#include "core/nc/text/source_text.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// The run loop of one channel: lines, header, program flow. What codes do is in the chapters' files.
class IsoControl final : private FlowControl<CallFrame>, private StatementFlow {
 public:
  /// What is handed in must outlive the control.
  IsoControl(const IsoDialect& dialect, const ProgramSource& source, const ControlSettings& settings,
             MotionSink& sink, Progress* progress, const ControlHost& host);
  InterpretSummary run();

  // The same step by step, for several channels.
  /// Power-on, and the main program is loaded. False: an error was reported.
  bool start();
  enum class Turn {
    kOn,
    kWaits,  ///< context().waiting says for whom; endWait() lets it go on
    kEnded   ///< summary().end says how
  };
  /// The next block.
  Turn advance();
  const InterpretSummary& summary() const { return summary_; }
  IsoContext& context() { return context_; }

 private:
  // program/control.cpp: what the run loop asks
  Go due() override;
  Reading read() override;
  bool workOver() override;
  void refuse() override {}  // reported where it was found
  Go carryOut() override;
  Go resume() override { return Go::kNext; }
  Go endOfText() override;
  bool opens() override { return true; }
  bool opened() override;
  void closed(const CallFrame& left) override;
  bool flush(ProgramEnd end) override;
  void sendEnd(const std::string& code) override;
  void tell(const char* what, const std::string& message) override { context_.fail(what, message); }
  const SourceText& text() const override { return *context_.calls.top().text; }
  std::size_t line() const override { return context_.calls.lineIndex(); }

  // program/language.cpp: what statements of a control's own language ask
  Go openCall(const CallFrame& frame, int times) override;
  Go endRun(const std::string& code) override;
  Go failed(bool nowhere) override;
  void statementDone() override { run_.blockDone(); }
  bool carryOutWords() override;
  Reading readLanguage();
  Go carryOutLanguage();

  bool loadMain();
  Go commentLeftOpen(const std::optional<OpenComment>& open);
  Go execute();
  Go openLines(const LineRange& lines);

  // program/flow.cpp
  Go flow(const BlockPlan& plan);
  Go flow(const FlowRequest& request);
  bool returnWords(FlowRequest& request);
  /// A call of block N`P` of the program in hand (IsoRules::local_call).
  Go callLocal();
  Go call(int code);
  /// The frame of a call by IsoDialect::subprogram. False: reported.
  bool subprogramFrame(int code, CallFrame& frame);
  /// The program of P or <file> of the block, as seen from file `caller`.
  bool loadCalled(CallFrame& frame, std::string_view code, std::uint32_t caller);
  Go returnFrom(const FlowRequest& request);
  Go alarm();
  Go stopAtAlarm();
  /// To block N`block` of the frame's text; looks for it from line index `from` on, then from the start.
  bool jump(CallFrame& frame, std::int64_t block, std::size_t from = 0,
            SharedAlarm missing = SharedAlarm::kBlockNotFound);
  /// False: more programs would be open than the control allows, reported.
  bool mayNest(const CallFrame& frame);
  void warnRepeated(const CallFrame& frame, std::int64_t block, std::size_t from);

  // macro/statements.cpp
  Go statement();
  bool condition(std::size_t& pos, bool& holds);
  Go behindIf();
  Go goTo(std::size_t pos);
  Go enterLoop(std::size_t pos);
  Go endLoop();

  // macro/calls.cpp
  /// What a block calls instead of being executed.
  struct MacroCall {
    static constexpr std::int32_t kSystem = -1;
    const Word* word = nullptr;        ///< that calls
    std::int32_t code10 = kSystem;     ///< G65, G66, G66.1, or kSystem
    SystemCall system;                 ///< with kSystem
    const CallFrame* modal = nullptr;  ///< the active G66.1 macro that takes the block as arguments
  };
  bool findCall(bool statement, MacroCall& call);
  bool findMMacro(MacroCall& call);
  Go callMacro(const MacroCall& call);
  Go open(const CallFrame& frame);
  bool explicitFrame(const MacroCall& call, CallFrame& frame);
  bool systemFrame(const MacroCall& call, CallFrame& frame);
  Go callFromBlock(const CallFrame& modal);
  void deferCalls(const BlockPlan& plan);

  // macro/interrupt.cpp
  bool takeInterruptWords();
  void switchInterrupt();
  Go followInterrupts();
  Go breakInterruptOff();
  bool endInterrupt(bool restore);

  InterpretSummary summary_;
  ControlSettings settings_;
  IsoContext context_;
  std::unique_ptr<SystemVariables> system_variables_;
  std::unique_ptr<IsoLanguage> language_;  ///< null: lexer and macro language of the family
  RunLoop<CallFrame> run_;
  Lexer lexer_;
  TapeFrames tape_;
  SubprogramWords subprograms_;                                     ///< of the block in hand
  InterruptSwitch interrupt_switch_ = InterruptSwitch::kNone;       ///< of the block in hand
  double main_passes_ = 0;                                          ///< of the main program, ended by M99
  CallFrame interrupt_frame_;                                       ///< with kOn
  MacroCall macro_call_;                                            ///< of the block in hand
  bool calls_macro_ = false;                                        ///< it is one
  std::set<std::pair<std::uint32_t, std::int64_t>> repeated_told_;  ///< by file and block number
  std::set<std::uint32_t> no_return_told_;                          ///< by file
};

}  // namespace proveout::nc
