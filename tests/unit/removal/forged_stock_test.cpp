// Stock files whose checksum is right and whose contents are not those of a stock: each is refused with its
// reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

#include "removal/grid/stock.h"
#include "removal/vdb/vdb_extern.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A saved stock, open for changes.
struct Contents {
  openvdb::MetaMap meta;
  openvdb::GridPtrVec grids;

  template <typename Grid>
  Grid& grid(const std::string& name) {
    for (const auto& grid : grids) {
      if (grid->getName() == name) return dynamic_cast<Grid&>(*grid);
    }
    throw std::runtime_error("no grid " + name);
  }
  openvdb::FloatGrid::TreeType& distance() { return grid<openvdb::FloatGrid>("distance").tree(); }
  void number(const std::string& name, double value) {
    meta.removeMeta(name);
    meta.insertMeta(name, openvdb::DoubleMetadata(value));
  }
  void vector(const std::string& name, double x, double y, double z) {
    meta.removeMeta(name);
    meta.insertMeta(name, openvdb::Vec3DMetadata(openvdb::Vec3d(x, y, z)));
  }
};
using Change = std::function<void(Contents&)>;

class ForgedStock : public ::testing::Test {
 protected:
  ForgedStock() : folder_(fs::temp_directory_path() / ("proveout-forged-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    openvdb::initialize();
    Progress progress;
    RemovalOptions options;
    options.resolution_mm = 0.5;
    const Result<Stock> stock = Stock::create(BoxShape{{0, 0, 0}, {20, 15, 10}}, options, progress);
    EXPECT_TRUE(stock.ok() && stock->save(path("good.vdb")).ok());
  }
  ~ForgedStock() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  static std::string bytesOf(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  /// The file with these changes and the checksum that belongs to it (FNV-1a, 64 bits).
  Result<Stock> load(const Change& change, double max_memory_gb = 1.0) {
    Contents contents;
    openvdb::io::File good(path("good.vdb"));
    good.open(false);
    contents.meta = *good.getMetadata();
    contents.grids = *good.getGrids();
    good.close();
    change(contents);
    openvdb::io::File file(path("forged.vdb"));
    file.write(contents.grids, contents.meta);
    file.close();
    std::uint64_t sum = 14695981039346656037ull;
    for (const char c : bytesOf(path("forged.vdb")))
      sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(sum));
    std::ofstream(path("forged.vdb"), std::ios::binary | std::ios::app) << "proveout" << digits;
    RemovalOptions options;
    options.max_memory_gb = max_memory_gb;
    Progress progress;
    return Stock::create(SavedStock{path("forged.vdb")}, options, progress);
  }
  std::string refusal(const Change& change) {
    const Result<Stock> stock = load(change);
    return stock.ok() ? "taken" : stock.error().message;
  }

  fs::path folder_;
};

TEST_F(ForgedStock, UnchangedItIsTaken) {
  const Result<Stock> stock = load([](Contents&) {});
  ASSERT_TRUE(stock.ok()) << stock.error().message;
  Progress progress;
  EXPECT_NEAR(stock->volume({}, progress)->mm3, 20 * 15 * 10, 1e-3);
}

TEST_F(ForgedStock, MetadataMustBeThoseOfAGrid) {
  const std::string wrong = "its metadata are out of range";
  for (const double h : {0.0, -0.5, kInfinite, std::nan(""), 1e-9, 1e-300})
    EXPECT_THAT(refusal([&](Contents& c) { c.number("resolution", h); }), HasSubstr(wrong)) << h;
  for (const double v : {0.0, -1.0, kInfinite, std::nan("")})
    EXPECT_THAT(refusal([&](Contents& c) { c.number("initial_volume", v); }), HasSubstr(wrong)) << v;
  for (const double x : {kInfinite, std::nan(""), 1e12, -1e300}) {
    EXPECT_THAT(refusal([&](Contents& c) { c.vector("origin", 0, x, 0); }), HasSubstr(wrong)) << x;
    EXPECT_THAT(refusal([&](Contents& c) { c.vector("blank_max", 20, 15, x); }), HasSubstr(wrong)) << x;
  }
  EXPECT_THAT(refusal([](Contents& c) { c.vector("blank_min", 30, 0, 0); }), HasSubstr(wrong));
  EXPECT_THAT(refusal([](Contents& c) { c.meta.removeMeta("blank_min"); }),
              HasSubstr("not a readable stock"));
}

TEST_F(ForgedStock, ALargeGridMeetsTheMemoryAllowed) {
  const Result<Stock> stock = load([](Contents& c) {
    c.vector("blank_min", -4e6, -4e6, -4e6);
    c.vector("blank_max", 4e6, 4e6, 4e6);
  });
  ASSERT_FALSE(stock.ok());
  EXPECT_EQ(stock.error().kind, ErrorKind::kResourceLimit);
  EXPECT_THAT(stock.error().message, HasSubstr("more than the 1 GB of memory allowed"));
  const Result<Stock> small = load([](Contents&) {}, 1e-6);
  ASSERT_FALSE(small.ok());
  EXPECT_EQ(small.error().kind, ErrorKind::kResourceLimit);
}

TEST_F(ForgedStock, SamplesLieInTheBlank) {
  const openvdb::Coord far(1 << 20, 0, 0);
  for (const openvdb::Index level : {1u, 2u, 3u}) {
    EXPECT_THAT(refusal([&](Contents& c) { c.distance().addTile(level, far, -1.0f, false); }),
                HasSubstr("it reaches out of its blank"))
        << level;
  }
  EXPECT_THAT(refusal([&](Contents& c) { c.distance().setValue(far, -1.0f); }),
              HasSubstr("it reaches out of its blank"));
  // The same samples on another grid, or of another blank.
  for (const double h : {0.52, 10.0}) {
    EXPECT_THAT(refusal([&](Contents& c) { c.number("resolution", h); }),
                HasSubstr("it reaches out of its blank"))
        << h;
  }
  EXPECT_THAT(refusal([](Contents& c) { c.vector("origin", 0.2, 0.2, 1.2); }),
              HasSubstr("it reaches out of its blank"));
  EXPECT_THAT(refusal([](Contents& c) { c.vector("blank_min", 0, 0.5, 0); }),
              HasSubstr("it reaches out of its blank"));
}

TEST_F(ForgedStock, TheSurfaceHasNoHoles) {
  const auto outside = [](const openvdb::Coord& at) {
    return [=](Contents& c) { c.distance().addTile(1, at, 0.5f, false); };
  };
  // Voids without leaves around them, inside and at a face, and a leaf of a face that is none any more.
  for (const openvdb::Coord& at :
       {openvdb::Coord(16, 8, 8), openvdb::Coord(16, 8, 0), openvdb::Coord(16, 8, -8)})
    EXPECT_THAT(refusal(outside(at)), HasSubstr("its surface has a hole")) << at;
  // A leaf through which no surface goes.
  EXPECT_THAT(refusal([](Contents& c) {
                c.distance().touchLeaf({16, 8, 8});
              }),
              HasSubstr("its surface has a hole"));
}

TEST_F(ForgedStock, CrossingsLieOnTheirEdges) {
  const std::string wrong = "a crossing is missing or out of range";
  const auto change = [](const std::string& name, auto value) {
    return [=](Contents& c) {
      using Tree = typename openvdb::tree::Tree4<decltype(value), 5, 4, 3>::Type;
      Tree& tree = c.grid<openvdb::Grid<Tree>>(name).tree();
      tree.setValue(tree.cbeginLeaf()->beginValueOn().getCoord(), value);
    };
  };
  for (const float t : {0.0f, 1.0f, -1.0f, 2.0f, std::nanf("")})
    EXPECT_THAT(refusal(change("crossing_z_t", t)), HasSubstr(wrong)) << t;
  for (const float n : {1.2f, -1.2f, 1e30f, std::nanf("")})
    EXPECT_THAT(refusal(change("crossing_x_normal", openvdb::Vec3s(0, n, 0))), HasSubstr(wrong)) << n;
  for (const std::int32_t face : {-1, 70'000})
    EXPECT_THAT(refusal(change("crossing_y_element", face)), HasSubstr(wrong)) << face;
}

/// The distance of a sample to a face that its edge lies in is 0, which must not take the sample's side.
TEST_F(ForgedStock, NormalsSquareToTheirEdgesKeepTheSamples) {
  const Result<Stock> first = load([](Contents& c) {
    auto& normals = c.grid<openvdb::Vec3SGrid>("crossing_z_normal");
    for (auto it = normals.beginValueOn(); it; ++it) it.setValue(openvdb::Vec3s(1, 0, 0));
  });
  ASSERT_TRUE(first.ok()) << first.error().message;
  ASSERT_TRUE(first->save(path("again.vdb")).ok());
  Progress progress;
  const Result<Stock> again = Stock::create(SavedStock{path("again.vdb")}, {}, progress);
  ASSERT_TRUE(again.ok()) << again.error().message;
  ASSERT_TRUE(again->save(path("third.vdb")).ok());
  EXPECT_TRUE(bytesOf(path("again.vdb")) == bytesOf(path("third.vdb")));
}

}  // namespace
}  // namespace proveout
