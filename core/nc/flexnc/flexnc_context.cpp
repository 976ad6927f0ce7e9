#include "core/nc/flexnc/flexnc_context.h"

#include <fmt/core.h>

namespace proveout::nc {

namespace {

/// What a loop may change: axes and the variables that are not 0.
std::vector<LoopBudget::Named> loopState(const FlexContext& c) {
  std::vector<LoopBudget::Named> state;
  for (int k = 0; k <= FlexVariables::kLast; ++k) {
    if (c.variables.value(k) != 0.0) state.push_back({fmt::format("P{}", k), c.variables.value(k)});
  }
  for (int k = 0; k < c.axes.count(); ++k) state.push_back({c.axes.at(k).name, c.machine[k]});
  return state;
}

}  // namespace

FlexContext::FlexContext(const ProgramSource& source_in, const ControlSettings& settings_in,
                         MotionSink& sink_in, Progress* progress)
    : source(source_in),
      settings(settings_in),
      sink(sink_in),
      axes(settings),
      emitter(settings, axes, sink, summary),
      recorder(sink),
      evaluator(variables, recorder),
      reader(variables, evaluator, recorder),
      report(emitter, program, levels, recorder),
      watch(
          summary, progress, settings.block_limit, [this] { return loopState(*this); },
          [this](const char* what, const std::string& message) {
            report.fail(fmt::format("fnc-{}", what), message);
          }),
      comp_stage(pipe, report),
      frame_stage(chain),
      rapid_stage(emitter, settings),
      emit_stage(emitter, settings.tool_change_s) {
  pipe.link(frame_stage);
  pipe.link(rapid_stage);
  pipe.link(emit_stage);
}

Vec2 FlexContext::origin() const {
  const Vec3 zero = settings.work_offsets[0] + settings.common_offset;
  return {zero.x(), zero.z()};
}

}  // namespace proveout::nc
