#include "removal/vdb/stock_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <span>
#include <sstream>
#include <string_view>

#include "removal/vdb/vdb_extern.h"
#include "removal/vdb/vdb_pack.h"

namespace proveout {

namespace {

/// Longer than any name, type or text in a saved stock.
constexpr std::uint32_t kLongestText = 64;
/// Voxels along a child of a root.
constexpr std::int32_t kRootStep = 4096;

/// Reads on, and never beyond the end.
class Cursor {
 public:
  Cursor(std::istream& in, std::uint64_t end) : in_(in), end_(end) {}

  std::uint64_t at() const { return at_; }
  [[noreturn]] void refuse(std::string_view what) const {
    throw std::runtime_error(fmt::format("it is not built as a saved stock is: {} near byte {}", what, at_));
  }
  void require(bool good, std::string_view what) const {
    if (!good) refuse(what);
  }
  void read(void* into, std::uint64_t bytes) {
    advance(bytes);
    require(bool(in_.read(static_cast<char*>(into), static_cast<std::streamsize>(bytes))), "the file ends");
  }
  void skip(std::uint64_t bytes) {
    advance(bytes);
    require(bool(in_.ignore(static_cast<std::streamsize>(bytes))), "the file ends");
  }
  template <typename Value>
  Value take() {
    Value value;
    read(&value, sizeof value);
    return value;
  }
  std::string text() {
    const auto length = take<std::uint32_t>();
    require(length <= kLongestText, "a text is too long");
    std::string text(length, ' ');
    read(text.data(), length);
    return text;
  }
  void expect(std::string_view wanted, std::string_view what) { require(text() == wanted, what); }

 private:
  void advance(std::uint64_t bytes) {
    require(bytes <= end_ - at_, "the file ends");
    at_ += bytes;
  }

