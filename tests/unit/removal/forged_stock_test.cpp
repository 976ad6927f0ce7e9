// Stock files whose checksum is right and whose contents are not those of a stock: each is refused with its
// reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

#include "core/mesh/tri_mesh.h"
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
  bool placed = true;  ///< the grids get the frame of the metadata
  std::uint32_t compression = openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK;

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
    contents.grids.push_back(good.readGrid("distance"));  // in the order of the file
    for (const char axis : {'x', 'y', 'z'}) {
      for (const char* what : {"_t", "_normal", "_motion", "_element"})
        contents.grids.push_back(good.readGrid(std::string("crossing_") + axis + what));
    }
    good.close();
    change(contents);
    if (contents.placed) placeGrids(contents);
    openvdb::io::File file(path("forged.vdb"));
    file.setCompression(contents.compression);
    file.write(contents.grids, contents.meta);
    file.close();
    return loadBytes(bytesOf(path("forged.vdb")), max_memory_gb);
  }

  /// These bytes with the checksum that belongs to them (FNV-1a, 64 bits).
  Result<Stock> loadBytes(const std::string& bytes, double max_memory_gb = 1.0) {
    std::uint64_t sum = 14695981039346656037ull;
    for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(sum));
    std::ofstream(path("forged.vdb"), std::ios::binary) << bytes << "proveout" << digits;
    RemovalOptions options;
    options.max_memory_gb = max_memory_gb;
    Progress progress;
    return Stock::create(SavedStock{path("forged.vdb")}, options, progress);
  }
  static std::string said(const Result<Stock>& stock) { return stock.ok() ? "taken" : stock.error().message; }
  std::string refusal(const Change& change) { return said(load(change)); }
  std::string refusalOfBytes(const std::string& bytes) { return said(loadBytes(bytes)); }

  /// Gives the grids the frame that the metadata state, where it is one.
  static void placeGrids(Contents& contents) {
    const auto h = contents.meta.getMetadata<openvdb::DoubleMetadata>("resolution");
    const auto origin = contents.meta.getMetadata<openvdb::Vec3DMetadata>("origin");
    if (!h || !origin || !std::isfinite(h->value()) || std::abs(h->value()) < 1e-6) return;
    const openvdb::Vec3d at = origin->value();
    for (int i = 0; i < 3; ++i) {
      if (!(std::abs(at[i]) < 1e15)) return;
    }
    for (const auto& grid : contents.grids) {
      auto transform = openvdb::math::Transform::createLinearTransform(h->value());
      transform->postTranslate(origin->value());
      grid->setTransform(transform);
    }
  }

  /// A good file without its checksum.
  std::string goodBytes() const {
    std::string bytes = bytesOf(path("good.vdb"));
    bytes.resize(bytes.size() - 24);
    return bytes;
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

constexpr char kNotBuilt[] = "it is not built as a saved stock is";

/// Each metadatum with another type, of which OpenVDB's own reader makes assertions.
TEST_F(ForgedStock, MetadataHaveTheirTypes) {
  for (const char* name :
       {"blank_max", "blank_min", "initial_volume", "origin", "resolution", "schema", "unit"}) {
    const auto as = [&](const openvdb::Metadata& value) {
      return refusal([&](Contents& c) {
        c.meta.removeMeta(name);
        c.meta.insertMeta(name, value);
      });
    };
    for (const std::string& said :
         {as(openvdb::Int32Metadata(1)), as(openvdb::StringMetadata("1")), as(openvdb::FloatMetadata(1)),
          as(openvdb::BoolMetadata(true)), as(openvdb::Vec3SMetadata({1, 1, 1})),
          refusal([&](Contents& c) { c.meta.removeMeta(name); })})
      EXPECT_THAT(said, HasSubstr(kNotBuilt)) << name;
  }
  EXPECT_THAT(refusal([](Contents& c) { c.meta.insertMeta("more", openvdb::Int32Metadata(1)); }),
              HasSubstr(kNotBuilt));
}

TEST_F(ForgedStock, GridsAreThoseThatAreSaved) {
  const std::vector<Change> changes = {
      [](Contents& c) { c.grids.pop_back(); },
      [](Contents& c) { std::swap(c.grids[1], c.grids[2]); },
      [](Contents& c) { c.grids.push_back(openvdb::BoolGrid::create()); },
      [](Contents& c) { c.grids[0]->setGridClass(openvdb::GRID_FOG_VOLUME); },
      [](Contents& c) { c.grids[1]->setGridClass(openvdb::GRID_STAGGERED); },
      [](Contents& c) { c.grids[0]->setSaveFloatAsHalf(true); },
      [](Contents& c) { c.grids[3]->insertMeta("more", openvdb::StringMetadata("x")); },
      [](Contents& c) {
        c.grids[1] = openvdb::Int32Grid::create();
        c.grids[1]->setName("crossing_x_t");
      },
      [](Contents& c) {
        c.placed = false;
        c.grids[5]->setTransform(openvdb::math::Transform::createLinearTransform(0.7));
      },
      [](Contents& c) { c.grids[2]->setName("crossing_x_t"); },
      [](Contents& c) { c.compression = openvdb::io::COMPRESS_ZIP; },
      [](Contents& c) { c.compression = openvdb::io::COMPRESS_NONE; },
      [](Contents& c) {  // one tree for two grids
        auto shared = openvdb::gridPtrCast<openvdb::FloatGrid>(c.grids[1])->copy();
        shared->setName("crossing_y_t");
        c.grids[5] = shared;
      },
  };
  for (std::size_t k = 0; k < changes.size(); ++k)
    EXPECT_THAT(refusal(changes[k]), HasSubstr(kNotBuilt)) << "change " << k;
}

/// Counts, lengths and places that are read before what they are of.
TEST_F(ForgedStock, NumbersInTheFileAreNotTrusted) {
  const std::string good = goodBytes();
  ASSERT_EQ(refusalOfBytes(good), "taken");
  const std::size_t transform = good.find("UniformScaleTranslateMap");
  const std::size_t tree = transform + std::string("UniformScaleTranslateMap").size() + 18 * sizeof(double);
  const std::size_t delayed = good.find("file_delayed_load");
  const std::size_t grid = good.find("distance");
  ASSERT_NE(transform, std::string::npos);
  ASSERT_NE(delayed, std::string::npos);
  const std::size_t root = tree + 8;  // buffers and the background
  const std::vector<std::pair<std::size_t, const char*>> places = {
      {0, "the magic number"},
      {8, "the version"},
      {20, "whether grids have places"},
      {57, "how many metadata"},
      {61, "the length of a name"},
      {grid - 8, "how many grids"},
      {grid - 4, "the length of a grid's name"},
      {grid + 32, "where a grid is"},
      {grid + 40, "where its values are"},
      {grid + 48, "where it ends"},
      {transform - 4, "the length of a map's name"},
      {tree, "how many buffers"},
      {root, "how many tiles"},
      {root + 4, "how many nodes"},
      {root + 8, "where a node is"},
      {delayed + 17, "the length of a type"},
  };
  for (const auto& [at, what] : places) {
    for (const std::uint32_t value : {0u, 3u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
      std::string bytes = good;
      std::memcpy(bytes.data() + at, &value, sizeof value);
      if (bytes == good) continue;
      const std::string said = refusalOfBytes(bytes);
      EXPECT_THAT(said, HasSubstr("not a readable stock")) << what << " " << value;
    }
  }
  for (const std::size_t size :
       {0ul, 1ul, 20ul, 57ul, grid, transform, tree, root + 8, good.size() / 2, good.size() - 1})
    EXPECT_NE(refusalOfBytes(good.substr(0, size)), "taken") << size;
  EXPECT_NE(refusalOfBytes(good + std::string(100, 'x')), "taken");
}

/// No byte of a file, changed, ends the process: what is taken is a stock.
TEST_F(ForgedStock, AnyByteMayBeWrong) {
  const std::string good = goodBytes();
  Progress progress;
  std::uint64_t random = 88172645463325252ull;
  int refused = 0;
  for (int k = 0; k < 120; ++k) {
    std::string bytes = good;
    for (int change = 0; change < 3;) {
      random ^= random << 13, random ^= random >> 7, random ^= random << 17;
      const std::size_t at = random % bytes.size();
      if (bytes[at] == 0 && k % 3 != 0) continue;  // most of a file are zeros of masks
      bytes[at] = static_cast<char>(random >> 40);
      ++change;
    }
    const Result<Stock> stock = loadBytes(bytes);
    refused += !stock.ok();
    if (!stock) EXPECT_NE(stock.error().kind, ErrorKind::kInternal) << stock.error().message;
    if (stock) EXPECT_TRUE(analyseTopology(stock->surface(1, progress)->mesh).closedManifold()) << k;
  }
  EXPECT_GT(refused, 40);
}

/// A node takes sixty times the memory of its bytes in a file.
TEST_F(ForgedStock, NodesAreCountedBeforeTheyAreMade) {
  const Result<Stock> stock = load(
      [](Contents& c) {
        auto& tree = c.grid<openvdb::Vec3SGrid>("crossing_x_normal").tree();
        for (int k = 0; k < 400; ++k) tree.touchLeaf({4096 * k, 0, 0});
      },
      0.1);
  ASSERT_FALSE(stock.ok());
  EXPECT_EQ(stock.error().kind, ErrorKind::kResourceLimit) << stock.error().message;
}

}  // namespace
}  // namespace proveout
