#include "app/cli_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "app/exit_codes.h"
#include "core/base/nearest_name.h"
#include "io/job/job.h"

namespace proveout {
namespace {

constexpr const char* kFooter =
    "Exit codes: 0 done, nothing over tolerance; 1 done, with findings of severity error;\n"
    "2 input error (bad file, program alarm, bad usage); 3 limit of memory or time; 130 interrupted.";

/// CLI11 keeps pointers to what it fills: the options live here while it parses.
struct Parsed {
  RunOptions run;
  PathOptions path;
  CheckOptions check;
  CompareCommandOptions compare;
  RenderCommandOptions render;
  CoverageOptions coverage;
  ExplainOptions explain;
  TemplateOptions filled;
  MachineOptions machine;
};

/// Strict: the whole text is a finite decimal number in (low, high].
CLI::Validator numberIn(double low, double high, const std::string& what) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && end == text.data() + text.size();
        if (whole && value > low && value <= high) return {};
        return "'" + text + "' is not " + what;
      },
      "");
}

CLI::Validator positiveMm() { return numberIn(0, 1e6, "a length in mm above 0"); }

CLI::Validator threadCount() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        int value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && end == text.data() + text.size();
        return whole && value >= 1 && value <= 1024 ? std::string()
                                                    : "'" + text + "' is not a number of threads, 1 to 1024";
      },
      "");
}

/// One of the names; the nearest one is told of another word.
CLI::Validator oneOf(const std::vector<std::string>& names) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        if (std::find(names.begin(), names.end(), text) != names.end()) return {};
        return fmt::format("'{}' is not known{}; there are {}", text, didYouMean(nearestName(text, names)),
                           fmt::join(names, ", "));
      },
      "");
}

CLI::Validator notEmpty() {
  return CLI::Validator(
      [](std::string& text) { return text.empty() ? std::string("an empty text") : std::string(); }, "");
}

/// `other`: what the limit is without the option.
void addMaxTime(CLI::App& app, std::optional<double>& seconds,
                const std::string& other = fmt::format("{:g}", kDefaultMaxTimeS)) {
  app.add_option("--max-time", seconds, "End the command within this time, exit 3; default: " + other)
      ->type_name("SECONDS")
      ->check(numberIn(0, 1e9, "a time in seconds above 0"));
}

void addPlacement(CLI::App& app, NominalOptions& options) {
  app.add_option("--nominal-at", options.at,
                 "Where the origin of the nominal's file lies, mm, in the frame of the finished part;\n"
                 "overrides the job's move")
      ->type_name("X,Y,Z");
  app.add_option(
         "--nominal-rotate", options.rotate,
         "How the nominal is turned about the fixed axes X, Y, Z before, degrees; overrides the job's rotate")
      ->type_name("A,B,C");
  app.add_option("--nominal-body", options.body,
                 "Body of a STEP file with several: its name, or its number from 1; overrides the job's body")
      ->type_name("NAME");
}

void addProgramOptions(CLI::App& app, ProgramOptions& options) {
  app.add_option("INPUT", options.input, "Job file (*.toml) or NC program")->required()->check(notEmpty());
  app.add_option(
         "--control", options.control,
         "Virtual control, with a program; `proveout coverage` lists them;\ndefault: auto, the one that the "
         "program looks like")
      ->type_name("NAME");
  app.add_option("--subprograms", options.subprograms,
                 "File or folder with subprograms, with a program; repeatable")
      ->type_name("PATH")
      ->allow_extra_args(false);
  app.add_option("--setup", options.setup,
                 "With a job of several setups: only up to this one (check and path: this one alone)")
      ->type_name("NAME");
  app.add_option("--until", options.until, "Stop after this line (120) or block (N70) of the main program")
      ->type_name("LINE|Nn");
  app.add_flag("--lenient", options.lenient, "Unsupported codes that are safe to skip become warnings");
  app.add_option(
         "--offset", options.offsets,
         "What the operator has entered, mm; overrides the job; repeatable:\nG55=X,Y,Z, 'G54.1 P3=X,Y,Z', "
         "common=X,Y,Z, D1=RADIUS, H1=LENGTH;\nlathes: DXW.n, DZW.n, RT.n, TIP.n; in one clamping: "
         "SETUP:G54=X,Y,Z")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false)
      ->check(notEmpty());
  app.add_flag("--skip", options.skip, "Leave out blocks that begin with /, as the block skip switch does");
  app.add_option("--program-unit", options.program_unit,
                 "Power-on unit of the control: mm, inch; overrides the job; default: mm")
      ->type_name("UNIT")
      ->check(oneOf({"mm", "inch"}));
  app.add_option("--machine", options.machine,
                 "TOML file with the keys of [machine], with a program (a job names it itself)")
      ->type_name("FILE")
      ->check(notEmpty());
  addMaxTime(app, options.max_time_s, fmt::format("the job's, or {:g}", kDefaultMaxTimeS));
}