  std::istream& in_;
  std::uint64_t at_ = 0, end_;
};

/// A grid as it must be, and what its nodes take in memory.
struct GridForm {
  std::string name, type;
  std::size_t value_bytes, upper_bytes, lower_bytes, leaf_bytes;
};

template <typename Grid>
GridForm formOf(std::string name) {
  using Tree = typename Grid::TreeType;
  using Upper = typename Tree::RootNodeType::ChildNodeType;
  using Leaf = typename Tree::LeafNodeType;
  return {std::move(name),
          Grid::gridType(),
          sizeof(typename Grid::ValueType),
          sizeof(Upper),
          sizeof(typename Upper::ChildNodeType),
          sizeof(Leaf) + Leaf::SIZE * sizeof(typename Grid::ValueType)};
}

GridForm formOf(std::size_t index) {
  const std::string& name = stockGridNames()[index];
  if (index == 0) return formOf<openvdb::FloatGrid>(name);
  switch ((index - 1) % 4) {
    case 0:
      return formOf<openvdb::FloatGrid>(name);
    case 1:
      return formOf<openvdb::Vec3SGrid>(name);
    default:
      return formOf<openvdb::Int32Grid>(name);
  }
}

// ---------------------------------------------------------------------------- header and metadata

openvdb::VersionId walkHeader(Cursor& cursor) {
  cursor.require(cursor.take<std::int64_t>() == openvdb::OPENVDB_MAGIC, "it is no file of OpenVDB");
  cursor.require(cursor.take<std::uint32_t>() == openvdb::OPENVDB_FILE_VERSION,
                 "another version of the format");
  openvdb::VersionId library;
  library.first = cursor.take<std::uint32_t>();
  library.second = cursor.take<std::uint32_t>();
  cursor.require(cursor.take<std::uint8_t>() == 1, "the grids have no places");
  constexpr std::uint64_t kUuidText = 36;
  cursor.skip(kUuidText);
  return library;
}

/// The head of the next metadatum, with this name and type.
void expectMeta(Cursor& cursor, std::string_view name, std::string_view type) {
  cursor.expect(name, fmt::format("the metadatum \"{}\" is missing", name));
  cursor.expect(type, fmt::format("the metadatum \"{}\" is of another type", name));
}

template <typename Value>
Value takeMeta(Cursor& cursor, std::string_view name, std::string_view type) {
  expectMeta(cursor, name, type);
  cursor.require(cursor.take<std::uint32_t>() == sizeof(Value), "a metadatum has another size");
  return cursor.take<Value>();
}

double takeNumber(Cursor& cursor, std::string_view name) { return takeMeta<double>(cursor, name, "double"); }

Vec3 takeVector(Cursor& cursor, std::string_view name) {
  const auto v = takeMeta<std::array<double, 3>>(cursor, name, "vec3d");
  return {v[0], v[1], v[2]};
}

void expectText(Cursor& cursor, std::string_view name, std::string_view wanted) {
  expectMeta(cursor, name, "string");
  cursor.expect(wanted, fmt::format("\"{}\" is not \"{}\"", name, wanted));
}

/// The metadata of the file, in the order of their names.
void walkMetadata(Cursor& cursor, Stock::Impl& impl) {
  constexpr std::uint32_t kCount = 7;
  cursor.require(cursor.take<std::uint32_t>() == kCount, "the metadata are others");
  impl.blank.max = takeVector(cursor, "blank_max");
  impl.blank.min = takeVector(cursor, "blank_min");
  impl.initial_volume = takeNumber(cursor, "initial_volume");
  impl.origin = takeVector(cursor, "origin");
  impl.h = takeNumber(cursor, "resolution");
  expectText(cursor, "schema", kStockSchema);
  expectText(cursor, "unit", "mm");
}

/// What the grid is, before anything is made of its size.
void checkFrame(const Stock::Impl& impl) {
  // Voxels count from the origin, which a stock takes along when it is moved.
  const bool good = impl.origin.allFinite() && std::isfinite(impl.initial_volume) &&
                    impl.initial_volume > 0.0 && checkGrid(impl.blank, impl.h).ok() &&
                    checkGrid({impl.blank.min - impl.origin, impl.blank.max - impl.origin}, impl.h).ok();
  if (!good) throw std::runtime_error("its metadata are out of range");
}

/// What OpenVDB adds to the metadata of a grid when it writes it; nothing here reads them.
struct Statistic {
  std::string_view name, type;
  std::uint32_t bytes;  ///< 0: any number
};
constexpr Statistic kStatistics[] = {
    {"file_bbox_max", "vec3i", 12},    {"file_bbox_min", "vec3i", 12},
    {"file_compression", "string", 0}, {"file_delayed_load", "__delayedload", 0},
    {"file_mem_bytes", "int64", 8},    {"file_voxel_count", "int64", 8},
};

void walkStatistic(Cursor& cursor, const std::string& name, const std::string& type) {
  const auto known = std::find_if(std::begin(kStatistics), std::end(kStatistics),
                                  [&](const Statistic& one) { return one.name == name && one.type == type; });
  cursor.require(known != std::end(kStatistics), "a grid has metadata that are not its own");
  const auto bytes = cursor.take<std::uint32_t>();
  cursor.require(known->bytes == 0 || bytes == known->bytes, "a metadatum has another size");
  cursor.skip(bytes);
}

void walkGridMetadata(Cursor& cursor, const GridForm& form, bool level_set) {
  constexpr std::uint32_t kMost = std::size(kStatistics) + 2;
  const auto count = cursor.take<std::uint32_t>();
  cursor.require(count <= kMost, "a grid has metadata that are not its own");
  bool named = false, classed = false;
  std::string before;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::string name = cursor.text(), type = cursor.text();
    cursor.require(before < name, "metadata are out of order");
    before = name;
    if (name == "name" && type == "string") {
      cursor.expect(form.name, "a grid has two names");
      named = true;
    } else if (name == "class" && type == "string" && level_set) {
      cursor.expect("level set", "a grid is of another class");
      classed = true;
    } else {
      walkStatistic(cursor, name, type);
    }
  }
  cursor.require(named && classed == level_set, "a grid has not its own metadata");
}

/// The transform that save gives to every grid, as bytes.
std::string transformBytes(const Stock::Impl& impl) {
  std::ostringstream out;
  gridTransform(impl)->write(out);
  return out.str();
}

// ---------------------------------------------------------------------------- trees

/// The walk of one grid's tree.
class TreeWalk {
 public:
  TreeWalk(Cursor& cursor, const GridForm& form, double& memory_bytes, double limit_bytes)
      : cursor_(cursor), form_(form), memory_(memory_bytes), limit_(limit_bytes) {}

