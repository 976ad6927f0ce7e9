// Where the words of a WL4 program were written: told to the recorder, block by block.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/nc/origins/origin_recorder.h"
#include "core/nc/wl4/macro/wl4_variables.h"
#include "core/nc/wl4/wl4_block.h"
#include "core/nc/wl4/wl4_block_plan.h"
#include "core/nc/wl4/wl4_levels.h"
#include "core/nc/wl4/wl4_setup.h"

namespace proveout::nc {

/// Words that gave the end of a piece of a contour, and the block that has it.
struct Wl4ContourWords {
  OriginRecorder::Slot u, v, block;
};

/// What it says of a block is of the block in hand, and of the state before it.
class Wl4Origins {
 public:
  /// All must outlive it.
  Wl4Origins(OriginRecorder& recorder, const Wl4Setup& setup, const Wl4Levels& levels, const Wl4Block& block,
             const Wl4State& state, const Wl4Variables& variables)
      : recorder_(recorder),
        setup_(setup),
        levels_(levels),
        block_(block),
        state_(state),
        variables_(variables) {}

  /// `line`: the text of the block on the line of the innermost level, before it is read.
  void beginBlock(std::string_view line);
  /// The words of a planned block that is about to run.
  void recordWords(const Wl4BlockPlan& p);
  /// Behind the change of the tool.
  void recordToolChange();
  /// What the programs %81 to %89 take from variables.
  void recordFixedCycle();
  /// The code of an open cycle.
  void recordOpenCycle(const Wl4BlockPlan& p);

  // Cycles over contours.
  /// Words of the block of G76 to G78 that all passes share.
  void recordContourCycle(const Wl4BlockPlan& p);
  /// A coordinate of the contour's start in the cycle's block.
  void recordStart(char letter, OriginKind kind) { recordLetter(letter, kind, false, false); }
  Wl4ContourWords wordsInPlane(const WorkPlane& plane) const;
  /// Words of the axes of a block of the contour.
  void recordContourAxes(const Wl4BlockPlan& p);
  /// The whole block of a contour, and what gave the end of its element.
  Wl4ContourWords recordContourBlock(const WorkPlane& plane);
  /// A pass along an element.
  void recordPass(const WorkPlane& plane, const Wl4ContourWords& words);

 private:
  /// Kinds of the plain words of a block; `steps` are incremental.
  struct PlainWords {
    KindSet kinds, steps;
    bool operator==(const PlainWords&) const = default;
  };
  /// What the kinds of the words of a plain motion block depend on.
  struct BlockShape {
    AddressSet letters;
    AxisSet named;
    int g = -1, motion = -1, distance = -1;
    bool chamfer = false;
    bool operator==(const BlockShape&) const = default;
  };
  std::optional<BlockShape> shapeOf(const Wl4BlockPlan& p) const;
  bool shownByText() const;
  void recordLetter(char letter, OriginKind kind, bool step = false, bool by_text = true);
  void recordCode(const Wl4Block::Code& code, OriginKind kind);
  void recordCodesOf(int number, OriginKind kind);
  void tellPlainWords();
  void recordBlock(const Wl4BlockPlan& p);
  void recordCodes(const Wl4BlockPlan& p);
  void recordAxes(const Wl4BlockPlan& p);
  void recordData(const Wl4BlockPlan& p);
  void recordSetters();

  OriginRecorder& recorder_;
  const Wl4Setup& setup_;
  const Wl4Levels& levels_;
  const Wl4Block& block_;
  const Wl4State& state_;
  const Wl4Variables& variables_;
  PlainWords plain_words_;                ///< of the block in hand, not told yet
  PlainWords told_words_;                 ///< told last
  std::optional<BlockShape> told_shape_;  ///< of the block that told them
  bool data_told_ = false;
  std::array<std::uint32_t, 3> system_by_{};  ///< words of G92
};

}  // namespace proveout::nc