void addRun(CLI::App& root, RunOptions& o) {
  CLI::App* app = root.add_subcommand("run", "Machine the part, check it, write mesh, report and pictures");
  addProgramOptions(*app, o.program);
  app->add_option(
         "--stock", o.stock,
         "Blank, mm, with a program: box:x0,y0,z0:x1,y1,z1,\ncylinder:x,y,z:DIAMETER:LENGTH[:AXIS],\n"
         "tube:x,y,z:DIAMETER:INNER:LENGTH[:AXIS],\nmesh:FILE, vdb:FILE")
      ->type_name("SHAPE");
  app->add_option(
         "--tool", o.tools,
         "Tool, mm and degrees, with a program; repeatable:\nN=flat:D, N=ball:D, N=bull:D:R, "
         "N=cone:D:TIPD:ANGLE,\n"
         "N=drill:D[:POINTANGLE], N=taper:BALLD:SIDEANGLE:D,\nN=dovetail:D:ANGLE:HEIGHT:NECKD, "
         "N=tslot:D:THICKNESS:NECKD,\nN=lollipop:D:NECKD; thread mills and free profiles need a job file.\n"
         "Motions without a T word use the lowest number")
      ->type_name("N=SHAPE")
      ->allow_extra_args(false);
  app->add_option("--nominal", o.nominal,
                  "CAD model to compare with, with a program: closed STL, OBJ, PLY, 3MF, GLB, or\nSTEP")
      ->type_name("FILE");
  app->add_option("--unit", o.unit, "Of the meshes of --nominal and --stock: mm, inch, m; default: mm")
      ->type_name("UNIT");
  addPlacement(*app, o.place);
  app->add_option("--tolerance", o.tolerance_mm,
                  "Allowed gouge and excess against nominal; overrides the job")
      ->type_name("MM")
      ->check(positiveMm());
  app->add_option("--resolution", o.resolution_mm,
                  "Grid spacing; default: longest side of the blank / 400, rounded up;\nwith a nominal as "
                  "fine as tolerance and tools ask for")
      ->type_name("MM")
      ->check(positiveMm());
  app->add_option("--causes", o.causes,
                  "What to say is wrong behind a deviation: off (nothing), fast (what it suggests),\n"
                  "proven (what puts it right when tried); default: the job's, or proven")
      ->type_name("NAME")
      ->check(oneOf(causeSearchNames()));
  app->add_option(
         "--simplify", o.simplify_mm,
         "How far the mesh may leave the surface to have fewer triangles; 0: off;\ndefault: a tenth of "
         "the grid, with a nominal at most a tenth of its tolerances")
      ->type_name("MM")
      ->check(numberIn(std::nextafter(0.0, -1.0), 10, "a length in mm from 0 to 10"));
  app->add_option("--threads", o.threads,
                  "Worker threads; the result does not depend on them; default: all cores")
      ->type_name("N")
      ->check(threadCount());
  app->add_option("--max-memory", o.max_memory_gb,
                  "Refuse a run that needs more (exit 3); default: what is free")
      ->type_name("GB")
      ->check(numberIn(0, 1e6, "a size in GB above 0"));
  app->add_option(
         "--baseline", o.baseline,
         "Findings that are known, as --write-baseline wrote them: only new ones,\nand known ones that "
         "became worse, count for the verdict")
      ->type_name("FILE")
      ->check(notEmpty());
  app->add_option("--write-baseline", o.write_baseline,
                  "Write the findings of this run for --baseline; the verdict stays as it is")
      ->type_name("FILE")
      ->check(notEmpty());
  app->add_option(
         "--select", o.select,
         "Only findings of these kinds, separated by commas, are listed and count;\nwhat says that the "
         "result is not whole always does")
      ->type_name("KINDS")
      ->allow_extra_args(false);
  app->add_option("--ignore", o.ignore, "Findings of these kinds are only counted")
      ->type_name("KINDS")
      ->allow_extra_args(false);
  app->add_option("--out", o.out,
                  "Folder for the results; default: NAME-out beside the job, or in the current folder")
      ->type_name("DIR")
      ->check(notEmpty());
  app->add_option("--format", o.formats,
                  "Mesh files: stl, stl-ascii, obj, ply, 3mf, glb, vdb, separated by commas;\ndefault: stl")
      ->type_name("LIST");
  app->add_option("--view", o.views, "Picture from here; repeatable: iso, top, front, ...; default: iso")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app->add_option("--size", o.size, "Size of the pictures; default: 1280x960")->type_name("WxH");
  app->add_flag("--no-render", o.no_render, "No pictures");
  app->add_flag("--no-view3d", o.no_view3d, "No 3-D view in report.html; --no-render leaves it out too");
  app->add_flag("--bodies", o.bodies, "Write a mesh file for each piece that a wire cut free: slugs/");
  app->add_flag("--csv", o.csv,
                "Write blocks.csv (what each block removed), mrr.svg (its rate over time)\nand findings.csv");
  app->add_option("--deviation", o.deviation,
                  "Write the deviation of each point of the part, separated by commas: ply, glb\n(the mesh "
                  "with deviation, block, tool and colours), csv (points over tolerance)")
      ->type_name("LIST");
  app->add_flag("--json", o.json, "Print report.json on stdout instead of the summary");
  app->add_flag("--quiet", o.quiet, "Print errors only");
  app->add_flag("--progress", o.progress, "Show progress even where stderr is no terminal");
  app->footer(kFooter);
}

