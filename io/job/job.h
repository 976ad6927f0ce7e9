// The job file: one TOML document that names the program, the blank, the tools and what to check.
// The format is described in docs/reference/job.md. Lengths mm, feeds mm/min, times s, angles degrees.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/nearest_name.h"
#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"
#include "core/geometry/types.h"
#include "core/mesh/mesh_placement.h"
#include "core/nc/control/control_host.h"
#include "core/nc/control/control_settings.h"
#include "core/nc/control/text_settings.h"
#include "core/tool/tool.h"
#include "io/acceptance.h"
#include "io/job/cutting_limits.h"
#include "io/mesh_io.h"
#include "io/report_wish.h"
#include "removal/compare/compare.h"
#include "removal/compare/features/judgement.h"
#include "removal/compare/fit/alignment.h"
#include "removal/compare/part/part_feature.h"
#include "removal/grid/start_hole.h"
#include "removal/grid/stock_shape.h"

namespace proveout {

/// A blank or nominal that is still a file: `path` is absolute or relative to the working folder.
struct MeshFile {
  std::string path;
  MeshUnit unit = MeshUnit::kMillimetre;
  std::string body = {};  ///< of a STEP file: name or number; empty: the only one
};

/// What the blank is, before its files are read. Workpiece frame.
using StockSpec = std::variant<BoxShape, CylinderShape, MeshFile, SavedStock>;

struct NominalSpec {
  MeshFile mesh;
  MeshPlacement placement;             ///< of what the file holds, in the frame of the finished part
  double gouge_mm = 0.02;              ///< allowed below nominal, > 0
  double excess_mm = 0.05;             ///< allowed above nominal, > 0
  std::vector<IgnoredRegion> ignored;  ///< not compared; names differ and are not empty
  std::vector<LocalTolerance> local;   ///< [[nominal.tolerance]], in their order
  /// Whether they are recognised and measured. None: those of a CAD model are, those of facets where
  /// something of the job asks for them.
  std::optional<bool> features;
  AlignWish align;                                  ///< `align`
  GeneralTolerance general;                         ///< of their characteristics
  std::vector<CharacteristicRule> characteristics;  ///< [[characteristic]], in their order

