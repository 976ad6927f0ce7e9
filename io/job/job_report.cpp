// [report] of a job file: the head of the report, its bands of deviation and its sections.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "io/job/job_sections.h"

namespace proveout {

namespace {

constexpr std::size_t kMostBandEdges = 15, kMostPlanes = 20, kMostHeadText = 200;

/// "2026-11-30".
bool isDate(const std::string& text) {
  int numbers[3] = {0, 0, 0};
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const std::pair<int, int> places[3] = {{0, 4}, {5, 7}, {8, 10}};
  for (int k = 0; k < 3; ++k) {
    const char *from = text.data() + places[k].first, *to = text.data() + places[k].second;
    if (const auto read = std::from_chars(from, to, numbers[k]); read.ec != std::errc() || read.ptr != to)
      return false;
  }
  using namespace std::chrono;
  return year_month_day(year(numbers[0]), month(static_cast<unsigned>(numbers[1])),
                        day(static_cast<unsigned>(numbers[2])))
      .ok();
}

/// The day that SOURCE_DATE_EPOCH names (https://reproducible-builds.org/specs/source-date-epoch), UTC.
/// Empty: it is not set, or no number of seconds.
std::string dateOfSource() {
  const char* text = std::getenv("SOURCE_DATE_EPOCH");
  if (text == nullptr) return {};
  const std::string_view digits(text);
  long long seconds = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), seconds);
  constexpr long long kYear9999 = 253'402'300'799;
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || seconds < 0 ||
      seconds > kYear9999)
    return {};
  const std::chrono::sys_days day(std::chrono::days(seconds / 86'400));
  const std::chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

void readHeadLines(ConfigTable& report, ReportWish& wish) {
  constexpr std::pair<const char*, const char*> kLines[] = {
      {"part_number", "Part number"},   {"drawing", "Drawing"},
      {"revision", "Drawing revision"}, {"program_revision", "Program revision"},
      {"customer", "Customer"},         {"machine", "Machine"},
      {"operator", "Operator"},         {"date", "Date"}};
  for (const auto& [key, label] : kLines) {
    auto text = report.text(key);
    if (!text || text->empty()) continue;
    if (text->size() > kMostHeadText)
      report.error(key, "job-range", fmt::format("{} may have {} characters at most", key, kMostHeadText));
    if (key == std::string_view("date") && !isDate(*text))
      report.error(key, "job-value", "date must be a day like \"2026-11-30\"");
    wish.head.push_back({key, label, std::move(*text)});
  }
}

void readBands(ConfigTable& report, ReportWish& wish) {
  const std::vector<ConfigValue>* edges = report.list("bands", kMostBandEdges);
  if (edges == nullptr) return;
  for (const ConfigValue& edge : *edges) {
    const auto value = readNumber(report.document(), edge, "an edge of bands", {-1e3, 1e3});
    if (!value) return;
    if (!wish.bands_mm.empty() && *value <= wish.bands_mm.back()) {
      report.error("bands", "job-value",
                   "bands must be edges in mm that ascend, like [-0.05, -0.02, 0.02, 0.05]");
      return;
    }
    wish.bands_mm.push_back(*value);
  }
  if (wish.bands_mm.size() == 1) report.error("bands", "job-value", "bands needs two edges or more");
}

void readPlanes(ConfigTable& report, ReportWish& wish) {
  const auto planes = report.texts("sections");
  if (!planes) return;
  if (planes->size() > kMostPlanes)
    report.error("sections", "job-range", fmt::format("sections may have {} planes at most", kMostPlanes));
  for (const std::string& text : *planes) {
    const std::size_t axis = text.empty() ? std::string::npos : std::string_view("XYZ").find(text.front());
    double at = 0.0;
    const char* end = text.data() + text.size();
    const bool good = axis != std::string::npos && text.size() > 1 && [&] {
      const auto read = std::from_chars(text.data() + 1, end, at);
      return read.ec == std::errc() && read.ptr == end;
    }() && std::abs(at) <= 1e6;
    if (!good) {
      report.error(
          "sections", "job-value",
          fmt::format("'{}' is no plane of a section: it is an axis and a place in mm, like \"X12.5\"",
                      text.substr(0, 40)));
      return;
    }
    wish.sections.push_back({static_cast<int>(axis), at});
  }
}

}  // namespace

void readReport(ConfigTable& root, Job& job) {
  auto report = root.table("report");
  if (report) {
    readHeadLines(*report, job.report);
    readBands(*report, job.report);
    readPlanes(*report, job.report);
    report->refuseOthers();
  }
  const auto isTheDate = [](const ReportHeadLine& line) { return line.key == "date"; };
  std::vector<ReportHeadLine>& head = job.report.head;
  std::string date = dateOfSource();
  if (!date.empty() && std::none_of(head.begin(), head.end(), isTheDate))
    head.push_back({"date", "Date", std::move(date)});
}

}  // namespace proveout
