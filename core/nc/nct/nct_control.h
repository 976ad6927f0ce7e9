// The nct milling control: runs a program block by block. Block life: lex, collect codes, plan (all checks,
// on a copy of the modal state), perform (emit motions and events), commit.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "core/nc/interpreter.h"
#include "core/nc/lexer.h"
#include "core/nc/nct/nct_context.h"

namespace proveout::nc {

/// The run loop of one channel: lines, header, program flow. What codes do is in the chapters' files.
class NctControl {
 public:
  NctControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
             Progress* progress, const ControlHost& host);
  InterpretSummary run();

 private:
  enum class Go { kOn, kStop };

  // nct_control.cpp
  bool start();
  bool loadMain();
  Go step();
  Go endOfText();
  Go execute();
  bool openDeferred();
  bool checkRepeats();
  bool checkHeader();
  bool onlyHeaderAbove() const;
  bool skipKeepsLookAhead();
  bool reachedUntil() const;

  // nct_flow.cpp
  Go flow(const BlockPlan& plan);
  Go call();
  bool loadCalled(CallFrame& frame);
  bool take(const ProgramStore::Loaded& loaded, CallFrame& frame);
  Go returnFrom();
  Go alarm();
  Go stopAtAlarm();
  Go finish(const std::string& code, ProgramEnd end);
  /// To block N`block` of the frame's text; looks for it from line index `from` on, then from the start.
  bool jump(CallFrame& frame, std::int64_t block, std::size_t from = 0);
  void warnRepeated(const CallFrame& frame, std::int64_t block, std::size_t from);

  // nct_statements.cpp
  Go statement();
  Go behindIf();
  bool endStatement(std::size_t pos);
  bool failStatement(const LexError& error);
  Go goTo(std::size_t pos);
  Go enterLoop(std::size_t pos);
  Go endLoop();
  const LoopIndex::Mark* loopMark(std::size_t pos);

  InterpretSummary summary_;
  NctContext context_;
  Lexer lexer_;
  bool until_hit_ = false;
  std::set<std::pair<std::uint32_t, std::int64_t>> repeated_told_;  ///< by file and block number
};

}  // namespace proveout::nc
