// The codes of the WL4 control as data: what executes is what `proveout coverage` prints (digest wl4, 4.1
// and 6).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"
#include "core/nc/text/block.h"
#include "core/nc/wl4/wl4_parameters.h"
#include "core/path/word_origin.h"

namespace proveout::nc {

struct Wl4BlockPlan;
struct Wl4Context;
struct Wl4State;

/// Of two codes of one group in a block the last one counts.
enum class Wl4Group : std::uint8_t {
  kMotion,
  kDeed,  ///< one-shot: what the block does in place of a motion
  kPlane,
  kRadius,
  kLength,
  kSystem,
  kStop,
  kCycle,
  kDistance,
  kFeed,
  kSpeed,
  kFlag  ///< one-shot: several may stand in a block
};

/// A part of what a code does to a block. False: an error was reported.
using Wl4Step = bool (*)(Wl4Context&, Wl4BlockPlan&);
/// What an M function does, by its number. False: an error was reported.
using Wl4Function = bool (*)(Wl4Context&, Wl4BlockPlan&, int);

struct Wl4GCode {
  int code;
  Wl4Group group;
  int Wl4State::*mode;             ///< what becomes the code; null: nothing, it is one-shot
  bool Wl4BlockPlan::*flag;        ///< what becomes true of the block; null: nothing
  Wl4Step plan;                    ///< plans the words of the axes; null: another code does
  Wl4Step perform;                 ///< of deeds and motions; null: nothing is left to do
  std::string_view program;        ///< called behind the block, if `perform` has not done it; empty: none
  AddressSet words;                ///< of E I J K P Q R those that it takes by itself
  std::optional<OriginKind> kind;  ///< of its word for motions; nothing: they do not depend on it
  std::string_view cls, ids, meaning;
};

/// When an M function acts in its block.
enum class Wl4Phase : std::uint8_t { kStart, kEnd };
/// What an M function does to the run.
enum class Wl4Flow : std::uint8_t {
  kOn,
  kEnd,    ///< of the program
  kReturn  ///< from a subprogram
};

struct Wl4MCode {
  int first, last;  ///< numbers of which a later row does not say otherwise
  Wl4Phase phase;
  Wl4Function perform;  ///< null: only the flow
  Wl4Flow flow;
  AddressSet words;                ///< as in Wl4GCode
  std::optional<OriginKind> kind;  ///< as in Wl4GCode
  std::string_view cls, ids, meaning;
};

/// What is neither a G nor an M code: the reader and the run loop do it.
struct Wl4Feature {
  std::string_view code, cls, ids, meaning;
};

/// The rows, by number.
std::span<const Wl4GCode> wl4GCodes();
std::span<const Wl4MCode> wl4MCodes();
std::span<const Wl4Feature> wl4Features();

/// Null: the control has no such code.
const Wl4GCode* wl4GCode(int code);
/// `m`: 0 to 99, of which every number has a row.
const Wl4MCode& wl4MCode(int m);

/// What the code supports, and the rows of the manual.
std::vector<CoverageRow> wl4Coverage();
std::vector<CoverageIdRow> wl4CoverageIds();

}  // namespace proveout::nc
