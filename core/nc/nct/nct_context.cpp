#include "core/nc/nct/nct_context.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/nc/nct/nct_spindle.h"
#include "core/nc/nct/nct_tools.h"
#include "core/nc/nct/nct_words.h"
#include "core/nc/nct/system_variables/system_variables.h"

namespace proveout::nc {

NctContext::NctContext(const ProgramSource& source, const ControlSettings& control_settings, MotionSink& sink,
                       Progress* progress, const ControlHost& control_host, InterpretSummary& run_summary)
    : settings(control_settings),
      summary(run_summary),
      codes(nctCodes()),
      axes(control_settings),
      emitter(control_settings, axes, sink, run_summary),
      programs(source, control_settings.encoding, sink),
      environment(axes, parameters),
      macro(variables, environment),
      alarms(calls, programs, block, variables, emitter),
      work(control_settings, progress, calls, alarms, run_summary),
      host(control_host),
      clock(emitter.time()),
      contour_alarms(*this),
      crossing_stage(pipe, contour_alarms),
      transform_stage(*this),
      corner_stage(pipe, contour_alarms),
      comp_stage(*this),
      virtual_stage(*this),
      frame_stage(chain),
      emit_stage(emitter, control_settings.tool_change_s) {
  pipe.link(transform_stage);
  pipe.link(frame_stage);
  pipe.link(emit_stage);
  tool_bank = std::make_unique<ToolBank>(*this);
  variables.addBank(8400, 8414, *tool_bank);
  variables.addBank(8431, 8450, *tool_bank);
  registers.offsets = OffsetTables(settings);
  WorkFrames& frames = registers.frames;
  frames.more_axes = axes.moreCount();
  frames.common.offset = settings.common_offset;
  for (std::size_t i = 0; i < frames.basic.size(); ++i) {
    frames.basic[i] = {settings.work_offsets[i], settings.work_rotations_deg[i]};
  }
  for (const auto& [p, offset] : settings.extended_offsets) frames.extended[p].offset = offset;
  system_variables = std::make_unique<SystemVariables>(*this);
}

NctContext::~NctContext() = default;

void NctContext::reset() {
  modals.clear();
  interrupt = InterruptMacro();
  const int first = static_cast<int>(parameters[MacroParam::kProtectFirst]);
  const int last = static_cast<int>(parameters[MacroParam::kProtectLast]);
  variables.protect(first == 0 ? 1 : first, first == 0 ? 0 : last);
  NctState s;
  s.active.fill(0);
  const auto flag = [&](MotionParam p) { return parameters.flag(p); };
  s.active[kGroupMotion] = flag(MotionParam::kDefaultG1) ? 10 : 0;
  s.active[kGroupPlane] = flag(MotionParam::kDefaultG18) ? 180 : flag(MotionParam::kDefaultG19) ? 190 : 170;
  s.active[kGroupDistance] = flag(MotionParam::kDefaultG91) ? 910 : 900;
  s.active[kGroupZones] = 230;
  s.active[kGroupFeedMode] = flag(MotionParam::kDefaultG95) ? 950 : 940;
  s.active[kGroupUnits] = settings.units == LengthUnit::kInch ? 200 : 210;
  s.active[kGroupRadiusComp] = 400;
  s.active[kGroupLengthComp] = flag(MotionParam::kDefaultG43)   ? 430
                               : flag(MotionParam::kDefaultG44) ? 440
                                                                : 490;
  s.active[kGroupCycle] = 800;
  s.active[kGroupReturn] = 980;
  s.active[kGroupScaling] = 500;
  s.active[kGroupMacro] = 670;
  s.active[kGroupSurfaceSpeed] = 970;
  s.active[kGroupWorkSystem] = 540;
  s.active[kGroupCutting] = 640;
  s.active[kGroupRotation] = 690;
  s.active[kGroupPolarData] = 150;
  s.active[kGroupTilt] = 691;
  s.active[kGroupPolarInterpolation] = 131;
  s.active[kGroupMirror] = 501;
  s.active[kGroupGear] = 808;
  s.feed = parameters[s.perTurn() ? MotionParam::kDefaultFeedPerTurn : MotionParam::kDefaultFeedPerMinute];
  s.surface_speed = parameters[SpindleParam::kSurfaceSpeed];
  s.surface_axis = std::max(0, axes.byNumber(static_cast<int>(parameters[SpindleParam::kSurfaceAxis])));
  const WorkPlane plane{PlaneFrame(s.plane())};
  s.axes.plane_u = static_cast<std::int8_t>(plane.u);
  s.axes.plane_v = static_cast<std::int8_t>(plane.v);
  s.axes.plane_w = static_cast<std::int8_t>(plane.w);
  s.axes.diameter = diameterAxes(*this);
  state = s;
  resetSpindles(*this);
  map = ProgramMap();
  chain = chainOf(state);
  machine = emitter.machine();
  position = chain.programOf(machine);
}

bool NctContext::openCall(const CallFrame& frame) {
  if (calls.depth() > kMaxNesting || (opensLocals(frame.kind) && !variables.enter(frame.args))) {
    return fail("nct-nesting", fmt::format("subprogram calls are nested deeper than {}", kMaxNesting));
  }
  calls.push(frame);
  last_called = frame.text;
  return true;
}

void NctContext::closeCall() {
  if (opensLocals(calls.top().kind)) variables.leave();
  calls.pop();
}

namespace {

/// How often cancellation is looked at and progress told, in blocks.
constexpr std::uint64_t kBlocksPerCheck = 1024;

}  // namespace

bool WorkGuard::over() {
  if (work_++ % kBlocksPerCheck == 0 && progress_ != nullptr) {
    const CallFrame& main = calls_.main();
    progress_->report("interpreting",
                      static_cast<double>(main.line) / static_cast<double>(main.text->lines().size()));
    if (progress_->cancelled()) {
      summary_.end = ProgramEnd::kCancelled;
      return true;
    }
  }
  if (work_ <= settings_.block_limit) return false;
  alarms_.fail("nct-block-limit",
               fmt::format("{} blocks executed without an end: endless loop? (the limit is a setting)",
                           settings_.block_limit));
  summary_.end = ProgramEnd::kBlockLimit;
  return true;
}

}  // namespace proveout::nc
