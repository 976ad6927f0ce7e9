// The stock as a .vdb file: a level set one voxel wide on either side, for everyone; and, per axis, the exact
// crossings as grids of fraction, normal, motion and element, from which it is loaded again without loss.
#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "removal/grid/face_numbers.h"
#include "core/base/memory.h"
#include "removal/grid/stock_impl.h"
#include "removal/vdb/stock_layout.h"
#include "removal/vdb/vdb_extern.h"
#include "removal/vdb/vdb_module.h"
#include "removal/vdb/vdb_pack.h"

namespace proveout {

namespace {

/// A file that was opened takes no more.
struct FullDisk : std::runtime_error {
  FullDisk() : std::runtime_error("the disk is full, or the file is larger than is allowed") {}
};

constexpr char kOutOfBlank[] = "it reaches out of its blank";

struct CrossingGrids {
  openvdb::FloatGrid::Ptr t;
  openvdb::Vec3SGrid::Ptr normal;
  openvdb::Int32Grid::Ptr motion, element;
};

CrossingGrids packAxis(const Stock::Impl& impl, int axis) {
  CrossingGrids g{openvdb::FloatGrid::create(-1.0f), openvdb::Vec3SGrid::create(),
                  openvdb::Int32Grid::create(-1), openvdb::Int32Grid::create(0)};
  auto t = g.t->getAccessor();
  auto normal = g.normal->getAccessor();
  auto motion = g.motion->getAccessor();
  auto element = g.element->getAccessor();
  forEachCrossing(impl, [&](const Crossing& c, int edge_axis, const Coord& start, const Coord&) {
    if (edge_axis != axis) return;
    const openvdb::Coord at = toVdb(start);
    t.setValue(at, c.t);
    normal.setValue(at,
                    openvdb::Vec3s(c.normal[0], c.normal[1], c.normal[2]) / float{Crossing::kNormalScale});
    motion.setValue(at, static_cast<std::int32_t>(c.motion));
    element.setValue(at, c.element);
  });
  return g;
}

/// Distances near the surface are those to the tangent planes of the crossings next to a sample.
openvdb::FloatGrid::Ptr packDistance(const Stock::Impl& impl) {
  const auto band = static_cast<float>(impl.h);
  const openvdb::FloatGrid::Ptr grid = sidesOf(impl, band);
  auto write = grid->getAccessor();
  const LeafReader reader(impl);
  const auto bring = [&](const Coord& voxel, float distance) {
    if (reader.leaf(voxel & ~7) == nullptr) return;  // a leaf in the file is a leaf of the stock
    const openvdb::Coord at = toVdb(voxel);
    const float old = write.getValue(at);
    if (distance < std::abs(old) || !write.isValueOn(at))
      write.setValue(at, old < 0.0f ? -distance : distance);
  };
  forEachCrossing(impl, [&](const Crossing& c, int axis, const Coord& at, const Coord& next) {
    const float across = static_cast<float>(std::abs(c.unitNormal()[axis])) * band;
    bring(at, c.t * across);
    bring(next, (1.0f - c.t) * across);
  });
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return grid;
}

/// A distance of 0 has a sign, too: a crossing whose normal is square to its edge leaves one.
bool isMaterial(float distance) { return std::signbit(distance); }

void unpackDistance(const openvdb::FloatGrid& grid, Stock::Impl& impl) {
  makeTree(impl);
  for (auto it = grid.cbeginValueAll(); it; ++it) {
    if (!std::isfinite(it.getValue())) throw std::runtime_error("a distance is not a finite number");
    if (it.getLevel() == 0 || !isMaterial(it.getValue())) continue;
    openvdb::CoordBBox box;
    it.getBoundingBox(box);
    const Coord low = leafCoord(fromVdb(box.min())), high = leafCoord(fromVdb(box.max()));
    if (!impl.tree.holds(low) || !impl.tree.holds(high)) throw std::runtime_error(kOutOfBlank);
    impl.tree.fillInside(low, high);
  }
  for (auto leaf = grid.tree().cbeginLeaf(); leaf; ++leaf) {
    const Coord origin = fromVdb(leaf->origin());
    if (!impl.tree.holds(leafCoord(origin))) throw std::runtime_error(kOutOfBlank);
    LeafBits& samples = *addLeaf(impl, origin).samples;
    for (int v = 0; v < 512; ++v) {
      if (isMaterial(leaf->getValue(v))) samples[v & 7] |= 1ull << (v >> 3);
    }
  }
  orderLeaves(impl);
}

/// Whether samples low..high (both included) lie in the blank, to rounding.
bool inBlank(const Stock::Impl& impl, const Coord& low, const Coord& high) {
  const Vec3 slack = Vec3::Constant(1e-3 * impl.h);
  const Vec3 first = impl.position(low), last = impl.position(high);
  return (first.array() >= (impl.blank.min - slack).array()).all() &&
         (last.array() <= (impl.blank.max + slack).array()).all();
}

/// No material lies outside of the blank.
void checkPlaces(const Stock::Impl& impl) {
  const auto check = [&](const Coord& low, const Coord& high) {
    if (!inBlank(impl, low, high)) throw std::runtime_error(kOutOfBlank);
  };
  impl.tree.forEachInside([&](const Coord& low, const Coord& high) {
    check({8 * low.x(), 8 * low.y(), 8 * low.z()}, {8 * high.x() + 7, 8 * high.y() + 7, 8 * high.z() + 7});
  });
  for (const StockLeaf& leaf : impl.leaves) {
    if (inBlank(impl, leaf.origin, leaf.origin.offsetBy(7))) continue;
    for (int v = 0; v < 512; ++v) {
      const Coord at = leaf.origin.offsetBy(v >> 6, v >> 3 & 7, v & 7);
      if (leafSample(leaf.material(), v >> 6, v >> 3 & 7, v & 7)) check(at, at);
    }
  }
}

struct CrossingReader {
  /// `first`: number of the axis's first grid.
  CrossingReader(std::istream& file, const StockLayout& layout, std::size_t first)
      : t(readStockTree<openvdb::FloatGrid>(file, layout, first)),
        normal(readStockTree<openvdb::Vec3SGrid>(file, layout, first + 1)),
        motion(readStockTree<openvdb::Int32Grid>(file, layout, first + 2)),
        element(readStockTree<openvdb::Int32Grid>(file, layout, first + 3)) {}

