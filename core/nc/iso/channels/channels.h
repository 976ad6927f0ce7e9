// Several channels of a control, run together.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/nc/control/channels.h"
#include "core/nc/iso/program/control.h"

namespace proveout::nc {

/// Files that channels write: one file is open at a time in all of them.
class SharedOutput final : public ProgramOutput {
 public:
  /// `in_use` tells whether any channel has a file open; both must outlive the object.
  SharedOutput(ProgramOutput& files, bool& in_use) : files_(files), in_use_(in_use) {}
  bool exists(const std::string& name) const override { return files_.exists(name); }
  Status open(const std::string& name, bool append) override;
  Status write(std::string_view bytes) override { return files_.write(bytes); }
  Status close() override;

 private:
  ProgramOutput& files_;
  bool& in_use_;
};

/// Steps the channels so that the one that is behind in simulated time goes on. Programs that read what
/// another channel writes therefore see it in the order of time, to a block.
class IsoChannels {
 public:
  /// See interpretChannels().
  IsoChannels(const IsoDialect& dialect, const std::vector<ChannelProgram>& channels, MotionSink& sink,
              Progress* progress, const ControlHost& host);
  InterpretSummary run();

 private:
  enum class State { kRuns, kWaits, kEnded };
  struct Channel {
    int number = 0;
    std::unique_ptr<SharedOutput> output;
    std::unique_ptr<IsoControl> control;
    State state = State::kRuns;
    double now_s = 0.0;          ///< how far its motions go
    std::uint32_t standing = 0;  ///< blocks since time went on
    bool polls = false;          ///< it has gone round a loop for another channel to do something
  };

  bool fail(const std::string& message);
  bool checkNumbers(const std::vector<ChannelProgram>& channels);
  bool checkParameters(const std::vector<ChannelProgram>& channels);
  void make(const std::vector<ChannelProgram>& channels, Progress* progress, const ControlHost& host);
  bool start();
  bool checkTables();

  Channel* next();
  /// One block of the channel. False: the run is over.
  bool step(Channel& channel);
  void watchStanding(Channel& channel);
  void release();
  void meet(const WaitingPoint& at);
  /// Channels that wait for each other, or for one that has ended. True: reported.
  bool deadlock();
  std::string whereOf(const Channel& channel) const;
  double passLimit() const;
  InterpretSummary finish();

  const IsoDialect& dialect_;
  MotionSink& sink_;
  InterpretSummary total_;
  ChannelMerge merge_;
  bool file_open_ = false;
  std::unique_ptr<Probe> no_probe_;
  std::vector<Channel> channels_;
  const Channel* stopped_by_ = nullptr;
  bool good_ = true;
};

}  // namespace proveout::nc
