// The wire EDM control: runs a program block by block (digest wedm). Block life: read, plan on a copy of the
// modal state, perform, commit.
#pragma once

#include <cstddef>
#include <string>

#include "core/nc/flow/run_loop.h"
#include "core/nc/wedm/wedm_context.h"
#include "core/nc/wedm/wedm_plan.h"

namespace proveout::nc {

/// Blocks, calls and ends; RunLoop leads through the programs.
class WedmControl : private FlowControl<FlowFrame> {
 public:
  /// What is referred to must outlive the control; `progress` may be null.
  WedmControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
              Progress* progress);
  /// Once. Errors go to the sink; the summary says how it ended.
  InterpretSummary run();

 private:
  Reading read() override;
  bool workOver() override;
  /// Loops of blocks that do nothing must have an end too.
  bool countsAll() const override { return true; }
  void refuse() override;
  Go carryOut() override;
  Go endOfText() override;
  bool opens() override;
  bool opened() override;
  void closed(const FlowFrame& left) override;
  void giveUp() override;
  bool flush(ProgramEnd end) override;
  void sendEnd(const std::string& code) override;
  void tell(const char* what, const std::string& message) override;
  const SourceText& text() const override { return c_.program.text(); }
  std::size_t line() const override;

  bool start();
  FlowFrame programFrom(std::size_t block) const;
  void beginWords();
  bool perform(WedmPlan& p);
  Go flow(const WedmPlan& p);
  Go call(const WedmCall& call);
  bool closedBehindEnd();

  WedmContext c_;
  RunLoop<FlowFrame> loop_;
};

}  // namespace proveout::nc
