// Flat pieces of surface in a half-plane, where two half sections at one angle differ.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "removal/turning/threads/thread_slices.h"

namespace proveout::thread_detail {

/// Points of sections nearer to each other than this are one, mm: rounding of the sections.
inline constexpr double kOnePointMm = 5e-6;

/// Gives the edges of `a` a corner wherever a corner of `b` lies on them. Whether there was any.
bool splitEdges(Slice& a, const Slice& b);

/// Triangles of what only one of two sections at one angle holds; `b` is the one towards larger angles.
/// Corners at one place have one vertex number in both. Oriented with the part's surface outwards. Nothing
/// where their borders cross.
std::optional<std::vector<std::array<std::uint32_t, 3>>> facesBetween(const Slice& a, const Slice& b);

}  // namespace proveout::thread_detail
