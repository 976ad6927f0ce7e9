// The FlexNC control: runs a program line by line (digest flexnc). Life of a block: read (variables are
// assigned on the way), check its codes and addresses, carry out its words from left to right, jump.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "core/nc/flexnc/flexnc_codes.h"
#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// The run loop: blocks in their order, calls, repeats, ends.
class FlexControl {
 public:
  /// What is referred to must outlive the control; `progress` may be null.
  FlexControl(const ProgramSource& source, const ControlSettings& settings, MotionSink& sink,
              Progress* progress)
      : c_(source, settings, sink, progress) {}
  /// Once. Errors go to the sink; the summary says how it ended.
  InterpretSummary run();

 private:
  enum class Go : std::uint8_t {
    kOn,
    kReturn,  ///< from the subprogram
    kStop     ///< the run is over
  };
  /// A REPEAT statement under way.
  struct Repeat {
    int left = 0;      ///< repeats, where no variable counts
    int counter = -1;  ///< number of the variable that counts, or -1
  };

  bool start();
  Go runFrom(std::size_t line);
  Go endOfText();
  Go block(std::size_t& next_line);
  Go execute(std::size_t& next_line);
  Go jump(const FlexJump& jump, std::size_t& next_line);
  Go call(const FlexJump& jump);
  Go repeat(const FlexJump& jump, std::size_t& next_line);
  double repeatsLeft(const FlexJump& jump, Repeat& repeat, bool first);
  bool findLabel(const FlexJump& jump, std::size_t& line);
  Go finish(const char* code, ProgramEnd end);
  Go failed();
  bool reachedUntil() const;

  FlexContext c_;
  std::map<std::size_t, Repeat> repeats_;  ///< by line
  bool until_hit_ = false;
  std::uint64_t runs_ = 0;  ///< programs opened
};

}  // namespace proveout::nc
