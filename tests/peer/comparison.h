// A program here and in LinuxCNC's interpreter: the same way, the same refusal, or a difference.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/peer/interpreter_run.h"

namespace proveout::peer {

/// The tools that both have: 50 mm long and 10 mm wide, 30 mm long and 6 mm wide.
const std::vector<PeerTool>& peerTools();

struct Ours {
  PeerRun run;
  int line = 0;                ///< of the error, 0: there is none
  std::set<std::string> told;  ///< codes of all diagnostics
};

/// A program by LinuxCNC's rules here; programs that it calls are looked for beside it.
/// `table` is a tool table in inches, or empty: then peerTools(). Machines and programs begin in inches with
/// it, as the interpreter does without an INI file.
Ours runHere(const std::string& path, const std::string& table = {});

enum class Verdict {
  kSame,
  kSameRefusal,
  kFault,  ///< different, and told here: a fault of the interpreter that is not followed
  kDifferent
};

/// Ends, centres and sweeps of motions within 1e-6 mm and degrees; `what` says where they part.
Verdict compare(const PeerRun& theirs, const Ours& ours, std::string& what);

}  // namespace proveout::peer
