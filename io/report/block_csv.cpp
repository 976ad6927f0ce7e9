// blocks.csv: what every block did, for spreadsheets. Commas between columns, points in numbers.
#include <fmt/format.h>

#include "core/base/printable.h"
#include "io/report.h"

namespace proveout {

namespace {

void appendNumber(const std::optional<double>& value, std::string& out) {
  out += ',';
  if (value) fmt::format_to(std::back_inserter(out), "{:.9g}", *value + 0.0);
}

}  // namespace

std::optional<double> CutFigures::area_mm2_min() const {
  return wire_mm2 > 0.0 && wire_s > 0.0 ? std::optional(60.0 * wire_mm2 / wire_s) : std::nullopt;
}

std::optional<double> CutFigures::engagement_mm2() const {
  if (!(engaged_mm > 0.0)) return std::nullopt;
  return removed_mm3 / engaged_mm;
}

std::optional<double> CutFigures::rate_mm3_min() const {
  if (!(engaged_s > 0.0)) return std::nullopt;
  return 60.0 * removed_mm3 / engaged_s;
}

std::string blockCsvHeader() {
  return "setup,file,line,block,depth,tool,kind,start_s,time_s,length_mm,removed_mm3,engagement_mm2,rate_mm3_"
         "min,"
         "air_s\n";
}

void appendBlockCsv(const BlockFigures& row, std::string& out) {
  out += csvField(row.setup);
  out += ',';
  out += csvField(row.file);
  fmt::format_to(std::back_inserter(out), ",{},", row.line);
  if (row.block >= 0) fmt::format_to(std::back_inserter(out), "N{}", row.block);
  fmt::format_to(std::back_inserter(out), ",{},{},{}", row.depth, row.tool, row.kind);
  const CutFigures& f = row.figures;
  for (const std::optional<double> value :
       {std::optional(row.start_s), std::optional(f.time_s()), std::optional(f.length_mm),
        std::optional(f.removed_mm3), f.engagement_mm2(), f.rate_mm3_min(), std::optional(f.air_s)}) {
    appendNumber(value, out);
  }
  out += '\n';
}

}  // namespace proveout