  FeatureTolerances featureTolerances() const { return {gouge_mm, excess_mm, general, characteristics}; }
  bool measuresFeatures() const { return features.value_or(true); }
  /// Whether faces are looked for in a nominal of facets, which takes its time.
  bool findsFeatures() const { return features.value_or(!general.none() || !characteristics.empty()); }
};

/// What a command may take where nobody says more, s: programs that do not end are told, and nobody waits all
/// night.
inline constexpr double kDefaultMaxTimeS = 3600.0;

/// How far a run goes to say what is wrong behind a deviation: not at all, as the deviations suggest, or by
/// trying what would put it right.
enum class CauseSearch : std::uint8_t { kOff, kFast, kProven };
/// "off", "fast", "proven".
const std::vector<std::string>& causeSearchNames();
std::optional<CauseSearch> causeSearchNamed(std::string_view name);

struct SimulationSpec {
  std::optional<double> resolution_mm;  ///< grid spacing; none: chosen from the stock
  double contact_mm = 0.01;             ///< touches of the stock that are less deep are not told
  double profile_resolution_mm = 0.01;  ///< of turned parts: facets leave the surface by a tenth of it
  std::optional<double>
      simplify_mm;  ///< how far the mesh may leave the surface; none: chosen from grid and tolerance
  CauseSearch causes = CauseSearch::kProven;
  int threads = 0;                       ///< 0: all cores
  double max_memory_gb = 0.0;            ///< 0: what the machine has free
  double max_time_s = kDefaultMaxTimeS;  ///< the command ends itself within so many seconds
};

enum class OutputFormat : std::uint8_t { kStl, kStlAscii, kObj, kPly, kThreeMf, kGlb, kVdb };
std::string_view outputFormatName(OutputFormat format);       ///< "stl", "stl-ascii", "obj", "3mf", ...
std::string_view outputFormatExtension(OutputFormat format);  ///< "stl", "stl", "obj", "3mf", ...
/// Parses one name; the error lists the names there are.
Result<OutputFormat> parseOutputFormat(std::string_view name);
/// Parses "stl,obj"; empty entries and doubles are errors.
Result<std::vector<OutputFormat>> parseOutputFormats(std::string_view list);

/// What is written of the deviation from nominal, point by point: the part's mesh with it as PLY and GLB, and
/// the points over tolerance as points.csv.
enum class DeviationOutput : std::uint8_t { kPly, kGlb, kCsv };
std::string_view deviationOutputName(DeviationOutput output);  ///< "ply", "glb", "csv"
/// Parses one name, and "ply,csv"; as those of formats.
Result<DeviationOutput> parseDeviationOutput(std::string_view name);
Result<std::vector<DeviationOutput>> parseDeviationOutputs(std::string_view list);

struct OutputSpec {
  std::vector<OutputFormat> formats = {OutputFormat::kStl};
  std::vector<std::string> views = {"iso"};  ///< names; see JobNames
  int width = 1280, height = 960;            ///< pixels, 16..8192
  bool csv = false;                          ///< blocks.csv, mrr.svg and findings.csv
  std::vector<DeviationOutput> deviation;    ///< of a job with a nominal
  std::vector<double> sections;              ///< heights of section drawings, mm, frame of the last setup
  std::optional<bool> view3d;                ///< the 3-D view of report.html; see wantsView
  std::optional<bool> bodies;  ///< a mesh file for each piece that was cut free; see writesBodies
};

/// Something beside the workpiece that no part of a tool may touch. Workpiece frame.
struct FixtureSpec {
  std::string name;  ///< not empty; names differ
  StockSpec shape;   ///< not a saved stock
};

/// A program that is a template: `program` names the file, these are the numbers in its fields.
struct TemplateUse {
  std::map<std::string, std::string> values;    ///< by parameter, as text
  TextEncoding encoding = TextEncoding::kAuto;  ///< of the template; what comes out of it is UTF-8
};

/// The control that a job names where the program itself is to tell: see chooseControls.
inline constexpr std::string_view kAutoControl = "auto";
/// Settings of controls by the name of their table `[control.NAME]`.
using SettingsByTable = std::map<std::string, std::map<std::string, double>>;

/// One clamping of the workpiece, with the program that is run in it.
struct SetupSpec {
  std::string name;                      ///< not empty; names differ
  std::string control;                   ///< name; empty: the job's
  std::string control_note;              ///< as Job::control_note
  SettingsByTable settings_by_table;     ///< as Job::settings_by_table
  std::string machine_file;              ///< as Job::machine_file, of a setup with a control of its own
  std::vector<Tool> tools;               ///< empty: the job's
  std::string program;                   ///< path
  std::optional<TemplateUse> filled;     ///< `program` is a template
  std::vector<std::string> subprograms;  ///< paths
  /// The job's, with what the setup changes; with a control of its own the setup's alone.
  ControlSettings settings;
  CuttingLimits limits;       ///< of the setup's machine and tools
  std::optional<Vec3> start;  ///< in the setup's workpiece frame
  /// Takes the workpiece from its place in the setup before into this one's workpiece frame.
  RigidTransform from_previous;
  std::vector<FixtureSpec> fixtures;
};

/// One channel of the control.
struct ChannelSpec {
  std::string program;                   ///< path
  std::vector<std::string> subprograms;  ///< paths
  ControlSettings settings;   ///< the job's, with the channel's number, tool, offsets and parameters
  std::optional<Vec3> start;  ///< as Job::start
};

struct Job {
  std::string path;                      ///< of the job file; empty for a job made on the command line
  std::string name;                      ///< defaults to the job file's name without extension
  std::string control;                   ///< name; see JobNames
  std::string control_note;              ///< why this control, where the program told it; else empty
  SettingsByTable settings_by_table;     ///< of a job whose control is kAutoControl
  std::string machine_file;              ///< path of `[machine] file`; empty: none
  std::string program;                   ///< path of the main program
  std::optional<TemplateUse> filled;     ///< `program` is a template
  std::vector<std::string> subprograms;  ///< paths of files and folders
  /// Clampings in their order. Empty: one, which is what the fields of the job itself say. Else `program` and
  /// `subprograms` of the job are empty; see jobOfSetup.
  std::vector<SetupSpec> setups;
  /// Channels of the control by number; empty: the control has one. `program`, `subprograms` and `start` of
  /// the job are those of the first. A job has channels or setups.
  std::vector<ChannelSpec> channels;
  /// Setups of the file that came behind `setups` were taken away: only a part of the job is to be run. Not
  /// set by job files.
  bool stops_early = false;
  /// Machine, offsets, switches and parameters. `start` is the control's default and `gauge_lengths` are
  /// filled from the tools; `until` is not set by job files.
  ControlSettings settings;
  Operator person;  ///< what the person at the machine answers
  std::optional<Vec3>
      start;  ///< control point before the first block, workpiece frame; none: above the stock
  std::optional<StockSpec> stock;      ///< always there in a job that was loaded from a file
  std::vector<StartHole> start_holes;  ///< in the stock, its frame; for controls that cut with a wire
  std::optional<Vec3> part_point;  ///< in the part, of which bodies there may be several; frame of the stock
  std::optional<NominalSpec> nominal;
  /// [[characteristic]] of the part as a whole (see isOfPart), in their order; they need no nominal.
  std::vector<PartRule> part_characteristics;
  std::vector<FixtureSpec> fixtures;  ///< of a job without setups
  std::vector<Tool> tools;            ///< validated, numbers differ; in the order of the file
  CuttingLimits limits;               ///< of the machine and of `tools`
  SimulationSpec simulation;
  SeverityChoice severities;  ///< [severity]
  OutputSpec output;
  ReportWish report;  ///< [report]
};

/// Whether the job asks for a .vdb file, which only a grid gives.
bool savesStock(const Job& job);
/// Whether pieces that were cut free get mesh files of their own: what the job says, else where a point names
/// the part and there is no nominal, so that its mesh file has the part alone.
bool writesBodies(const Job& job);
/// Whether report.html is to have its 3-D view: what the job says, else where pictures are drawn.
bool wantsView(const Job& job);
/// The main programs of the job, of a clamping or of its channels: "left.nc, right.nc".
std::string programNames(const Job& job);
/// Number of clampings, at least 1.
std::size_t setupCount(const Job& job);
/// The controls of the clampings, each once.
std::vector<std::string> controlsOf(const Job& job);
/// The job as it is in one clamping: control, tools, program, subprograms, settings, start and fixtures are
/// the setup's and there are no further setups. `index` below setupCount.
Job jobOfSetup(const Job& job, std::size_t index);

/// A parameter of a control that `[control.NAME]` may set.
struct ParameterRange {
  std::string name;
  double min = 0.0, max = 0.0;
  int count = 0;                          ///< > 0: NAME.1 to NAME.count set one each, NAME alone sets all
  std::vector<std::string> choices = {};  ///< words that the job gives in place of 0, 1, ...; none: a number
};

/// Names that a job may use and that io does not know itself; an empty list is not checked against.
struct JobNames {
  std::vector<std::string> controls;  ///< of the virtual controls
  std::vector<std::string> views;     ///< of the renderer
  /// By control. A control without an entry has its parameters checked by the interpreter alone.
  std::map<std::string, std::vector<ParameterRange>> parameters;
  /// By control: NAME of its table `[control.NAME]`, which several may share. Without an entry: its own name.
  std::map<std::string, std::string> settings_tables = {};
  /// Settings that are no numbers, by control.
  std::map<std::string, std::vector<TextSetting>> texts;
  /// `program` is a name for diagnostics, not a file: the programs come from elsewhere. Subprograms are
  /// files.
  bool programs_in_memory = false;
};

/// Names of encodings in job files: "auto", "utf-8", ...
const std::vector<std::string>& encodingNames();
std::optional<TextEncoding> encodingNamed(std::string_view name);

/// Reads a job file. Relative paths in it are resolved against its folder; every named file must exist.
/// Unknown keys, wrong types, values out of range and features that cannot be simulated are errors in
/// `diagnostics`, each with its place. Returns a job only if there was no error.
std::optional<Job> loadJob(const std::string& path, const JobNames& names, Diagnostics& diagnostics);

/// Reads a file with the keys of `[machine]` into the job, and notes its name there. What is wrong becomes
/// errors in `diagnostics`.
void loadMachine(const std::string& path, Job& job, Diagnostics& diagnostics);

/// The same as loadJob for a text: `text_name` stands in diagnostics, `folder` is what relative paths are
/// resolved against.
std::optional<Job> parseJob(std::string_view text, const std::string& text_name, const std::string& folder,
                            const JobNames& names, Diagnostics& diagnostics);

/// Parses the command line's blank: `box:x0,y0,z0:x1,y1,z1`, `cylinder:x,y,z:DIAMETER:LENGTH[:AXIS]` (centre
/// of the lower end, axis x, y or z; default z), `tube:x,y,z:DIAMETER:INNER:LENGTH[:AXIS]`, `mesh:FILE`,
/// `vdb:FILE`.
Result<StockSpec> parseStockOption(const std::string& text);

/// Reads a blank's or fixture's mesh, if it is one; other shapes pass through.
Result<StockShape> loadStockShape(const StockSpec& spec);

}  // namespace proveout
