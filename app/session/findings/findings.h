// What the stages found, in the report's terms: contacts, deviations, overtravel, alarms.
#pragma once

#include <optional>
#include <vector>

#include "app/session/programs/interpretation.h"
#include "io/report.h"
#include "removal/compare/compare.h"
#include "removal/grid/stock.h"

namespace proveout {

/// Errors of the interpreter (and of tool assignment) as findings of kind kAlarm.
void addAlarms(const Toolpath& path, std::vector<Finding>& findings);

/// Travel past the job's limits.
void addOvertravel(const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings);

/// Axes that are clamped while a tool cuts (MachineAxis::clamped) and turn in a feed motion, and axes with
/// teeth that stand between them then: the first motion of each axis.
void addClampedAxes(const MachineModel& machine, const Toolpath& path, const RecordingSource& texts,
                    std::vector<Finding>& findings);

/// Areas that the control forbids: where its alarm stopped a motion.
void addForbiddenZones(const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings);

/// What a patch over tolerance is.
FindingKind deviationFinding(const DeviationPatch& patch);

/// A gouge or excess: an error. Nobody is blamed yet.
void addDeviation(const DeviationPatch& patch, const Comparison& comparison, std::vector<Finding>& findings);

/// What could not be decided: one warning, at the place that is worst. Returns that patch; null: there is
/// none. `profile_mm`: the profile resolution, where the facets of a mesh without a grid are what is unsure.
const DeviationPatch* addUndecided(const Comparison& comparison, std::vector<Finding>& findings,
                                   double profile_mm = 0.0);

/// A nominal whose facets leave its curved faces by much of a tolerance: a note, a warning where it is more.
void addCoarseNominal(const Comparison& comparison, std::vector<Finding>& findings);

/// Regions that the job leaves out of the comparison (notes).
void addIgnored(const std::vector<IgnoredRegion>& regions, const Comparison& comparison,
                std::vector<Finding>& findings);

/// What the outcome as a whole tells: nothing of the blank is left (an error: there is no part that could
/// pass), nothing was cut, or pieces came loose (warnings).
void addOutcome(double initial_mm3, double final_mm3, const std::vector<StockBody>& bodies,
                std::vector<Finding>& findings);

/// Two bodies of which either may be the part, and nothing says which is (a warning).
void addUncertainPart(const std::vector<StockBody>& bodies, std::optional<std::size_t> rival,
                      std::vector<Finding>& findings);

/// A blank, or a stock from the clamping before, that the grid does not hold: its volume there (`held_mm3`)
/// is off its own by more than 0.1 % (a warning).
void addGridVolume(double own_mm3, double held_mm3, double resolution_mm, std::vector<Finding>& findings);

/// A removed volume that may be off by more than 0.2 % of itself (a warning): small tools or a thin blank on
/// a coarse grid.
void addVolumeError(double removed_mm3, double error_mm3, double resolution_mm,
                    std::vector<Finding>& findings);

/// Walls and films thinner than the grid can hold: what it lost, and where sheets of the surface share a cell
/// (warnings).
void addThinFeatures(const RemovalSummary& removal, const StockSurface& surface, double resolution_mm,
                     const Toolpath& path, const RecordingSource& texts, std::vector<Finding>& findings);

/// A run that was told to stop early: what follows was not looked at (a warning).
void addPartial(ProgramEnd end, const ControlSettings& settings, std::vector<Finding>& findings);

/// A run that was told to stop after a clamping though others follow (a warning).
void addUnrunSetups(const std::string& last_name, std::vector<Finding>& findings);

/// "N120" or "line 12"; empty where the program runs to its end.
std::string untilText(const ControlSettings& settings);

/// A mesh that is not a closed, oriented 2-manifold (an error), or whose triangles run through each other (a
/// warning).
void addMeshDefects(const MeshTopology& topology, const StockSurface& surface,
                    std::vector<Finding>& findings);
/// So many pairs of triangles run through each other in meshes of pieces that came free (a warning).
void addFreedDefects(std::size_t pairs, std::vector<Finding>& findings);

/// The finding as a compiler's message, with the source line and the place.
Diagnostic findingDiagnostic(const Finding& finding);

}  // namespace proveout
