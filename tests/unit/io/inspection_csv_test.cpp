// findings.csv and points.csv, read back by a reader of RFC 4180.
#include "io/exchange/inspection_csv.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace proveout {
namespace {

using CsvTable = std::vector<std::vector<std::string>>;

/// Rows of fields, by the grammar of RFC 4180, section 2, with LF as the line end: a field in quotes may hold
/// anything.
CsvTable parseCsv(const std::string& text) {
  CsvTable rows(1);
  std::string field;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (quoted) {
      if (text[i] != '"') {
        field += text[i];
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        field += text[i++];
      } else {
        quoted = false;
      }
    } else if (text[i] == '"') {
      EXPECT_TRUE(field.empty()) << "a quote within a field";
      quoted = true;
    } else if (text[i] == ',' || text[i] == '\n') {
      rows.back().push_back(std::exchange(field, {}));
      if (text[i] == ',') continue;
      rows.emplace_back();
    } else {
      EXPECT_NE(text[i], '\r') << "a CR outside of quotes";
      field += text[i];
    }
  }
  EXPECT_FALSE(quoted);
  EXPECT_TRUE(rows.back().empty()) << "the last line has no end";
  rows.pop_back();
  return rows;
}

std::string at(const CsvTable& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table[0].begin(), table[0].end(), column);
  EXPECT_NE(found, table[0].end()) << column;
  return found == table[0].end() ? "" : table[row].at(static_cast<std::size_t>(found - table[0].begin()));
}

TEST(FindingsCsv, HasARowForEachFinding) {
  Finding gouge(FindingKind::kGouge);
  gouge.where = Vec3(1.5, -2.25, 0.1);
  gouge.depth_mm = 0.123456789;
  gouge.area_mm2 = 12.0;
  gouge.volume_mm3 = 0.5;
  gouge.bound_mm = 0.001;
  gouge.tool = 3;
  gouge.setup = "top, \"A\"";
  gouge.feature = "hole of diameter 8 at X20.000 Y20.000";
  gouge.source = BlockRef{"sub/a,b.nc", 12, 120, 0, "G1 X5"};
  gouge.message = "0.12 mm below nominal; it says \"why\",\nand more";
  const Finding bare(FindingKind::kNothingCut);
  const CsvTable table = parseCsv(findingsCsv({gouge, bare}));
  ASSERT_EQ(table.size(), 3u);
  for (const auto& row : table) EXPECT_EQ(row.size(), table[0].size());
  EXPECT_EQ(at(table, 1, "number"), "1");
  EXPECT_EQ(at(table, 1, "kind"), "gouge");
  EXPECT_EQ(at(table, 1, "severity"), "error");
  EXPECT_EQ(at(table, 1, "feature"), gouge.feature);
  EXPECT_EQ(at(table, 1, "setup"), gouge.setup);
  EXPECT_EQ(at(table, 1, "file"), "sub/a,b.nc");
  EXPECT_EQ(at(table, 1, "line"), "12");
  EXPECT_EQ(at(table, 1, "block"), "N120");
  EXPECT_EQ(at(table, 1, "tool"), "3");
  EXPECT_EQ(at(table, 1, "x"), "1.5");
  EXPECT_EQ(at(table, 1, "y"), "-2.25");
  EXPECT_EQ(at(table, 1, "depth_mm"), "0.123456789");
  EXPECT_EQ(at(table, 1, "area_mm2"), "12");
  EXPECT_EQ(at(table, 1, "volume_mm3"), "0.5");
  EXPECT_EQ(at(table, 1, "bound_mm"), "0.001");
  EXPECT_EQ(at(table, 1, "message"), "0.12 mm below nominal; it says \"why\",\\nand more");
  EXPECT_EQ(at(table, 2, "number"), "2");
  EXPECT_EQ(at(table, 2, "kind"), "nothing_cut");
  for (const char* column : {"file", "line", "block", "tool", "x", "depth_mm", "bound_mm", "feature"})
    EXPECT_EQ(at(table, 2, column), "") << column;
}

TEST(FindingsCsv, OfNoFindingHasColumnNamesOnly) { EXPECT_EQ(parseCsv(findingsCsv({})).size(), 1u); }

TEST(PointsCsv, HasARowForEachPoint) {
  DeviationPoint point;
  point.at = {1, 2, -3.0625};
  point.deviation_mm = -0.125;
  point.normal = {0, 0, 1};
  point.tolerance_mm = 0.02;
  point.feature = "plane at Z5.000";
  point.file = "a.nc";
  point.line = 7;
  point.tool = 0;
  std::string text = pointsCsvHeader();
  appendPointsCsv(point, text);
  appendPointsCsv(DeviationPoint(), text);
  const CsvTable table = parseCsv(text);
  ASSERT_EQ(table.size(), 3u);
  for (const auto& row : table) EXPECT_EQ(row.size(), table[0].size());
  EXPECT_EQ(at(table, 1, "z"), "-3.0625");
  EXPECT_EQ(at(table, 1, "deviation_mm"), "-0.125");
  EXPECT_EQ(at(table, 1, "nz"), "1");
  EXPECT_EQ(at(table, 1, "tolerance_mm"), "0.02");
  EXPECT_EQ(at(table, 1, "feature"), "plane at Z5.000");
  EXPECT_EQ(at(table, 1, "line"), "7");
  EXPECT_EQ(at(table, 1, "block"), "");
  EXPECT_EQ(at(table, 1, "tool"), "0");
  EXPECT_EQ(at(table, 2, "line"), "");
}

}  // namespace
}  // namespace proveout
