// The end of a program: what M2 and M30 set back.
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {

void endStateOfLinuxCnc(IsoContext& c, const IsoState& fresh) {
  IsoState& s = c.state;
  LinuxCncChannel& own = linuxCncChannel(c);
  s.active[kGroupMotion] = gcode::kLine;
  s.active[kGroupWorkSystem] = gcode::kWorkSystem1;
  s.work_system = fresh.work_system;
  s.active[kGroupPlane] = gcode::kPlaneXY;
  s.takeMainPlane();
  s.active[kGroupDistance] = gcode::kAbsolute;
  s.active[kGroupFeedMode] = gcode::kFeedPerMinute;
  s.active[kGroupRadiusComp] = gcode::kCompOff;
  s.d_tip = 0;
  s.spindle_direction = 0;
  s.feed = 0.0;
  own.modal = LinuxCncModal{};
  if (own.comp.linked()) own.comp.clear();
  static_cast<LinuxCncLanguage*>(c.language)->programEnds();
}

}  // namespace proveout::nc
