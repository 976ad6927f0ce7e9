// The run loop of a control: block by block through the programs that are open.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/flow/flow_frame.h"
#include "core/nc/text/program_likeness.h"
#include "core/nc/text/source_text.h"

namespace proveout::nc {

/// What is to be done behind a block, or behind a part of one.
enum class Go : std::uint8_t {
  kOn,      ///< the block is done: the next one
  kNext,    ///< the next one, though this one was not carried out: skipped, or an error that was reported
  kCalls,   ///< the block has opened a program and goes on when that has returned
  kReturn,  ///< the program returns to its caller
  kWaits,   ///< for another channel; advance() goes on when its time has come
  kStop     ///< the run is over; the summary says how
};

/// What became of the text of a block.
enum class Reading : std::uint8_t {
  kBlock,
  kEmpty,    ///< nothing is to be done
  kSkipped,  ///< the operator has it left out
  kBad       ///< the error is still to be reported
};

/// What the loop asks of a control whose open programs are such frames.
template <class Frame>
class FlowControl {
 public:
  virtual ~FlowControl() = default;

  /// What must be done before the next block: opens a call that was put off (kCalls), or goes on with a block
  /// that waited. kOn: nothing.
  virtual Go due() { return Go::kOn; }
  /// The block in hand of the innermost program; sets its number.
  virtual Reading read() = 0;
  /// Counts the block, and looks for loops without an end. True: the run is over, the summary says how.
  virtual bool workOver() = 0;
  /// Blocks that are empty or skipped count too.
  virtual bool countsAll() const { return false; }
  /// Reports what was wrong with a bad block.
  virtual void refuse() = 0;
  virtual Go carryOut() = 0;
  /// The rest of a block whose call has returned.
  virtual Go resume() { return Go::kOn; }
  /// Behind the last block of the innermost program.
  virtual Go endOfText() = 0;

  /// Before a called program is opened, for each repetition. False: the run is over.
  virtual bool opens() = 0;
  /// A program is open, the main one too; once more if `call.repetition` of its frame is above 0. False: the
  /// run is over, reported.
  virtual bool opened() { return true; }
  /// A program was left, `left` was its frame: its caller is the innermost one again. With
  /// `left.call.again()` the program opens once more at once.
  virtual void closed(const Frame& left) = 0;

  /// Takes back what a bad block has left behind.
  virtual void recover() {}
  /// Before errors stop the run.
  virtual void giveUp() {}
  /// Sends what was kept back, before the run ends so. False: an error was reported.
  virtual bool flush(ProgramEnd end) = 0;
  /// Tells the path of the end; `code`: the word that ended it, "M30".
  virtual void sendEnd(const std::string& code) = 0;
  /// Reports an error: "until".
  virtual void tell(const char* what, const std::string& message) = 0;
  /// Of the innermost program.
  virtual const SourceText& text() const = 0;
  /// Of the block in hand, index.
  virtual std::size_t line() const = 0;
};

/// A stack of open programs that goes on by one block at a time. Nothing of a run lies on the stack of C++:
/// a block that calls a program gives kCalls, and FlowControl::resume() carries out what is left of it.
/// `Frame` is a FlowFrame with what the control knows of an open program besides.
template <class Frame>
class RunLoop {
 public:
  /// All must outlive the loop.
  RunLoop(FlowControl<Frame>& control, std::vector<Frame>& frames, InterpretSummary& summary,
          const ControlSettings& settings)
      : control_(control), frames_(frames), summary_(summary), settings_(settings) {}
  RunLoop(const RunLoop&) = delete;
  RunLoop& operator=(const RunLoop&) = delete;

  /// The main program. Its frame must have first and end; so below. False: the run is over.
  bool openMain(Frame frame) {
    PROVEOUT_ASSERT(frames_.empty());
    return push(std::move(frame)) == Go::kCalls;
  }
  /// The next block of the innermost program: kOn, kWaits or kStop.
  Go advance();
  /// To the end of the run, or until it waits.
  void run() {
    while (advance() == Go::kOn) {
    }
  }

