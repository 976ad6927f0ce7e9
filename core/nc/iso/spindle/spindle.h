// Spindle words and functions of the nct control (manual chapter 11).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Power-on: the default spindle is the main one.
void resetSpindles(IsoContext& c);
/// Why the spindles of the settings cannot be; empty: they can.
std::string checkSpindles(const ControlSettings& settings, const AxisTable& axes);

/// S, spindle names and G92 S of the block in hand. False: reported.
bool planSpindle(IsoContext& c, BlockPlan& plan);
/// Carries out M3, M4, M5, M11 to M19 and the configured codes; `found` is the row of `m`. `handled`: it was
/// one of them. False: reported.
bool spindleFunction(IsoContext& c, const BlockPlan& plan, const MFunction& found, int m, bool& handled);
/// The main spindle turns by speed from here on: direction +1 M3, -1 M4, 0 M5. False: reported.
bool turnMain(IsoContext& c, int direction, double rpm);
/// The main spindle stops and its position loop closes: at angle 0 (M19), or where it came to stand. It stays
/// so until the program starts it. False: reported.
bool closeMainLoop(IsoContext& c, bool orient);
/// Of the main spindle's settings, 1/min per second; 0: at once.
double mainAcceleration(const IsoContext& c);
/// Number by which programs call the main spindle.
int mainNumber(const IsoContext& c);
/// The main spindle from here on; the direction in force becomes `direction`. False: an error was reported.
bool sendSpindle(IsoContext& c, int direction, double rpm);
/// The main spindle stops oriented. False: an error was reported.
bool sendOriented(IsoContext& c);
/// The main spindle stops and its position loop closes where it stands. False: an error was reported.
bool sendPositionLoop(IsoContext& c);
/// What S and spindle positions of the block do before its motion.
bool performSpindle(IsoContext& c, const BlockPlan& plan);

// spindle/surface_speed.cpp

/// G96 of the block in hand; speed at its start. False: reported.
bool planSurfaceSpeed(IsoContext& c, BlockPlan& plan);
/// Is the main spindle turning at constant surface speed?
bool surfaceSpeedRuns(const IsoContext& c, const BlockPlan& plan);
/// Main spindle where the axis of G96 is at `at` (program coordinates), 1/min.
double surfaceRpm(const IsoContext& c, const IsoState& state, const AxisPoint& at);
/// Speed with which the block's motion takes as many turns, 1/min; the end's becomes the state's.
double surfaceMeanRpm(IsoContext& c, const BlockPlan& plan);
/// The spindle behind a block: rapids end at the speed of their end point.
bool performSurfaceSpeed(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