void addExplain(CLI::App& root, ExplainOptions& o) {
  CLI::App* app = root.add_subcommand(
      "explain", "Which block made a point of the part, and which words and data put it there");
  app->add_option("REPORT", o.report, "report.json of a run, or its folder; its inputs must be unchanged")
      ->required();
  app->add_option("--at", o.at, "A point, mm, as findings give it: X,Y,Z")->required()->type_name("X,Y,Z");
  addMaxTime(*app, o.max_time_s, fmt::format("the job's, or {:g}", kDefaultMaxTimeS));
  app->add_flag("--progress", o.progress, "Show progress even where stderr is no terminal");
  app->footer(kFooter);
}

void addTemplate(CLI::App& root, TemplateOptions& o) {
  CLI::App* app = root.add_subcommand("template", "Fill a template in: the program, on stdout");
  app->add_option("FILE", o.input, "Template (.tmpl), set of templates (.tmps) or program text (.pmc)")
      ->required()
      ->check(notEmpty());
  app->add_option("--set", o.values, "Value of a parameter; repeatable")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app->add_flag("--list", o.list, "Print the parameters instead, with meaning, range and default");
  app->add_flag("--json", o.json, "With --list: as JSON");
  app->add_option("--encoding", o.encoding,
                  "Of the files: auto, utf-8, koi8-r, cp1251, gb18030; default: auto")
      ->option_text("NAME")
      ->check(oneOf({"auto", "utf-8", "koi8-r", "cp1251", "gb18030"}));
  app->add_option("-o,--output", o.output, "Write the program into this file")
      ->type_name("FILE")
      ->check(notEmpty());
  app->footer(kFooter);
}

void addPathAndCheck(CLI::App& root, PathOptions& path, CheckOptions& check) {
  CLI::App* app = root.add_subcommand("path", "Interpret only: the motions, one a line, on stdout");
  addProgramOptions(*app, path.program);
  app->add_option("--format", path.format, "jsonl or csv; default: jsonl")
      ->type_name("NAME")
      ->check(oneOf({"jsonl", "csv"}))
      ->option_text("NAME");
  app->footer(kFooter);
  app = root.add_subcommand("check", "Interpret only: what the control would say of the program");
  addProgramOptions(*app, check.program);
  app->add_flag("--json", check.json, "Print the diagnostics as JSON on stdout");
  app->footer(kFooter);
}

