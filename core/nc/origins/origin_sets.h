// Codes of the words in force, interned: each new set goes to the sink once, and motions get its index.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/nc/origins/intern_table.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// One a channel. Sets that are equal have one index.
class OriginSets {
 public:
  /// `sink` must outlive it.
  explicit OriginSets(MotionSink& sink) : sink_(sink) {}
  OriginSets(const OriginSets&) = delete;
  OriginSets& operator=(const OriginSets&) = delete;

  const OriginCode& code(OriginKind kind) const { return codes_[static_cast<std::size_t>(kind)]; }
  void setCode(OriginKind kind, OriginCode code);
  /// Word of the innermost call that is open; 0: none is.
  void setCall(std::uint32_t word);
  const DataInForce& data() const { return data_; }
  /// False: they were those.
  bool setData(const DataInForce& data);

  /// Of the set in force; -1 before the first. What is new goes to the sink.
  std::int32_t index();

 private:
  void internModal();
  void internSet();

  MotionSink& sink_;
  std::array<OriginCode, kOriginKinds> codes_{};
  OriginSet set_;
  ModalOrigins modal_;
  DataInForce data_;
  std::uint64_t modal_hash_ = 0;
  bool modal_new_ = true, set_new_ = true, data_new_ = true;
  std::int32_t index_ = -1;
  InternTable<DataInForce> data_rows_;
  InternTable<ModalOrigins> modal_rows_;
  InternTable<OriginSet> sets_;
};

}  // namespace proveout::nc
