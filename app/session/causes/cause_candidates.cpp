#include "app/session/causes/cause_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "app/session/findings/control_datum.h"
#include "core/base/assert.h"
#include "core/nc/control/control_settings.h"
#include "core/tool/tool_table.h"

namespace proveout {
namespace {

using enum OriginKind;

/// Kinds of words that move a cut, the likeliest first.
struct KindOf {
  CutShift shift;
  OriginKind kind;
  bool only_turning = false;
};
constexpr KindOf kKinds[] = {
    {CutShift::kX, kX},
    {CutShift::kX, kI},
    {CutShift::kX, kArcRadius},
    {CutShift::kX, kWorkOffset},
    {CutShift::kX, kShift},
    {CutShift::kX, kMirror},
    {CutShift::kX, kScaling},
    {CutShift::kX, kRotation},
    {CutShift::kX, kPolar},
    {CutShift::kX, kDistance},
    {CutShift::kX, kUnits},
    {CutShift::kX, kCorner},
    {CutShift::kX, kAngle},
    {CutShift::kX, kCycleShift},
    {CutShift::kX, kAllowance, true},
    {CutShift::kX, kCycleDepth, true},
    {CutShift::kX, kDiameter, true},
    {CutShift::kX, kCompensation, true},
    {CutShift::kX, kTool, true},
    {CutShift::kX, kContour, true},
    {CutShift::kY, kY},
    {CutShift::kY, kJ},
    {CutShift::kY, kArcRadius},
    {CutShift::kY, kWorkOffset},
    {CutShift::kY, kShift},
    {CutShift::kY, kMirror},
    {CutShift::kY, kScaling},
    {CutShift::kY, kRotation},
    {CutShift::kY, kPolar},
    {CutShift::kY, kDistance},
    {CutShift::kY, kUnits},
    {CutShift::kY, kCorner},
    {CutShift::kY, kAngle},
    {CutShift::kY, kCycleShift},
    {CutShift::kZ, kCycleDepth},
    {CutShift::kZ, kZ},
    {CutShift::kZ, kLengthOffset},
    {CutShift::kZ, kLengthCode},
    {CutShift::kZ, kCyclePlane},
    {CutShift::kZ, kTool},
    {CutShift::kZ, kWorkOffset},
    {CutShift::kZ, kShift},
    {CutShift::kZ, kK},
    {CutShift::kZ, kDistance},
    {CutShift::kZ, kScaling},
    {CutShift::kZ, kUnits},
    {CutShift::kZ, kAllowance, true},
    {CutShift::kZ, kContour, true},
    {CutShift::kZ, kCompensation, true},
    {CutShift::kRadial, kRadiusOffset},
    {CutShift::kRadial, kCompensation},
    {CutShift::kRadial, kTool},
    {CutShift::kRadial, kArcRadius},
    {CutShift::kRadial, kI},
    {CutShift::kRadial, kJ},
    {CutShift::kRadial, kX, true},
    {CutShift::kRadial, kY, true},
    {CutShift::kRadial, kZ, true},
    {CutShift::kRadial, kCycleDepth, true},
    {CutShift::kRadial, kAllowance, true},
    {CutShift::kRadial, kScaling},
};
/// Data come behind the words that choose them, before all other words.
constexpr int kDatumRank = 1, kWordStep = 2;

std::string placeKey(const ResolvedOrigin& word) {
  return fmt::format("{}:{}:{}", word.file, word.line, word.begin);
}

class Collector {
 public:
  Collector(const CauseSource& source, MotionId motion) : s_(source), motion_(motion) {}

  std::vector<CauseCandidate> collect() {
    int rank = 0;
    for (const KindOf& k : kKinds) {
      rank += kWordStep;
      if (k.only_turning && !s_.turning) continue;
      if (k.kind == kRadiusOffset && !compensated()) continue;
      const auto word = originOf(s_.path, motion_, k.kind, s_.text);
      if (word) addWord(k.shift, *word, rank);
    }
    addData();
    return std::move(out_);
  }

