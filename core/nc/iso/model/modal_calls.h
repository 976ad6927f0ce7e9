// Macros that stay active: G66 after each motion, G66.1 from each block (manual 23.3.2, 23.3.3).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/assert.h"
#include "core/nc/iso/model/call_stack.h"

namespace proveout::nc {

/// The active modal macros, the last activated at the end. Each is kept as the frame that a call opens.
class ModalCalls {
 public:
  bool none() const { return frames_.empty(); }
  /// False: as many are active as calls may be open.
  bool activate(CallFrame frame) {
    if (frames_.size() >= kMaxNesting) return false;
    frame.modal_index = static_cast<std::int16_t>(frames_.size());
    frames_.push_back(frame);
    return true;
  }
  /// G67: the last one ends. Without any: nothing.
  void cancel() {
    if (!frames_.empty()) frames_.pop_back();
  }
  void clear() { frames_.clear(); }
  const CallFrame& last() const {
    PROVEOUT_ASSERT(!frames_.empty());
    return frames_.back();
  }

  /// The macro of that kind that the program in hand calls: outside of modal macros the one activated last,
  /// inside one the one activated before it. Null: none.
  const CallFrame* find(CallKind kind, const CallStack& calls) const {
    std::size_t limit = frames_.size();
    for (std::size_t level = calls.depth(); level-- > 1;) {
      const int index = calls.at(level).modal_index;
      if (index < 0) continue;
      limit = std::min(limit, static_cast<std::size_t>(index));
      break;
    }
    while (limit-- > 0) {
      if (frames_[limit].kind == kind) return &frames_[limit];
    }
    return nullptr;
  }

 private:
  std::vector<CallFrame> frames_;
};

}  // namespace proveout::nc
