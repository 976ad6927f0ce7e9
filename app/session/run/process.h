// The processes: what the run of a job asks of the one that a clamping's control drives. One row a process;
// the workpiece itself is a removal/process/workpiece.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/session/forecast/prediction.h"
#include "app/session/run/blank.h"
#include "app/session/run/run_result.h"
#include "app/session/run/stock_probe.h"
#include "removal/process/workpiece.h"

namespace proveout {

/// The fixtures of a clamping, as its process sees them.
class Fixtures {
 public:
  virtual ~Fixtures() = default;
  /// Tells the workpiece how they hold it; `blank`: its bounds in this clamping.
  virtual void hold(const Box3& /*blank*/, PieceOptions& /*options*/) const {}
  /// What was repaired in their meshes, one sentence each, for a warning.
  virtual std::vector<std::string> repairs() const { return {}; }
  /// Runs the path of the clamping through them; every touch, by cutter, shank or holder, in rapid or in
  /// feed, is a finding of kind kFixtureContact.
  virtual Status addContacts(const SetupRun& setup, const RecordingSource& texts,
                             std::vector<Finding>& findings, Progress& progress) = 0;
};

/// What messages and reports say of a process.
struct ProcessWords {
  std::string_view verb;    ///< of what its controls do: "mills"
  const char* tool_advice;  ///< behind "control .. cannot work with this tool"; may be empty
  /// What a job has to give that the command line cannot, with {} for the control; null: it can give all.
  const char* needs_job;
  // How exact a part is that it finished.
  const char* exact_tool;     ///< why tools add no error
  const char* exact_grid;     ///< of facets of a mesh from a grid, behind the first half of that sentence
  const char* exact_section;  ///< of the section that stands for the part; null: swept volumes do
  std::string (*exact_facets)(const Job& setup);  ///< of a mesh that is no grid's; null: there is none
};

struct Process {
  ProcessKind kind;
  ProcessWords words;
  bool part_turns;           ///< the path lies in the plane of the spindle axis, its X is a radius
  bool on_grid;              ///< the workpiece is a grid
  bool always_changes_tool;  ///< at a place that clears the blank, even where tools have no length
  bool tool_turns;           ///< the spindle has to turn by the hand of the tool
  bool starts_outside;       ///< of the blank; else the tool may stand in a start hole
  bool from_above;           ///< tools come down to their depth
  bool names_tools;          ///< the command line can name some of its tools
  bool cuts_through;  ///< into bodies: the blank may have start holes, the job may say which is the part

  /// Refuses what the process cannot start from or hold: blank, fixtures, start, place of the tool change of
  /// clamping `setup`, which is the first of the job or follows one of the same process.
  Status (*check)(const Job& job, std::size_t setup, const Blank& blank);
  /// Where the control point starts if the job does not say.
  Vec3 (*start)(const Box3& blank);
  /// Whether it can work with a tool of this kind.
  bool (*holds)(const Tool& tool);
  /// What measuring moves of a clamping meet; null: nothing. All must outlive it.
  std::unique_ptr<PieceProbe> (*probe)(const Job& setup, const ProbedStock& stock, const Toolpath& path,
                                       Progress& progress);
  /// Of clamping `setup`, on its own.
  Workload (*work)(const Job& job, const RunResult& run, std::size_t setup, const Blank& blank);
  /// The first clamping's workpiece.
  Result<std::unique_ptr<Workpiece>> (*make)(Blank& blank, const Job& job, Progress& progress);
  /// Those that tools come near to. Errors: a fixture that cannot be made.
  Result<std::unique_ptr<Fixtures>> (*fixtures)(const SetupRun& setup, double resolution_mm,
                                                Progress& progress);
  /// Findings of its own on what a clamping made; null: none.
  void (*look)(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings);
};

/// The process that a control drives; milling for names of no control.
const Process& processOf(std::string_view control);
/// Of a clamping of the job.
const Process& processOf(const Job& job, std::size_t setup);

inline const Process& processOf(const SetupRun& setup) { return processOf(setup.job.control); }
/// Whether the path of a clamping lies in the plane of the spindle axis, its X a radius.
inline bool partTurns(const SetupRun& setup) { return processOf(setup).part_turns; }

/// Refuses clampings that cannot be worked in, or not behind those before them.
Status checkProcesses(const Job& job, const Blank& blank);

/// Whether a clamping's workpiece is on a grid, of which the job may choose the spacing.
bool needsGrid(const Job& job);

/// ProcessWords::exact_grid where tools sweep volumes out of the grid.
inline constexpr const char* kSweptGridAccuracy =
    ": measured on the cells of the mesh, by the heights of their corners over the faces; details thinner "
    "than a cell may be lost";

// The rows.
extern const Process kMillingProcess;
extern const Process kTurningProcess;
extern const Process kWireProcess;

}  // namespace proveout
