// Aids for contours (manual chapter 17): ,A ,C ,R and over-determined blocks.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// Is one of ,A ,C ,R in the block?
inline bool hasContourWords(const Block& block) { return !(block.present & AddressSet("acr")).empty(); }

/// ,A of a G0, G1 or drilling block with one coordinate of the plane: the other one. False: an error was
/// reported.
bool planDirection(IsoContext& c, BlockPlan& plan);
/// ,A ,C ,R and Q of a G1 block, behind its axis words. False: an error was reported.
bool planLineContour(IsoContext& c, BlockPlan& plan);
/// ,C and ,R of an arc. False: an error was reported.
bool planJoin(IsoContext& c, BlockPlan& plan);
/// Does the circular block have an end, a centre and a radius in cutter compensation?
bool overdeterminedArc(const IsoContext& c, const BlockPlan& plan);
/// Such a block. False: an error was reported.
bool planOverdeterminedArc(IsoContext& c, BlockPlan& plan);
/// Reports Q where it has no meaning. False: it was there.
bool refuseChoice(IsoContext& c, const BlockPlan& plan);

}  // namespace proveout::nc
