// The frame of a program tape (ISO 6983): text of the leader, %, a name, blocks, %.
#pragma once

#include <cstddef>
#include <map>

#include "core/nc/iso/model/call_stack.h"

namespace proveout::nc {

struct IsoContext;

/// What stands in front of the blocks of the texts of a run.
class TapeFrames {
 public:
  /// Sets a program that begins to the first line behind its leader; tells what it skips.
  void skipLeader(IsoContext& c, CallFrame& frame);
  /// Is there nothing but %, comments and empty lines above the line in hand?
  bool onlyHeaderAbove(const CallStack& calls);
  /// False: the block in hand has an O word elsewhere, reported.
  bool checkHeader(IsoContext& c);

 private:
  std::size_t leaderOf(const SourceText& text);
  std::map<const SourceText*, std::size_t> leaders_;  ///< lines in front of the % of a text
};

/// Tells of a name that stands behind % in the block in hand.
void noteTapeName(IsoContext& c);

}  // namespace proveout::nc
