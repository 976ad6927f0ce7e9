// Offsets and work frames that programs have set stay for the next program of the job (section 1).
//
// The person at the machine enters what the job gives anew for each setup: a cell of the offset tables stays
// where the next setup gives it the value that this one has given it, a work frame where no setup gives it
// one. G54 and the external shift are not kept: where nothing gives them, they are the workpiece's own zero.
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

class KeptTables {
 public:
  /// Puts what the programs before have left into the tables of the context.
  explicit KeptTables(IsoContext& c);
  /// Tells the next program (InterpretSummary::kept).
  void keep(IsoContext& c) const;

 private:
  OffsetTables given_;  ///< by the job
};

}  // namespace proveout::nc
