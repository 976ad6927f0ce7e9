// Tools of the nct control: T, M6, tool management (manual chapter 12).
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// T of the block in hand: which tool comes next. False: reported.
bool planTool(IsoContext& c, BlockPlan& plan, const Word& t);
/// Row of the offset table that an H or D word means: N2923 stands for that of the tool in the spindle.
/// False: reported.
bool offsetRowOfTool(IsoContext& c, const Word& w, std::int64_t& row);
/// Puts the cells of plan.payload (OffsetChange) into the tables. Always true.
bool performOffset(IsoContext& c, BlockPlan& plan);

/// The tool `type` of the row (0: without tool management) is in the spindle from here on.
bool sendToolChange(IsoContext& c, int type, int row);
/// Tells the shape that the row of D gives the tool in the spindle (manual 15.1). For jobs that do not have
/// the tool.
bool sendToolShape(IsoContext& c);
/// T with life counting at T (N2901.TLC): one more use of the tool called.
void countToolCall(IsoContext& c, const BlockPlan& plan);

/// G10 L75, L76, L77.
bool planToolInput(IsoContext& c, BlockPlan& plan);

/// #8400 to #8414, #8431 to #8450: the tool in the spindle.
class ToolBank final : public VariableBank {
 public:
  explicit ToolBank(IsoContext& c) : c_(c), magazine_(10 * c.channel()) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;

 private:
  IsoContext& c_;
  int magazine_;  ///< that of the channel's spindle until #8400 names another
};

}  // namespace proveout::nc
