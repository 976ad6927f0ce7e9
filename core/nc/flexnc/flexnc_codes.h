// The codes of the FlexNC control: rows that execute, and that `proveout coverage` prints (digest flexnc,
// 13).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"
#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// The words of the axes that wait for their motion.
struct FlexAxisWords {
  const FlexWord *x = nullptr, *z = nullptr, *i = nullptr, *k = nullptr;
  /// Null: there is none.
  const FlexWord* first() const { return x != nullptr ? x : z != nullptr ? z : i != nullptr ? i : k; }
  bool any() const { return first() != nullptr; }
  /// Of X, Z, I, K.
  const FlexWord*& of(char address) {
    return address == 'X' ? x : address == 'Z' ? z : address == 'I' ? i : k;
  }
};

/// A block on its way from left to right.
struct FlexCursor {
  std::size_t next = 0;  ///< word of the block
  FlexAxisWords axes;    ///< read and not moved yet
  bool names_motion = false;
  bool ends = false;  ///< M02
};

struct FlexGCode {
  int tenths;
  int FlexState::*mode;  ///< that takes the code's whole number; null: none
  /// What else it does; `cursor.next` is behind the code, and goes behind the words that are its own. Null:
  /// nothing. False: an error was reported.
  bool (*perform)(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
  std::optional<OriginKind> kind;
  std::string_view cls, ids, meaning;
};
std::span<const FlexGCode> flexGCodes();
/// Null: no code of this list.
const FlexGCode* flexGCode(int tenths);

struct FlexMCode {
  int code;
  bool (*perform)(FlexContext& c, FlexCursor& cursor, const FlexWord& word);
  std::string_view cls, ids, meaning;
};
std::span<const FlexMCode> flexMCodes();
const FlexMCode* flexMCode(int tenths);

/// Codes that performCycle() carries out, with the rows of the manual that they are.
struct FlexCycleRow {
  CycleCode code;
  std::string_view ids, meaning;
};
std::span<const FlexCycleRow> flexCycleRows();

/// What a row of coverage is that no code stands for.
struct FlexFeature {
  std::string_view code, cls, ids, meaning;
};
std::span<const FlexFeature> flexFeatures();

std::vector<CoverageRow> flexncCoverage();
std::vector<CoverageIdRow> flexncCoverageIds();

}  // namespace proveout::nc
