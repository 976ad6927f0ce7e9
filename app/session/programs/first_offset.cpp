#include "app/session/programs/first_offset.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/programs/interpretation.h"

namespace proveout {

namespace {

constexpr int kG54 = 1;

/// Looks for the work systems that cuts are made under; ends the program at the first one under G54.
class OffsetScout : public ToolpathBuilder {
 public:
  OffsetScout(Toolpath& path, Progress& progress) : ToolpathBuilder(path), path_(path), progress_(progress) {}

  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) override {
    ToolpathBuilder::motion(motion, arc, axis);
    if (motion.kind == MotionKind::kFeed || motion.kind == MotionKind::kThread) look();
    path_.motions.clear();
    path_.arcs.clear();
    path_.axes.clear();
  }
  void event(const PathEvent& /*event*/) override {}

  /// 0: none, or none that says where the workpiece lies.
  int first() const { return g54_ ? 0 : first_; }

 private:
  void look() {
    const DataInForce* data = dataOf(path_, static_cast<MotionId>(path_.motions.size() - 1));
    if (data == nullptr || data->work_system == 0) return;
    if (first_ == 0) first_ = data->work_system;
    if (data->work_system != kG54) return;
    g54_ = true;
    progress_.cancel();
  }

  Toolpath& path_;
  Progress& progress_;
  int first_ = 0;
  bool g54_ = false;
};

/// Whether another offset than G54 names another place.
bool givesOther(const ControlSettings& settings) {
  const auto other = [&](const Vec3& offset) { return offset != settings.work_offsets[0]; };
  for (std::size_t k = 1; k < settings.work_offsets.size(); ++k) {
    if (settings.work_given[k] && other(settings.work_offsets[k])) return true;
  }
  return std::any_of(settings.extended_offsets.begin(), settings.extended_offsets.end(),
                     [&](const auto& row) { return other(row.second); });
}

Vec3 offsetOf(const ControlSettings& settings, int system) {
  if (system < kFirstExtendedSystem) return settings.work_offsets[static_cast<std::size_t>(system - 1)];
  const auto row = settings.extended_offsets.find(system - kFirstExtendedSystem + 1);
  return row == settings.extended_offsets.end() ? Vec3(Vec3::Zero()) : row->second;
}

}  // namespace

void placeByFirstOffset(Job& job, const RecordingSource& source, const Box3& blank, Diagnostics& diagnostics,
                        Progress& progress) {
  ControlSettings& settings = job.settings;
  if (settings.placement.origin || !job.channels.empty() || !givesOther(settings)) return;
  const Result<ControlId> control = findControl(job.control);
  if (!control) return;
  Progress reading(&progress);
  Toolpath path;
  OffsetScout scout(path, reading);
  ControlHost host;
  host.person = job.person;
  interpretJob(job, *control, source, controlSettings(job, blank), scout, reading, host);
  const int first = scout.first();
  if (first == 0 || lacksWorkOffset(settings, first)) return;
  settings.placement.origin = offsetOf(settings, first) + settings.common_offset;
  Diagnostic note;
  note.severity = Severity::kNote;
  note.code = "placement";
  note.message = fmt::format(
      "nothing is cut under G54: the workpiece is taken to lie where {0} says, the first offset that the "
      "program cuts "
      "under; [placement] origin in the job says where it really lies",
      workSystemName(first));
  diagnostics.add(std::move(note));
}

}  // namespace proveout
