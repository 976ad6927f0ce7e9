#include "core/nc/origins/origin_sets.h"

#include <algorithm>
#include <bit>

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

void OriginSets::setCode(OriginKind kind, OriginCode code) {
  const auto place = static_cast<std::size_t>(kind);
  if (place < kMain) {
    set_new_ = true;
  } else {
    modal_hash_ ^= hashOf(place, codes_[place]) ^ hashOf(place, code);
    modal_new_ = true;
  }
  codes_[place] = code;
}

void OriginSets::setCall(std::uint32_t word) {
  modal_.call = word;
  modal_new_ = true;
}

bool OriginSets::setData(const DataInForce& data) {
  if (data == data_) return false;
  data_ = data;
  data_new_ = true;
  return true;
}

std::int32_t OriginSets::index() {
  if (data_new_ || modal_new_) internModal();
  if (set_new_) internSet();
  return index_;
}

void OriginSets::internModal() {
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

void OriginSets::internSet() {
  const auto send = [&](const OriginSet& set) { sink_.originSet(set); };
  std::copy_n(codes_.begin(), kMain, set_.axis.begin());
  index_ = static_cast<std::int32_t>(indexOf(sets_, set_, hashOf(set_), send));
  set_new_ = false;
}

}  // namespace proveout::nc
