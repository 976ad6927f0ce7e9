// The programs that are open: the main program and what it called, with what each call brought along.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/assert.h"
#include "core/nc/flow/flow_frame.h"
#include "core/nc/macro/variables.h"
#include "core/nc/text/source_text.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// How a program came to run.
enum class CallKind : std::uint8_t {
  kMain,
  kLines,       ///< lines of the program itself, as a part of a block
  kSubprogram,  ///< M98, and codes that stand for it: no local level of its own
  kMacro,       ///< G65
  kModalMacro,  ///< G66, after each motion
  kBlockMacro,  ///< G66.1, from each block
  kSystem,      ///< a G, M, T or other code that parameters turn into a call
  kInterrupt    ///< M96
};
std::string_view callKindName(CallKind kind);  ///< "M98", "G65", "G66", "G66.1", "system call", "interrupt"

/// Does the call open a level of local variables?
constexpr bool opensLocals(CallKind kind) { return kind > CallKind::kSubprogram; }

/// A flow function of a block: M99, M2, M30.
struct FlowRequest {
  int code = 0;             ///< of the M function; 0: none
  std::int64_t block = -1;  ///< P of M99, or -1
  std::int64_t count = -1;  ///< L of M99, or -1
  std::size_t line = 0;     ///< index of its line
  std::int64_t number = -1;
};

/// Its blocks are the lines of the text.
struct CallFrame : FlowFrame {
  SourceText* text = nullptr;
  std::uint32_t file = 0;
  CallKind kind = CallKind::kMain;
  std::int16_t modal_index = -1;   ///< G66: which of the open modal calls this one belongs to; -1: none
  std::int64_t total = 1;          ///< repetitions that the call asks for
  std::int64_t return_block = -1;  ///< N of the caller to go on from, or -1
  std::int32_t system_code =
      -1;                  ///< the code that parameters turned into this call (see system_calls.h), or -1
  bool interrupt = false;  ///< opened by the interrupt signal
  FlowRequest waiting;     ///< to be done when the calls that the block put off are done
  Arguments args;
  std::size_t more_line = 0;  ///< with more_from > 0: the line, index, that has another block there
  std::size_t more_from = 0;  ///< index into its text

  /// The program is all of that text, which must outlive the frame; `its_file`: file index of the path.
  void setProgram(SourceText& its_text, std::uint32_t its_file) {
    text = &its_text;
    file = its_file;
    first = 0;
    end = its_text.lines().size();
  }
};

/// Nesting of subprogram calls (manual 14.4.2): so many calls may be open below the main program.
inline constexpr std::size_t kMaxNesting = 16;

/// The open programs. A call may also be put off to the end of the block in hand: it opens before the next
/// line of the same frame is read, and when it returns the next call put off opens.
class CallStack {
 public:
  bool empty() const { return frames_.empty(); }
  std::size_t depth() const { return frames_.size(); }
  CallFrame& top() { return frames_.back(); }
  const CallFrame& top() const { return frames_.back(); }
  CallFrame& main() { return frames_.front(); }
  const CallFrame& main() const { return frames_.front(); }
  CallFrame& at(std::size_t level) { return frames_[level]; }
  const CallFrame& at(std::size_t level) const { return frames_[level]; }

  /// For the run loop, which opens and closes frames; it tells so by entered() and left().
  std::vector<CallFrame>& frames() { return frames_; }
  void entered();
  /// Calls that the frame put off are dropped.
  void left();
  void push(const CallFrame& frame);
  void pop();

  /// Puts a call off until the block in hand is done; calls run in the order in which they were put off.
  void defer(const CallFrame& frame) {
    PROVEOUT_ASSERT(pending_.empty() || pending_.back().depth <= frames_.size());
    pending_.push_back({frame, frames_.size()});
  }
  /// Takes out the next call that the last frame put off. False: none.
  bool takeDeferred(CallFrame& out);
  bool hasDeferred() const { return !pending_.empty() && pending_.back().depth == frames_.size(); }

  /// The block in hand: index of its line and its N number.
  void setBlock(std::size_t line_index, std::int64_t number) {
    line_index_ = line_index;
    here_.line = static_cast<std::uint32_t>(line_index + 1);
    here_.block = number;
  }
  std::size_t lineIndex() const { return line_index_; }
  /// For the limits of the run; a program must be open. A text without lines stands on that of its call.
  FlowPlace place() const {
    FlowPlace at = flowPlace(frames_);
    at.line = line_index_;
    return at;
  }
  /// Where the block in hand stands, without the words in force; line 0 without an open program.
  const SourceRef& here() const { return here_; }

 private:
  struct Pending {
    CallFrame frame;
    std::size_t depth = 0;  ///< frames that were open
  };
  std::vector<CallFrame> frames_;
  std::vector<Pending> pending_;  ///< depth never falls from front to back
  std::size_t line_index_ = 0;
  SourceRef here_;
};

}  // namespace proveout::nc
