#include "core/nc/origins/origin_recorder.h"

#include <limits>
#include <string_view>

#include "core/base/assert.h"

namespace proveout::nc {

OriginKind axisKind(std::string_view name) {
  const char letter = name.size() == 1 ? name[0] : '\0';
  const auto from = [&](OriginKind kind, char first) {
    return static_cast<OriginKind>(static_cast<int>(kind) + letter - first);
  };
  if (letter >= 'X' && letter <= 'Z') return from(OriginKind::kX, 'X');
  if (letter >= 'A' && letter <= 'C') return from(OriginKind::kA, 'A');
  if (letter >= 'U' && letter <= 'W') return from(OriginKind::kU, 'U');
  return OriginKind::kOtherAxis;
}

OriginRecorder::OriginRecorder(MotionSink& sink)
    : sink_(sink), words_(std::make_shared<OriginWords>()), sets_(sink) {}

void OriginRecorder::shareWords(const OriginRecorder& owner, int channel) {
  words_ = owner.words_;
  channel_ = channel;
}

void OriginRecorder::writeRepeated() {
  stale_ = false;
  repeated_.each([&](OriginKind kind) {
    Slot& slot = slots_[static_cast<std::size_t>(kind)];
    slot.line = repeated_line_;
    slot.block = repeated_block_;
    slot.word = 0;
  });
}

void OriginRecorder::literals(KindSet kinds, KindSet steps, bool inch) {
  settle();
  touch();
  repeated_ = kinds;
  repeated_line_ = line_;
  Slot fresh{line_, frame_, 0, block_, Slot::State::kLiteral, Reading(false, inch)};
  kinds.without(steps).each([&](OriginKind kind) { slots_[static_cast<std::size_t>(kind)] = fresh; });
  fresh.reading = Reading(true, inch);
  steps.each([&](OriginKind kind) { slots_[static_cast<std::size_t>(kind)] = fresh; });
  present_.add(kinds);
  changed_.add(kinds);
}

void OriginRecorder::word(OriginKind kind, Columns columns, double value, ReadList reads, Reading reading) {
  Slot slot;
  slot.state = Slot::State::kWord;
  slot.word = numberOf(kind, columns, value, reads, reading);
  put(kind, slot);
}

void OriginRecorder::clear(KindSet kinds) {
  const KindSet gone = present_ & kinds;
  if (gone.empty()) return;
  settle();
  touch();
  repeated_.remove(gone);
  gone.each([&](OriginKind kind) { slots_[static_cast<std::size_t>(kind)] = Slot(); });
  present_.remove(gone);
  changed_.add(gone);
}

void OriginRecorder::put(OriginKind kind, const Slot& slot) {
  settle();
  touch();
  repeated_.remove(kind);
  slots_[static_cast<std::size_t>(kind)] = slot;
  changed_.add(kind);
  if (slot.state == Slot::State::kNone) {
    present_.remove(kind);
  } else {
    present_.add(kind);
  }
}

void OriginRecorder::restore(const Slots& before, KindSet stay) {
  for (std::size_t k = 0; k < before.size(); ++k) {
    const auto kind = static_cast<OriginKind>(k);
    if (!stay.has(kind)) put(kind, before[k]);
  }
}

void OriginRecorder::openCall() {
  const ReadList outer = calls_.empty() ? ReadList{} : listOf(std::span(&calls_.back(), 1));
  calls_.push_back(numberOf(OriginKind::kCall, {}, std::numeric_limits<double>::quiet_NaN(), outer));
  sets_.setCall(calls_.back());
  touch();
}

void OriginRecorder::closeCall() {
  PROVEOUT_ASSERT(!calls_.empty());
  calls_.pop_back();
  sets_.setCall(calls_.empty() ? 0 : calls_.back());
  touch();
}

void OriginRecorder::setData(const DataInForce& data) {
  if (sets_.setData(data)) touch();
}

std::uint32_t OriginRecorder::numberOf(OriginKind kind, Columns columns, double value, ReadList reads,
                                       Reading reading) {
  constexpr double kMmPerInch = 25.4;
  WordOrigin word;
  word.file = frame_ >> kDepthBits;
  word.line = line_;
  word.depth = static_cast<std::uint16_t>(frame_ & ((1u << kDepthBits) - 1));
  word.begin = static_cast<std::uint16_t>(columns.begin);
  word.end = static_cast<std::uint16_t>(columns.end);
  word.kind = kind;
  word.incremental = reading.incremental();
  word.inch = reading.inch();
  word.block = block_;
  word.value = value * (reading.inch() && isLength(kind) ? kMmPerInch : 1.0);
  return words_->numberOf(word, reads, channel_, sink_);
}

/// Gives a literal a number of its own, for other programs and variables.
void OriginRecorder::materialize(OriginKind kind, Slot& slot) {
  if (slot.word != 0 || slot.state != Slot::State::kLiteral) return;
  WordOrigin word;
  word.file = slot.frame >> kDepthBits;
  word.line = slot.line;
  word.depth = static_cast<std::uint16_t>(slot.frame & ((1u << kDepthBits) - 1));
  word.kind = writtenAs(kind, slot.reading);
  word.incremental = slot.reading.incremental();
  word.inch = slot.reading.inch();
  word.block = slot.block;
  slot.word = words_->numberOf(word, 0, channel_, sink_);
}

std::uint32_t OriginRecorder::wordOf(OriginKind kind) {
  settle();
  Slot& slot = slots_[static_cast<std::size_t>(kind)];
  materialize(kind, slot);
  return slot.word;
}

/// The code of what does not stand a few lines above in the same program.
OriginCode OriginRecorder::farCode(OriginKind kind) {
  Slot& slot = slots_[static_cast<std::size_t>(kind)];
  if (slot.state == Slot::State::kNone) return {};
  const bool here = slot.state == Slot::State::kLiteral && slot.frame == frame_;
  if (here && slot.line <= OriginCode::kMostLines) return OriginCode::line(slot.line, slot.reading);
  materialize(kind, slot);
  return OriginCode::word(slot.word);
}

std::int32_t OriginRecorder::update() {
  settle();
  due_ = false;
  KindSet due = changed_, young = young_;
  if (line_ != told_line_) due.add(young);
  if (frame_ != told_frame_) due.add(present_);
  young.remove(due);
  due.each([&](OriginKind kind) {
    const Slot& slot = slots_[static_cast<std::size_t>(kind)];
    const std::uint32_t back = line_ - slot.line;  // lines behind this one are far away
    const bool near =
        slot.state == Slot::State::kLiteral && slot.frame == frame_ && back <= OriginCode::kMostLinesBack;
    if (near) young.add(kind);
    const OriginCode code = near ? OriginCode::linesBack(back, slot.reading) : farCode(kind);
    if (code != sets_.code(kind)) sets_.setCode(kind, code);
  });
  young_ = young;
  changed_ = KindSet();
  told_line_ = line_;
  told_frame_ = frame_;
  ready_ = line_ == repeated_line_ && young.without(repeated_).empty();
  index_ = sets_.index();
  return index_;
}

}  // namespace proveout::nc
