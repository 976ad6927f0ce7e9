// The nct milling control: runs a program block by block. Block life: lex, collect codes, plan (all checks,
// on a copy of the modal state), perform (emit motions and events), commit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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
  bool jump(CallFrame& frame, std::int64_t block);

  InterpretSummary summary_;
  NctContext context_;
  Lexer lexer_;
  bool until_hit_ = false;
};

}  // namespace proveout::nc