  Crossing read(const Coord& voxel) const {
    const openvdb::Coord at = toVdb(voxel);
    Crossing c;
    c.t = t->getConstUnsafeAccessor().getValue(at);
    const auto v = normal->getConstUnsafeAccessor().getValue(at);
    const std::int32_t face = element->getConstUnsafeAccessor().getValue(at);
    constexpr float kLeast = 0.5f * kEdgeMargin;  // 1 - t of a turned stock is rounded
    bool good = c.t >= kLeast && c.t <= 1.0f - kLeast && face >= 0 && face <= 0xFFFF;
    for (int i = 0; i < 3; ++i) good = good && std::abs(v[i]) <= 1.0f;
    if (!good) throw std::runtime_error("a crossing is missing or out of range");
    c.setNormal(Vec3(v[0], v[1], v[2]));
    c.motion = static_cast<std::uint32_t>(motion->getConstUnsafeAccessor().getValue(at));
    c.element = static_cast<std::uint16_t>(face);
    return c;
  }

  openvdb::FloatGrid::Ptr t;
  openvdb::Vec3SGrid::Ptr normal;
  openvdb::Int32Grid::Ptr motion, element;
};

void unpackCrossings(std::istream& file, const StockLayout& layout, Stock::Impl& impl) {
  const CrossingReader axes[3] = {{file, layout, 1}, {file, layout, 5}, {file, layout, 9}};
  const LeafReader reader(impl);
  for (StockLeaf& leaf : impl.leaves) {
    forEachEdge(reader.edges(leaf), [&](int axis, int x, int y, int z) {
      leaf.crossings.push_back(axes[axis].read(leaf.origin.offsetBy(x, y, z)));
    });
  }
}

/// A leaf stands wherever samples of both sides meet, and nowhere else: without one the surface would have a
/// hole.
void checkLeaves(const Stock::Impl& impl) {
  const auto refuse = [](bool bad) {
    if (bad) throw std::runtime_error("its surface has a hole");
  };
  const LeafReader reader(impl);
  for (const StockLeaf& leaf : impl.leaves) {
    refuse(!isMixed(reader, leaf.origin));
    for (int n = 1; n < 8; ++n) {  // whose blocks reach into this leaf
      const Coord below = leaf.origin.offsetBy(n & 1 ? -8 : 0, n & 2 ? -8 : 0, n & 4 ? -8 : 0);
      refuse(reader.leaf(below) == nullptr && isMixed(reader, below));
    }
  }
  impl.tree.forEachInside([&](const Coord& low, const Coord& high) {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      Coord at;
      for (at[u] = low[u]; at[u] <= high[u]; ++at[u]) {
        for (at[v] = low[v]; at[v] <= high[v]; ++at[v]) {
          for (const int beside : {low[axis] - 1, high[axis] + 1}) {
            at[axis] = beside;
            refuse(impl.tree.get(at) == StockTree::kOutside);
          }
        }
      }
    }
  });
}

/// Behind the grids stand this mark and the checksum (FNV-1a, 64 bits) of everything before: it tells what
/// was damaged by chance. What was made on purpose has a right one, too, and is told by walkStockFile and
/// what comes behind it.
constexpr std::string_view kTrailerMark = "proveout";
constexpr std::size_t kTrailerSize = kTrailerMark.size() + 16;

/// Checksum of the first `size` bytes of a file, as 16 digits.
std::string checksum(const std::string& path, std::uintmax_t size) {
  std::ifstream in(path, std::ios::binary);
  std::vector<char> buffer(1 << 20);
  std::uint64_t sum = 14695981039346656037ull;
  while (size > 0) {
    const auto part = static_cast<std::streamsize>(std::min<std::uintmax_t>(size, buffer.size()));
    if (!in.read(buffer.data(), part)) throw std::runtime_error("it cannot be read");
    for (std::streamsize i = 0; i < part; ++i)
      sum = (sum ^ static_cast<unsigned char>(buffer[i])) * 1099511628211ull;
    size -= static_cast<std::uintmax_t>(part);
  }
  return fmt::format("{:016x}", sum);
}

/// OpenVDB numbers each file that it writes with a random UUID. Here the same stock gives the same bytes: the
/// number is made of what stands behind it (RFC 9562, version 8). Readers only compare it with that of
/// another file.
void replaceTag(const std::string& path, const std::string& tag) {
  constexpr std::size_t kHeaderBytes = 256;  // magic number, versions and the UUID as text
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  std::string header(kHeaderBytes, '\0');
  file.read(header.data(), kHeaderBytes);
  file.clear();
  const std::size_t at = header.find(tag);
  if (at == std::string::npos) throw std::runtime_error("its header is not as OpenVDB writes it");
  file.seekp(static_cast<std::streamoff>(at));
  file << std::string(tag.size(), '0');
  file.flush();
  const std::uintmax_t size = std::filesystem::file_size(path);
  const std::string whole = checksum(path, size), half = checksum(path, size / 2);
  file.seekp(static_cast<std::streamoff>(at));
  file << fmt::format("{}-{}-8{}-8{}-{}", whole.substr(0, 8), whole.substr(8, 4), whole.substr(13, 3),
                      half.substr(0, 3), half.substr(3, 12));
  file.close();
  if (!file) throw FullDisk();
}

void appendTrailer(const std::string& path) {
  const std::string sum = checksum(path, std::filesystem::file_size(path));
  std::ofstream out(path, std::ios::binary | std::ios::app);
  out << kTrailerMark << sum;
  out.close();
  if (!out) throw FullDisk();
}

/// Returns how many bytes stand before the trailer.
std::uint64_t checkTrailer(const std::string& path) {
  const std::uintmax_t size = std::filesystem::file_size(path);
  if (size < kTrailerSize) throw std::runtime_error("it was not saved by proveout, or is cut short");
  std::ifstream in(path, std::ios::binary);
  std::string trailer(kTrailerSize, ' ');
  in.seekg(static_cast<std::streamoff>(size - kTrailerSize));
  in.read(trailer.data(), static_cast<std::streamsize>(kTrailerSize));
  if (!in || trailer.compare(0, kTrailerMark.size(), kTrailerMark) != 0) {
    throw std::runtime_error("it was not saved by proveout, or is cut short");
  }
  if (trailer.substr(kTrailerMark.size()) != checksum(path, size - kTrailerSize)) {
    throw std::runtime_error("its contents are damaged");
  }
  return size - kTrailerSize;
}

openvdb::MetaMap metadata(const Stock::Impl& impl) {
  openvdb::MetaMap meta;
  meta.insertMeta("schema", openvdb::StringMetadata(kStockSchema));
  meta.insertMeta("unit", openvdb::StringMetadata("mm"));
  meta.insertMeta("resolution", openvdb::DoubleMetadata(impl.h));
  meta.insertMeta("initial_volume", openvdb::DoubleMetadata(impl.initial_volume));
  const auto vector = [](const Vec3& v) {
    return openvdb::Vec3DMetadata(openvdb::Vec3d(v.x(), v.y(), v.z()));
  };
  meta.insertMeta("origin", vector(impl.origin));
  meta.insertMeta("blank_min", vector(impl.blank.min));
  meta.insertMeta("blank_max", vector(impl.blank.max));
  return meta;
}

}  // namespace