void addAlignment(CLI::App& app, CompareCommandOptions& o) {
  app.add_option("--align", o.align,
                 "Move the nominal onto the part before: fit (least squares over the surface),\n"
                 "datums (a plane and two holes of a STEP file); default: none")
      ->option_text("NAME")
      ->check(oneOf({"none", "fit", "datums"}));
  app.add_option("--align-limit", o.align_limit_mm, "No point of the nominal moves farther; default: 1")
      ->type_name("MM")
      ->check(positiveMm());
  app.add_option("--datum", o.datums,
                 "Of --align datums, three times: a point on the plane, the first and the second hole")
      ->option_text("X,Y,Z")
      ->allow_extra_args(false);
  CLI::Option* const scan =
      app.add_flag("--scan", o.scan,
                   "MACHINED is the model, and NOMINAL a scan of the part: points or an open\n"
                   "mesh, PLY or STL; what it does not show is told and not judged");
  app.add_option("--scan-reach", o.scan_reach_mm,
                 "How near to a place of the model a point shows it; default: two spacings of the points")
      ->type_name("MM")
      ->check(positiveMm())
      ->needs(scan);
}

void addCompare(CLI::App& root, CompareCommandOptions& o) {
  CLI::App* app =
      root.add_subcommand("compare", "Compare two meshes: where material is missing or left over");
  app->add_option("MACHINED", o.machined,
                  "Closed mesh of the part: STL, OBJ, PLY, 3MF, GLB; with --scan the model")
      ->required()
      ->check(notEmpty());
  app->add_option("NOMINAL", o.nominal, "CAD model: closed mesh, or STEP; with --scan the scan")
      ->required()
      ->check(notEmpty());
  app->add_option("--unit", o.unit, "Of both meshes: mm, inch, m; default: mm")->option_text("UNIT");
  app->add_option("--nominal-unit", o.nominal_unit, "Of the nominal, where it has another one")
      ->type_name("UNIT");
  addPlacement(*app, o.place);
  addAlignment(*app, o);
  app->add_option("--gouge", o.gouge_mm, "Allowed below nominal; default: 0.02")
      ->option_text("MM")
      ->check(positiveMm());
  app->add_option("--excess", o.excess_mm, "Allowed above nominal; default: 0.05")
      ->option_text("MM")
      ->check(positiveMm());
  app->add_option_function<std::string>(
         "--general-tolerance",
         [&o](const std::string& text) {
           Result<GeneralTolerance> general = parseGeneralTolerance(text);
           if (!general) throw CLI::ValidationError("--general-tolerance", general.error().message);
           o.general = *general;
         },
         "Of the features of the nominal: a class of ISO 2768, as m or mK")
      ->option_text("CLASS");
  app->add_option("--resolution", o.resolution_mm, "Spacing of the samples; default: 0.2")
      ->option_text("MM")
      ->check(positiveMm());
  app->add_option("--threads", o.threads, "Worker threads; default: all cores")
      ->type_name("N")
      ->check(threadCount());
  addMaxTime(*app, o.max_time_s);
  app->add_option("--max-memory", o.max_memory_gb,
                  "Refuse a comparison that needs more (exit 3); default: what is free")
      ->type_name("GB")
      ->check(numberIn(0, 1e6, "a size in GB above 0"));
  app->add_option("--out", o.out,
                  "Write report.json, junit.xml, report.html and deviation.png into this folder")
      ->type_name("DIR")
      ->check(notEmpty());
  CLI::Option* const out = app->get_option("--out");
  app->add_option("--deviation", o.deviation,
                  "Write the deviation of each point of MACHINED there too, separated by commas:\nply, glb "
                  "(the mesh with deviation and colours), csv (points over tolerance)")
      ->type_name("LIST")
      ->needs(out);
  app->add_flag("--csv", o.csv, "Write findings.csv there too")->needs(out);
  app->add_option("--size", o.size, "Size of the pictures; default: 1200x900")->option_text("WxH");
  app->add_flag("--no-view3d", o.no_view3d, "No 3-D view in report.html");
  app->add_flag("--json", o.json, "Print report.json on stdout instead of the summary");
  app->add_flag("--quiet", o.quiet, "Print errors only");
  app->add_flag("--progress", o.progress, "Show progress even where stderr is no terminal");
  app->footer(kFooter);
}

