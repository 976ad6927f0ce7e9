// Which words are in force: a control tells it block by block, and motions get the set as an index.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/nc/origins/kind_set.h"
#include "core/nc/origins/origin_sets.h"
#include "core/nc/origins/origin_words.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// The words of a cycle, which end with it.
inline constexpr KindSet kCycleKinds =
    KindSet::of(OriginKind::kCycle, OriginKind::kCycleDepth, OriginKind::kCyclePlane, OriginKind::kCycleStep,
                OriginKind::kCycleShift);
/// The words that count in their own block alone.
inline constexpr KindSet kBlockKinds =
    KindSet::of(OriginKind::kI, OriginKind::kJ, OriginKind::kK, OriginKind::kArcRadius, OriginKind::kAngle,
                OriginKind::kCorner);
/// Coordinates: they are where the machine is, no modal data.
inline constexpr KindSet kAxisKinds =
    KindSet::of(OriginKind::kX, OriginKind::kY, OriginKind::kZ, OriginKind::kA, OriginKind::kB,
                OriginKind::kC, OriginKind::kU, OriginKind::kV, OriginKind::kW, OriginKind::kOtherAxis);

/// The kind of the axis of that name: A, B, C, U, V, W, X, Y, Z, else kOtherAxis.
OriginKind axisKind(std::string_view name);

/// One a channel. Blocks go in in the order in which they run.
class OriginRecorder final : public ValueOrigins {
 public:
  using Reading = OriginCode::Reading;

  /// What is in force of one kind. Control states keep copies where a mode comes back later.
  struct Slot {
    enum class State : std::uint8_t { kNone, kLiteral, kWord };
    std::uint32_t line = 0, frame = 0;  ///< kLiteral: where the block stands
    std::uint32_t word = 0;             ///< kWord, or a literal that was needed as a word once
    std::int32_t block = -1;
    State state = State::kNone;
    Reading reading;
  };
  using Slots = std::array<Slot, kOriginKinds>;

  /// `sink` must outlive the recorder.
  explicit OriginRecorder(MotionSink& sink);
  OriginRecorder(const OriginRecorder&) = delete;
  OriginRecorder& operator=(const OriginRecorder&) = delete;
  /// From here on words are those of `owner` too. Before the first block.
  void shareWords(const OriginRecorder& owner, int channel);

  /// The program that runs from here on. `by_text`: readers of the path have the text of its file.
  void enter(std::uint32_t file, std::uint16_t depth, bool by_text) {
    const std::uint32_t frame = file << kDepthBits | depth;
    if (frame == frame_ && by_text == by_text_) return;
    frame_ = frame;
    by_text_ = by_text;
    ready_ = false;
    due_ = true;
  }
  /// The block of it that runs from here on: line from 1, and N number or -1.
  void begin(std::uint32_t line, std::int64_t block) {
    line_ = line;
    block_ = static_cast<std::int32_t>(block);
    due_ = true;
  }
  /// The block in hand calls a program, which is entered next. Calls are closed in reverse order.
  void openCall();
  void closeCall();
  /// Can words of the block be found in its text? For blocks of plain words.
  bool byText() const { return by_text_; }

  /// Plain words of the block take effect; those in `steps` are incremental.
  void literals(KindSet kinds, KindSet steps, bool inch);
  /// The block's words are of the kinds that the last call of literals() was told of, read as there, and
  /// there are no others: costs next to nothing. False: this cannot be said so, call literals().
  bool again() {
    if (!ready_) return false;
    told_line_ = repeated_line_ = line_;
    repeated_block_ = block_;
    stale_ = true;
    due_ = false;
    return true;
  }
  /// A word takes effect. `reads`: what its expression read.
  void word(OriginKind kind, Columns columns, double value, ReadList reads, Reading reading);
  /// Nothing is in force any more.
  void clear(KindSet kinds);
  const Slot& slot(OriginKind kind) {
    settle();
    return slots_[static_cast<std::size_t>(kind)];
  }
  void put(OriginKind kind, const Slot& slot);
  const Slots& slots() {
    settle();
    return slots_;
  }
  /// What was in force before is again, but for kinds that stay as they are.
  void restore(const Slots& before, KindSet stay);
  bool any(KindSet kinds) const { return !(present_ & kinds).empty(); }

  /// The tables' rows in force.
  const DataInForce& data() const { return sets_.data(); }
  void setData(const DataInForce& data);

  /// The set in force in the block, for SourceRef::origins.
  std::int32_t index() { return due_ ? update() : index_; }

  /// Number of the word in force, for variables that tell its value; 0: none.
  std::uint32_t wordOf(OriginKind kind);
  /// Number of a word of the block, or of an assignment in it. Columns 0: as the text shows.
  std::uint32_t numberOf(OriginKind kind, Columns columns, double value, ReadList reads,
                         Reading reading = {});
  ReadList listOf(std::span<const std::uint32_t> words) override { return words_->listOf(words); }
  std::uint32_t assigned(Columns columns, double value, ReadList reads) override {
    return numberOf(OriginKind::kVariable, columns, value, reads);
  }

 private:
  static constexpr unsigned kDepthBits = 8;

  void touch() {
    ready_ = false;
    due_ = true;
  }
  void settle() {
    if (stale_) writeRepeated();
  }
  void writeRepeated();
  std::int32_t update();
  OriginCode farCode(OriginKind kind);
  void materialize(OriginKind kind, Slot& slot);

  MotionSink& sink_;
  std::shared_ptr<OriginWords> words_;
  int channel_ = 0;

  std::uint32_t line_ = 0, frame_ = 0;
  std::int32_t block_ = -1;
  bool by_text_ = false;

  Slots slots_{};
  KindSet present_;  ///< kinds with a word
  KindSet changed_;  ///< since the last update
  KindSet young_;    ///< whose codes count lines back: the next line changes them

  // Blocks of the same kinds of words: only the last one is written down, and that when somebody looks.
  KindSet repeated_;
  std::uint32_t repeated_line_ = 0;
  std::int32_t repeated_block_ = -1;
  bool stale_ = false;  ///< the slots of `repeated_` have an older line
  bool ready_ = false;  ///< a block of such words changes no code
  bool due_ = true;     ///< the index may have changed

  OriginSets sets_;  ///< as of the last update
  std::uint32_t told_line_ = 0, told_frame_ = 0;
  std::int32_t index_ = -1;
  std::vector<std::uint32_t> calls_;  ///< numbers of the words of the open calls
};

}  // namespace proveout::nc
