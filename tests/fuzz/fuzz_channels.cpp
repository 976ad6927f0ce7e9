// Feeds any bytes to several channels of the nct control. The first byte says how many; their programs, and
// behind them subprograms that all may call, are cut out of the rest. One path must come out, the same one
// twice, and of one channel that of the control alone.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tests/fuzz/checking_sink.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

constexpr std::size_t kMostPrograms = 3;

std::vector<std::string> cutUp(const std::string& bytes) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::size_t end = bytes.find('~', at);
    parts.push_back(bytes.substr(at, end == std::string::npos ? end : end - at));
    at = end == std::string::npos ? end : end + 1;
  }
  return parts;
}

ControlSettings settingsOf(int channel, std::size_t size) {
  ControlSettings settings;
  settings.channel = channel;
  settings.tool = size % 3 == 0 ? 0 : channel;
  settings.block_limit = 300;
  settings.max_errors = 20;
  settings.lenient = size % 2 == 0;
  settings.acceleration_mm_s2 = Vec3::Constant(size % 5 < 2 ? 800.0 : 0.0);
  settings.radius_offsets[1] = {5.0, 0.0};
  settings.length_offsets[1] = {50.0, 0.0};
  settings.work_offsets[1] = Vec3(100, 20, -3 * channel);
  settings.limits[0] = AxisLimit{-500, 500};
  settings.parameters = {{"N2201", 500}, {"N2202", 520}};
  return settings;
}

struct Run {
  InterpretSummary summary;
  std::size_t sum = 0;
  double end_s = 0.0;
};

Run run(const std::vector<ChannelProgram>& programs) {
  CheckingSink sink;
  MemoryOutput output;
  ControlHost host;
  host.output = &output;
  Run out;
  out.summary = interpretChannels(ControlId::kNct, programs, sink, nullptr, host);
  out.sum = sink.sum();
  out.end_s = sink.end_s();
  return out;
}

std::size_t runAlone(const ChannelProgram& program) {
  CheckingSink sink;
  MemoryOutput output;
  ControlHost host;
  host.output = &output;
  interpret(ControlId::kNct, *program.source, program.settings, sink, nullptr, host);
  return sink.sum();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t count = data[0] % kMostPrograms + 1;
  std::vector<std::string> parts = cutUp({reinterpret_cast<const char*>(data) + 1, size - 1});
  if (parts.size() < count) parts.resize(count);
  std::vector<std::unique_ptr<MemoryProgramSource>> sources;
  std::vector<ChannelProgram> programs;
  for (std::size_t k = 0; k < count; ++k) {
    const int number = static_cast<int>(k) + 1;
    sources.push_back(
        std::make_unique<MemoryProgramSource>("channel" + std::to_string(number) + ".nc", parts[k]));
    for (std::size_t i = count; i < parts.size() && i < count + 4; ++i)
      sources.back()->add("O001" + std::to_string(i - count + 1) + ".nc", parts[i]);
    programs.push_back({sources.back().get(), settingsOf(number, size)});
  }
  const Run first = run(programs), second = run(programs);
  require(first.sum == second.sum && first.summary.cycle_s == second.summary.cycle_s,
          "the same programs give the same path");
  require(first.summary.end != ProgramEnd::kCancelled && first.summary.errors >= 0, "runs come to an end");
  if (first.summary.ok())
    require(first.end_s <= first.summary.cycle_s * (1.0 + 1e-9) + 1e-9,
            "the cycle ends with the last channel");
  if (count == 1)
    require(first.sum == runAlone(programs.front()), "one channel goes the way of the control alone");
  return 0;
}
