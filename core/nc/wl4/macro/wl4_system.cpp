#include "core/nc/wl4/macro/wl4_system.h"

namespace proveout::nc {

namespace {

/// Variables that tell modes and words in force.
struct WholeValue {
  int number;
  int Wl4State::*value;
};
constexpr WholeValue kWholeValues[] = {
    {101, &Wl4State::motion},   {102, &Wl4State::radius},     {103, &Wl4State::system},
    {104, &Wl4State::distance}, {105, &Wl4State::feed_mode},  {106, &Wl4State::speed_mode},
    {107, &Wl4State::cycle},    {108, &Wl4State::open_cycle}, {112, &Wl4State::spindle},
    {114, &Wl4State::coolant},  {117, &Wl4State::gear},       {121, &Wl4State::selected_tool},
    {141, &Wl4State::d},        {200, &Wl4State::tool},
};
struct RealValue {
  int number;
  double Wl4State::*value;
};
constexpr RealValue kRealValues[] = {
    {120, &Wl4State::speed}, {136, &Wl4State::i},    {137, &Wl4State::j},
    {138, &Wl4State::k},     {139, &Wl4State::feed}, {140, &Wl4State::p},
};

}  // namespace

std::optional<double> Wl4SystemValues::systemVariable(int number) const {
  const Wl4State& s = state_;
  if (number >= 130 && number <= 135) {
    const auto k = static_cast<std::size_t>(number - 130);
    return k % 2 == 0 ? s.target[k / 2] : s.increment[k / 2];
  }
  if (number >= 1000 && number < 1030) {
    const auto k = static_cast<std::size_t>(number % 10);
    if (k >= kTouches) return std::nullopt;
    const Touch& touch = touches_[k];
    return number < 1010 ? touch.machine : number < 1020 ? touch.system : touch.distance;
  }
  for (const WholeValue& whole : kWholeValues) {
    if (whole.number == number) return s.*whole.value;
  }
  for (const RealValue& real : kRealValues) {
    if (real.number == number) return s.*real.value;
  }
  return std::nullopt;
}

std::uint32_t Wl4SystemValues::systemOrigin(int number) const {
  switch (number) {
    case 120:
      return recorder_.wordOf(OriginKind::kSpindle);
    case 121:
      return recorder_.wordOf(OriginKind::kNextTool);
    case 130:
    case 131:
      return recorder_.wordOf(OriginKind::kX);
    case 132:
    case 133:
      return recorder_.wordOf(OriginKind::kY);
    case 134:
    case 135:
      return recorder_.wordOf(OriginKind::kZ);
    case 139:
      return recorder_.wordOf(OriginKind::kFeed);
    case 141:
      return recorder_.wordOf(OriginKind::kRadiusOffset);
    default:
      return 0;
  }
}

}  // namespace proveout::nc
