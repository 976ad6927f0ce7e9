#include "core/nc/iso/channels/channels.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "core/nc/iso/spindle/wait.h"

namespace proveout::nc {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// So many blocks without a motion are a loop that asks for what another channel does: its time goes on with
/// theirs. Fewer are enough to see that it still does.
constexpr std::uint32_t kPollingBlocks = 10'000;
constexpr std::uint32_t kStillPollingBlocks = 16;

/// The stock as it is at a channel's time is not known while others are cut in the same stock.
class NoProbe final : public Probe {
 public:
  Result<std::optional<double>> firstContact(const Motion&, const ArcGeometry*, const AxisSweep*) override {
    return inputError("measuring moves are not supported in runs of several channels");
  }
};

bool isGlobal(const ParameterTable& table, const std::string& name) {
  for (int chapter = 0; chapter < static_cast<int>(ParamChapter::kCount); ++chapter) {
    for (const ParamInfo& info : table.chapter(static_cast<ParamChapter>(chapter))) {
      if (info.name == name) return info.scope == ParamScope::kGlobal;
    }
  }
  return false;
}

}  // namespace

Status SharedOutput::open(const std::string& name, bool append) {
  if (in_use_) return inputError("another channel has a file open");
  const Status done = files_.open(name, append);
  in_use_ = done.ok();
  return done;
}

Status SharedOutput::close() {
  in_use_ = false;
  return files_.close();
}

IsoChannels::IsoChannels(const IsoDialect& dialect, const std::vector<ChannelProgram>& channels,
                         MotionSink& sink, Progress* progress, const ControlHost& host)
    : dialect_(dialect), sink_(sink), merge_(sink, total_), no_probe_(std::make_unique<NoProbe>()) {
  good_ = checkNumbers(channels) && checkParameters(channels);
  if (good_) make(channels, progress, host);
}

bool IsoChannels::fail(const std::string& message) {
  ++total_.errors;
  sink_.diagnostic({Severity::kError, dialect_.alarms.code("channel"), message, {}, {}, {}});
  return false;
}

bool IsoChannels::checkNumbers(const std::vector<ChannelProgram>& channels) {
  if (channels.empty() || channels.size() > kMaxChannels)
    return fail(fmt::format("a control has 1 to {} channels", kMaxChannels));
  ChannelSet seen;
  for (const ChannelProgram& channel : channels) {
    const int number = channel.settings.channel;
    if (number < 1 || number > kMaxChannels)
      return fail(fmt::format("channel numbers are 1 to {}, not {}", kMaxChannels, number));
    if (seen.has(number)) return fail(fmt::format("two channels with the number {}", number));
    seen.add(number);
  }
  return true;
}

bool IsoChannels::checkParameters(const std::vector<ChannelProgram>& channels) {
  const auto& first = channels.front().settings.parameters;
  for (const ChannelProgram& channel : channels) {
    for (const auto& [name, value] : channel.settings.parameters) {
      const auto common = first.find(name);
      if (!isGlobal(dialect_.parameters, name) || (common != first.end() && common->second == value))
        continue;
      return fail(fmt::format("parameter {} belongs to the whole control, channel {} cannot have its own",
                              name, channel.settings.channel));
    }
  }
  return true;
}

void IsoChannels::make(const std::vector<ChannelProgram>& channels, Progress* progress,
                       const ControlHost& host) {
  const bool several = channels.size() > 1;
  for (const ChannelProgram& program : channels) {
    Channel& channel = channels_.emplace_back();
    channel.number = program.settings.channel;
    ControlHost own = host;
    if (several && host.output != nullptr) {
      channel.output = std::make_unique<SharedOutput>(*host.output, file_open_);
      own.output = channel.output.get();
    }
    if (several) own.probe = no_probe_.get();
    channel.control = std::make_unique<IsoControl>(dialect_, *program.source, program.settings,
                                                   merge_.add(channel.number), progress, own);
  }
}

bool IsoChannels::start() {
  ChannelSet all;
  for (const Channel& channel : channels_) all.add(channel.number);
  for (Channel& channel : channels_) {
    if (channels_.size() > 1) channel.control->context().channels = all;
    if (channel.control->start()) continue;
    stopped_by_ = &channel;
    return false;
  }
  IsoContext& owner = channels_.front().control->context();
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    std::vector<IsoParameters*> others;
    for (Channel& channel : channels_) {
      if (&channel != &channels_[k]) others.push_back(&channel.control->context().parameters);
    }
    IsoContext& c = channels_[k].control->context();
    c.parameters.shareGlobals(std::move(others));
    if (k > 0) c.shareWith(owner);
  }
  return checkTables();
}

bool IsoChannels::checkTables() {
  if (channels_.size() < 2) return true;
  const AxisTable& axes = channels_.front().control->context().axes;
  for (int k = kMainAxes; k < axes.count(); ++k) {
    if (!axes.at(k).turns) continue;
    return fail(
        fmt::format("axis {} turns the part: with several channels it would turn it for all of them, "
                    "which is not supported (carries = \"nothing\" only tells its position)",
                    axes.at(k).name));
  }
  return true;
}

IsoChannels::Channel* IsoChannels::next() {
  Channel* first = nullptr;
  for (Channel& channel : channels_) {
    if (channel.state != State::kRuns) continue;
    const bool tie = first != nullptr && channel.now_s == first->now_s;
    if (first == nullptr || channel.now_s < first->now_s || (tie && first->polls && !channel.polls))
      first = &channel;
  }
  return first;
}

