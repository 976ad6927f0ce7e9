// The system variables of the WL4 control, #100 and up (digest wl4, 3.2).
#pragma once

#include <array>
#include <cstddef>

#include "core/nc/origins/origin_recorder.h"
#include "core/nc/wl4/macro/wl4_variables.h"
#include "core/nc/wl4/wl4_state.h"

namespace proveout::nc {

class Wl4SystemValues final : public Wl4System {
 public:
  /// Where a measuring move has ended (G38), of one axis, mm or deg; X in diameter on lathes.
  struct Touch {
    double machine = 0.0, system = 0.0, distance = 0.0;
  };
  static constexpr std::size_t kTouches = 8;  ///< axes

  /// Both must outlive the values.
  Wl4SystemValues(const Wl4State& state, OriginRecorder& recorder) : state_(state), recorder_(recorder) {}

  std::optional<double> systemVariable(int number) const override;
  std::uint32_t systemOrigin(int number) const override;
  /// `axis` < kTouches.
  void setTouch(std::size_t axis, const Touch& touch) { touches_[axis] = touch; }

 private:
  const Wl4State& state_;
  OriginRecorder& recorder_;
  std::array<Touch, kTouches> touches_{};
};

}  // namespace proveout::nc
