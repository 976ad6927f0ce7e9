#include "app/session/programs/interpretation.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "app/session/programs/clearance.h"
#include "app/session/programs/origin_sink.h"
#include "app/session/programs/placed_path.h"
#include "app/session/programs/wire_heights.h"
#include "app/session/run/control_choice.h"
#include "app/session/run/job_defaults.h"
#include "app/session/run/process.h"
#include "app/session/run/stock_probe.h"
#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "core/nc/text/source_text.h"
#include "core/tool/tool_table.h"
#include "io/job/template_files.h"
#include "io/program_files.h"

namespace proveout {
namespace {

/// What a kept event takes with its texts, bytes: a generous estimate.
constexpr std::size_t kEventBytes = 512;

/// Bytes that the tool path may take: the job's limit, else half of the machine's memory.
double pathMemory(const Job& job) {
  if (job.simulation.max_memory_gb > 0) return job.simulation.max_memory_gb * 1e9;
  return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Builds the path and stops the interpretation before the path outgrows the memory: an endless loop would
/// reach that long before the limit of blocks.
class GuardedBuilder : public ToolpathBuilder {
 public:
  GuardedBuilder(Toolpath& path, double most_bytes, Progress& progress)
      : ToolpathBuilder(path), most_bytes_(most_bytes), progress_(progress) {}
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) override {
    ToolpathBuilder::motion(motion, arc, axis);
    // Twice: a growing vector holds its old half as long as it copies.
    add(2 * (sizeof(Motion) + (arc ? sizeof(ArcGeometry) : 0) + (axis ? sizeof(AxisSweep) : 0) +
             (axis && axis->pose ? sizeof(PoseSweep) : 0)),
        motion.source);
  }
  void wireMotion(const Motion& motion, const WireSweep& wire) override {
    ToolpathBuilder::wireMotion(motion, wire);
    add(2 * (sizeof(Motion) + sizeof(WireSweep)), motion.source);
  }
  void event(const PathEvent& event) override {
    ToolpathBuilder::event(event);
    add(kEventBytes, event.source);
  }
  void originWord(const WordOrigin& word) override {
    ToolpathBuilder::originWord(word);
    bytes_ += 2.0 * static_cast<double>(sizeof(WordOrigin) + word.from.size() * sizeof(word.from.front()));
  }
  void originData(const DataInForce& data) override {
    ToolpathBuilder::originData(data);
    bytes_ += 2.0 * sizeof(DataInForce);
  }
  void originModal(const ModalOrigins& modal) override {
    ToolpathBuilder::originModal(modal);
    bytes_ += 2.0 * sizeof(ModalOrigins);
  }
  void originSet(const OriginSet& set) override {
    ToolpathBuilder::originSet(set);
    bytes_ += 2.0 * sizeof(OriginSet);
  }
  /// The block that went over the limit.
  const std::optional<SourceRef>& outgrownAt() const { return outgrown_at_; }

 private:
  void add(std::size_t bytes, const SourceRef& source) {
    bytes_ += static_cast<double>(bytes);
    // The paths of other setups and the texts of programs are held as well.
    constexpr unsigned kLook = 4096;
    const bool spent = ++added_ % kLook == 0 && memorySpent();
    if ((bytes_ <= most_bytes_ && !spent) || outgrown_at_) return;
    outgrown_at_ = source;
    progress_.cancel();
  }

  double bytes_ = 0.0, most_bytes_;
  unsigned added_ = 0;
  Progress& progress_;
  std::optional<SourceRef> outgrown_at_;
};

}  // namespace

ControlSettings controlSettings(const Job& job, const Box3& blank) {
  ControlSettings settings = job.settings;
  for (const Tool& tool : job.tools) {
    if (tool.gauge_length != 0.0) settings.gauge_lengths[tool.number] = tool.gauge_length;
    if (!tool.insert && tool.diameter > 0.0) settings.tool_radii[tool.number] = 0.5 * tool.diameter;
    if (tool.insert) settings.inserts[tool.number] = {noseCenter(*tool.insert), tool.insert->gauge};
  }
  placeMachine(job, blank, settings);
  giveWireHeights(job, blank, settings);
  return settings;
}

namespace {

/// Settings of the job's channels, of which there is one where the control has no others.
std::vector<ControlSettings> channelSettings(const Job& job, const ControlSettings& settings) {
  if (job.channels.empty()) return {settings};
  std::vector<ControlSettings> all;
  for (std::size_t k = 0; k < job.channels.size(); ++k) {
    ControlSettings own = job.channels[k].settings;
    own.start = job.channels[k].start.value_or(settings.start);
    own.start_by_default = settings.start_by_default && !job.channels[k].start;
    own.gauge_lengths = settings.gauge_lengths;
    own.inserts = settings.inserts;
    own.tool_radii = settings.tool_radii;
    own.unnamed_gauge = settings.unnamed_gauge;
    own.tool_change = placeInChannel(settings, own);
    own.max_errors = settings.max_errors;
    own.lenient = settings.lenient;
    if (k == 0) own.until = settings.until;
    all.push_back(std::move(own));
  }
  return all;
}

/// Takes what is given in the workpiece frame to where the control has it. Returns the ways back, by channel;
/// empty: the workpiece lies where the offsets say.
std::vector<ChannelPlacement> takeToControl(std::vector<ControlSettings>& settings) {
  std::vector<ChannelPlacement> back;
  bool any = false;
  for (ControlSettings& own : settings) {
    const RigidTransform move = pathIntoWorkpiece(own);
    any = any || move.rotation != Eigen::Matrix3d::Identity() || move.translation != Vec3::Zero();
    back.push_back({own.channel, move});
  }
  if (!any) return {};
  for (std::size_t k = 0; k < settings.size(); ++k) {
    settings[k].start = back[k].move.inverse()(settings[k].start);
    for (AxisSettings& axis : settings[k].axes)
      axis.center = axis.center.value_or(workpieceZero(settings[k]));
  }
  return back;
}

}  // namespace

InterpretSummary interpretJob(const Job& job, ControlId control, const RecordingSource& source,
                              const ControlSettings& settings, MotionSink& sink, Progress& progress,
                              const ControlHost& host) {
  OriginSink texts(sink, source);  // a filled set tells the lines of its templates
  MotionSink* told = job.filled ? &texts : &sink;
  ControlHost asked = host;
  std::vector<ControlSettings> all = channelSettings(job, settings);
  const std::vector<ChannelPlacement> back = takeToControl(all);
  std::optional<PlacedSink> placed;
  std::optional<PlacedProbe> probe;
  if (!back.empty()) {
    told = &placed.emplace(*told, back);
    if (host.probe != nullptr) asked.probe = &probe.emplace(*host.probe, back.front().move);
  }
  if (all.size() == 1) return interpret(control, source, all.front(), *told, &progress, asked);
  const std::vector<const ProgramSource*> sources = source.channels();
  std::vector<ChannelProgram> programs;
  for (std::size_t k = 0; k < all.size(); ++k) programs.push_back({sources[k], std::move(all[k])});
  return interpretChannels(control, programs, *told, &progress, asked);
}

namespace {

/// Why the control cannot work with the job's tools; empty: it can. Checked before anything is made of them.
std::string toolRefusalOf(const Job& job) {
  const Process& process = processOf(job.control);
  for (const Tool& tool : job.tools) {
    if (!process.holds(tool))
      return fmt::format("tool {} is {}; control {} {}{}", tool.number,
                         tool.type == ToolType::kInsert ? "a lathe insert"
                         : tool.type == ToolType::kWire ? "a wire"
                                                        : "a rotating tool",
                         job.control, process.words.verb, process.words.tool_advice);
  }
  return {};
}

}  // namespace

Interpreted interpretProgram(const Job& job, const RecordingSource& source, const ControlSettings& settings,
                             Progress& progress, const ProbedStock* stock) {
  Interpreted result;
  GuardedBuilder builder(result.path, pathMemory(job), progress);
  if (auto note = choiceNote(job)) result.path.diagnostics.add(std::move(*note));
  const Result<ControlId> control = findControl(job.control);
  const std::string refusal = !control ? control.error().message : toolRefusalOf(job);
  if (!refusal.empty()) {
    Diagnostic diagnostic;
    diagnostic.code = control ? "tool" : "control";
    diagnostic.message = refusal;
    result.path.diagnostics.add(diagnostic);
    result.summary.end = ProgramEnd::kAlarm;
    result.summary.errors = 1;
    return result;
  }
  progress.report("interpreting", 0.0);
  MemoryOutput output;
  ControlHost host;
  host.output = &output;
  host.person = job.person;
  std::unique_ptr<PieceProbe> probe;
  if (stock != nullptr) probe = processOf(job.control).probe(job, *stock, result.path, progress);
  host.probe = probe.get();
  result.summary = interpretJob(job, *control, source, settings, builder, progress, host);
  if (probe) result.probe_failure = probe->failure();
  if (probe && probe->passedFixtures() && !job.fixtures.empty()) {
    Diagnostic note;
    note.severity = Severity::kNote;
    note.code = "probe";
    note.message = "measuring moves stop at the stock, not at the fixtures";
    result.path.diagnostics.add(std::move(note));
  }
  result.files = output.files();
  result.path.blocks = result.summary.blocks;
  result.outgrown_at = builder.outgrownAt();
  return result;
}

void addOffsetTools(Toolpath& path, std::vector<Tool>& tools) {
  std::set<int> defined;
  for (const Tool& tool : tools) defined.insert(tool.number);
  for (const auto& [before, event] : path.events) {
    const auto* shape = event.as<event::ToolShape>();
    if (shape == nullptr) continue;
    Tool tool;
    tool.number = shape->tool;
    tool.diameter = shape->diameter;
    const double radius = 0.5 * tool.diameter, corner = shape->corner_radius;
    if (tool.number <= 0 || !(radius > 0.0) || !(corner >= 0.0 && corner <= radius)) continue;
    if (!defined.insert(tool.number).second) continue;
    tool.type = corner == 0.0 ? ToolType::kFlat : corner == radius ? ToolType::kBall : ToolType::kBull;
    if (tool.type == ToolType::kBull) tool.corner_radius = corner;
    tool.name = fmt::format("offset row {}", shape->d);
    Diagnostic note;
    note.severity = Severity::kNote;
    note.code = "tool";
    note.message = fmt::format(
        "tool {} is not in the job: its shape is that of offset row {}, diameter {} and corner radius {} mm",
        tool.number, shape->d, tool.diameter, corner);
    path.diagnostics.add(std::move(note));
    tools.push_back(std::move(tool));
  }
}

bool assignTools(Toolpath& path, const std::vector<Tool>& tools, const RecordingSource& source) {
  if (path.motions.empty()) return true;
  const ToolTable table(tools);
  std::set<int> missing;
  const auto diagnose = [&](Severity severity, const Motion& motion, std::string code, std::string message) {
    const BlockRef block = blockRef(path, motion.source, source);
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    diagnostic.where = {block.file, static_cast<int>(block.line), 0, 0};
    diagnostic.source_line = block.text;
    path.diagnostics.add(std::move(diagnostic));
  };
  const Tool* const unnamed = table.unnamed();
  if (unnamed == nullptr) {
    diagnose(Severity::kError, path.motions.front(), "tool", "the job defines no tool");
    return false;
  }
  std::map<int, MotionId> first_change;  // by channel
  for (const Toolpath::EventAt& e : path.events) {
    if (e.event.as<event::ToolChange>() != nullptr) first_change.emplace(e.event.channel, e.before);
  }
  int known = unnamed->number;  // the last tool that was found
  bool told = false, good = true;
  for (Motion& motion : path.motions) {
    if (motion.tool == known) continue;
    const Tool* const tool = table.ofMotion(motion.tool);
    if (tool != nullptr && tool->number != motion.tool) {  // it names none
      const auto changed = first_change.find(motion.channel);
      const bool emptied = changed != first_change.end() &&
                           static_cast<MotionId>(&motion - path.motions.data()) >= changed->second;
      if (emptied && motion.kind != MotionKind::kRapid) {
        diagnose(Severity::kError, motion, "tool", "a feed motion with the spindle emptied by T0 M6");
        return false;
      }
      // Many programs go up before their first tool: nothing is met there. A wire is in the machine, no
      // program calls it.
      const bool climbs = motion.kind == MotionKind::kRapid && motion.to.z() > motion.from.z() &&
                          motion.to.head<2>() == motion.from.head<2>();
      if (!told && !climbs && motion.wire < 0) {
        diagnose(Severity::kNote, motion, "tool",
                 fmt::format("no tool is changed in up to here; tool {} is taken to be in the spindle",
                             tool->number));
        told = true;
      }
      motion.tool = tool->number;
      continue;
    }
    if (tool != nullptr) {
      known = motion.tool;
      continue;
    }
    if (!missing.insert(motion.tool).second) continue;
    good = false;
    diagnose(Severity::kError, motion, "tool",
             fmt::format("tool {} is not defined; give it as [[tool]] in the job or as --tool {}=SHAPE",
                         motion.tool, motion.tool));
  }
  return good;
}

}  // namespace proveout
