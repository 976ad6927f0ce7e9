#include "core/tool/tool_type.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/tool/types/rows.h"

namespace proveout {
namespace {

using namespace tool_types;
constexpr std::array kToolTypes{&kFlat,  &kBall,     &kBull,       &kCone, &kDrill,  &kTaperBall, &kDovetail,
                                &kTSlot, &kLollipop, &kThreadMill, &kForm, &kInsert, &kWire};

}  // namespace

std::span<const ToolTypeRow* const> toolTypes() { return kToolTypes; }

const ToolTypeRow& rowOf(ToolType type) {
  const auto found = std::find_if(kToolTypes.begin(), kToolTypes.end(),
                                  [&](const ToolTypeRow* row) { return row->type == type; });
  PROVEOUT_ASSERT(found != kToolTypes.end());
  return **found;
}

}  // namespace proveout
