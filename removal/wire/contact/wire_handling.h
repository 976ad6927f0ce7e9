// What the operator or the machine does with a wire between its cuts: threading, stops, pieces that fall.
#pragma once

#include <vector>

#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/grid/stock.h"
#include "removal/wire/contact/wire_contacts.h"

namespace proveout {

/// Contacts of rapids before which the operator may have cut the wire become kByHand.
void tellByHand(const Toolpath& path, std::vector<Contact>& contacts);

/// Where the wire is threaded: at the start of the path, at events that thread it, and where a rapid ends
/// that met material and before which the operator had to cut it (`contacts`, see tellByHand). `tools` must
/// have the wires of the path.
std::vector<ThreadingPlace> threadingPlaces(const Toolpath& path, const std::vector<Tool>& tools,
                                            const WireWork& work, const std::vector<Contact>& contacts,
                                            double z);

/// The pieces that fell, with the motions that go through where they may lie: until a stop, or until the wire
/// is cut.
std::vector<FallenPiece> fallenPieces(const Toolpath& path, const WireWork& work, double height_mm,
                                      const std::vector<FreePiece>& pieces);

}  // namespace proveout