Status writeStockFile(const Stock::Impl& impl, const std::string& path) {
  constexpr std::size_t kLongestName = 240;  // with the ending it is no longer than a name may be
  const std::filesystem::path target(path);
  const std::string name = target.filename().string().substr(0, kLongestName);
  const std::string aside = (target.parent_path() / (name + ".part")).string();
  std::error_code ignored;
  try {
    openvdb::initialize();
    openvdb::GridPtrVec grids;
    grids.push_back(packDistance(impl));
    for (int axis = 0; axis < 3; ++axis) {
      const CrossingGrids g = packAxis(impl, axis);
      for (const openvdb::GridBase::Ptr& grid :
           {openvdb::GridBase::Ptr(g.t), openvdb::GridBase::Ptr(g.normal), openvdb::GridBase::Ptr(g.motion),
            openvdb::GridBase::Ptr(g.element)}) {
        grids.push_back(grid);
      }
    }
    for (std::size_t k = 0; k < grids.size(); ++k) {
      grids[k]->setTransform(gridTransform(impl));
      grids[k]->setName(stockGridNames()[k]);
    }
    openvdb::io::File file(aside);
    file.setCompression(kStockCompression);
    file.write(grids, metadata(impl));
    file.close();
    replaceTag(aside, file.getUniqueTag());
    appendTrailer(aside);
    std::filesystem::rename(aside, path);
  } catch (const FullDisk& e) {
    std::filesystem::remove(aside, ignored);
    return Error{ErrorKind::kResourceLimit, fmt::format("{}: cannot write the stock: {}", path, e.what())};
  } catch (const std::exception& e) {
    std::filesystem::remove(aside, ignored);
    return inputError(fmt::format("{}: cannot write the stock: {}", path, e.what()));
  }
  return Done{};
}

