// Programs of the nct control on the machines of test_machines.h, and what their paths tell.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/machine/machine_chain.h"
#include "core/nc/registry/interpreter.h"
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

}  // namespace proveout::test
