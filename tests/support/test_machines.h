// The machines of the manual's chapter 25, as its examples take them.
#pragma once

#include <initializer_list>
#include <string>

#include "core/machine/machine_model.h"

namespace proveout::test {

inline MachineAxis linearAxis(const std::string& name, int direction, int on,
                              AxisSide side = AxisSide::kTool) {
  MachineAxis axis;
  axis.name = name;
  axis.side = side;
  axis.on = on;
  axis.direction = Vec3::Unit(direction);
  return axis;
}

/// X, Y and Z on each other, the spindle on Z.
inline MachineModel plainMachine() {
  MachineModel model;
  for (int k = 0; k < 3; ++k)
    model.axes.push_back(linearAxis(std::string(1, static_cast<char>('X' + k)), k, k - 1));
  model.spindle.on = 2;
  return model;
}

/// A head behind the last axis of the tool.
inline void addHead(MachineModel& model, const std::string& name, const Vec3& direction, const Vec3& point) {
  MachineAxis axis;
  axis.name = name;
  axis.kind = AxisKind::kRotary;
  axis.on = model.spindle.on;
  axis.direction = direction;
  axis.point = point;
  model.spindle.on = static_cast<int>(model.axes.size());
  model.axes.push_back(axis);
}

/// A table on another one or the bed; it turns left-handed, as most do.
inline void addTable(MachineModel& model, const std::string& name, const Vec3& direction, const Vec3& point) {
  MachineAxis axis;
  axis.name = name;
  axis.kind = AxisKind::kRotary;
  axis.side = AxisSide::kPart;
  for (std::size_t k = 0; k < model.axes.size(); ++k) {
    if (model.axes[k].side == AxisSide::kPart) axis.on = static_cast<int>(k);
  }
  axis.direction = direction;
  axis.point = point;
  axis.left = true;
  model.axes.push_back(axis);
}

/// Head-head, C then B or A; the vectors I and J of the manual.
inline MachineModel headHead(char second, const Vec3& i, const Vec3& j = Vec3::Zero()) {
  MachineModel model = plainMachine();
  addHead(model, "C", Vec3::UnitZ(), i + j);
  addHead(model, std::string(1, second), second == 'A' ? Vec3::UnitX() : Vec3::UnitY(), i);
  return model;
}
/// TM-CB.
inline MachineModel machineCB() { return headHead('B', {0, 0, 150}); }
/// TM-CA.
inline MachineModel machineCA() { return headHead('A', Vec3::Zero()); }

/// TM-AC and TM-BC: a trunnion.
inline MachineModel trunnion(char first) {
  MachineModel model = plainMachine();
  addTable(model, std::string(1, first), first == 'A' ? Vec3::UnitX() : Vec3::UnitY(), {400, 300, -500});
  addTable(model, "C", Vec3::UnitZ(), {400, 300, -460});
  return model;
}

/// TM-HT.
inline MachineModel headTable() {
  MachineModel model = plainMachine();
  addHead(model, "B", Vec3::UnitY(), {0, 0, 150});
  addTable(model, "C", Vec3::UnitZ(), {400, 300, -500});
  return model;
}

}  // namespace proveout::test
