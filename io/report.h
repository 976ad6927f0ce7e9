// The report of a run: what `report.json`, `junit.xml` and `report.html` say. Plain data, filled by the
// pipeline; described for readers in docs/reference/report.md. Lengths mm, volumes mm3, times s, workpiece
// frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/geometry/types.h"
#include "core/mesh/mesh_placement.h"
#include "io/acceptance.h"
#include "io/finding_kind.h"
#include "io/report_wish.h"
#include "io/verdict.h"
#include "removal/process/stock_body.h"

namespace proveout {

/// The block of the program that is to blame.
struct BlockRef {
  std::string file;         ///< as the program is named in messages
  std::uint32_t line = 0;   ///< from 1
  std::int64_t block = -1;  ///< N number, or -1
  std::uint16_t depth = 0;  ///< subprogram level
  std::string text;         ///< the line's text, where it is at hand
};

/// A block's share of the surface that a finding is about.
struct BlockShare {
  BlockRef block;
  std::string setup;  ///< as in Finding
  std::optional<int> tool;
  double share = 0.0;  ///< of the area, 0..1
};

/// A word of a program, or a datum of the job, that could be what is wrong.
struct Cause {
  std::string what;                ///< kind of word ("Z", "depth of the cycle"), or key of the job
  std::string value;               ///< the word's text ("Z-3.5"), or the datum's value
  std::optional<BlockRef> source;  ///< where the word is written; none: a datum of the job
  std::uint32_t column = 0;        ///< of the word, from 1; 0: not known
  bool incremental = false;        ///< a step: words before it count as well
  std::vector<BlockRef> from;      ///< assignments of the variables that the word read
  std::string along;               ///< what is off: "X", "Y", "Z", "radius"; empty: not known
  std::optional<double> off_mm;    ///< by how much, signed: the cut is so far beyond where it should be
  double explains = 0.0;           ///< share of the finding that this would explain, 0..1
  std::string with;  ///< what was put in its place to see what is left ("G41", "D1 = 5"); empty: nothing
  std::optional<double> left_mm;  ///< depth of what is left of the finding then; 0: it goes
};

/// `what` of the cause of material that no motion reaches.
inline constexpr std::string_view kUncut = "no motion cuts here";
/// The same of a contour along which the middle of the wire went.
inline constexpr std::string_view kNoOffset = "cut without offset (G40 or a value of 0)";

/// Something that was found, at one place or over the blocks that made the same mistake.
struct Finding {
  /// With the severity that its kind has as a rule.
  explicit Finding(FindingKind what) : kind(what), severity(findingKindInfo(what).severity) {}

