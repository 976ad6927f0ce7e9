// The interrupt macro: what M96 has enabled (manual 23.4).
#pragma once

#include <cstdint>
#include <optional>

#include "core/nc/iso/model/call_stack.h"
#include "core/nc/iso/model/state.h"
#include "core/nc/origins/origin_recorder.h"

namespace proveout::nc {

struct InterruptMacro {
  bool enabled = false;
  CallFrame frame;                  ///< while enabled: what the signal opens
  std::optional<IsoState> resumed;  ///< while it runs: the modals of the interrupted program
  /// And where their words were written.
  OriginRecorder::Slots words{};
  OriginRecorder::Slot cycle_start;
  DataInForce data;
};

}  // namespace proveout::nc
