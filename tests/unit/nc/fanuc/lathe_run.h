// Programs of Fanuc-like lathes, for tests.
#pragma once

#include <gtest/gtest.h>

#include "tests/unit/nc/iso_run.h"

namespace proveout::test {

/// The tool starts at that diameter and Z; rapids are straight.
inline ControlSettings latheAt(double diameter, double z, std::map<std::string, double> parameters = {}) {
  parameters.emplace("rapid", 1.0);
  ControlSettings settings = runAtZero(std::move(parameters));
  settings.start = Vec3(0.5 * diameter, 0, z);
  return settings;
}
inline IsoRun lathe(const std::string& text, const ControlSettings& settings = latheAt(0, 0)) {
  return {ControlId::kFanucLathe, text, settings};
}
/// "R 40 2": kind, diameter, Z.
inline std::vector<std::string> turned(const IsoRun& run) {
  EXPECT_EQ(run.error(), "") << run.message();
  std::vector<std::string> all;
  const std::vector<std::string> motions = run.motions();
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Vec3& p = run.path.motions[k].to;
    all.push_back(motions[k].substr(0, 2) + IsoRun::number(2.0 * p.x()) + " " + IsoRun::number(p.z()));
  }
  return all;
}
inline std::vector<std::string> turned(const std::string& text, const ControlSettings& settings) {
  return turned(lathe(text, settings));
}

}  // namespace proveout::test