 private:
  /// The same place counts once: Z of a cycle is its depth.
  void addWord(CutShift shift, const ResolvedOrigin& word, int rank) {
    const std::string key = fmt::format("{}w{}", static_cast<int>(shift), placeKey(word));
    const auto same = [&](const CauseCandidate& c) { return c.key == key; };
    if (word.begin > 0 && std::any_of(out_.begin(), out_.end(), same)) return;
    out_.push_back(
        {shift, word.begin > 0 ? key : key + originKindName(word.kind).data(), rank, word, {}, {}});
    for (const ResolvedOrigin& from : word.from) addWord(shift, from, rank + kWordStep);
  }

  void addDatum(CutShift shift, OriginKind behind, const std::string& datum, double value, std::uint32_t by) {
    if (const auto word = originOfWord(s_.path, by, s_.text)) {  // the program set it
      addWord(shift, *word, rankOf(shift, behind) + kDatumRank);
      return;
    }
    out_.push_back({shift,
                    fmt::format("{}d{}", static_cast<int>(shift), datum),
                    rankOf(shift, behind) + kDatumRank,
                    {},
                    datum,
                    fmt::format("{:g}", value)});
  }

  /// D counts with G41 and G42 only.
  bool compensated() const { return s_.path.motions[motion_].compensated; }

  static int rankOf(CutShift shift, OriginKind kind) {
    int rank = 0;
    for (const KindOf& k : kKinds) {
      rank += kWordStep;
      if (k.shift == shift && k.kind == kind) return rank;
    }
    return rank;
  }

  void addData() {
    const DataInForce* data = dataOf(s_.path, motion_);
    if (data == nullptr) return;
    if (data->length.row > 0)
      addDatum(CutShift::kZ, kLengthOffset, fmt::format("offsets.length.{}", data->length.row),
               data->length.value(),
               data->length.wear_by > 0 ? data->length.wear_by : data->length.geometry_by);
    if (data->radius.row > 0 && compensated())
      addDatum(CutShift::kRadial, kRadiusOffset, fmt::format("offsets.radius.{}", data->radius.row),
               data->radius.value(),
               data->radius.wear_by > 0 ? data->radius.wear_by : data->radius.geometry_by);
    addTool();
    addVectors(*data);
  }

  void addTool() {
    const int number = s_.path.motions[motion_].tool;
    const Tool* const tool = ToolTable(s_.tools).find(number);
    if (tool == nullptr) return;
    const std::string key = fmt::format("tools.{}.", number);
    if (tool->insert) {
      const DataInForce* data = dataOf(s_.path, motion_);
      for (const auto& [shift, datum, mm] :
           {std::tuple(CutShift::kX, LatheDatum::kOffsetX, data->tool_offset.x()),
            std::tuple(CutShift::kZ, LatheDatum::kOffsetZ, data->tool_offset.z())}) {
        if (mm != 0.0) addDatum(shift, kTool, latheDatumKey(s_.control, datum, data->nose_tool), mm, 0);
      }
      for (const CutShift shift : {CutShift::kX, CutShift::kZ, CutShift::kRadial}) {
        addDatum(shift, kTool, key + "nose_radius", tool->insert->nose_radius, 0);
        if (data->nose_radius > 0.0)  // what the operator entered
          addDatum(shift, kTool, latheDatumKey(s_.control, LatheDatum::kNoseRadius, data->nose_tool),
                   data->nose_radius, 0);
      }
      return;
    }
    addDatum(CutShift::kRadial, kTool, key + "diameter", tool->diameter, 0);
    if (tool->gauge_length > 0.0) addDatum(CutShift::kZ, kTool, key + "gauge_length", tool->gauge_length, 0);
    if (tool->type == ToolType::kDrill)
      addDatum(CutShift::kZ, kTool, key + "point_angle", tool->point_angle_deg, 0);
    if (tool->type == ToolType::kCone)
      addDatum(CutShift::kRadial, kTool, key + "cone_angle", tool->cone_angle_deg, 0);
    if (tool->corner_radius > 0.0)
      addDatum(CutShift::kZ, kTool, key + "corner_radius", tool->corner_radius, 0);
  }

