// Several channels of a control: their numbers, and their paths put into one in order of time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/nc/control/channel_program.h"
#include "core/nc/control/run_summary.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// A set of channel numbers, 1 to kMaxChannels.
class ChannelSet {
 public:
  void add(int number) { bits_ = static_cast<std::uint16_t>(bits_ | 1u << number); }
  bool has(int number) const { return (bits_ >> number & 1u) != 0; }
  bool empty() const { return bits_ == 0; }
  bool operator==(const ChannelSet&) const = default;
  /// "12" for channels 1 and 2.
  std::string text() const;

 private:
  std::uint16_t bits_ = 0;
};

/// Takes the paths of channels, each in its own order, and passes on one path in order of start times; of
/// what starts at the same time the channel that was added first goes before. With one channel its path comes
/// out as it went in.
class ChannelMerge {
 public:
  /// Both must outlive the merge. `total` gets the motions and times of what is passed on.
  ChannelMerge(MotionSink& sink, InterpretSummary& total) : sink_(sink), total_(total) {}
  ChannelMerge(const ChannelMerge&) = delete;
  ChannelMerge& operator=(const ChannelMerge&) = delete;

  /// Where the next channel sends its path. Valid as long as the merge. Add all before anything is sent.
  MotionSink& add(int number);

  /// When the next motion of a channel starts at the earliest, s. `channel` counts from 0.
  double reached(std::size_t channel) const { return channels_[channel]->now_s; }
  /// Passes on what starts before `limit_s`: no channel sends anything earlier any more.
  void passBefore(double limit_s);
  /// Passes on the rest, but of motions and events only what starts until `last_s`, when the run ended.
  void finish(double last_s);

 private:
  struct MotionItem {
    Motion motion;
    std::unique_ptr<ArcGeometry> arc;
    std::unique_ptr<AxisSweep> axis;
  };
  struct FileItem {
    std::uint32_t index = 0;
    std::string name;
  };
  struct Item {
    double start_s = 0.0;
    std::variant<FileItem, MotionItem, PathEvent, Diagnostic> what;
  };
  struct Channel : MotionSink {
    Channel(ChannelMerge& owner, int channel_number) : merge(owner), number(channel_number) {}
    void file(std::uint32_t index, const std::string& name) override;
    void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) override;
    void event(const PathEvent& event) override;
    void diagnostic(const Diagnostic& diagnostic) override;
    // Rows of the origins go on at once, counted over all channels; words have the channels' common numbers.
    void originWord(const WordOrigin& word) override;
    void originData(const DataInForce& data) override;
    void originModal(const ModalOrigins& modal) override;
    void originSet(const OriginSet& set) override;
    SourceRef mapped(SourceRef source) const;
    std::uint8_t told() const;  ///< the number, where there are several

    ChannelMerge& merge;
    int number;
    double now_s = 0.0;
    std::vector<std::uint32_t> files;              ///< by the channel's index
    std::vector<std::uint32_t> data, modal, sets;  ///< by the channel's index, of the origins
    std::deque<Item> waiting;
  };

  Channel* earliest() const;
  void pass(const Item& item);

  MotionSink& sink_;
  InterpretSummary& total_;
  std::uint32_t files_ = 0;
  std::uint32_t data_ = 0, modal_ = 0, sets_ = 0;  ///< rows of the origins so far
  std::vector<std::unique_ptr<Channel>> channels_;
};

}  // namespace proveout::nc
