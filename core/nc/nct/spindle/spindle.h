// Spindle words and functions of the nct control (manual chapter 11).
#pragma once

#include "core/nc/nct/context/context.h"

namespace proveout::nc {

/// Power-on: the default spindle is the main one.
void resetSpindles(NctContext& c);
/// Why the spindles of the settings cannot be; empty: they can.
std::string checkSpindles(const ControlSettings& settings, const AxisTable& axes);

/// S, spindle names and G92 S of the block in hand. False: reported.
bool planSpindle(NctContext& c, BlockPlan& plan);
/// Carries out M3, M4, M5, M11 to M19 and the configured codes; `found` is the row of `m`. `handled`: it was
/// one of them. False: reported.
bool spindleFunction(NctContext& c, const BlockPlan& plan, const MFunction& found, int m, bool& handled);
/// The main spindle turns by speed from here on: direction +1 M3, -1 M4, 0 M5. False: reported.
bool turnMain(NctContext& c, int direction, double rpm);
/// The main spindle stops and its position loop closes: at angle 0 (M19), or where it came to stand. It stays
/// so until the program starts it. False: reported.
bool closeMainLoop(NctContext& c, bool orient);
/// Of the main spindle's settings, 1/min per second; 0: at once.
double mainAcceleration(const NctContext& c);
/// Number by which programs call the main spindle.
int mainNumber(const NctContext& c);
/// The main spindle from here on; the direction in force becomes `direction`. False: an error was reported.
bool sendSpindle(NctContext& c, int direction, double rpm);
/// The main spindle stops oriented. False: an error was reported.
bool sendOriented(NctContext& c);
/// The main spindle stops and its position loop closes where it stands. False: an error was reported.
bool sendPositionLoop(NctContext& c);
/// What S and spindle positions of the block do before its motion.
bool performSpindle(NctContext& c, const BlockPlan& plan);

// spindle/surface_speed.cpp

/// G96 of the block in hand; speed at its start. False: reported.
bool planSurfaceSpeed(NctContext& c, BlockPlan& plan);
/// Is the main spindle turning at constant surface speed?
bool surfaceSpeedRuns(const NctContext& c, const BlockPlan& plan);
/// Main spindle where the axis of G96 is at `at` (program coordinates), 1/min.
double surfaceRpm(const NctContext& c, const NctState& state, const AxisPoint& at);
/// Speed with which the block's motion takes as many turns, 1/min; the end's becomes the state's.
double surfaceMeanRpm(NctContext& c, const BlockPlan& plan);
/// The spindle behind a block: rapids end at the speed of their end point.
bool performSurfaceSpeed(NctContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
