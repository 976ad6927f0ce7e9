#include "core/nc/iso/parameters/parameter_table.h"

#include "core/base/assert.h"
#include "core/nc/iso/parameters/parameters.h"

namespace proveout::nc {
namespace {

std::size_t rowsOf(ParamChapter chapter) {
  switch (chapter) {
    case ParamChapter::kMotion:
      return static_cast<std::size_t>(MotionParam::kCount);
    case ParamChapter::kMachine:
      return static_cast<std::size_t>(MachineParam::kCount);
    case ParamChapter::kComp:
      return static_cast<std::size_t>(CompParam::kCount);
    case ParamChapter::kCycles:
      return static_cast<std::size_t>(CycleParam::kCount);
    case ParamChapter::kMacro:
      return static_cast<std::size_t>(MacroParam::kCount);
    case ParamChapter::kFeeds:
      return static_cast<std::size_t>(FeedParam::kCount);
    case ParamChapter::kData:
      return static_cast<std::size_t>(DataParam::kCount);
    case ParamChapter::kAxis:
      return static_cast<std::size_t>(AxisParam::kCount);
    case ParamChapter::kTools:
      return static_cast<std::size_t>(ToolParam::kCount);
    case ParamChapter::kSpindle:
      return static_cast<std::size_t>(SpindleParam::kCount);
    case ParamChapter::kFunctions:
      return static_cast<std::size_t>(FunctionParam::kCount);
    case ParamChapter::kProgram:
      return static_cast<std::size_t>(ProgramParam::kCount);
    case ParamChapter::kSafety:
      return static_cast<std::size_t>(SafetyParam::kCount);
    case ParamChapter::kFiveAxis:
      return static_cast<std::size_t>(FiveAxisParam::kCount);
    case ParamChapter::kOwn:
    case ParamChapter::kCount:
      break;
  }
  return 0;
}

/// What 0 would take away from a machine, and what is 0 nowhere.
void fixUsual(ParameterTable& table) {
  constexpr double kArcTolerance = 0.01;  // of the common controls, mm
  table.fix(MotionParam::kRadiusDifference, kArcTolerance)
      .fix(MotionParam::kSkipKeepsLookAhead, 1)
      .fix(MachineParam::kSpindleOrients, 1)
      .fix(MachineParam::kSpindleIndexes, 1)
      .fix(MachineParam::kToolChangeOnM6, 1)
      .fix(CompParam::kToolOffsets, 999)
      .fix(CompParam::kInterferenceCheck, 1)
      .fix(CompParam::kMinCompStep, 0.001)
      .fix(CompParam::kLengthAlwaysZ, 1)
      .fix(CycleParam::kChipBreakReturn, 1)
      .fix(CycleParam::kPeckClearance, 1)
      .fix(CycleParam::kBoreRetract, 100)
      .fix(CycleParam::kRigidChipBreakReturn, 1)
      .fix(CycleParam::kRigidPeckClearance, 1)
      .fix(CycleParam::kTapRetract, 100)
      .fix(CycleParam::kTapReturn, 100)
      .fix(FeedParam::kInsideCornerAngle, 90)
      .fix(FeedParam::kInsideCornerFactor, 1)
      .fix(AxisParam::kRolloverPeriod, 360)
      .fix(ToolParam::kRows, 999)
      .fix(SpindleParam::kDefault, 1)
      .fix(SpindleParam::kSurfaceAxis, 1);
}

}  // namespace

ParameterTable::ParameterTable(std::string_view control, std::size_t own_rows) : control_(control) {
  for (std::size_t k = 0; k < chapters_.size(); ++k)
    chapters_[k].resize(rowsOf(static_cast<ParamChapter>(k)));
  chapters_[static_cast<std::size_t>(ParamChapter::kOwn)].resize(own_rows);
  fixUsual(*this);
}

ParameterTable& ParameterTable::add(ParamChapter chapter, std::span<const ParamInfo> rows) {
  std::vector<ParamInfo>& own = chapters_[static_cast<std::size_t>(chapter)];
  PROVEOUT_ASSERT(rows.size() == own.size());
  own.assign(rows.begin(), rows.end());
  return *this;
}

ParameterTable& ParameterTable::addRow(ParamId id, const ParamInfo& row) {
  std::vector<ParamInfo>& own = chapters_[static_cast<std::size_t>(id.chapter)];
  PROVEOUT_ASSERT(id.row < own.size());
  PROVEOUT_ASSERT(row.min <= row.default_value && row.default_value <= row.max);
  own[id.row] = row;
  return *this;
}

std::string_view ParameterTable::insteadOf(std::string_view name) const {
  const std::string_view whole = name.substr(0, name.find('.'));
  for (const ElsewhereParam& p : elsewhere_) {
    if (p.name == whole) return p.instead;
  }
  return {};
}

std::vector<ParameterInfo> ParameterTable::list() const {
  std::vector<ParameterInfo> all;
  for (const std::vector<ParamInfo>& chapter : chapters_) {
    for (const ParamInfo& p : chapter) {
      const int count = scopeCount(p.scope);
      if (!p.name.empty())
        all.push_back({p.name, p.default_value, p.min, p.max, p.meaning, count > 1 ? count : 0, p.choices});
    }
  }
  return all;
}

}  // namespace proveout::nc
