#include "core/nc/iso/context/context.h"

#include <fmt/core.h>

#include "core/base/assert.h"
#include "core/nc/kinematics/machine_of.h"

namespace proveout::nc {

namespace {

constexpr std::uint64_t kFreeMotions = 100;  ///< of a block; curves in chords and cycles make more

/// What a loop may change: axes and variables.
std::vector<LoopBudget::Named> loopState(const IsoContext& c) {
  std::vector<LoopBudget::Named> state;
  const auto add = [&](int number) {
    Value value;
    if (c.variables.peek(number, value) && !value.vacant)
      state.push_back({fmt::format("#{}", number), value.number});
  };
  for (int k = 1; k <= kLocalCount; ++k) add(k);
  for (int k = VariableStore::kFirstGlobal; k <= VariableStore::kLastGlobal; ++k) add(k);
  for (int k = 0; k < c.axes.count(); ++k) state.push_back({c.axes.at(k).name, c.position[k]});
  return state;
}

}  // namespace

IsoStages::IsoStages(IsoContext& c)
    : contour_alarms(c.alarms, c),
      crossing(c.pipe, contour_alarms),
      transform(c.chain, c.map, c.alarms, c.dialect.rules.scales_centres),
      corner(c.pipe, contour_alarms),
      comp(c.pipe, c.parameters, c.alarms, c),
      virtual_plane(c.pipe, c.chain, c.registers.frames, c.axes),
      frame(c.chain),
      axes(c.registers.frames.axes, c.emitter, c.axes, c.settings),
      rapid(c.emitter, c.settings, c.axes),
      dogleg(c.emitter, c.settings, c.axes),
      zone({c.settings, c.axes, c.parameters, c.registers.program_zone, c.calls, c.emitter, c.pipe, c.alarms,
            c}),
      emit(c.emitter, c.settings.tool_change_s) {}

IsoContext::IsoContext(const IsoDialect& control, const ProgramSource& source,
                       const ControlSettings& control_settings, MotionSink& sink, Progress* progress,
                       const ControlHost& control_host, InterpretSummary& run_summary)
    : dialect(control),
      settings(control_settings),
      summary(run_summary),
      codes(control.codes),
      axes(control_settings),
      five_axes(fiveAxisModelOf(machineOf(control_settings, axes, offsetZero(control_settings)))),
      emitter(control_settings, axes, sink, run_summary),
      parameters(control.parameters),
      programs(source, control_settings.encoding, control.layout, sink),
      environment(axes, parameters, *this),
      macro(variables, environment, control.alarms, control.formulas),
      origins(sink),
      systems(control.letters),
      m_index(codes, control_settings),
      alarms(control.alarms, calls, programs, block, variables, emitter),
      watch(
          run_summary, progress, control_settings.block_limit, [this] { return loopState(*this); },
          [this](const char* what, const std::string& message) { alarms.fail(what, message); }, kFreeMotions),
      host(control_host),
      clock(emitter.time(), stages.rapid),
      stages(*this) {
  macro.setOrigins(origins);
  pipe.link(stages.transform);
  pipe.link(stages.frame);
  pipe.link(stages.emit);
  registers.offsets = OffsetTables(settings);
  WorkFrames& frames = registers.frames;
  frames.more_axes = axes.moreCount();
  frames.common.offset = settings.common_offset;
  for (std::size_t i = 0; i < frames.basic.size(); ++i) {
    frames.basic[i] = {settings.work_offsets[i], settings.work_rotations_deg[i]};
  }
  for (const auto& [p, offset] : settings.extended_offsets) frames.extended[p].offset = offset;
}

void IsoContext::shareWith(IsoContext& owner) {
  const auto count = [&](auto parameter) { return static_cast<int>(owner.parameters[parameter]); };
  variables.share(owner.variables, count(MacroParam::kCommonLow), count(MacroParam::kCommonKept));
  registers.offsets.share(owner.registers.offsets, count(DataParam::kCommonToolOffsets));
  registers.shared_tools = owner.registers.shared_tools;
  origins.shareWords(owner.origins, channel());
}

CoordinateChain IsoContext::chainOf(const IsoState& s, const AxisPoint& at) const {
  const WorkFrames& frames = registers.frames;
  const ProgramMap transforms = programMap(s.transforms, axes);
  if (!s.five.any()) return frames.chain(transforms, s.work_system, s.length);
  const WorkSystem work = frames.system(s.work_system);
  const RotaryAngles angles = five_axes.at(at);
  SpatialFrames spatial;
  spatial.tilt = s.five.tilt;
  for (std::size_t k = 0; k < spatial.rotary_offset.more.size(); ++k)
    spatial.rotary_offset.more[k] = frames.common.offset.more[k] + work.offset.more[k];
  const Vec3 zero = frames.common.offset.xyz + work.offset.xyz;
  spatial.zero.offset = zero;
  if (s.five.dynamic_zero > 0) {
    const AxisPoint& row = registers.dynamic_zeros[static_cast<std::size_t>(s.five.dynamic_zero - 1)];
    const RotaryAngles measured = five_axes.at(row);
    if (s.five.turnsWithTable()) {
      spatial.zero =
          five_axes.workpieceOnTable(angles, five_axes.dynamicZero(measured, row.xyz, measured), measured);
    } else {
      spatial.zero.offset = five_axes.dynamicZero(angles, row.xyz, measured);
    }
    spatial.rotary_offset.more = row.more;
  } else if (s.five.turnsWithTable()) {
    spatial.zero = five_axes.workpieceOnTable(angles, zero, five_axes.at(spatial.rotary_offset));
  }
  spatial.length = s.length.xyz;
  if (s.five.along_tool) {
    const bool minus = s.active[kGroupLengthComp] == gcode::kLengthMinus;
    spatial.length = five_axes.lengthVector(angles, minus ? -s.h_value : s.h_value);
  }
  return frames.chain(transforms, s.work_system, s.length, &spatial);
}

void IsoContext::settle(const AxisPoint& at) {
  machine = stages.virtual_plane.linked() ? stages.virtual_plane.adopt(at) : at;
  if (state.five.follows()) chain = chainOf(state);
  position = chain.programOf(machine);
}

bool IsoContext::flushPipe() {
  if (!pipe.flush(FlushReason::kBuffer)) return false;
  rebasePipe();
  return true;
}

void IsoContext::recover() {
  pipe.clear();
  settle(standing());
}

void IsoContext::enteredCall() {
  const CallFrame& frame = calls.top();
  const bool room = !opensLocals(frame.kind) || variables.enter(frame.args);
  PROVEOUT_ASSERT(room);  // as many levels as calls may be open
  origins.openCall();
  enterProgram();
  last_called = frame.text;
}

void IsoContext::enterProgram() {
  const SourceRef& at = calls.here();
  origins.enter(at.file, at.depth, !calls.top().text->builtIn());
  origins.begin(at.line, at.block);
  word_patterns.last = nullptr;
}

void IsoContext::closeCall() {
  const CallKind kind = calls.top().kind;
  calls.pop();
  leftCall(kind);
}

void IsoContext::leftCall(CallKind kind) {
  PROVEOUT_ASSERT(!calls.empty());
  if (opensLocals(kind)) variables.leave();
  origins.closeCall();
  enterProgram();
}

}  // namespace proveout::nc
