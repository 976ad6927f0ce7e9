#include "core/nc/nct/call_stack.h"

#include <algorithm>

namespace proveout::nc {

std::string_view callKindName(CallKind kind) {
  switch (kind) {
    case CallKind::kMain:
      return "main program";
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
  while (hasDeferred()) pending_.pop_back();
  frames_.pop_back();
}

bool CallStack::takeDeferred(CallFrame& out) {
  if (!hasDeferred()) return false;
  const auto first = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& p) { return p.depth == frames_.size(); });
  out = first->frame;
  pending_.erase(first);
  return true;
}

SourceRef CallStack::here() const {
  SourceRef ref;
  if (frames_.empty()) return ref;
  ref.file = frames_.back().file;
  ref.line = static_cast<std::uint32_t>(line_index_ + 1);
  ref.block = number_;
  ref.depth = static_cast<std::uint16_t>(frames_.size() - 1);
  return ref;
}

}  // namespace proveout::nc
