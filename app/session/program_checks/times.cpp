#include "app/session/program_checks/times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "io/report_text.h"

namespace proveout {
namespace {

constexpr double kLongMotion = 1800.0, kLongProgram = 86400.0;  ///< s
constexpr double kLongDwell = 60.0, kLongDwells = 30.0;         ///< s

double motionTime(const Toolpath& path) {
  double sum = 0.0;
  for (const Motion& motion : path.motions) sum += motion.time_s;
  return sum;
}

/// The word of a block that says so many seconds: "P" of "G4 P500". Empty: none does, the time is computed.
std::string wordOf(double seconds, const std::string& block) {
  for (std::size_t i = 0; i + 1 < block.size(); ++i) {
    if (std::isalpha(static_cast<unsigned char>(block[i])) == 0) continue;
    const char* const number = block.c_str() + i + 1;
    char* end = nullptr;
    const double value = std::strtod(number, &end);
    if (end != number && std::abs(value - seconds) <= 1e-9 * seconds) return block.substr(i, 1);
  }
  return {};
}

}  // namespace

void addLongMotions(const CheckedProgram& program, std::vector<Finding>& findings) {
  const auto& motions = program.path.motions;
  const auto longest = std::max_element(motions.begin(), motions.end(),
                                        [](const Motion& a, const Motion& b) { return a.time_s < b.time_s; });
  if (longest == motions.end()) return;
  const double sum = motionTime(program.path);
  if (longest->time_s <= kLongMotion && sum <= kLongProgram) return;
  Finding finding =
      findingAt(FindingKind::kCycleTime, static_cast<MotionId>(longest - motions.begin()), program);
  finding.message =
      fmt::format("this motion alone takes {}, the motions of the program {}: is the feed right?",
                  report_text::duration(longest->time_s), report_text::duration(sum));
  findings.push_back(std::move(finding));
}

void addLongDwells(const CheckedProgram& program, std::vector<Finding>& findings) {
  const Toolpath& path = program.path;
  const Toolpath::EventAt* longest = nullptr;
  double sum = 0.0, most = 0.0;
  std::size_t count = 0;
  for (const Toolpath::EventAt& at : path.events) {
    const auto* dwell = at.event.as<event::Dwell>();
    if (dwell == nullptr) continue;
    ++count;
    sum += dwell->seconds;
    if (dwell->seconds <= most) continue;
    most = dwell->seconds;
    longest = &at;
  }
  const double motions_s = motionTime(path);
  if (longest == nullptr || (most <= kLongDwell && (sum <= kLongDwells || sum <= motions_s))) return;
  Finding finding(FindingKind::kDwell);
  finding.source = blockRef(path, longest->event.source, program.texts);
  finding.spots = count;
  finding.message = fmt::format("this dwell takes {}", report_text::duration(most));
  if (count > 1) finding.message += fmt::format(", all {} dwells {}", count, report_text::duration(sum));
  finding.message += fmt::format(", the motions of the program {}", report_text::duration(motions_s));
  if (const std::string word = wordOf(most, finding.source->text); !word.empty())
    finding.message +=
        fmt::format(": {} is read in seconds by this control; on other controls it is in milliseconds", word);
  findings.push_back(std::move(finding));
}

}  // namespace proveout
