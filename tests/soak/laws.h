// What holds for every run, whatever the job. All laws are here.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/soak/case_runner.h"

namespace proveout::soak {

/// A case with the run of its whole program, which every law looks at.
struct LawCase {
  CaseRunner& runner;
  const RunResult& whole;
};

struct Law {
  const char* name;
  int every;  ///< asked of one case in so many: what costs whole runs more
  /// Why the law is broken; none where it holds.
  std::optional<std::string> (*broken)(const LawCase&);
};

const std::vector<Law>& laws();

/// A law of wires: the mesh has the material that no wire came near to, and its walls where one passed or
/// where the blank ends. Other jobs keep it.
std::optional<std::string> wallsBesideTheWire(const LawCase& c);

struct Judged {
  bool ran = false;  ///< false: the job was refused, with `why`
  std::string why;
  std::vector<std::string> broken;  ///< "law: what is wrong"
};

/// Runs a case and asks all laws.
Judged judge(std::uint64_t seed);

}  // namespace proveout::soak
