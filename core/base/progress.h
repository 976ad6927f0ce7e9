// Progress and cancellation of long work: one object, handed down, read by any thread.
#pragma once

#include <atomic>
#include <string_view>

namespace proveout {

/// The default says nothing. Implementations of `report` must be thread-safe.
class Progress {
 public:
  Progress() = default;
  /// Of a part of other work, which must outlive it: is cancelled with that, or alone.
  explicit Progress(const Progress* whole) : whole_(whole) {}
  virtual ~Progress() = default;
  /// `phase` is a short static text ("removing"); `done` in 0..1. May be called from any thread.
  virtual void report(std::string_view phase, double done) {
    (void)phase;
    (void)done;
  }
  /// Asks the work to stop; async-signal-safe.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->cancelled());
  }

 private:
  const Progress* whole_ = nullptr;
  std::atomic<bool> cancelled_{false};
};

}  // namespace proveout
