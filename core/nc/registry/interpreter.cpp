#include "core/nc/registry/interpreter.h"

#include "core/nc/registry/controls.h"

namespace proveout {
namespace {

InterpretSummary refused(MotionSink& sink, const char* why) {
  InterpretSummary summary;
  summary.end = ProgramEnd::kAlarm;
  summary.errors = 1;
  sink.diagnostic({Severity::kError, "control", why, {}, {}, {}});
  return summary;
}

}  // namespace

InterpretSummary interpret(ControlId control, const ProgramSource& source, const ControlSettings& settings,
                           MotionSink& sink, Progress* progress, const ControlHost& host) {
  if (const auto run = nc::rowOf(control).run) return run(source, settings, sink, progress, host);
  return refused(sink, nc::kNotBuilt);
}

InterpretSummary interpretChannels(ControlId control, const std::vector<ChannelProgram>& channels,
                                   MotionSink& sink, Progress* progress, const ControlHost& host) {
  if (const auto run = nc::rowOf(control).run_channels) return run(channels, sink, progress, host);
  return refused(sink, "this control has no channels");
}

}  // namespace proveout
