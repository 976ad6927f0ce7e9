#include "core/nc/origin_recorder.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <string_view>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

std::uint64_t hashOf(const DataInForce& data) {
  std::uint64_t hash = static_cast<std::uint32_t>(data.tool);
  const auto add = [&](std::uint64_t value) { hash = mixBits(hash ^ value); };
  const auto addVector = [&](const Vec3& v) {
    for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint64_t>(v[k] + 0.0));  // -0 equals 0
  };
  add(static_cast<std::uint32_t>(data.length.row));
  add(std::bit_cast<std::uint64_t>(data.length.value() + 0.0));
  add(static_cast<std::uint32_t>(data.radius.row));
  add(std::bit_cast<std::uint64_t>(data.radius.value() + 0.0));
  add(static_cast<std::uint32_t>(data.work_system));
  add(static_cast<std::uint32_t>(data.nose_tool));
  addVector(data.length_offset);
  addVector(data.work_offset.value);
  addVector(data.shift.value);
  return hash;
}

std::uint64_t hashOf(const OriginSet& set) {
  const std::uint64_t first = static_cast<std::uint64_t>(set.modal) << 32 | set.axis[0].bits();
  const std::uint64_t second = static_cast<std::uint64_t>(set.axis[1].bits()) << 32 | set.axis[2].bits();
  const std::uint64_t hash = first * 0x9E3779B97F4A7C15u + second * 0xBF58476D1CE4E5B9u;
  return hash ^ hash >> 32;
}

/// What one code adds to the hash of all.
std::uint64_t hashOf(std::size_t place, OriginCode code) {
  return mixBits(static_cast<std::uint64_t>(place) << 32 | code.bits());
}

/// Index of a value, which the sink gets if it is new.
template <class T, class Send>
std::uint32_t indexOf(InternTable<T>& table, const T& value, std::uint64_t hash, Send send) {
  const std::uint32_t known = table.find(value, hash);
  if (known != InternTable<T>::kNone) return known;
  send(value);
  return table.add(value, hash);
}

constexpr std::size_t kMain = 3;  ///< X, Y, Z stand in the set itself

}  // namespace

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

OriginRecorder::OriginRecorder(MotionSink& sink) : sink_(sink), words_(std::make_shared<OriginWords>()) {}

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
  modal_.call = calls_.back();
  modal_new_ = true;
  touch();
}

void OriginRecorder::closeCall() {
  PROVEOUT_ASSERT(!calls_.empty());
  calls_.pop_back();
  modal_.call = calls_.empty() ? 0 : calls_.back();
  modal_new_ = true;
  touch();
}

void OriginRecorder::setData(const DataInForce& data) {
  if (data == data_) return;
  touch();
  data_ = data;
  data_new_ = true;
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

void OriginRecorder::setCode(std::size_t kind, OriginCode code) {
  if (kind < kMain) {
    set_new_ = true;
  } else {
    modal_hash_ ^= hashOf(kind, codes_[kind]) ^ hashOf(kind, code);
    modal_new_ = true;
  }
  codes_[kind] = code;
}

std::int32_t OriginRecorder::update() {
  settle();
  due_ = false;
  KindSet due = changed_, young = young_;
  if (line_ != told_line_) due.add(young);
  if (frame_ != told_frame_) due.add(present_);
  young.remove(due);
  due.each([&](OriginKind kind) {
    const auto k = static_cast<std::size_t>(kind);
    const Slot& slot = slots_[k];
    const std::uint32_t back = line_ - slot.line;  // lines behind this one are far away
    const bool near =
        slot.state == Slot::State::kLiteral && slot.frame == frame_ && back <= OriginCode::kMostLinesBack;
    if (near) young.add(kind);
    const OriginCode code = near ? OriginCode::linesBack(back, slot.reading) : farCode(kind);
    if (code != codes_[k]) setCode(k, code);
  });
  young_ = young;
  changed_ = KindSet();
  told_line_ = line_;
  told_frame_ = frame_;
  ready_ = line_ == repeated_line_ && young.without(repeated_).empty();
  if (data_new_ || modal_new_) internModal();
  if (set_new_) internSet();
  return index_;
}

void OriginRecorder::internModal() {
  if (data_new_) {
    const auto send = [&](const DataInForce& data) { sink_.originData(data); };
    modal_.data = indexOf(data_rows_, data_, hashOf(data_), send);
  }
  const auto send = [&](const ModalOrigins& modal) { sink_.originModal(modal); };
  std::copy(codes_.begin() + kMain, codes_.end(), modal_.code.begin());
  const std::uint32_t index =
      indexOf(modal_rows_, modal_,
              mixBits(modal_hash_ ^ modal_.data ^ static_cast<std::uint64_t>(modal_.call) << 32), send);
  set_new_ = set_new_ || index != set_.modal;
  set_.modal = index;
  data_new_ = modal_new_ = false;
}

void OriginRecorder::internSet() {
  const auto send = [&](const OriginSet& set) { sink_.originSet(set); };
  std::copy_n(codes_.begin(), kMain, set_.axis.begin());
  index_ = static_cast<std::int32_t>(indexOf(sets_, set_, hashOf(set_), send));
  set_new_ = false;
}

}  // namespace proveout::nc
