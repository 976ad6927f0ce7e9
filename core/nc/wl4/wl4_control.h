// The WL4 control, milling and turning: runs a program block by block (digest wl4). Block life: read
// (variables are assigned on the way), plan on a copy of the modal state, perform, commit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

/// The run loop: blocks in their order, calls, jumps.
class Wl4Control {
 public:
  /// What is referred to must outlive the control; `progress` may be null.
  Wl4Control(bool lathe, const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
             Progress* progress, const ControlHost& host);
  /// Once. Errors go to the sink; the summary says how it ended.
  InterpretSummary run();

 private:
  enum class Go : std::uint8_t {
    kOn,
    kReturn,  ///< from the subprogram
    kStop     ///< the run is over
  };

  bool start();
  Go runProgram(const Wl4Program& program, const Wl4Level::Call& call);
  Go endOfText(const Wl4Program& program);
  Go block(std::size_t& next_line);
  bool endless();
  bool isOwnError(std::size_t here) const;
  Go execute(std::size_t& next_line);
  bool carryOut(Wl4BlockPlan& p);
  void commit(Wl4BlockPlan& p);
  Go cycles(const Wl4BlockPlan& p);
  Go flow(std::size_t& next_line);
  Go failed();
  Go finish(const std::string& code, ProgramEnd end);
  bool reachedUntil() const;
  Go subprograms();
  Go call(const std::string& name, int times);
  Go jump(std::int64_t label, std::size_t& next_line);

  Wl4Context c_;
  bool in_cycle_ = false;  ///< inside a fixed cycle: motions do not call it again
  bool until_hit_ = false;
  std::uint64_t runs_ = 0, calls_ = 0;  ///< programs opened; calls that opened them
};

}  // namespace proveout::nc
