#include "core/nc/control/channels.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/assert.h"

namespace proveout::nc {

std::string ChannelSet::text() const {
  std::string digits;
  for (int number = 1; number <= kMaxChannels; ++number) {
    if (has(number)) digits += fmt::format("{}", number);
  }
  return digits;
}

MotionSink& ChannelMerge::add(int number) {
  return *channels_.emplace_back(std::make_unique<Channel>(*this, number));
}

void ChannelMerge::Channel::file(std::uint32_t index, const std::string& name) {
  if (files.size() <= index) files.resize(index + 1);
  files[index] = merge.files_++;
  waiting.push_back({now_s, FileItem{files[index], name}});
}

SourceRef ChannelMerge::Channel::mapped(SourceRef source) const {
  if (source.file < files.size()) source.file = files[source.file];
  if (source.origins >= 0) {
    const auto set = static_cast<std::size_t>(source.origins);
    PROVEOUT_ASSERT(set < sets.size());  // a row comes before what refers to it
    source.origins = static_cast<std::int32_t>(sets[set]);
  }
  return source;
}

void ChannelMerge::Channel::originWord(const WordOrigin& word) {
  WordOrigin mapped_word = word;
  if (word.file < files.size()) mapped_word.file = files[word.file];
  merge.sink_.originWord(mapped_word);
}

void ChannelMerge::Channel::originData(const DataInForce& row) {
  data.push_back(merge.data_++);
  merge.sink_.originData(row);
}

void ChannelMerge::Channel::originModal(const ModalOrigins& row) {
  ModalOrigins mapped_row = row;
  PROVEOUT_ASSERT(row.data < data.size());
  mapped_row.data = data[row.data];
  modal.push_back(merge.modal_++);
  merge.sink_.originModal(mapped_row);
}

void ChannelMerge::Channel::originSet(const OriginSet& row) {
  OriginSet mapped_row = row;
  PROVEOUT_ASSERT(row.modal < modal.size());
  mapped_row.modal = modal[row.modal];
  sets.push_back(merge.sets_++);
  merge.sink_.originSet(mapped_row);
}

std::uint8_t ChannelMerge::Channel::told() const {
  return merge.channels_.size() > 1 ? static_cast<std::uint8_t>(number) : std::uint8_t{0};
}

void ChannelMerge::Channel::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
  MotionItem item{motion, nullptr, nullptr};
  item.motion.channel = told();
  item.motion.source = mapped(motion.source);
  if (arc) item.arc = std::make_unique<ArcGeometry>(*arc);
  if (axis) item.axis = std::make_unique<AxisSweep>(*axis);
  waiting.push_back({now_s, std::move(item)});
  now_s += motion.time_s;
}

void ChannelMerge::Channel::event(const PathEvent& event) {
  PathEvent item = event;
  item.channel = told();
  item.source = mapped(event.source);
  // A channel that waited knows of it when it goes on: only then the event is in order.
  const double start = event.as<event::Wait>() != nullptr ? now_s + event.time_s : now_s;
  waiting.push_back({start, std::move(item)});
  now_s += event.time_s;
}

void ChannelMerge::Channel::diagnostic(const Diagnostic& diagnostic) {
  Diagnostic item = diagnostic;
  if (told() > 0) item.notes.push_back(fmt::format("in channel {}", number));
  waiting.push_back({now_s, std::move(item)});
}

ChannelMerge::Channel* ChannelMerge::earliest() const {
  Channel* first = nullptr;
  for (const auto& channel : channels_) {
    if (channel->waiting.empty()) continue;
    if (first == nullptr || channel->waiting.front().start_s < first->waiting.front().start_s)
      first = channel.get();
  }
  return first;
}

void ChannelMerge::pass(const Item& item) {
  double time = 0.0;
  if (const auto* motion = std::get_if<MotionItem>(&item.what)) {
    sink_.motion(motion->motion, motion->arc.get(), motion->axis.get());
    time = motion->motion.time_s;
    ++total_.motions;
    (motion->motion.kind == MotionKind::kRapid ? total_.rapid_s : total_.cutting_s) += time;
  } else if (const auto* event = std::get_if<PathEvent>(&item.what)) {
    sink_.event(*event);
    time = event->as<event::Wait>() != nullptr ? 0.0 : event->time_s;
  } else if (const auto* file = std::get_if<FileItem>(&item.what)) {
    sink_.file(file->index, file->name);
  } else {
    sink_.diagnostic(std::get<Diagnostic>(item.what));
  }
  total_.cycle_s = std::max(total_.cycle_s, item.start_s + time);
}

void ChannelMerge::passBefore(double limit_s) {
  for (Channel* next = earliest(); next && next->waiting.front().start_s < limit_s; next = earliest()) {
    pass(next->waiting.front());
    next->waiting.pop_front();
  }
}

void ChannelMerge::finish(double last_s) {
  for (Channel* next = earliest(); next; next = earliest()) {
    const Item& item = next->waiting.front();
    const bool moves =
        std::holds_alternative<MotionItem>(item.what) || std::holds_alternative<PathEvent>(item.what);
    if (item.start_s <= last_s || !moves) pass(item);
    next->waiting.pop_front();
  }
  // What began before the end of a run that was stopped is cut off there.
  total_.cycle_s = std::min(total_.cycle_s, last_s);
}

}  // namespace proveout::nc
