// findings.csv and points.csv: tables for spreadsheets and statistics (RFC 4180 with the line ends of
// blocks.csv: commas, LF, quotes where needed; UTF-8). Numbers have points; what is not known is empty.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/report.h"

namespace proveout {

/// The line of column names and a line for each finding, in their order and numbered from 1 as in the report.
std::string findingsCsv(const std::vector<Finding>& findings);

/// A row of points.csv.
struct DeviationPoint {
  Vec3 at = Vec3::Zero();        ///< of the machined surface, mm; float
  double deviation_mm = 0.0;     ///< > 0: material left over; < 0: missing
  Vec3 normal = Vec3::Zero();    ///< outward normal of the nominal at the nearest point, unit
  double tolerance_mm = 0.0;     ///< that it is beyond, > 0
  std::string_view feature;      ///< of the CAD model; empty: none is known
  std::string_view setup, file;  ///< empty: none
  std::int64_t line = -1, block = -1, tool = -1;  ///< -1: none
};
std::string pointsCsvHeader();
void appendPointsCsv(const DeviationPoint& point, std::string& out);

}  // namespace proveout
