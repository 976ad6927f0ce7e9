// Free outlines of tools: checked, and split into convex solids of revolution.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/tool/profile.h"

namespace proveout {

/// A point of an outline, mm, tip at z = 0.
struct OutlinePoint {
  double r = 0.0, z = 0.0;
  /// Of the arc from the point before: 0 is a straight line, above 0 an arc that bulges outwards, below 0 a
  /// hollow arc. Arcs are at most a quarter turn below and a quarter turn above the height of their centre.
  double arc_radius = 0.0;
};

/// A piece of the outline from a to b; heights never fall along it.
struct OutlineEdge {
  bool arc = false;
  double ar, az, br, bz;
  double cr, cz;  ///< centre of an arc that bulges outwards
};

/// Chord height by which a hollow arc is simplified, mm: a hollow outline is no finite union of convex
/// solids. The simplified tool is the thicker one.
inline constexpr double kHollowArcToleranceMm = 1e-3;
/// Convex parts of one tool; every part is moved through the stock on its own.
inline constexpr int kMaxToolParts = 500;

/// Edges of an outline that starts at z = 0 (anywhere between the axis and the side: the bottom is closed
/// flat) and whose heights never fall. The error says which point is wrong and why.
Result<std::vector<OutlineEdge>> outlineEdges(const std::vector<OutlinePoint>& points);

/// Twice the largest radius of the edges, mm.
double outlineDiameter(const std::vector<OutlineEdge>& edges);

/// The solid of revolution of an outline as a union of convex ones, lowest first. Neighbours overlap, so that
/// no gap opens between them by rounding, and their element ids differ.
std::vector<ConvexProfile> convexParts(const std::vector<OutlineEdge>& edges);

}  // namespace proveout
