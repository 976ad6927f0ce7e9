// Programs of LinuxCNC with the motions that its interpreter gives, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {

/// A program behind "G21 G90 G0 F100", which starts at 0; its motions, and the error that ends it.
struct LcnCase {
  std::string name, text;
  std::vector<std::string> motions;
  std::string error;  ///< empty: it runs
};

/// Two tools: 50 mm long with a radius of 5, 30 with 3.
inline ControlSettings lcnSettings(std::map<std::string, double> parameters = {}) {
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.length_offsets = {{1, {50.0, 0.0}}, {2, {30.0, 0.0}}};
  settings.radius_offsets = {{1, {5.0, 0.0}}, {2, {3.0, 0.0}}};
  return settings;
}

inline IsoRun runLcn(const std::string& lines, const ControlSettings& settings = lcnSettings()) {
  return IsoRun(ControlId::kLinuxCnc, "G21 G90 G0 F100\n" + lines + "\nM2\n", settings);
}

inline void checkLcnCases(const std::vector<LcnCase>& cases) {
  for (const LcnCase& c : cases) {
    const IsoRun run = runLcn(c.text);
    EXPECT_EQ(run.error(), c.error) << c.name << ": " << run.message();
    EXPECT_EQ(run.motions(), c.motions) << c.name;
  }
}

}  // namespace proveout::test
