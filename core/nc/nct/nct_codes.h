// The codes of the nct control as data: what executes is what `proveout coverage` prints.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/nc/block.h"

namespace proveout::nc {

class NctControl;
struct BlockPlan;

/// What the simulation does with a code (the classes of the dialect digests).
enum class CodeClass { kSim, kTime, kState, kHost, kReject };
std::string_view codeClassName(CodeClass cls);

/// Modal groups of the nct control (manual chapter 3). 0: one-shot.
enum NctGroup : std::int8_t {
  kOneShot = 0,
  kGroupMotion = 1,
  kGroupPlane = 2,
  kGroupDistance = 3,
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
using PlanFunction = bool (NctControl::*)(BlockPlan&);

struct GCode {
  std::int16_t code10;  ///< G number times ten: 842 is G84.2
  std::int8_t group;    ///< NctGroup
  CodeClass cls;
  bool built;            ///< false: refused as not supported
  bool skippable;        ///< not built, but a lenient run may leave it out
  bool flushes;          ///< stops the look-ahead of cutter compensation
  AddressSet words;      ///< addresses that the code takes
  PlanFunction plan;     ///< null: the code only sets its group
  std::string_view ids;  ///< coverage ids
  std::string_view meaning;
};

/// Where in a block an M function acts (digest nct-2, 1.5).
enum class MPhase { kBefore, kAfter, kStop, kCall, kEnd };

struct MCode {
  int code;
  MPhase phase;
  int exclusive;  ///< codes of one number > 0 exclude each other in a block
  CodeClass cls;
  AddressSet words;
  std::string_view ids;
  std::string_view meaning;
};

/// A row for what is neither a G nor an M code: words, syntax, errors.
struct FeatureRow {
  std::string_view code;
  CodeClass cls;
  std::string_view ids;
  std::string_view meaning;
  bool built = true;  ///< false: refused as not supported
};

std::span<const GCode> nctGCodes();
std::span<const MCode> nctMCodes();
std::span<const FeatureRow> nctFeatures();

/// Null: no such code in this control.
const GCode* findGCode(int code10);
const MCode* findMCode(int code);

}  // namespace proveout::nc