  FindingKind kind;
  Severity severity;
  std::optional<Vec3> where;
  std::optional<double> depth_mm, area_mm2, volume_mm3;
  std::optional<BlockRef> source;       ///< of several the first
  std::optional<BlockRef> last_source;  ///< the last block, where several did the same
  /// The block that moved, where `source` is what it moved for: a line of the control's own cycle, or the
  /// call of a contour cycle.
  std::optional<BlockRef> inside;
  std::optional<std::uint32_t> motion;  ///< id in the path stream
  std::optional<int> tool;
  std::string setup;  ///< name of the clamping; empty in a job without setups
  std::string message;
  std::string feature;             ///< of the CAD model, for people; empty: none is known
  std::optional<double> bound_mm;  ///< the true depth is within this of depth_mm
  std::size_t spots = 1;           ///< places that are told as one
  std::vector<BlockShare> blocks;  ///< that made the surface, largest share first
  std::vector<Cause> causes;       ///< likeliest first
  /// Words and data that were not put otherwise, as trials had taken about as much as the run itself; 0 where
  /// one of those that were leaves nothing of the finding.
  std::size_t untried_causes = 0;
  bool known = false;  ///< the baseline has it: it does not count for the verdict
  std::string worse;   ///< by what it is beyond what the baseline has; empty: it is not, or is new
};

/// One clamping of a job with setups.
struct ReportSetup {
  std::string name;
  std::string program;  ///< name of its main program
  std::uint64_t blocks = 0, motions = 0;
  double cycle_s = 0.0;
  double removed_mm3 = 0.0, final_mm3 = 0.0;
  std::string control;  ///< empty: the control of all setups
};

struct ReportProgram {
  std::string control;
  std::vector<std::string> files;
  std::uint64_t blocks = 0;  ///< executed
  std::uint64_t motions = 0;
  std::string until;  ///< "N120" or "line 12": only the program up to there was run; empty: all of it
};

struct ToolUse {
  int number = 0;
  std::string name;         ///< may be empty
  std::string description;  ///< "ball 3.175", may be empty
  double cutting_s = 0.0, rapid_s = 0.0;
  double removed_mm3 = 0.0;
  std::uint64_t motions = 0;
};

struct ReportTime {
  double cycle_s = 0.0, cutting_s = 0.0, rapid_s = 0.0;
  std::vector<ToolUse> per_tool;
};

/// What a part of the machining did: all of it, one tool's, or one block's. Times s, lengths mm along the
/// path of the control point.
struct CutFigures {
  double feed_s = 0.0, rapid_s = 0.0;        ///< of motions
  double other_s = 0.0;                      ///< dwells and tool changes
  double air_s = 0.0;                        ///< of feed_s: feed motions that removed nothing
  double length_mm = 0.0;                    ///< of all motions
  double engaged_s = 0.0, engaged_mm = 0.0;  ///< of the motions that removed material
  double removed_mm3 = 0.0;
  /// Of a wire, of the motions that removed material: path times height of the workpiece, and their time.
  double wire_mm2 = 0.0, wire_s = 0.0;