  void topology() {
    cursor_.require(cursor_.take<std::int32_t>() == 1, "a tree has several buffers");
    cursor_.skip(form_.value_bytes);  // the background
    const auto tiles = cursor_.take<std::uint32_t>(), children = cursor_.take<std::uint32_t>();
    for (std::uint32_t n = 0; n < tiles; ++n) {
      rootPlace();
      cursor_.skip(form_.value_bytes);
      cursor_.require(cursor_.take<std::uint8_t>() <= 1, "a tile is neither on nor off");
    }
    for (std::uint32_t n = 0; n < children; ++n) {
      rootPlace();
      upper();
    }
  }

  void buffers() {
    for (std::uint64_t n = 0; n < leaves_; ++n) {
      std::array<std::uint64_t, 8> on;
      cursor_.read(on.data(), sizeof on);
      values(512, countOn(on));
    }
  }

 private:
  template <std::size_t kWords>
  using Mask = std::array<std::uint64_t, kWords>;

  static std::uint32_t countOn(std::span<const std::uint64_t> mask) {
    std::uint32_t count = 0;
    for (const std::uint64_t word : mask) count += static_cast<std::uint32_t>(std::popcount(word));
    return count;
  }

  void charge(std::size_t bytes) {
    memory_ += static_cast<double>(bytes);
    if (memory_ > limit_) throw StockTooLarge();
  }

  void rootPlace() {
    constexpr std::size_t kMapNode = 96;
    const auto place = cursor_.take<std::array<std::int32_t, 3>>();
    cursor_.require(std::all_of(place.begin(), place.end(), [](auto x) { return x % kRootStep == 0; }),
                    "a node stands between the places of nodes");
    cursor_.require(places_.insert(place).second, "two nodes stand at one place");
    charge(kMapNode);
  }

  /// The masks of an inner node and its tiles; returns how many children follow.
  template <std::size_t kWords>
  std::uint32_t inner() {
    Mask<kWords> child, on;
    cursor_.read(child.data(), sizeof child);
    cursor_.read(on.data(), sizeof on);
    for (std::size_t k = 0; k < kWords; ++k)
      cursor_.require((child[k] & on[k]) == 0, "a child is a tile as well");
    values(64 * kWords, countOn(on));
    return countOn(child);
  }

  void upper() {
    charge(form_.upper_bytes);
    const std::uint32_t children = inner<512>();
    for (std::uint32_t n = 0; n < children; ++n) lower();
  }

  void lower() {
    constexpr std::uint64_t kLeafMask = 64;
    charge(form_.lower_bytes);
    const std::uint32_t leaves = inner<64>();
    for (std::uint32_t n = 0; n < leaves; ++n) charge(form_.leaf_bytes);
    cursor_.skip(kLeafMask * leaves);
    leaves_ += leaves;
  }

  /// The values of a node: which of them are left out, those that are inactive once or twice, a mask that
  /// chooses between these, and what is left.
  void values(std::uint32_t count, std::uint32_t on) {
    using namespace openvdb::io;
    const auto how = cursor_.take<std::int8_t>();
    cursor_.require(how >= NO_MASK_OR_INACTIVE_VALS && how <= NO_MASK_AND_ALL_VALS,
                    "values are left out in an unknown way");
    const bool one = how == NO_MASK_AND_ONE_INACTIVE_VAL || how == MASK_AND_ONE_INACTIVE_VAL;
    cursor_.skip(form_.value_bytes * (how == MASK_AND_TWO_INACTIVE_VALS ? 2 : one ? 1 : 0));
    if (how >= MASK_AND_NO_INACTIVE_VALS && how <= MASK_AND_TWO_INACTIVE_VALS) cursor_.skip(count / 8);
    chunk(form_.value_bytes * (how == NO_MASK_AND_ALL_VALS ? count : on));
  }

