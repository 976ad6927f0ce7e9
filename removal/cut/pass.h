// What the motions of a path sweep through, body by body, in the order of the program.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/path/toolpath.h"
#include "removal/sweep/motion_bodies.h"

namespace proveout {

/// Penetration that counts as contact, mm: below any gauge on a shop floor.
inline constexpr double kContactToleranceMm = 1e-3;

enum class ToolPart : std::uint8_t { kCutter, kShank, kHolder };

/// One convex part of a tool on one motion, or a piece of what it sweeps there.
struct Pass {
  SweptBody body;
  MotionId motion = kNoMotion;
  /// Of a helix about z: how far on in the table the pass over the same place one turn lower is; 0: there is
  /// none, or it does not cover all that this one does below its own top.
  std::int32_t lower = 0;
  /// Of an envelope, which holds all that comes near to a watched part: how far on in the table a pass of
  /// that part is; 0: this is a part of the tool itself.
  std::int32_t around = 0;
  ToolPart part = ToolPart::kCutter;
  bool watched = false;  ///< contact with stock is a finding

  bool isEnvelope() const { return around != 0; }
  bool cuts() const { return part == ToolPart::kCutter && !isEnvelope(); }
};

/// The passes of a run and what they share.
struct PassTable {
  std::vector<Pass> passes;          ///< in the order of their motions
  std::vector<std::uint32_t> first;  ///< for each motion, and the end: number of its first pass
  BodyStore store;                   ///< what the bodies know by place

  std::span<const Pass> of(MotionId motion) const {
    if (std::size_t{motion} + 1 >= first.size()) return {};
    return {passes.data() + first[motion], passes.data() + first[motion + 1]};
  }
  /// Whether a pass is a piece of the same volume as the one before it.
  bool goesOn(std::uint32_t number) const {
    return number > 0 && passes[number].body.isPieceWith(passes[number - 1].body);
  }
};

/// A pass that reaches into a block, and the heights below and above which it does not (bounds), mm.
struct Reach {
  std::uint32_t pass;
  float low, high;
};
using ReachList = std::vector<Reach>;

/// Fills `out` with one entry for all pieces that follow each other in `list` and are asked as one
/// (SweptBody::isAskedWhole), and one for every other cutting pass.
void unitePieces(const PassTable& table, std::span<const Reach> list, ReachList& out);

}  // namespace proveout
