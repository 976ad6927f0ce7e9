#include "core/nc/control/program_source.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace proveout {
namespace {

std::string lowered(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::string stemOf(std::string_view name) {
  const auto dot = name.rfind('.');
  return lowered(dot == std::string_view::npos ? name : name.substr(0, dot));
}

std::string_view lastPart(std::string_view path) {
  const auto slash = path.rfind('/');
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

}  // namespace

Error noneOf(const SubprogramQuery& query, const std::string& where) {
  std::string names, endings;
  for (const std::string& stem : query.stems) names += (names.empty() ? "" : ", ") + stem;
  for (const std::string& ending : query.extensions) {
    if (!ending.empty()) endings += (endings.empty() ? "" : " ") + ending;
  }
  return inputError("neither this file nor " + where + " have it; names looked for: " + names +
                    ", alone and with " + endings);
}

std::string systemFolder(int channel) {
  return channel > 0 ? "SystemMacros/Channel" + std::to_string(channel) + "/" : std::string();
}

MemoryProgramSource::MemoryProgramSource(std::string main_name, std::string main_bytes)
    : main_{main_name, main_name, std::move(main_bytes)} {}

void MemoryProgramSource::add(const std::string& name, std::string bytes) {
  subprograms_.push_back({name, name, std::move(bytes)});
}

Result<ProgramText> MemoryProgramSource::mainProgram() const { return main_; }

Result<ProgramText> MemoryProgramSource::subprogram(const SubprogramQuery& query) const {
  const std::string folder = systemFolder(query.system_channel);
  for (const std::string& stem : query.stems) {
    for (const ProgramText& text : subprograms_) {
      if (stemOf(text.name) == lowered(folder + stem)) return text;
    }
  }
  for (const ProgramText& text : subprograms_) {
    if (!query.path.empty() && lowered(text.name) == lowered(lastPart(query.path))) return text;
  }
  if (!query.extensions.empty() && !query.stems.empty()) return noneOf(query, "the programs given");
  const std::string what = query.stems.empty() ? query.path : folder + query.stems.front();
  return inputError("program " + what + " is not among the programs given");
}

}  // namespace proveout
