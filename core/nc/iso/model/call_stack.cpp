#include "core/nc/iso/model/call_stack.h"

#include <algorithm>

#include "core/base/assert.h"

namespace proveout::nc {

std::string_view callKindName(CallKind kind) {
  switch (kind) {
    case CallKind::kMain:
      return "main program";
    case CallKind::kLines:
      return "blocks of the cycle";
    case CallKind::kSubprogram:
      return "M98";
    case CallKind::kMacro:
      return "G65";
    case CallKind::kModalMacro:
      return "G66";
    case CallKind::kBlockMacro:
      return "G66.1";
    case CallKind::kSystem:
      return "system call";
    case CallKind::kInterrupt:
      return "interrupt";
  }
  return "call";
}

void CallStack::pop() {
  PROVEOUT_ASSERT(!frames_.empty());
  frames_.pop_back();
  left();
}

void CallStack::left() {
  while (!pending_.empty() && pending_.back().depth > frames_.size()) pending_.pop_back();
  here_.file = frames_.empty() ? 0 : frames_.back().file;
  here_.depth = static_cast<std::uint16_t>(frames_.empty() ? 0 : frames_.size() - 1);
}

bool CallStack::takeDeferred(CallFrame& out) {
  if (!hasDeferred()) return false;
  const auto first = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& p) { return p.depth == frames_.size(); });
  PROVEOUT_ASSERT(first != pending_.end());
  out = first->frame;
  pending_.erase(first);
  return true;
}

void CallStack::push(const CallFrame& frame) {
  frames_.push_back(frame);
  entered();
}

void CallStack::entered() {
  here_.file = frames_.back().file;
  here_.depth = static_cast<std::uint16_t>(frames_.size() - 1);
  if (here_.line == 0) here_.line = 1;
}

}  // namespace proveout::nc
