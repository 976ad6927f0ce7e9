// Programs of LinuxCNC in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {

using Lines = std::vector<std::string>;

inline IsoRun lcn(const std::string& text, const std::map<std::string, std::string>& files = {},
                  const ControlSettings& settings = runAtZero()) {
  return IsoRun(ControlId::kLinuxCnc, text, settings, files);
}

/// What the program tells by (DEBUG,..), (MSG,..) and (PRINT,..).
inline Lines told(const IsoRun& run) {
  Lines all;
  for (const auto& [before, e] : run.path.events)
    if (const auto* message = e.as<event::Message>()) all.push_back(message->text);
  return all;
}

/// The value of an expression as (DEBUG) prints it; or the error's message.
inline std::string valueOf(const std::string& expression) {
  const IsoRun run = lcn("#1=[" + expression + "]\n(debug,#1)\nM2\n");
  const Lines lines = told(run);
  return lines.empty() ? run.message() : lines.front();
}

}  // namespace proveout::test
