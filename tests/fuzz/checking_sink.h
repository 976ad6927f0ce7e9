// A sink for any program: nothing that it gets may be infinite, leap or be without text.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/nc/registry/interpreter.h"

namespace proveout {

class CheckingSink : public MotionSink {
 public:
  void file(std::uint32_t index, const std::string& name) override {
    if (!files_.insert(index).second) std::abort();  // of several channels not in the order of their numbers
    add(name);
  }
  void motion(const Motion& m, const ArcGeometry* arc, const AxisSweep* axis) override {
    const bool finite = m.from.allFinite() && m.to.allFinite() && std::isfinite(m.feed) &&
                        std::isfinite(m.time_s) &&
                        (arc == nullptr || (arc->center.allFinite() && std::isfinite(arc->sweep_rad)));
    if (m.source.origins < 0 || static_cast<std::uint32_t>(m.source.origins) >= sets_) std::abort();
    if (axis != nullptr && !isSound(*axis)) std::abort();
    if (!finite || m.time_s < 0.0 || m.feed < 0.0) std::abort();
    if (m.channel > kMaxChannels || !files_.contains(m.source.file)) std::abort();
    Channel& channel = channels_[m.channel];
    if (channel.seen && (m.from - channel.last).norm() > 1e-6 * (1.0 + channel.last.norm())) std::abort();
    // Of several channels in order of start times; the sums are rounded.
    if (channel.now_s < latest_start_s_ - 1e-6 * (1.0 + latest_start_s_)) std::abort();
    latest_start_s_ = std::max(latest_start_s_, channel.now_s);
    channel.seen = true;
    channel.last = m.to;
    channel.now_s += m.time_s;
    for (const double value : {m.to.x(), m.to.y(), m.to.z(), m.feed, m.time_s}) add(value);
    add(static_cast<double>(m.source.line));
  }
  void wireMotion(const Motion& m, const WireSweep& wire) override {
    motion(m, nullptr, nullptr);
    for (const WireTrack* track : {&wire.lower, &wire.upper}) {
      if (!track->from.allFinite() || !track->to.allFinite() || !track->center.allFinite()) std::abort();
      add(track->to.x());
      add(track->to.y());
      add(track->sweep_rad);
    }
    if (!std::isfinite(wire.upper.sweep_rad + wire.lower.sweep_rad) || !(wire.z_low < wire.z_high))
      std::abort();
    if (wire_seen_ && (wire.upper.from - upper_).norm() > 1e-6 * (1.0 + upper_.norm())) std::abort();
    wire_seen_ = true;
    upper_ = wire.upper.to;
  }
  void event(const PathEvent& event) override {
    if (!std::isfinite(event.time_s) || event.time_s < 0.0) std::abort();
    if (event.channel > kMaxChannels) std::abort();
    channels_[event.channel].now_s += event.time_s;
    add(std::string(eventName(event.what)));
    forEachField(event.what, [this](const char* key, const auto& value) {
      add(key);
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
        add(value);
      } else {
        add(static_cast<double>(value));
      }
    });
  }
  void diagnostic(const Diagnostic& d) override {
    const std::string text = formatDiagnostic(d);
    if (text.empty()) std::abort();
    add(text);
  }
  // Origins refer to what has come before.
  void originWord(const WordOrigin& word) override {
    for (const std::uint32_t from : word.from) {
      if (from == 0 || from > words_) std::abort();
    }
    if (word.line == 0) std::abort();
    ++words_;
  }
  void originData(const DataInForce&) override { ++data_; }
  void originModal(const ModalOrigins& modal) override {
    for (const OriginCode code : modal.code) check(code);
    if (modal.data >= data_) std::abort();
    ++modal_;
  }
  void originSet(const OriginSet& set) override {
    for (const OriginCode code : set.axis) check(code);
    if (set.modal >= modal_) std::abort();
    ++sets_;
  }

  /// Sum over everything that came, in its order, without the channels' numbers.
  std::size_t sum() const { return sum_; }
  /// When the last channel ended, s.
  double end_s() const {
    double end = 0.0;
    for (const Channel& channel : channels_) end = std::max(end, channel.now_s);
    return end;
  }

 private:
  struct Channel {
    bool seen = false;
    Vec3 last = Vec3::Zero();
    double now_s = 0.0;
  };

  /// A tool has a direction, and axes have positions.
  static bool isSound(const AxisSweep& axis) {
    const auto unit = [](const Vec3& v) { return std::abs(v.norm() - 1.0) < 1e-6; };
    for (int k = 0; k < axis.rotary_count; ++k) {
      const RotaryPosition& r = axis.rotary[static_cast<std::size_t>(k)];
      if (!std::isfinite(r.from) || !std::isfinite(r.to)) return false;
    }
    return unit(axis.from) && unit(axis.to);
  }
  void add(std::string_view text) { sum_ = 31 * sum_ + std::hash<std::string_view>()(text); }
  void add(double value) { sum_ = 31 * sum_ + std::hash<double>()(value); }
  void check(OriginCode code) const {
    if (code.isWord() && code.number() > words_) std::abort();
  }

  std::uint32_t words_ = 0, data_ = 0, modal_ = 0, sets_ = 0;
  std::set<std::uint32_t> files_;
  std::array<Channel, kMaxChannels + 1> channels_;
  double latest_start_s_ = 0.0;
  bool wire_seen_ = false;
  Vec2 upper_ = Vec2::Zero();  ///< where the upper point of the wire stands
  std::size_t sum_ = 0;
};

}  // namespace proveout
