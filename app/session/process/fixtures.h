// Fixtures: clamps, vises, plates that no part of a tool may touch.
#pragma once

#include <string>
#include <vector>

#include "app/session/run/run_result.h"

namespace proveout {

/// The fixtures of a clamping, each as a stock of its own on the job's grid.
struct FixtureStock {
  std::string name;
  Stock stock;
};
struct FixtureStocks {
  std::vector<FixtureStock> stocks;  ///< those that a tool comes near to on its way
  std::vector<std::string> repairs;  ///< of the meshes of all, one sentence each, for a warning
};
/// No more of a fixture is built than tools come near to. Errors: a mesh that cannot be read or is not
/// closed, a fixture thinner than two cells of the grid.
Result<FixtureStocks> makeFixtures(const SetupRun& setup, double resolution_mm, Progress& progress);

/// Surface of what makeFixtures builds, mm2; what cannot be read counts as none.
struct FixtureAreas {
  double solids_mm2 = 0.0;  ///< boxes, cylinders and tubes
  double meshes_mm2 = 0.0;
};
FixtureAreas fixtureAreas(const SetupRun& setup);

/// Runs the path of a clamping through its fixtures; every touch, by cutter, shank or holder, in rapid or in
/// feed, is a finding of kind kFixtureContact. What a cutter takes out of a fixture is not met again by the
/// motions that follow.
Status addFixtureContacts(std::vector<FixtureStock>& fixtures, const SetupRun& setup,
                          const RecordingSource& texts, std::vector<Finding>& findings, Progress& progress);

/// The same for a clamping whose part turns: its fixtures are round about the spindle axis.
Status addTurnedFixtureContacts(const SetupRun& setup, const RecordingSource& texts,
                                std::vector<Finding>& findings, Progress& progress);

}  // namespace proveout