  double time_s() const { return feed_s + rapid_s + other_s; }
  /// Mean section of the chip, mm2: removed volume over the path on which it was removed. None: nothing was.
  std::optional<double> engagement_mm2() const;
  /// Material removal rate over the time in which material was removed. None: nothing was.
  std::optional<double> rate_mm3_min() const;
  /// Cutting rate of a wire: the area that it passes through. None: no wire cut anything.
  std::optional<double> area_mm2_min() const;
};

struct ToolFigures {
  int tool = 0;
  CutFigures figures;
};

/// Material removal rate along the machining time, in equal steps from 0 to the cycle time, mm3/min; where
/// wires alone cut, their cutting rate, mm2/min.
struct RateSeries {
  double step_s = 0.0;
  bool by_area = false;           ///< mm2/min
  std::vector<double> mean, max;  ///< of each step: mean over its time, largest of its motions
  struct Span {
    double from_s = 0.0, to_s = 0.0;
    std::string label;  ///< of the tool that is at work: "T1"
  };
  std::vector<Span> spans;
};

/// Where time and material went. Sums: removed_mm3 is the removed volume, time_s the cycle time.
struct ReportAccounting {
  CutFigures total;
  std::vector<ToolFigures> per_tool;
  RateSeries rate;  ///< for the plot; not in report.json
};

/// A row of blocks.csv: one execution of a program block.
struct BlockFigures {
  std::string_view setup;  ///< empty in a job without setups
  std::string_view file;
  std::uint32_t line = 0;
  std::int64_t block = -1;  ///< N number, or -1
  std::uint16_t depth = 0;
  int tool = 0;
  std::string_view kind;  ///< "rapid", "feed", "thread", "mixed", "event"
  double start_s = 0.0;   ///< since the program's start
  CutFigures figures;
};

struct ReportStock {
  double initial_mm3 = 0.0, removed_mm3 = 0.0, final_mm3 = 0.0;  ///< integrated from exact surface crossings
  double error_mm3 = 0.0;          ///< by how much removed and final may be off, about
  double initial_error_mm3 = 0.0;  ///< and initial, and final again by as much
  bool exact = false;     ///< they are closed forms, or nothing was cut; else the error is an estimate
  double mesh_mm3 = 0.0;  ///< enclosed by the exported facets
  std::vector<StockBody> bodies;
  std::size_t mesh_bodies = 0;  ///< so many of them are in the exported mesh, the first ones
  std::uint64_t triangles = 0, vertices = 0;
  bool closed = false;  ///< the exported mesh is a closed, oriented 2-manifold
};

/// A dimension of a feature; mm, or degrees for an angle, micrometres for a roughness.
struct ReportCharacteristic {
  std::string name;   ///< quantityName: "diameter", "x", "position", "depth", ...
  std::string part;   ///< of a feature with several: "step of 12"; else empty
  std::string label;  ///< as the job names it; may be empty
  std::string unit = "mm";
  double nominal = 0.0;
  std::optional<double> measured;      ///< none: the part has too little of the feature
  std::optional<double> lower, upper;  ///< allowed deviations from nominal; none: no limit
  std::optional<Vec3> where;           ///< of the part as a whole: where it is met
  std::string tolerance;               ///< where they are from: "job", "ISO 2768-m", "surface"; empty: none
  std::string verdict;                 ///< "pass", "fail"; empty: there is no tolerance
};

/// A feature of the nominal as it was machined.
struct ReportFeature {
  std::string id;       ///< "F3": its number in the table
  std::string kind;     ///< featureKindName
  std::string feature;  ///< "through hole of diameter 8 at X20.000 Y20.000"
  Vec3 at = Vec3::Zero();
  bool missing = false;  ///< the part has no surface near most of it
  std::vector<ReportCharacteristic> characteristics;
  /// Of one found in facets: how far their corners are off its faces at most, mm.
  std::optional<double> residual_mm = std::nullopt;
};

/// How the nominal was brought to the part: `align` of the job.
struct ReportAlignment {
  std::string kind;                               ///< "fit", "datums"
  std::array<std::array<double, 4>, 3> matrix{};  ///< rows: takes a point of the placed nominal onto the part
  double rms_mm = 0.0, moved_mm = 0.0, turned_deg = 0.0;
  std::uint64_t points = 0, left_out = 0;
  int free_directions = 0;  ///< that the surface does not settle
};

/// A scan that was compared one-sided: only what was scanned is judged.
struct ReportScan {
  std::string file;
  bool mesh = false;         ///< it has triangles; else points alone
  std::uint64_t points = 0;  ///< that were compared
  std::uint64_t off = 0;     ///< too far from the nominal to be of the part
  double coverage = 0.0;     ///< share of the nominal's surface near which there are points, 0..1
  double reach_mm = 0.0;     ///< what is near
};

/// Deviations of the part from nominal, positive outside (excess), negative inside (gouge).
struct ReportComparison {
  std::string nominal;              ///< file
  std::string nominal_unit = "mm";  ///< of the file's coordinates: "mm", "inch", "m"
  MeshPlacement placement;          ///< of what the file holds
  double gouge_tolerance_mm = 0.0, excess_tolerance_mm = 0.0;
  double max_gouge_mm = 0.0, max_excess_mm = 0.0;  ///< >= 0
  double rms_mm = 0.0, p95_mm = 0.0;               ///< of the absolute deviation, by area
  /// Histogram by area: bin i holds deviations from edges_mm[i] to edges_mm[i + 1].
  std::vector<double> histogram_edges_mm;  ///< ascending, one more than areas
  std::vector<double> histogram_area_mm2;
  bool decided = true;                           ///< false: the grid is too coarse for these tolerances
  std::optional<double> deciding_resolution_mm;  ///< grid that would decide it
  std::vector<ReportFeature> features;           ///< of the nominal, as they are recognised
  bool features_found = false;                   ///< in facets, not told by a CAD model
  std::optional<ReportAlignment> alignment;
  std::optional<ReportScan> scan;
};

/// One contribution to the error of the figures.
struct ErrorTerm {
  std::string source;              ///< "grid", "tool", "arcs", "nominal", ...
  std::optional<double> bound_mm;  ///< none: not known
  std::string statement;           ///< one sentence: what it is and where the bound is from
};

struct FileHash {
  std::string role;  ///< "job", "program", "subprogram", "stock", "fixture", "nominal"
  std::string path;
  std::uint64_t bytes = 0;
  std::string sha256;
};

struct ReportMesh {
  std::string path;    ///< relative to the report
  std::string format;  ///< "stl", "obj", "ply", "3mf", "glb", "vdb"
  std::string sha256;  ///< of the file; may be empty
};

struct ReportImage {
  std::string path;   ///< relative to the report
  std::string title;  ///< "iso", "top", "deviation iso", ...
};

/// A file with data for other programs.
struct ReportData {
  std::string path;    ///< relative to the report
  std::string what;    ///< "deviation" (a mesh), "points" (over tolerance), "findings"
  std::string sha256;  ///< of the file
};

struct ReportOutputs {
  std::vector<ReportMesh> meshes;
  std::vector<ReportImage> images;
  std::vector<std::string> tables;  ///< blocks.csv, mrr.svg, profile.svg, relative to the report
  std::string html;                 ///< file name; empty: none
  std::vector<ReportData> data = {};
};

/// Differs from run to run; everything else in the report depends on the inputs alone.
struct ReportPerformance {
  double wall_s = 0.0, interpret_s = 0.0, remove_s = 0.0, mesh_s = 0.0, compare_s = 0.0, render_s = 0.0;
  double read_s = 0.0;  ///< of meshes that are compared without a program: reading and repairing them
  double peak_memory_mb = 0.0;
  double predicted_memory_mb = 0.0, predicted_s = 0.0;  ///< before the run; 0: nothing was predicted
  int threads = 0;
};

/// What was looked at. A check that was not made is "skipped" in junit.xml, never passed.
struct ReportChecks {
  bool interpreted = true;     ///< the program was run
  bool removal = false;        ///< stock was cut: contacts are known
  bool comparison = false;     ///< gouge and excess are known
  bool travel_limits = false;  ///< the job gives limits
  bool fixtures = false;       ///< the job has fixtures: contacts with them are known
  bool mesh = false;           ///< a mesh was made and its topology checked
};

struct Report {
  std::string name;
  std::string version;  ///< of proveout
  Verdict verdict = Verdict::kError;
  std::vector<ReportHeadLine> head;  ///< what the job says of part and people
  ReportChecks checks;
  ReportProgram program;
  std::vector<ReportSetup> setups;  ///< in their order; empty in a job without setups
  ReportTime time;
  std::optional<ReportAccounting> accounting;  ///< none: nothing was cut
  std::optional<ReportStock> stock;
  std::string
      profile_svg;  ///< half section of a turned part for report.html (ProfileChart::page); empty: none
  double resolution_mm = 0.0;
  std::vector<Finding> findings;
  std::vector<ReportCharacteristic> part_characteristics;  ///< of the part as a whole
  ReportAcceptance acceptance;
  std::optional<ReportComparison> comparison;
  std::vector<ErrorTerm> error_budget;
  std::vector<Diagnostic> diagnostics;  ///< what the control said of the program, in order
  std::vector<std::string> command;     ///< words of the command line that decide the findings; may be empty
  std::vector<FileHash> inputs;
  std::string part_sha256;  ///< sha256OfMesh of the part; empty: none
  ReportOutputs outputs;
  ReportPerformance performance;
};

struct ReportOptions {
  /// false leaves out `performance` (and times in junit.xml), so that equal inputs give equal bytes.
  bool with_performance = true;
};

/// report.json, schema proveout.report/1: UTF-8, two spaces of indent, keys in a fixed order, ends with a
/// newline.
std::string reportJson(const Report& report, const ReportOptions& options = {});

/// junit.xml: one suite, one test case a check; a failure carries the findings' text.
std::string reportJunit(const Report& report, const ReportOptions& options = {});

/// A picture for report.html.
struct ReportPicture {
  std::string title;
  std::string png;  ///< bytes of a PNG file
};

/// report.html: one self-contained page, no script, no network. Everything from outside is escaped.
std::string reportHtml(const Report& report, const std::vector<ReportPicture>& pictures,
                       const ReportOptions& options = {});

/// The rate over time as an SVG file of its own; "" if there is nothing to draw.
std::string rateSvgFile(const RateSeries& rate);

/// blocks.csv: the line of column names, and a row; each ends with a newline.
std::string blockCsvHeader();
void appendBlockCsv(const BlockFigures& row, std::string& out);

}  // namespace proveout
