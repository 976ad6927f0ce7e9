// What GRBL, Mach3 and others that read LinuxCNC's language take and what they do in another way.
#pragma once

#include <string_view>

#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/model/flavour.h"

namespace proveout::nc {

/// As the settings of the run say.
LinuxCncFlavour givenFlavour(const IsoContext& c);
/// Keeps the flavour at hand, as every block asks for it.
void beginLinuxCnc(IsoContext& c);
inline LinuxCncFlavour linuxCncFlavour(const IsoContext& c) {
  const auto& kept = linuxCncChannel(c).flavour;
  return kept ? *kept : givenFlavour(c);
}
/// GRBL and those that follow it: errors have numbers, few codes.
inline bool isGrbl(const IsoContext& c) {
  const LinuxCncFlavour flavour = linuxCncFlavour(c);
  return flavour == LinuxCncFlavour::kGrbl || flavour == LinuxCncFlavour::kSmoothie ||
         flavour == LinuxCncFlavour::kGrblHal;
}
/// GRBL 1.1 itself and Smoothie: no parameters, no O-words, no cycles.
inline bool isPlainGrbl(const IsoContext& c) {
  return isGrbl(c) && linuxCncFlavour(c) != LinuxCncFlavour::kGrblHal;
}

/// Whether the flavour has the G or M code. False: reported.
bool flavourTakesG(IsoContext& c, const Word& w, int code10);
bool flavourTakesM(IsoContext& c, const Word& w);
/// The words of a line that only a flavour refuses. False: reported.
bool flavourTakesWords(IsoContext& c, const BlockPlan& plan);
/// Number of GRBL's error for a name of ours; 0: none.
int grblError(std::string_view name);
/// Radii of an arc in GRBL: error 33. False: reported.
bool grblRadii(IsoContext& c, double r1, double r2);

/// A line of Mach3: G70 and G71 are G20 and G21, and G80 may stand beside a motion, which it leaves alone.
void takeMach3Codes(Block& block);
/// P of G41 and G42 is the radius. False: reported.
bool planMach3Radius(IsoContext& c, BlockPlan& plan);

// Plan functions of Mach3.
/// G12 G13: a circle about the present place.
bool planMach3Circle(IsoContext& c, BlockPlan& plan);
/// G68 A B R, G69, G50, G51 X Y Z: parts of the modal state. False: reported.
bool planMach3Transforms(IsoContext& c, BlockPlan& plan);
/// G54 P n, G59 P n. False: reported.
bool planMach3Frame(IsoContext& c, BlockPlan& plan);
/// G16: X is the radius, Y the angle (of the plane's axes). False: reported.
bool mach3Polar(IsoContext& c, BlockPlan& plan, AxisPoint& target);

}  // namespace proveout::nc
