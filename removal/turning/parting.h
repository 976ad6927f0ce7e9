// Where on its way a tool cuts pieces free, and which of them fall there.
#pragma once

#include <vector>

#include "removal/turning/turning_tool.h"

namespace proveout {

/// A tool on its way, both on the side of the axis on which it is looked at. The tool must outlive it.
struct ToolWay {
  const TurningTool* tool = nullptr;
  PlaneWay way;

  /// Between two parts of it, 0..1.
  ToolWay between(double from, double to) const { return {tool, way.between(from, to)}; }
};

/// Whether a way goes on as another one ends: from the same place in the same direction, but for rounding of
/// the points that a program gives.
bool goesOn(const PlaneWay& before, const PlaneWay& behind);

/// Of an area that may be in several pieces: what the chuck holds and what has come free from it.
struct Freed {
  std::vector<SectionBody> held;   ///< the lowest in Z first; the others are chips that the stroke goes over
  std::vector<SectionBody> falls;  ///< what the stroke leaves something of
};
/// `stroke`: the way that the tool goes on without a turn. What it takes wholly of a piece that has come free
/// counts as cut.
Freed freedIn(const SectionArea& area, const std::vector<ToolWay>& stroke);

/// The part of a way, 0..1, at which the first piece that falls comes free, to about 0.0000001 mm of way.
/// Requires one at its end. `stroke`: behind this way.
double freedAt(const SectionArea& before, const ToolWay& on, const std::vector<ToolWay>& stroke);

/// What of a piece the stroke that cut it off does not go over: what later motions may meet.
SectionArea besideStroke(const SectionBody& piece, const std::vector<ToolWay>& stroke);

/// Takes off a piece that a blade with round corners has just cut off what these leave of its face until the
/// blade has gone on by their radius. `stroke`: what the tool goes on. Returns the volume, mm3.
double trimCorners(SectionBody& piece, const std::vector<ToolWay>& stroke, MotionId motion);

/// Whether a piece that such a motion cut off is what a programmed parting leaves: a blade fed towards the
/// axis, and a piece larger than the blade is wide.
bool isPartedBy(const ToolWay& on, const SectionBody& piece);

}  // namespace proveout
