// Saved stocks as files: the same bytes for the same stock.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The bytes of the file of a stock with a slot and a bore in it.
std::string saved(double depth, int threads, const std::string& name) {
  RemovalOptions options;
  options.resolution_mm = 0.4;
  options.threads = threads;
  Progress progress;
  Result<Stock> stock = Stock::create(BoxShape{{0, 0, -20}, {40, 30, 0}}, options, progress);
  PathMaker path;
  path.line({-10, 11, -depth}, {50, 17, -depth}).line({20, 8, 5}, {20, 8, -9});
  EXPECT_TRUE(stock.ok() && stock->remove(path.path(), {tool("1=bull:6:1")}, options, progress).ok());
  const fs::path file = fs::temp_directory_path() / ("proveout-" + name + ".vdb");
  EXPECT_TRUE(stock->save(file.string()).ok());
  const std::string bytes = bytesOf(file);
  fs::remove(file);
  return bytes;
}

TEST(StockFile, TheSameStockGivesTheSameBytes) {
  const std::string first = saved(3.0, 1, "first"), again = saved(3.0, 1, "again");
  ASSERT_GT(first.size(), 1000u);
  EXPECT_TRUE(first == again);
  EXPECT_TRUE(first == saved(3.0, 4, "threads"));
}

TEST(StockFile, AnotherStockHasAnotherNumber) {
  // Magic number, versions, a flag: then the file's number as text.
  constexpr std::size_t kAt = 21, kDigits = 36;
  const std::string one = saved(3.0, 1, "one"), other = saved(3.5, 1, "other");
  const std::string number = one.substr(kAt, kDigits);
  EXPECT_NE(number, other.substr(kAt, kDigits));
  EXPECT_EQ(number.find_first_not_of("0123456789abcdef-"), std::string::npos) << number;
  EXPECT_EQ(number[14], '8') << number;  // the version of the number's form
}

}  // namespace
}  // namespace proveout::test
