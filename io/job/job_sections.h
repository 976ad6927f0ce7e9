// The sections of a job file, each read by one function. Errors go to the document's diagnostics; what could
// not be read keeps its default, and the job is thrown away in the end.
#pragma once

#include "io/job/config_table.h"
#include "io/job/job.h"

namespace proveout {

inline constexpr NumberRange kTopSpeed{0.0, 1e6, true};       // 1/min that a machine or tool may turn
inline constexpr NumberRange kRate{0.0, 1e7, true};           // mm/min or deg/min; far above any machine
inline constexpr NumberRange kAcceleration{0.0, 1e9, false};  // mm/s^2, deg/s^2; 0: speed at once

/// `name = [low, high]`; the key is there.
std::optional<AxisLimit> readLimit(ConfigTable& table, const std::string& name);
void readControl(ConfigTable& root, const JobNames& names, Job& job);
/// `[machine]`, and the file that it may name.
void readMachine(ConfigTable& root, Job& job);
/// `program` and `subprograms`.
void readProgram(ConfigTable& table, Job& job);
/// `[template]`, in place of `program`.
void readTemplateUse(ConfigTable& table, Job& job);
void readStock(ConfigTable& root, Job& job);
/// [[stock.start_hole]]
void readStartHoles(ConfigTable& stock, Job& job);
void readNominal(ConfigTable& root, Job& job);
/// `general_tolerance` and `features` of [nominal].
void readFeatureKeys(ConfigTable& table, NominalSpec& nominal);
/// `align`, `align_limit` and `datums` of [nominal].
void readAlignment(ConfigTable& table, NominalSpec& nominal);
/// A box or a ring of the table, whichever it has. Nothing, and an error at `key`, where it has neither or
/// both.
std::optional<IgnoredRegion> readRegion(ConfigTable& table, const char* key);
/// Whether the table has a key of readRegion.
bool hasRegion(ConfigTable& table);
/// [[characteristic]], behind readNominal.
void readCharacteristics(ConfigTable& root, Job& job);
void readTools(ConfigTable& root, Job& job);
void readOffsets(ConfigTable& root, Job& job);
/// [placement]
void readPlacement(ConfigTable& root, Job& job);
void readPanel(ConfigTable& root, Job& job);
void readSimulation(ConfigTable& root, Job& job);
/// [severity]
void readSeverities(ConfigTable& root, Job& job);
/// [[fixture]]
void readFixtures(ConfigTable& root, Job& job);
/// [[channel]]; call after everything that channels may change.
void readChannels(ConfigTable& root, const JobNames& names, Job& job);
/// The parameters of the job's control in a table of their own.
void readParameters(ConfigTable& table, const JobNames& names, Job& job);
/// A shape with the keys of [stock], by its `shape` key: one of `shapes`.
std::optional<StockSpec> readShape(ConfigTable& table, const std::vector<std::string>& shapes);
/// The file that `key` names, with `unit`.
std::optional<StockSpec> readMeshFile(ConfigTable& table, const std::string& key);
/// [[setup]]; call after everything that setups may change.
void readSetups(ConfigTable& root, const JobNames& names, Job& job);
/// [report]
void readReport(ConfigTable& root, Job& job);
void readOutput(ConfigTable& root, const JobNames& names, Job& job);

}  // namespace proveout