namespace {

Error tooLarge(const std::string& path, double limit_bytes) {
  return {
      ErrorKind::kResourceLimit,
      fmt::format("{}: the stock needs more than the {:.3g} GB of memory allowed; allow more (--max-memory)",
                  path, limit_bytes / 1e9)};
}

/// The samples, and that they are those of a stock. False: too many.
bool unpackSamples(std::istream& file, const StockLayout& layout, double limit_bytes, Stock::Impl& impl) {
  const auto distance = readStockTree<openvdb::FloatGrid>(file, layout, 0);
  if (leafBytes(static_cast<double>(distance->tree().leafCount())) > limit_bytes) return false;
  unpackDistance(*distance, impl);
  checkPlaces(impl);
  checkLeaves(impl);
  return true;
}

}  // namespace

Status readStockFile(Stock::Impl& impl, const std::string& path, const RemovalOptions& options) {
  if (!std::filesystem::is_regular_file(path)) return inputError(path + ": no such stock file");
  const double limit = memoryLimit(options);
  try {
    openvdb::initialize();
    const std::uint64_t size = checkTrailer(path);
    std::ifstream file(path, std::ios::binary);
    const StockLayout layout = walkStockFile(file, size, limit, impl);
    if (!unpackSamples(file, layout, limit, impl)) return tooLarge(path, limit);
    unpackCrossings(file, layout, impl);
    numberFaces(impl);
  } catch (const StockTooLarge&) {
    return tooLarge(path, limit);
  } catch (const std::bad_alloc&) {
    return outOfMemory(path + ": not enough memory for the stock", "allow more (--max-memory)");
  } catch (const std::exception& e) {
    return inputError(fmt::format("{}: not a readable stock: {}", path, e.what()));
  }
  return Done{};
}

}  // namespace proveout
