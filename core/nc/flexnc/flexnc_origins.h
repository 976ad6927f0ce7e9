// Where the words of a FlexNC program were written: told to the recorder as they take effect.
#pragma once

#include <array>
#include <optional>

#include "core/nc/flexnc/flexnc_context.h"

namespace proveout::nc {

/// The line in hand begins.
void beginFlexLine(FlexContext& c);
/// The tables in force: tool, corrector, offsets.
void recordFlexData(FlexContext& c);
/// A coordinate; `kind` kX or kZ. Null: nothing is told.
void recordFlexAxis(FlexContext& c, OriginKind kind, const FlexWord* word, bool step);
/// G52 with the words of X and Z, which may be null.
void recordFlexShift(FlexContext& c, const std::array<const FlexWord*, 2>& axes);
/// M06.
void recordFlexToolChange(FlexContext& c);

/// The words in force while a cycle moves: the code and arguments of the block in hand (index of the code's
/// word) as the call that made the moves. Before: those of the program are back when it goes.
class FlexCycleOrigins {
 public:
  FlexCycleOrigins(FlexContext& c, std::size_t code);
  ~FlexCycleOrigins();
  FlexCycleOrigins(const FlexCycleOrigins&) = delete;
  FlexCycleOrigins& operator=(const FlexCycleOrigins&) = delete;
  /// Number of the place in the cycle that comes next, from 1.
  void place(std::uint32_t number);
  /// The same of a move, with the arguments that say where it ends.
  void move(std::uint32_t number, const CycleMove& move);

 private:
  using Slot = OriginRecorder::Slot;
  /// An argument of the block in hand; without a slot the call has no such argument.
  struct Argument {
    double value = 0.0;
    std::optional<Slot> slot;
  };
  /// Tells it.
  Argument record(OriginKind kind, char letter, std::size_t code);
  /// Which diameters say where a move ends.
  void tellDiameters(double end);

  FlexContext& c_;
  std::uint32_t file_;
  OriginRecorder::Slots before_;
  Argument x_, a_;  ///< diameters
  Argument y_, z_;  ///< along Z
};

}  // namespace proveout::nc