  void addVectors(const DataInForce& data) {
    constexpr CutShift kAxes[] = {CutShift::kX, CutShift::kY, CutShift::kZ};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const char* const letter = k == 0 ? "x" : k == 1 ? "y" : "z";
      if (data.work_system > 0) {
        addDatum(kAxes[k], kWorkOffset,
                 fmt::format("offsets.work.{}.{}", workSystemName(data.work_system), letter),
                 data.work_offset.value[axis], data.work_offset.set_by[k]);
      }
      if (data.common_offset.value[axis] != 0.0 || data.common_offset.set_by[k] != 0)
        addDatum(kAxes[k], kWorkOffset, fmt::format("offsets.work.common.{}", letter),
                 data.common_offset.value[axis], data.common_offset.set_by[k]);
      if (data.shift.set_by[k] != 0)
        addDatum(kAxes[k], kShift, "", data.shift.value[axis], data.shift.set_by[k]);
    }
  }

  const CauseSource& s_;
  MotionId motion_;
  std::vector<CauseCandidate> out_;
};

}  // namespace

std::vector<CauseCandidate> candidatesOf(const CauseSource& source, MotionId motion) {
  if (motion >= source.path.motions.size() || source.path.motions[motion].source.origins < 0) return {};
  return Collector(source, motion).collect();
}

namespace {

/// Of a word that nothing speaks for or against: what is most often wrong first.
int usualRank(const CauseCandidate& c) {
  static constexpr OriginKind kOrder[] = {
      kCycleDepth, kZ,         kCompensation, kLengthOffset, kTool,       kWorkOffset, kCyclePlane,
      kX,          kY,         kRadiusOffset, kShift,        kMotionCode, kI,          kJ,
      kArcRadius,  kCycleStep, kPlane,        kContour};
  constexpr int kLast = 100;
  if (!c.word) return kLast;
  const auto* const at = std::find(std::begin(kOrder), std::end(kOrder), c.word->kind);
  return at == std::end(kOrder) ? kLast - 1 : static_cast<int>(at - std::begin(kOrder));
}

}  // namespace

std::vector<CauseCandidate> inForce(const CauseSource& source, MotionId motion) {
  std::vector<CauseCandidate> all = candidatesOf(source, motion), out;
  if (all.empty()) return out;
  const SourceRef& own = source.path.motions[motion].source;
  const auto foreign = [&](const CauseCandidate& c) {
    return !c.word || c.word->line != own.line || c.word->file != own.file;
  };
  const auto order = [&](const CauseCandidate& c) { return std::pair(foreign(c), usualRank(c)); };
  std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return order(a) < order(b); });
  for (CauseCandidate& c : all) {
    const std::string place = c.key.substr(1);
    const auto same = [&](const CauseCandidate& o) { return o.key.substr(1) == place; };
    if (std::none_of(out.begin(), out.end(), same)) out.push_back(std::move(c));
  }
  return out;
}

std::vector<CauseCandidate> spindleWords(const CauseSource& source, MotionId motion) {
  std::vector<CauseCandidate> out;
  PROVEOUT_ASSERT(motion < source.path.motions.size());
  const Motion& m = source.path.motions[motion];
  if (m.source.origins < 0) return out;
  for (const OriginKind kind : {kSpindleDirection, kSpindle, kSpindleMode}) {
    const auto word = originOf(source.path, motion, kind, source.text);
    if (!word) continue;
    CauseCandidate candidate;
    candidate.key = placeKey(*word);
    candidate.word = word;
    out.push_back(std::move(candidate));
    // What holds it still is that word, whatever its speed would be.
    const bool starts = word->value == 3.0 || word->value == 4.0;
    if (kind == kSpindleDirection && m.spindle == 0.0 && !starts) break;
  }
  return out;
}

}  // namespace proveout
