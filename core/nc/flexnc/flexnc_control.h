// The FlexNC control: runs a program line by line (digest flexnc). Life of a block: read (variables are
// assigned on the way), check its codes and addresses, carry out its words from left to right, jump.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_context.h"
#include "core/nc/flow/run_loop.h"

namespace proveout::nc {

/// Blocks, calls, repeats and ends; RunLoop leads through the lines.
class FlexControl : private FlowControl<FlowFrame> {
 public:
  /// What is referred to must outlive the control; `progress` may be null.
  FlexControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
              Progress* progress)
      : c_(source, settings, sink, progress), loop_(*this, c_.levels, c_.summary, c_.settings) {}
  /// Once. Errors go to the sink; the summary says how it ended.
  InterpretSummary run();

 private:
  /// A REPEAT statement under way.
  struct Repeat {
    int left = 0;      ///< repeats, where no variable counts
    int counter = -1;  ///< number of the variable that counts, or -1
  };

  Reading read() override;
  bool workOver() override;
  void refuse() override;
  Go carryOut() override;
  Go endOfText() override;
  bool opens() override;
  void closed(const FlowFrame& left) override;
  void recover() override;
  bool flush(ProgramEnd end) override;
  void sendEnd(const std::string& code) override;
  void tell(const char* what, const std::string& message) override;
  const SourceText& text() const override { return c_.program.text(); }
  std::size_t line() const override { return c_.levels.back().block; }

  bool start();
  FlowFrame programFrom(std::size_t line) const;
  Go end(const char* code);
  Go jump(const FlexJump& jump);
  Go call(const FlexJump& jump);
  Go repeat(const FlexJump& jump);
  double repeatsLeft(const FlexJump& jump, Repeat& repeat, bool first);
  bool findRepeat(const FlexJump& jump, std::size_t& line);
  bool findLabel(const FlexJump& jump, std::size_t& line);

  FlexContext c_;
  RunLoop<FlowFrame> loop_;
  std::map<std::size_t, Repeat> repeats_;  ///< by line
};

}  // namespace proveout::nc
