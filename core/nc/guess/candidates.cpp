#include "core/nc/guess/candidates.h"

#include <cmath>

namespace proveout::nc::guess {
namespace {

constexpr std::string_view kNctCodes =
    "0-4 5.1 7.1 9-11 10.9 12.1 13.1 15-23 28 30 31 33 37 38 39 40-42 43 43.1 43.4 43.5 43.7-43.9 44 49 50 "
    "50.1 51 51.1 51.2 52 53 53.1 53.6 54-59 54.1 54.2 61-67 66.1 68 68.1 68.2 69 69.1 70.7-79.7 73 74 76 "
    "80-89 "
    "80.8 81.8 83.1 84.1-84.3 86.1 90 91 92 94-99";
constexpr std::string_view kFanucMillCodes =
    "0-4 2.2 2.3 2.4 3.2-3.4 10.6 5 5.1 6.2 7.1 8 9 10-11 12.1 13.1 15-23 27-31 33 37 39 40-42 40.1 41.1 "
    "42.1 43 "
    "43.1 43.4 "
    "43.5 43.7 44-49 50 50.1 51 51.1 52 53 53.1 54-59 54.1 54.2 54.4 60 61-64 65 66 66.1 67 68 68.2 69 73 74 "
    "76 80-89 "
    "81.1 84.2 84.3 90-99 90.1 92.1 112 113 107";
constexpr std::string_view kHaasMillCodes =
    "0-4 9-13 17-21 28-31 35-37 40-44 47 49-52 53-59 60 61 64 65 68-74 76 77 80-89 90-95 98-103 107 110-129 "
    "136 141 "
    "143 150 154 174 184 187 234 254 255 268 269 43.4 54.1";
constexpr std::string_view kFanucLatheCodes =
    "0-4 7.1 9-11 12.1 13.1 15-23 27-34 36 37 40-42 50 50.2 50.3 51.2 52-59 53 54.1 61-67 65 66 68-69 70-76 "
    "80 83-85 "
    "87-89 90 92 94 96-99 107 112 113 91 95 77-79 92.1 33 39 43 44 49 50.1 51.1 66.1 68.1 69.1 2.2-2.4 "
    "3.2-3.4 5 5.1 6.2 8 10.6 60 93 40.1 41.1 42.1 43.4 43.5 45-48 53.1 54.2 68.2";
constexpr std::string_view kHaasLatheCodes =
    "0-4 9 10 14 15 17-21 28-32 40-42 50-59 61 64 65 70-76 80-90 92 94-99 100-103 105 110-129 112 113 154 "
    "159-161 "
    "184 186-189 195 196 200 211 212 241-249 266 53 107";
constexpr std::string_view kLinuxCncCodes =
    "0-4 5 5.1-5.3 6.2 6.3 7 8 10 17-21 17.1 18.1 19.1 28 28.1 30 30.1 33 33.1 37 38.2-38.5 47 40-42 41.1 "
    "42.1 43 "
    "43.1 43.2 49 "
    "52 53 54-59 59.1-59.3 61 61.1 64 70-72 71.1 71.2 72.1 72.2 73 74 76 80-89 84.2 84.3 90-99 90.1 91.1 "
    "92.1-92.3";
constexpr std::string_view kGrblCodes =
    "0-4 10 17-21 28 28.1 30 30.1 38.2-38.5 40 43.1 49 53 54-59 61 80 90-94 91.1 92.1";
constexpr std::string_view kMach3Codes =
    "0-4 10 12 13 15-21 28 28.1 30 31 32 40-43 49-59 61 64 65 68 69 73 76 77 80-89 90-99 90.1 91.1 92.1-92.3";
constexpr std::string_view kWl4Codes = "0-4 9 12 13 17-19 31-33 36 38 40-44 49 50 51 53-60 63 64 70-92 94-97";
constexpr std::string_view kFlexNcCodes =
    "0-4 3.1 5 8.1 12 12.1-12.3 12.5 13 13.1 13.2 13.5 17-19 22.1-22.3 23.1-23.4 30 40-42 52 76 77 77.1-77.3 "
    "79 79.1 "
    "79.2 80 81 81.1-81.3 86 87 90-92 98 99";
constexpr std::string_view kWedmCodes = "0-6 8 9 11 12 20 21 28-31 34-37 40-42 50-52 54-61 74 75 90-92";

int tenthsOf(std::string_view text, std::size_t& at) {
  int value = 0;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') value = 10 * value + (text[at++] - '0');
  value *= 10;
  if (at + 1 < text.size() && text[at] == '.') {
    value += text[at + 1] - '0';
    at += 2;
  }
  return value;
}

}  // namespace

const std::array<Candidate, kCandidateCount>& candidates() {
  static const std::array<Candidate, kCandidateCount> kAll{{
      {kNct, ControlId::kNct, "", kNctCodes},
      {kFanucMill, ControlId::kFanucMill, "", kFanucMillCodes},
      {kHaasMill, ControlId::kFanucMill, "haas", kHaasMillCodes},
      {kFanucLathe, ControlId::kFanucLathe, "", kFanucLatheCodes},
      {kHaasLathe, ControlId::kFanucLathe, "haas", kHaasLatheCodes},
      {kLinuxCnc, ControlId::kLinuxCnc, "", kLinuxCncCodes},
      {kGrbl, ControlId::kLinuxCnc, "grbl", kGrblCodes},
      {kMach3, ControlId::kLinuxCnc, "mach3", kMach3Codes},
      {kWl4Mill, ControlId::kWl4Mill, "", kWl4Codes},
      {kWl4Lathe, ControlId::kWl4Lathe, "", kWl4Codes},
      {kFlexNc, ControlId::kFlexNc, "", kFlexNcCodes},
      {kWedm, ControlId::kWedm, "", kWedmCodes},
  }};
  return kAll;
}

bool hasCode(std::string_view codes, int tenths) {
  for (std::size_t at = 0; at < codes.size(); ++at) {
    const int first = tenthsOf(codes, at);
    int last = first;
    if (at < codes.size() && codes[at] == '-') last = tenthsOf(codes, ++at);
    // A range of whole codes has no decimal ones: 54.1 is not in 54-59.
    const int step = first % 10 == 0 && last % 10 == 0 ? 10 : first / 10 == last / 10 ? 1 : 10;
    if (tenths >= first && tenths <= last && (tenths - first) % step == 0) return true;
  }
  return false;
}

}  // namespace proveout::nc::guess
