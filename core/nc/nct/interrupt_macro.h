// The interrupt macro: what M96 has enabled (manual 23.4).
#pragma once

#include <cstdint>
#include <optional>

#include "core/nc/block.h"
#include "core/nc/nct/call_stack.h"
#include "core/nc/nct/nct_parameters.h"
#include "core/nc/nct/nct_state.h"
#include "core/nc/origin_recorder.h"

namespace proveout::nc {

/// What a block asks of the interrupt macro.
enum class InterruptSwitch : std::uint8_t { kNone, kOn, kOff };
/// What an M word asks; kNone for other words, and where N1758 USD has the function off.
InterruptSwitch interruptSwitch(const NctParameters& parameters, const Word& w);

struct InterruptMacro {
  bool enabled = false;
  CallFrame frame;                  ///< while enabled: what the signal opens
  std::optional<NctState> resumed;  ///< while it runs: the modals of the interrupted program
  /// And where their words were written.
  OriginRecorder::Slots words{};
  OriginRecorder::Slot cycle_start;
  DataInForce data;
};

}  // namespace proveout::nc
