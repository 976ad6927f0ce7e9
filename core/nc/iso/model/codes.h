// The codes of a control as data: what executes is what `proveout coverage` prints.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/nc/origins/kind_set.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

struct IsoContext;
struct BlockPlan;

/// What the simulation does with a code (the classes of the dialect digests).
enum class CodeClass { kSim, kTime, kState, kHost, kReject };
std::string_view codeClassName(CodeClass cls);

/// Modal groups (nct manual, chapter 3). 0: one-shot.
enum IsoGroup : std::int8_t {
  kOneShot = 0,
  kGroupMotion = 1,
  kGroupPlane = 2,
  kGroupDistance = 3,
  kGroupZones = 4,
  kGroupFeedMode = 5,
  kGroupUnits = 6,
  kGroupRadiusComp = 7,
  kGroupLengthComp = 8,
  kGroupCycle = 9,
  kGroupReturn = 10,
  kGroupScaling = 11,
  kGroupMacro = 12,
  kGroupSurfaceSpeed = 13,
  kGroupWorkSystem = 14,
  kGroupCutting = 15,
  kGroupRotation = 16,
  kGroupPolarData = 17,
  kGroupTilt = 18,
  kGroupPolarInterpolation = 21,
  kGroupMirror = 22,
  kGroupGear = 34,
  kGroupCount = 35
};

/// Plans a block that the code governs: checks everything, fills the plan. False: an error was reported.
using PlanFunction = bool (*)(IsoContext&, BlockPlan&);

struct GCode {
  std::int32_t code10;  ///< G number times ten: 842 is G84.2; of the shared rules where `written` is another
  std::int8_t group;    ///< IsoGroup
  CodeClass cls;
  bool built;            ///< false: refused as not supported
  bool skippable;        ///< not built, but a lenient run may leave it out
  bool flushes;          ///< stops the look-ahead of cutter compensation
  AddressSet words;      ///< addresses that the code takes
  KindSet kinds;         ///< what it is for motions; empty: they do not depend on it
  PlanFunction plan;     ///< null: the code only sets its group
  std::string_view ids;  ///< coverage ids
  std::string_view meaning;
  std::int32_t written = -1;  ///< number that programs write, tenfold; -1: that of the shared rules

  constexpr std::int32_t number10() const { return written < 0 ? code10 : written; }
  constexpr std::int32_t meaning10() const { return code10; }
};

/// Where in a block an M function acts (digest nct-2, 1.5).
enum class MPhase { kBefore, kAfter, kStop, kCall, kEnd };

/// Groups of M codes that exclude each other in a block.
inline constexpr int kSpindleCodes = 1, kFlowCodes = 2, kCoolantCodes = 3, kGearCodes = 4;

struct MCode {
  int code;
  MPhase phase;
  int exclusive;  ///< codes of one number > 0 exclude each other in a block
  CodeClass cls;
  AddressSet words;
  std::string_view ids;
  std::string_view meaning;
  /// What the code does to the plan when it is read, before the words of the block are. Null: nothing. False:
  /// an error was reported.
  PlanFunction plan = nullptr;
};

/// A row for what is neither a G nor an M code: words, syntax, errors.
struct FeatureRow {
  std::string_view code;
  CodeClass cls;
  std::string_view ids;
  std::string_view meaning;
  bool built = true;  ///< false: refused as not supported
};

/// The rows of one chapter.
struct CodeTable {
  std::span<const GCode> g;
  std::span<const MCode> m;
  std::span<const FeatureRow> features;
};

/// All chapters of a control, with look-up by number: as programs write it, and as the shared rules do.
class CodeIndex {
 public:
  /// Rows of `instead` replace those of the same number in programs; G rows of `tables` whose numbers are in
  /// `without` are left out.
  explicit CodeIndex(std::vector<CodeTable> tables, std::vector<CodeTable> instead = {},
                     std::span<const std::int32_t> without = {});
  /// By the number in programs, tenfold. Null: no such code in this control.
  const GCode* g(int number10) const {
    if (number10 >= 0 && number10 < kDense) return g_[static_cast<std::size_t>(number10)];
    return beyond(g_sorted_, number10, &GCode::number10);
  }
  /// By GCode::code10: the row of a code in force (IsoState::active). Null: no such code in this control.
  const GCode* inForce(int code10) const {
    if (code10 >= 0 && code10 < kDense) return in_force_[static_cast<std::size_t>(code10)];
    return beyond(meanings_, code10, &GCode::meaning10);
  }
  const MCode* m(int code) const;

  const std::vector<const GCode*>& allG() const { return g_sorted_; }  ///< by number
  const std::vector<const MCode*>& allM() const { return m_sorted_; }  ///< by number
  const std::vector<const FeatureRow*>& allFeatures() const { return features_; }

 private:
  static constexpr int kDense = 1000;  ///< up to G99.9 a code is found by its number alone
  using NumberOf = std::int32_t (GCode::*)() const;
  static const GCode* beyond(const std::vector<const GCode*>& sorted, int number10, NumberOf number);

  std::array<const GCode*, kDense> g_{}, in_force_{};
  std::vector<const GCode*> g_sorted_, meanings_;  ///< by number, by code10
  std::vector<const MCode*> m_sorted_;
  std::vector<const FeatureRow*> features_;
};

}  // namespace proveout::nc
