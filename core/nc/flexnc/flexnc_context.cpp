#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

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
      watch(summary, progress, settings.block_limit),
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
