#include "core/nc/wl4/wl4_context.h"

namespace proveout::nc {

Wl4Context::Wl4Context(bool lathe, const ProgramSource& source, const ControlSettings& settings,
                       MotionSink& sink, Progress* progress, const ControlHost& host)
    : setup(lathe, settings, host),
      emitter(setup.settings, setup.axes, sink, summary),
      programs(source, setup.settings.encoding, sink),
      recorder(sink),
      system(state, recorder),
      variables(system),
      evaluator(variables),
      reader(evaluator),
      origins(recorder, setup, levels, block, state, variables),
      report(emitter, programs, levels, block, recorder),
      watch(report, summary, levels, progress, setup.settings.block_limit),
      corner_stage(pipe, report),
      comp_stage(pipe, report),
      frame_stage(chain),
      emit_stage(emitter, setup.settings.tool_change_s) {
  evaluator.setOrigins(recorder);
  pipe.link(frame_stage);
  pipe.link(emit_stage);
}

}  // namespace proveout::nc
