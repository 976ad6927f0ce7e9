// What one channel of a control runs.
#pragma once

#include "core/nc/control/control_settings.h"
#include "core/nc/control/program_source.h"

namespace proveout {

inline constexpr int kMaxChannels = 8;

/// What one channel of a control runs.
struct ChannelProgram {
  const ProgramSource* source = nullptr;  ///< its main program and what that calls
  /// With the channel's number, 1 to kMaxChannels. Parameters that belong to the whole control are those of
  /// the first channel.
  ControlSettings settings;
};

}  // namespace proveout
