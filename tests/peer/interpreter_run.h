// Runs of LinuxCNC's interpreter, which is not part of this project, through its module for Python.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace proveout::peer {

/// A motion in machine coordinates, mm.
struct PeerMotion {
  char kind = 'R';  ///< R rapid, F feed or thread, A arc
  Vec3 to = Vec3::Zero(), center = Vec3::Zero();
  Vec3 sweep = Vec3::Zero();  ///< of arcs: along the axis, by the right-hand rule, rad
  int line = 0;               ///< of the program; 0: not known
};

struct PeerRun {
  std::vector<PeerMotion> motions;
  std::string error;  ///< empty: it ran
};

/// Whether the interpreter's module is installed.
bool hasInterpreter();

/// The tools of a run, those of LinuxCNC's tool table without an INI file: inches.
struct PeerTool {
  int number = 1;
  double z = 0.0, diameter = 0.0;  ///< mm
};

/// Those tools as lines of a tool table.
std::string tableOf(const std::vector<PeerTool>& tools);

/// The programs as the interpreter runs them, one run each, in order, with the tools of `table`; `folder` is
/// for files of the run.
std::vector<PeerRun> runInterpreter(const std::vector<std::string>& paths, const std::string& table,
                                    const std::string& folder);

}  // namespace proveout::peer
