#include "io/exchange/inspection_csv.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/printable.h"

namespace proveout {
namespace {

/// One line of a table.
class CsvRow {
 public:
  explicit CsvRow(std::string& out) : out_(out) {}
  void text(std::string_view value) {
    next();
    out_ += csvField(value);
  }
  /// A coordinate that is single precision: the shortest text that reads back as it.
  void single(double value) {
    next();
    if (std::isfinite(value))
      fmt::format_to(std::back_inserter(out_), "{}", static_cast<float>(value) + 0.0F);
  }
  void number(std::optional<double> value) {
    next();
    if (value && std::isfinite(*value)) fmt::format_to(std::back_inserter(out_), "{:.9g}", *value + 0.0);
  }
  void whole(std::optional<std::int64_t> value) {
    next();
    if (value && *value >= 0) fmt::format_to(std::back_inserter(out_), "{}", *value);
  }
  /// Column of N numbers, as in blocks.csv.
  void block(std::int64_t number) {
    next();
    if (number >= 0) fmt::format_to(std::back_inserter(out_), "N{}", number);
  }
  void end() { out_ += "\n"; }

 private:
  void next() {
    if (!first_) out_ += ',';
    first_ = false;
  }
  std::string& out_;
  bool first_ = true;
};

}  // namespace

std::string findingsCsv(const std::vector<Finding>& findings) {
  std::string out =
      "number,kind,severity,feature,setup,file,line,block,tool,x,y,z,depth_mm,area_mm2,volume_mm3,bound_mm,"
      "spots,known,message\n";
  std::int64_t number = 0;
  for (const Finding& f : findings) {
    CsvRow row(out);
    row.whole(++number);
    row.text(findingKindName(f.kind));
    row.text(severityName(f.severity));
    row.text(f.feature);
    row.text(f.setup);
    row.text(f.source ? f.source->file : std::string());
    row.whole(f.source && f.source->line > 0 ? std::optional<std::int64_t>(f.source->line) : std::nullopt);
    row.block(f.source ? f.source->block : -1);
    row.whole(f.tool);
    for (int axis = 0; axis < 3; ++axis)
      row.number(f.where ? std::optional<double>((*f.where)[axis]) : std::nullopt);
    for (const std::optional<double>& value : {f.depth_mm, f.area_mm2, f.volume_mm3, f.bound_mm})
      row.number(value);
    row.whole(static_cast<std::int64_t>(f.spots));
    row.text(f.known ? "yes" : "no");
    row.text(f.message);
    row.end();
  }
  return out;
}

std::string pointsCsvHeader() {
  return "x,y,z,deviation_mm,nx,ny,nz,tolerance_mm,feature,setup,file,line,block,tool\n";
}

void appendPointsCsv(const DeviationPoint& point, std::string& out) {
  CsvRow row(out);
  constexpr double kDigits = 1e6;  // of normals: beyond them there is only rounding
  for (int axis = 0; axis < 3; ++axis) row.single(point.at[axis]);
  row.single(point.deviation_mm);
  for (int axis = 0; axis < 3; ++axis) row.number(std::round(kDigits * point.normal[axis]) / kDigits);
  row.number(point.tolerance_mm);
  row.text(point.feature);
  row.text(point.setup);
  row.text(point.file);
  row.whole(point.line);
  row.block(point.block);
  row.whole(point.tool);
  row.end();
}

}  // namespace proveout
