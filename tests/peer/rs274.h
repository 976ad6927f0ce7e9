// Runs of LinuxCNC's stand-alone interpreter `rs274`, which is not part of this project.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace proveout::peer {

/// A motion in machine coordinates, mm.
struct PeerMotion {
  char kind = 'R';  ///< R rapid, F feed or thread, A arc
  Vec3 to = Vec3::Zero(), center = Vec3::Zero();
  std::array<bool, 3> center_axes{};  ///< of arcs: axes of the plane
};

struct PeerRun {
  std::vector<PeerMotion> motions;
  std::string error;  ///< empty: it ran
};

bool hasInterpreter();
/// The program as the interpreter runs it; `folder` is for its files. Nothing: it did not start.
std::optional<PeerRun> runInterpreter(const std::string& program, const std::string& folder);

}  // namespace proveout::peer