  /// So many bytes, packed by Blosc or, behind a length below 0, as they are.
  void chunk(std::size_t bytes) {
    const auto length = cursor_.take<std::int64_t>();
    if (length <= 0) {
      cursor_.require(0 - static_cast<std::uint64_t>(length) == bytes, "values are too few or too many");
      return cursor_.skip(bytes);
    }
    struct Head {
      std::uint8_t version, packer, flags, value_bytes;
      std::uint32_t unpacked, block, packed;
    };
    static_assert(sizeof(Head) == 16);
    cursor_.require(static_cast<std::uint64_t>(length) >= sizeof(Head) &&
                        static_cast<std::uint64_t>(length) <= bytes + sizeof(Head),
                    "values are too few or too many");
    const auto head = cursor_.take<Head>();
    const bool good = head.unpacked == bytes && head.packed == static_cast<std::uint64_t>(length) &&
                      head.value_bytes > 0 && (bytes == 0 || (head.block > 0 && head.block <= bytes));
    cursor_.require(good, "values are packed in an unknown way");
    cursor_.skip(static_cast<std::uint64_t>(length) - sizeof(Head));
  }

  Cursor& cursor_;
  const GridForm& form_;
  double& memory_;
  double limit_;
  std::set<std::array<std::int32_t, 3>> places_;
  std::uint64_t leaves_ = 0;
};

void walkDescriptor(Cursor& cursor, const GridForm& form, std::array<std::int64_t, 3>& places) {
  cursor.expect(form.name, fmt::format("the grid \"{}\" is missing", form.name));
  cursor.expect(form.type, fmt::format("the grid \"{}\" is of another type", form.name));
  cursor.expect("", "a grid shares another one's tree");
  for (std::int64_t& place : places) place = cursor.take<std::int64_t>();
}

void expectPlace(const Cursor& cursor, std::int64_t place) {
  cursor.require(place >= 0 && static_cast<std::uint64_t>(place) == cursor.at(),
                 "a grid is not where it is said to be");
}

}  // namespace

const std::array<std::string, kStockGrids>& stockGridNames() {
  static const std::array<std::string, kStockGrids> names = [] {
    std::array<std::string, kStockGrids> made;
    made[0] = "distance";
    std::size_t next = 1;
    for (const char axis : {'x', 'y', 'z'}) {
      for (const char* what : {"t", "normal", "motion", "element"})
        made[next++] = fmt::format("crossing_{}_{}", axis, what);
    }
    return made;
  }();
  return names;
}

StockLayout walkStockFile(std::istream& file, std::uint64_t size, double limit_bytes, Stock::Impl& impl) {
  Cursor cursor(file, size);
  StockLayout layout;
  layout.library = walkHeader(cursor);
  walkMetadata(cursor, impl);
  checkFrame(impl);
  if (treeBytes(impl) > limit_bytes) throw StockTooLarge();
  cursor.require(cursor.take<std::int32_t>() == static_cast<std::int32_t>(kStockGrids),
                 "there are more grids, or fewer");
  const std::string transform = transformBytes(impl);
  double memory_bytes = 0.0;
  for (std::size_t k = 0; k < kStockGrids; ++k) {
    const GridForm form = formOf(k);
    std::array<std::int64_t, 3> places{};
    walkDescriptor(cursor, form, places);
    expectPlace(cursor, places[0]);
    cursor.require(cursor.take<std::uint32_t>() == kStockCompression, "a grid is packed in another way");
    walkGridMetadata(cursor, form, k == 0);
    std::string found(transform.size(), ' ');
    cursor.read(found.data(), found.size());
    cursor.require(found == transform, "a grid has another frame than the stock");
    layout.trees[k] = static_cast<std::streamoff>(cursor.at());
    TreeWalk walk(cursor, form, memory_bytes, limit_bytes);
    walk.topology();
    expectPlace(cursor, places[1]);
    walk.buffers();
    expectPlace(cursor, places[2]);
  }
  cursor.require(cursor.at() == size, "something stands behind the grids");
  return layout;
}

}  // namespace proveout
