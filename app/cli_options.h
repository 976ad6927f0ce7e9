// The command line as plain data. Nothing here touches files: names and numbers are checked where they are
// used.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/placement_options.h"
#include "removal/compare/features/general_tolerance.h"

namespace proveout {

/// A program or a job, for the commands that interpret.
struct ProgramOptions {
  std::string input;                   ///< job file (*.toml) or program
  std::optional<std::string> control;  ///< with a program; none: the program tells it
  std::vector<std::string> subprograms;
  std::optional<std::string> setup;  ///< name of a clamping of the job
  std::optional<std::string> until;  ///< "120" (line) or "N70" (block number)
  std::optional<double> max_time_s;
  bool lenient = false;
  std::vector<std::string> offsets;         ///< "G55=X,Y,Z", "D1=5"; see applyOffsets
  std::optional<std::string> program_unit;  ///< "mm", "inch": power-on unit of the control
  std::optional<std::string> machine;       ///< file with the keys of [machine]
  bool skip = false;                        ///< block skip switch of `/` on
};

struct RunOptions {
  ProgramOptions program;
  std::optional<std::string> stock;
  std::vector<std::string> tools;
  std::optional<std::string> nominal;
  std::optional<std::string> unit;  ///< of the meshes of `nominal` and `stock`
  NominalOptions place;
  std::optional<double> tolerance_mm;
  std::optional<double> resolution_mm;
  std::optional<double> simplify_mm;
  std::optional<std::string> causes;  ///< "off", "fast", "proven"
  std::optional<double> max_memory_gb;
  std::optional<int> threads;
  std::optional<std::string> baseline;        ///< file with findings that are known
  std::optional<std::string> write_baseline;  ///< file to write them to
  std::vector<std::string> select, ignore;    ///< lists of kinds, "gouge,excess"
  std::optional<std::string> out;
  std::optional<std::string> formats;
  std::vector<std::string> views;
  std::optional<std::string> size;
  bool no_render = false;
  bool no_view3d = false;
  bool csv = false;
  std::optional<std::string> deviation;  ///< "ply,glb,csv"
  bool bodies = false;
  bool json = false;
  bool quiet = false;
  bool progress = false;
};

/// The words of a command line that decide what a run finds; not how it is shown, nor where it is written.
std::vector<std::string> decidingArguments(const RunOptions& options);

struct ExplainOptions {
  std::string report;  ///< a report.json, or the folder that holds it
  std::string at;      ///< "x,y,z"
  std::optional<double> max_time_s;
  bool progress = false;
};

struct PathOptions {
  ProgramOptions program;
  std::string format = "jsonl";
};

struct CheckOptions {
  ProgramOptions program;
  bool json = false;
};

struct CompareCommandOptions {
  std::string machined, nominal;
  std::string unit = "mm";                  ///< of both files
  std::optional<std::string> nominal_unit;  ///< of the nominal, where it has another one
  NominalOptions place;
  bool scan = false;                    ///< the second file is a scan, the first one the model
  std::optional<double> scan_reach_mm;  ///< ScanOptions::reach_mm
  std::string align = "none";           ///< "none", "fit", "datums"
  std::optional<double> align_limit_mm;
  std::vector<std::string> datums;  ///< "X,Y,Z" each
  double gouge_mm = 0.02, excess_mm = 0.05;
  GeneralTolerance general;  ///< of the nominal's features
  double resolution_mm = 0.2;
  std::optional<int> threads;
  std::optional<double> max_time_s, max_memory_gb;
  std::optional<std::string> out;
  std::optional<std::string> deviation;  ///< "ply,glb,csv"
  bool csv = false;                      ///< findings.csv
  std::string size = "1200x900";
  bool no_view3d = false;
  bool json = false;
  bool quiet = false;
  bool progress = false;
};

struct RenderCommandOptions {
  std::string mesh;
  std::string unit = "mm";
  std::string output;  ///< empty: the mesh's name with .png
  std::string view = "iso";
  std::string size = "1200x900";
  std::optional<std::string> heatmap;
  std::optional<int> threads;
  std::optional<double> max_time_s;
};

struct CoverageOptions {
  std::optional<std::string> control;
  bool settings = false;  ///< what jobs may set, too
  bool json = false;
};

struct MachineOptions {
  std::string file;                    ///< of the machine
  std::optional<std::string> at;       ///< "X0 Y0 Z100 A30 C60", machine coordinates
  std::optional<std::string> job;      ///< names the workpiece's zero and the tools
  std::optional<int> tool;             ///< of the job
  std::optional<std::string> picture;  ///< PNG
};

struct TemplateOptions {
  std::string input;                ///< .tmpl, .tmps or .pmc
  std::vector<std::string> values;  ///< "D=40"
  bool list = false;
  bool json = false;  ///< of the list
  std::string encoding = "auto";
  std::optional<std::string> output;
};

using CommandOptions =
    std::variant<RunOptions, PathOptions, CheckOptions, CompareCommandOptions, RenderCommandOptions,
                 CoverageOptions, ExplainOptions, TemplateOptions, MachineOptions>;

/// What to do: a command, or a text to print and an exit code (--help, --version, bad usage).
struct CommandLine {
  std::optional<CommandOptions> command;
  std::string output;  ///< for stdout
  std::string errors;  ///< for stderr
  int exit_code = 0;
};

/// `arguments` without the program's name.
CommandLine parseCommandLine(const std::vector<std::string>& arguments);

}  // namespace proveout
