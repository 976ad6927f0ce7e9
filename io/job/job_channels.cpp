// Channels of a job file: [[channel]].
#include <fmt/format.h>

#include <algorithm>

#include "io/job/job_sections.h"

namespace proveout {

namespace {

constexpr int kMostChannels = 8;
constexpr std::int64_t kMostTool = 99'999'999;

void readKind(ConfigTable& table) {
  const auto kind = table.choice("type", {"mill", "lathe"});
  if (kind && *kind == "lathe") {
    table.error("type", "job-unsupported",
                "a lathe channel has a control of its own, which this version does not simulate");
  }
}

/// What the channel says on top of what the job says.
ChannelSpec readChannel(ConfigTable& table, const JobNames& names, const Job& job) {
  Job part;
  part.control = job.control;
  part.settings = job.settings;
  part.settings.parameters.clear();
  part.start = job.start;
  readKind(table);
  if (const auto number = table.must("number").integer("number", 1, kMostChannels))
    part.settings.channel = static_cast<int>(*number);
  readProgram(table, part);
  if (part.filled) table.error("template", "job-unsupported", "a channel's program is no template");
  readOffsets(table, part);
  if (auto parameters = table.table("parameters")) readParameters(*parameters, names, part);
  part.settings.parameters.insert(job.settings.parameters.begin(), job.settings.parameters.end());
  if (const auto start = table.point("start")) part.start = *start;
  if (const auto tool = table.integer("tool", 1, kMostTool)) part.settings.tool = static_cast<int>(*tool);
  return {std::move(part.program), std::move(part.subprograms), std::move(part.settings), part.start};
}

}  // namespace

void readChannels(ConfigTable& root, const JobNames& names, Job& job) {
  std::vector<ConfigTable> tables = root.tables("channel");
  if (tables.empty()) {
    if (root.find("channel") != nullptr)
      root.error("channel", "job-value", "channel must hold at least one table, [[channel]]");
    return;
  }
  for (const char* key : {"program", "subprograms"}) {
    if (root.find(key) != nullptr)
      root.error(key, "job-value", fmt::format("with [[channel]], {} belongs to the channels", key));
  }
  if (root.find("template") != nullptr)
    root.error("template", "job-unsupported", "a channel's program is no template");
  if (root.find("setup") != nullptr)
    root.error("channel", "job-unsupported", "a job has channels or setups; both together are not supported");
  for (ConfigTable& table : tables) {
    ChannelSpec spec = readChannel(table, names, job);
    const auto same = [&](const ChannelSpec& other) {
      return other.settings.channel == spec.settings.channel;
    };
    if (spec.settings.channel > 0 && std::any_of(job.channels.begin(), job.channels.end(), same)) {
      table.error("number", "job-value",
                  fmt::format("there are two channels with the number {}", spec.settings.channel));
    }
    table.refuseOthers();
    job.channels.push_back(std::move(spec));
  }
  std::sort(job.channels.begin(), job.channels.end(), [](const ChannelSpec& a, const ChannelSpec& b) {
    return a.settings.channel < b.settings.channel;
  });
  job.program = job.channels.front().program;
  job.subprograms = job.channels.front().subprograms;
  job.start = job.channels.front().start;
}

}  // namespace proveout
