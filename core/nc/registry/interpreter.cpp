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

/// Nothing, or why this control is not the one of a machine with these settings.
const char* whyNot(const nc::ControlRow& row, const ControlSettings& settings) {
  if (row.axis_events || (settings.events.empty() && settings.gantry.empty() && settings.tandem.empty()))
    return nullptr;
  return "this control ties no axes together: [[machine.event]], gantry and tandem are for the nct control, "
         "leave them out";
}

}  // namespace

InterpretSummary interpret(ControlId control, const ProgramSource& source, const ControlSettings& settings,
                           MotionSink& sink, Progress* progress, const ControlHost& host) {
  if (const char* why = whyNot(nc::rowOf(control), settings)) return refused(sink, why);
  if (const auto run = nc::rowOf(control).run) return run(source, settings, sink, progress, host);
  return refused(sink, nc::kNotBuilt);
}

InterpretSummary interpretChannels(ControlId control, const std::vector<ChannelProgram>& channels,
                                   MotionSink& sink, Progress* progress, const ControlHost& host) {
  for (const ChannelProgram& channel : channels) {
    if (const char* why = whyNot(nc::rowOf(control), channel.settings)) return refused(sink, why);
  }
  if (const auto run = nc::rowOf(control).run_channels) return run(channels, sink, progress, host);
  return refused(sink, "this control has no channels");
}

}  // namespace proveout
