// What a control made of a program.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/nc/control/run_summary.h"
#include "core/path/toolpath.h"

namespace proveout {

struct Interpreted {
  Toolpath path;
  InterpretSummary summary;
  std::map<std::string, std::string> files;  ///< that the program wrote, by name
  std::optional<Error> probe_failure;        ///< the stock could not answer a measuring move
  std::optional<SourceRef> outgrown_at;      ///< block at which the path outgrew its memory; cancelled there
};

}  // namespace proveout
