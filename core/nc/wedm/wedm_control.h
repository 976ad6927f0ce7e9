// The wire EDM control: runs a program block by block (digest wedm). Block life: read, plan on a copy of the
// modal state, perform, commit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/nc/limits/loop_budget.h"
#include "core/nc/wedm/wedm_context.h"
#include "core/nc/wedm/wedm_plan.h"

namespace proveout::nc {

/// The run loop: blocks in their order, calls, ends.
class WedmControl {
 public:
  /// What is referred to must outlive the control; `progress` may be null.
  WedmControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
              Progress* progress);
  /// Once. Errors go to the sink; the summary says how it ended.
  InterpretSummary run();

 private:
  enum class Go : std::uint8_t {
    kOn,
    kReturn,  ///< from the subprogram
    kStop     ///< the run is over
  };

  bool start();
  Go runFrom(std::size_t block, const WedmLevel::Call& call = {});
  Go endOfText();
  Go block(std::size_t index);
  Go execute();
  bool perform(WedmPlan& p);
  Go flow(const WedmPlan& p);
  Go call(const WedmCall& call);
  Go finish(const char* code, ProgramEnd end);
  Go failed();
  bool workOver();
  bool goesOn();
  bool reachedUntil() const;
  bool closedBehindEnd();

  WedmContext c_;
  bool until_hit_ = false;
  std::uint64_t calls_ = 0;
  LoopBudget loops_;
};

}  // namespace proveout::nc
