// Programs of the nct control on the machines of test_machines.h, and what their paths tell.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/machine/machine_chain.h"
#include "core/nc/registry/interpreter.h"
#include "core/path/posed_way.h"
#include "core/path/toolpath.h"
#include "tests/support/test_machines.h"

namespace proveout::test {

inline constexpr double kPrinted = 9e-5;  // half of the last printed digit in three coordinates

struct Outcome {
  Toolpath path;
  InterpretSummary summary;
  std::string error;
};

/// A machine with H1 = 100 and its zero, as the manual's examples take it.
inline ControlSettings settingsOf(const MachineModel& machine, const Vec3& zero) {
  ControlSettings settings;
  settings.machine = machine;
  int number = 4;
  for (std::size_t k = 3; k < machine.axes.size(); ++k) {
    AxisSettings axis;
    axis.name = machine.axes[k].name;
    axis.number = number++;
    axis.kind = machine.axes[k].kind;
    axis.carries = RotaryCarries::kNothing;
    axis.limit = machine.axes[k].travel;
    settings.axes.push_back(axis);
  }
  settings.work_offsets[0] = zero;
  settings.work_given[0] = true;
  settings.start = {0, 0, 0};
  settings.length_offsets[1] = {100.0, 0.0};
  settings.gauge_lengths[1] = 100.0;
  settings.tool = 1;
  return settings;
}

inline Outcome runOf(const std::string& text, const ControlSettings& settings) {
  Outcome out;
  ToolpathBuilder sink(out.path);
  out.summary = interpret(ControlId::kNct, MemoryProgramSource("main.nc", text + "\nM30\n"), settings, sink);
  for (const Diagnostic& d : out.path.diagnostics.all()) {
    if (d.severity == Severity::kError && out.error.empty()) out.error = d.code + ": " + d.message;
  }
  return out;
}

/// Where the tip is at the end of a line of the program (from 1), in the workpiece frame, and its axis.
inline ToolPose endOf(const Outcome& out, std::uint32_t line) {
  ToolPose pose{Vec3::Constant(1e9), Vec3::Zero()};
  for (const Motion& m : out.path.motions) {
    if (m.source.line != line) continue;
    pose.tip = m.to;
    pose.axis = m.axis >= 0 ? out.path.axes[static_cast<std::size_t>(m.axis)].to : Vec3(Vec3::UnitZ());
  }
  return pose;
}
inline double rotaryAt(const Outcome& out, std::uint32_t line, std::string_view name) {
  double value = 1e9;
  for (const Motion& m : out.path.motions) {
    if (m.source.line != line || m.axis < 0) continue;
    const AxisSweep& sweep = out.path.axes[static_cast<std::size_t>(m.axis)];
    for (int k = 0; k < sweep.rotary_count; ++k) {
      const RotaryPosition& r = sweep.rotary[static_cast<std::size_t>(k)];
      if (r.name.data() == name) value = r.to;
    }
  }
  return value;
}

inline void expectTip(const Outcome& out, std::uint32_t line, const Vec3& tip) {
  EXPECT_EQ(out.error, "");
  const Vec3 found = endOf(out, line).tip;
  EXPECT_LT((found - tip).norm(), kPrinted)
      << "line " << line << ": " << found.transpose() << " for " << tip.transpose();
}

inline const Vec3 kTableZero(400, 300, -420);

/// The only motion of a line of the program.
inline const Motion* motionOf(const Outcome& out, std::uint32_t line) {
  const Motion* found = nullptr;
  int count = 0;
  for (const Motion& m : out.path.motions) {
    if (m.source.line != line) continue;
    found = &m;
    ++count;
  }
  EXPECT_EQ(count, 1) << "motions of line " << line << ", " << out.error;
  return found;
}
inline ToolPose poseAt(const Outcome& out, std::uint32_t line, double share) {
  const Motion* m = motionOf(out, line);
  if (m == nullptr) return {};
  if (m->axis < 0) return {out.path.pointAt(*m, share), Vec3::UnitZ()};
  return posedWayOf(out.path, *m).at(share);
}
inline const AxisSweep* sweepOf(const Outcome& out, std::uint32_t line) {
  const Motion* m = motionOf(out, line);
  return m == nullptr || m->axis < 0 ? nullptr : &out.path.axes[static_cast<std::size_t>(m->axis)];
}
inline void expectPose(const ToolPose& pose, const Vec3& tip, const Vec3& axis, const char* what) {
  EXPECT_LT((pose.tip - tip).norm(), kPrinted) << what << ": " << pose.tip.transpose();
  EXPECT_LT((pose.axis - axis.normalized()).norm(), kPrinted) << what << ": " << pose.axis.transpose();
}
/// Where the axes are at the end of a line.
inline void expectAxes(const Outcome& out, std::uint32_t line, const Vec3& xyz, double first, double second) {
  const AxisSweep* sweep = sweepOf(out, line);
  ASSERT_NE(sweep, nullptr);
  ASSERT_NE(sweep->pose, nullptr);
  const AxisPoint& at = sweep->pose->axes_to;
  EXPECT_LT((at.xyz - xyz).norm(), kPrinted) << "line " << line << ": " << at.xyz.transpose();
  EXPECT_NEAR(at[3], first, 1e-9) << line;
  EXPECT_NEAR(at[4], second, 1e-9) << line;
}

/// Where the tip of a tool of 100 mm is with the machine there, workpiece frame.
inline ToolPose poseOf(const ControlSettings& settings, const Vec3& xyz, double first, double second) {
  AxisPoint machine(xyz);
  machine.more[0] = first;
  machine.more[1] = second;
  return MachineChain(*settings.machine, settings.work_offsets[0]).pose(machine, 100.0);
}

/// TM-CB, TM-AC, TM-HT.
inline ControlSettings machineOf(char which) {
  return which == 'H'   ? settingsOf(machineCB(), Vec3::Zero())
         : which == 'T' ? settingsOf(trunnion('A'), kTableZero)
                        : settingsOf(headTable(), kTableZero);
}

}  // namespace proveout::test