void addRenderAndCoverage(CLI::App& root, RenderCommandOptions& o, CoverageOptions& coverage) {
  CLI::App* app = root.add_subcommand("render", "Draw a mesh");
  app->add_option("MESH", o.mesh, "STL, OBJ, PLY, 3MF or GLB")->required()->check(notEmpty());
  app->add_option("--unit", o.unit, "Of the mesh: mm, inch, m; default: mm")->option_text("UNIT");
  app->add_option("-o,--output", o.output, "Picture; default: NAME.png in the current folder")
      ->type_name("PNG")
      ->check(notEmpty());
  app->add_option("--view", o.view, "iso, top, front, ...; default: iso")->option_text("NAME");
  app->add_option("--size", o.size, "16x16 to 8192x8192; default: 1200x900")->option_text("WxH");
  app->add_option("--heatmap", o.heatmap, "Colour by deviation from the nominal that this report.json names")
      ->type_name("REPORT");
  app->add_option("--threads", o.threads, "Worker threads; default: all cores")
      ->type_name("N")
      ->check(threadCount());
  addMaxTime(*app, o.max_time_s);
  app->footer(kFooter);
  app = root.add_subcommand("coverage", "What each control supports, from the tables that execute");
  app->add_option("--control", coverage.control, "This control only; default: all that are built")
      ->type_name("NAME");
  app->add_flag("--settings", coverage.settings, "Also what [control.NAME] of a job may set");
  app->add_flag("--json", coverage.json, "As JSON");
  app->footer(kFooter);
}

void addMachine(CLI::App& root, MachineOptions& o) {
  CLI::App* app = root.add_subcommand("machine", "Show a machine's axes and reach, or where its tool is");
  app->add_option("FILE", o.file, "Machine file")->required()->check(notEmpty());
  app->add_option("--at", o.at, "Positions of the axes: \"X0 Y0 Z100 A30 C60\"; others are at 0")
      ->type_name("WORDS");
  CLI::Option* job = app->add_option("--job", o.job, "Job whose zero and tools are taken")->type_name("FILE");
  app->add_option("--tool", o.tool, "Tool of the job; default: none, the gauge point itself")
      ->type_name("N")
      ->needs(job);
  app->add_option("--picture", o.picture, "Draw the axes, all at 0")->type_name("PNG")->check(notEmpty());
  app->footer(kFooter);
}

/// Of a command line that CLI11 refuses: the command or option that there is not, with the nearest one;
/// empty: something else is wrong.
std::string unknownWord(CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* used = nullptr;
  std::vector<std::string> names;
  const std::string command = arguments.empty() ? std::string() : arguments.front();
  for (const CLI::App* sub : app.get_subcommands([](CLI::App*) { return true; })) {
    names.push_back(sub->get_name());
    if (sub->get_name() == command) used = sub;
  }
  if (command.starts_with("--") && app.get_option_no_throw(command) == nullptr) {
    const std::string nearest = nearestName(command.substr(2), {"help", "version"});
    return fmt::format("there is no option {} without a command{}; commands are {}", command,
                       didYouMean(nearest.empty() ? "" : "--" + nearest), fmt::join(names, ", "));
  }
  if (command.empty() || command.starts_with('-'))
    return fmt::format("a command is missing; there are {}", fmt::join(names, ", "));
  if (used == nullptr) {
    return fmt::format("there is no command '{}'{}; there are {}", command,
                       didYouMean(nearestName(command, names)), fmt::join(names, ", "));
  }
  std::vector<std::string> options;
  for (const CLI::Option* option : used->get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back(name);
  }
  for (std::size_t k = 1; k < arguments.size() && arguments[k] != "--"; ++k) {
    if (!arguments[k].starts_with("--")) continue;
    const std::string name = arguments[k].substr(2, arguments[k].find('=') - 2);
    if (std::find(options.begin(), options.end(), name) != options.end()) continue;
    const std::string nearest = nearestName(name, options);
    return fmt::format("{} has no option --{}{}", command, name,
                       didYouMean(nearest.empty() ? "" : "--" + nearest));
  }
  return {};
}

}  // namespace