  // For the control, while it carries out a block.
  Frame& top() { return frames_.back(); }
  /// kCalls; kOn if it is to run no time; kStop: not opened.
  Go call(Frame frame, int times);
  /// To a block of the innermost program.
  void jump(std::size_t block) {
    PROVEOUT_ASSERT(block >= top().first && block <= top().end);
    top().next = block;
  }
  /// Behind an error that was reported: `then` while the job allows more of them, else the run stops.
  Go failed(Go then = Go::kNext);
  /// The run ends here: what was kept back goes, then the end.
  Go finish(const std::string& code, ProgramEnd end);
  /// The block in hand is done: the run ends behind it if the job says so. The loop does this itself for kOn;
  /// it is for blocks that end their program.
  void blockDone() { until_hit_ = until_hit_ || reachedUntil(); }

 private:
  Go push(Frame frame);
  /// The next one of the innermost program, or the end of its text.
  Go block();
  /// The innermost program returns: it is run again, or its caller goes on.
  Go returned();
  bool reachedUntil() const {
    const auto& until = settings_.until;
    return until && frames_.size() == 1 && until->reachedBy(frames_.back().number, control_.line());
  }

  FlowControl<Frame>& control_;
  std::vector<Frame>& frames_;
  InterpretSummary& summary_;
  const ControlSettings& settings_;
  bool until_hit_ = false;
  std::uint64_t runs_ = 0, calls_ = 0;  ///< programs opened; calls that opened them
};

template <class Frame>
Go RunLoop<Frame>::push(Frame frame) {
  PROVEOUT_ASSERT(frame.first <= frame.end);
  frame.next = frame.block = frame.first;
  frame.number = -1;
  frame.run = runs_++;
  frames_.push_back(std::move(frame));
  return control_.opened() ? Go::kCalls : Go::kStop;
}

template <class Frame>
Go RunLoop<Frame>::call(Frame frame, int times) {
  frame.call = {++calls_, 0, times};
  if (times <= 0) return Go::kOn;
  return control_.opens() ? push(std::move(frame)) : Go::kStop;
}

template <class Frame>
Go RunLoop<Frame>::returned() {
  PROVEOUT_ASSERT(frames_.size() > 1);  // the main program ends, it does not return
  Frame frame = std::move(frames_.back());
  frames_.pop_back();
  control_.closed(frame);
  if (!frame.call.again()) return control_.resume();
  ++frame.call.repetition;
  return control_.opens() ? push(std::move(frame)) : Go::kStop;
}

template <class Frame>
Go RunLoop<Frame>::advance() {
  Go go = control_.due();
  if (go == Go::kOn || go == Go::kCalls)
    go = until_hit_ && frames_.size() == 1 ? finish("until", ProgramEnd::kUntil) : block();
  while (go == Go::kReturn) go = returned();
  if (go == Go::kOn) blockDone();
  return go == Go::kStop || go == Go::kWaits ? go : Go::kOn;
}

template <class Frame>
Go RunLoop<Frame>::block() {
  Frame& frame = frames_.back();
  if (frame.next >= frame.end) return control_.endOfText();
  frame.block = frame.next++;
  frame.number = -1;
  const Reading reading = control_.read();
  const bool works = reading == Reading::kBlock || reading == Reading::kBad;
  if ((works || control_.countsAll()) && control_.workOver()) return Go::kStop;
  if (reading == Reading::kSkipped) return Go::kNext;
  if (reading == Reading::kEmpty) return Go::kOn;
  ++summary_.blocks;
  if (reading == Reading::kBlock) return control_.carryOut();
  control_.refuse();
  return failed();
}

template <class Frame>
Go RunLoop<Frame>::failed(Go then) {
  if (summary_.end == ProgramEnd::kCancelled || summary_.end == ProgramEnd::kBlockLimit) return Go::kStop;
  control_.recover();
  if (summary_.errors < settings_.max_errors && mayBeProgram(control_.text())) return then;
  control_.giveUp();
  summary_.end = ProgramEnd::kAlarm;
  return Go::kStop;
}

template <class Frame>
Go RunLoop<Frame>::finish(const std::string& code, ProgramEnd end) {
  summary_.end = ProgramEnd::kAlarm;
  if (!control_.flush(end)) return Go::kStop;
  if (settings_.until && !until_hit_) {
    control_.tell("until", "the program ends here; the block to stop after was not reached");
    return Go::kStop;
  }
  summary_.end = end;
  control_.sendEnd(code);
  return Go::kStop;
}

}  // namespace proveout::nc
