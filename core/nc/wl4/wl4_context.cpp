#include "core/nc/wl4/wl4_context.h"

#include <fmt/core.h>

#include <vector>

namespace proveout::nc {

namespace {

/// What a loop may change: axes and variables.
std::vector<LoopBudget::Named> loopState(const Wl4Context& c) {
  std::vector<LoopBudget::Named> state;
  for (int k = 1; k <= Wl4Variables::kGlobals; ++k)
    state.push_back({fmt::format("#{}", k), c.variables.read(k).value_or(0.0)});
  for (int k = 0; k < c.setup.axes.count(); ++k) state.push_back({c.setup.axes.at(k).name, c.machine[k]});
  return state;
}

}  // namespace

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
      watch(
          summary, progress, setup.settings.block_limit, [this] { return loopState(*this); },
          [this](const char* what, const std::string& message) {
            report.fail(fmt::format("wl4-{}", what), message);
          }),
      corner_stage(pipe, report),
      comp_stage(pipe, report),
      frame_stage(chain),
      emit_stage(emitter, setup.settings.tool_change_s) {
  evaluator.setOrigins(recorder);
  evaluator.setLoops(watch.budget());
  pipe.link(frame_stage);
  pipe.link(emit_stage);
}

}  // namespace proveout::nc