std::vector<std::string> decidingArguments(const RunOptions& o) {
  const std::string& input = o.program.input;
  const bool dashed = input.starts_with('-');  // would be read as an option
  std::vector<std::string> out = {"run"};
  if (!dashed) out.push_back(input);
  const auto add = [&](const char* name, const std::optional<std::string>& value) {
    if (value) out.insert(out.end(), {name, *value});
  };
  const auto addNumber = [&](const char* name, const std::optional<double>& value) {
    char text[32];
    if (value) add(name, std::string(text, std::to_chars(text, text + sizeof text, *value).ptr));
  };
  add("--control", o.program.control);
  for (const std::string& path : o.program.subprograms) add("--subprograms", path);
  add("--setup", o.program.setup);
  add("--until", o.program.until);
  if (o.program.lenient) out.push_back("--lenient");
  for (const std::string& offset : o.program.offsets) add("--offset", offset);
  if (o.program.skip) out.push_back("--skip");
  add("--program-unit", o.program.program_unit);
  add("--machine", o.program.machine);
  add("--stock", o.stock);
  for (const std::string& tool : o.tools) add("--tool", tool);
  add("--nominal", o.nominal);
  add("--unit", o.unit);
  add("--nominal-at", o.place.at);
  add("--nominal-rotate", o.place.rotate);
  add("--nominal-body", o.place.body);
  for (const std::string& kinds : o.select) add("--select", kinds);
  for (const std::string& kinds : o.ignore) add("--ignore", kinds);
  if (o.causes) add("--causes", *o.causes);
  addNumber("--tolerance", o.tolerance_mm);
  addNumber("--resolution", o.resolution_mm);
  addNumber("--simplify", o.simplify_mm);
  if (dashed) out.insert(out.end(), {"--", input});
  return out;
}

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  CommandLine line;
  Parsed parsed;
  CLI::App app("Runs an NC program against a stock blank: machined part, findings, report, pictures.",
               "proveout");
  app.set_version_flag("--version", std::string("proveout ") + PROVEOUT_VERSION,
                       "Print the version and leave");
  app.require_subcommand(1);
  app.footer("`proveout COMMAND --help` tells the options of a command.\n" + std::string(kFooter));
  addRun(app, parsed.run);
  addPathAndCheck(app, parsed.path, parsed.check);
  addCompare(app, parsed.compare);
  addExplain(app, parsed.explain);
  addTemplate(app, parsed.filled);
  addRenderAndCoverage(app, parsed.render, parsed.coverage);
  addMachine(app, parsed.machine);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    line.output = out.str();
    line.errors = err.str().empty() ? "" : "proveout: error: " + err.str();
    if (const std::string unknown = code == 0 ? "" : unknownWord(app, arguments); !unknown.empty())
      line.errors = fmt::format("proveout: error: {}\nRun with --help for more information.\n", unknown);
    line.exit_code = code == 0 ? kExitOk : kExitInput;
    return line;
  }
  if (app.got_subcommand("run")) line.command = std::move(parsed.run);
  if (app.got_subcommand("path")) line.command = std::move(parsed.path);
  if (app.got_subcommand("check")) line.command = std::move(parsed.check);
  if (app.got_subcommand("compare")) line.command = std::move(parsed.compare);
  if (app.got_subcommand("render")) line.command = std::move(parsed.render);
  if (app.got_subcommand("explain")) line.command = std::move(parsed.explain);
  if (app.got_subcommand("template")) line.command = std::move(parsed.filled);
  if (app.got_subcommand("coverage")) line.command = std::move(parsed.coverage);
  if (app.got_subcommand("machine")) line.command = std::move(parsed.machine);
  return line;
}

}  // namespace proveout