bool IsoChannels::step(Channel& channel) {
  const double before = channel.now_s;
  const IsoControl::Turn turn = channel.control->advance();
  channel.now_s = channel.control->context().emitter.time().reached_s();
  if (turn == IsoControl::Turn::kEnded) {
    channel.state = State::kEnded;
    if (channel.control->summary().end == ProgramEnd::kEndOfProgram) return true;
    stopped_by_ = &channel;
    return false;
  }
  if (turn == IsoControl::Turn::kWaits) {
    channel.state = State::kWaits;
    return true;
  }
  if (channel.now_s > before) {
    channel.standing = 0;
    channel.polls = false;
  } else {
    watchStanding(channel);
  }
  return true;
}

void IsoChannels::watchStanding(Channel& channel) {
  if (++channel.standing < (channel.polls ? kStillPollingBlocks : kPollingBlocks)) return;
  channel.standing = 0;
  double others = kNever;
  for (const Channel& other : channels_) {
    if (&other != &channel && other.state == State::kRuns) others = std::min(others, other.now_s);
  }
  if (others == kNever) return;  // nobody is left to end the loop: the limit of blocks does
  channel.polls = true;
  IsoContext& c = channel.control->context();
  c.stages.rapid.flush(FlushReason::kBuffer);
  c.emitter.time().flush();
  channel.now_s = c.emitter.time().reached_s();
  if (others > channel.now_s) c.emitter.event(event::Wait{}, others - channel.now_s, c.here());
  channel.now_s = c.emitter.time().reached_s();
}

void IsoChannels::release() {
  for (const Channel& channel : channels_) {
    if (channel.state != State::kWaits) continue;
    const WaitingPoint at = channel.control->context().waiting;
    const bool all = std::all_of(channels_.begin(), channels_.end(), [&](const Channel& other) {
      const WaitingPoint& there = other.control->context().waiting;
      return !at.whom.has(other.number) ||
             (other.state == State::kWaits && there.code == at.code && there.whom == at.whom);
    });
    if (all) meet(at);
  }
}

void IsoChannels::meet(const WaitingPoint& at) {
  double last = 0.0;
  for (const Channel& channel : channels_) {
    if (at.whom.has(channel.number)) last = std::max(last, channel.now_s);
  }
  for (Channel& channel : channels_) {
    if (!at.whom.has(channel.number)) continue;
    endWait(channel.control->context(), last - channel.now_s);
    channel.state = State::kRuns;
    channel.now_s = last;
    channel.standing = 0;
  }
}

std::string IsoChannels::whereOf(const Channel& channel) const {
  if (channel.state == State::kEnded) return fmt::format("channel {} has ended", channel.number);
  const IsoContext& c = channel.control->context();
  const SourceRef at = c.here();
  const std::string block = at.block >= 0 ? fmt::format(" N{}", at.block) : "";
  const std::string place = fmt::format("{}:{}{}", c.programs.text(at.file).name(), at.line, block);
  if (channel.state == State::kRuns) return fmt::format("channel {} is at {}", channel.number, place);
  return fmt::format("channel {} waits at {} with {}", channel.number, place, c.waiting.text);
}

bool IsoChannels::deadlock() {
  const bool none_runs = std::none_of(channels_.begin(), channels_.end(),
                                      [](const Channel& c) { return c.state == State::kRuns; });
  for (Channel& channel : channels_) {
    if (channel.state != State::kWaits) continue;
    IsoContext& c = channel.control->context();
    const bool hopeless = std::any_of(channels_.begin(), channels_.end(), [&](const Channel& other) {
      return c.waiting.whom.has(other.number) && other.state == State::kEnded;
    });
    if (!hopeless && !none_runs) continue;
    std::string message = "deadlock of waiting codes: ";
    for (const Channel& other : channels_)
      message += (&other == &channels_.front() ? "" : "; ") + whereOf(other);
    c.fail("deadlock", message);
    stopped_by_ = &channel;
    return true;
  }
  return false;
}

double IsoChannels::passLimit() const {
  // A channel that waits depends on one that runs, and sends nothing before that one's time.
  double limit = kNever;
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    if (channels_[k].state == State::kRuns) limit = std::min(limit, merge_.reached(k));
  }
  return limit == kNever ? 0.0 : limit;
}

InterpretSummary IsoChannels::run() {
  total_.end = ProgramEnd::kAlarm;
  if (!good_) return total_;
  good_ = start();
  while (good_) {
    release();
    if (deadlock()) break;
    Channel* channel = next();
    if (channel == nullptr || !step(*channel)) break;
    merge_.passBefore(passLimit());
  }
  return finish();
}

InterpretSummary IsoChannels::finish() {
  double last_s = kNever;
  if (good_) total_.end = ProgramEnd::kEndOfProgram;
  for (Channel& channel : channels_) {
    IsoContext& c = channel.control->context();
    c.stages.rapid.flush(FlushReason::kEnd);
    c.emitter.time().flush();
  }
  if (stopped_by_ != nullptr) {
    const InterpretSummary& its = stopped_by_->control->summary();
    last_s = its.cycle_s;
    total_.end = its.end == ProgramEnd::kEndOfProgram ? ProgramEnd::kAlarm : its.end;
  }
  merge_.finish(last_s);
  for (const Channel& channel : channels_) {
    const InterpretSummary& its = channel.control->summary();
    total_.blocks += its.blocks;
    total_.errors += its.errors;
    total_.warnings += its.warnings;
  }
  return total_;
}

}  // namespace proveout::nc
