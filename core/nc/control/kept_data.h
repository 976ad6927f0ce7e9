// What a program leaves in the control for the next one of the job.
#pragma once

#include <map>
#include <vector>

#include "core/machine/axis_point.h"

namespace proveout {

/// A cell of the offset tables that a program has changed. Columns and rows are the control's own.
struct KeptOffset {
  static constexpr int kTipColumn = -1;  ///< the cell is a tip code
  int column = 0, row = 0;
  bool wear = false;
  double value = 0.0;  ///< mm, or a code
  double found = 0.0;  ///< the same before the programs: what the job gives
};

/// A work frame that the job gives no value.
struct KeptFrame {
  int system = 0;    ///< as workSystemName() counts
  AxisPoint offset;  ///< machine frame, mm, rotary axes degrees
};

struct KeptData {
  std::map<int, double> variables;  ///< by number, those that are not vacant
  std::vector<KeptOffset> offsets;
  std::vector<KeptFrame> frames;
};

}  // namespace proveout
