// Saved stocks whose bytes are forged: the input is a list of changes to the grids and metadata of a good
// file, which is then written by OpenVDB with a right checksum, or damaged without one. A stock that is taken
// must be sound: it has a closed surface, can be cut, and saved and read again it is the same. Files whose
// bytes OpenVDB has not written are fuzz_vdb's.
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/ChangeBackground.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "removal/vdb/vdb_extern.h"
#include "tests/fuzz/stock_laws.h"

namespace {

using namespace proveout;
using namespace proveout::stocks;

/// A good file, in memory.
struct Saved {
  std::string bytes;
  openvdb::MetaMap meta;
  openvdb::GridPtrVec grids;
};

Saved open(std::string bytes) {
  const std::string path = folder().write("base.vdb", bytes);
  Saved saved;
  saved.bytes = std::move(bytes);
  openvdb::io::File file(path);
  file.open(false);  // all of it now: the file will be another one
  saved.meta = *file.getMetadata();
  saved.grids.push_back(file.readGrid("distance"));  // in the order of the file
  for (const char axis : {'x', 'y', 'z'}) {
    for (const char* what : {"_t", "_normal", "_motion", "_element"})
      saved.grids.push_back(file.readGrid(std::string("crossing_") + axis + what));
  }
  for (auto& grid : saved.grids) grid = grid->deepCopyGrid();
  file.close();
  return saved;
}

const std::vector<Saved>& bases() {
  static const std::vector<Saved> bases = [] {
    openvdb::initialize();
    std::vector<Saved> out;
    for (std::string& bytes : goodFiles()) out.push_back(open(std::move(bytes)));
    return out;
  }();
  return bases;
}

openvdb::Coord place(Bytes& bytes) {
  if (bytes.take<std::uint8_t>() % 16 == 0)
    return {bytes.take<std::int32_t>(), bytes.take<std::int32_t>(), bytes.take<std::int32_t>()};
  return {bytes.take<std::int8_t>(), bytes.take<std::int8_t>(), bytes.take<std::int8_t>()};
}

template <typename Grid, typename Value>
void changeTree(Grid& grid, Bytes& bytes, const Value& value) {
  const openvdb::Coord at = place(bytes);
  switch (bytes.take<std::uint8_t>() % 6) {
    case 0:
      return grid.tree().setValue(at, value);
    case 1:
      return grid.tree().setValueOff(at, value);
    case 2:
      return grid.tree().addTile(bytes.take<std::uint8_t>() % 4, at, value, true);
    case 3:
      grid.tree().touchLeaf(at);
      return;
    case 4:
      return grid.tree().clear();
    default:
      openvdb::tools::changeBackground(grid.tree(), value);
  }
}

void changeGrid(openvdb::GridBase& grid, Bytes& bytes) {
  if (auto* numbers = dynamic_cast<openvdb::FloatGrid*>(&grid)) {
    changeTree(*numbers, bytes, bytes.take<float>());
  } else if (auto* vectors = dynamic_cast<openvdb::Vec3SGrid*>(&grid)) {
    const float x = bytes.take<float>(), y = bytes.take<float>(), z = bytes.take<float>();
    changeTree(*vectors, bytes, openvdb::Vec3s(x, y, z));
  } else if (auto* whole = dynamic_cast<openvdb::Int32Grid*>(&grid)) {
    changeTree(*whole, bytes, bytes.take<std::int32_t>());
  }
}

double number(Bytes& bytes) {
  const auto how = bytes.take<std::uint8_t>();
  return how % 2 == 0 ? bytes.take<double>() : bytes.take<std::int16_t>() / 8.0;
}

void changeMeta(openvdb::MetaMap& meta, Bytes& bytes) {
  constexpr std::array<const char*, 6> kKeys = {"resolution", "initial_volume", "origin",
                                                "blank_min",  "blank_max",      "schema"};
  const char* const key = kKeys[bytes.take<std::uint8_t>() % kKeys.size()];
  const auto kind = bytes.take<std::uint8_t>();
  const bool as_it_is = kind % 8 != 0;
  if (kind % 16 == 8) return meta.removeMeta(key);
  const bool vector = std::string_view(key).starts_with("blank") || std::string_view(key) == "origin";
  meta.removeMeta(key);
  if (vector == as_it_is) {
    const double x = number(bytes), y = number(bytes), z = number(bytes);
    meta.insertMeta(key, openvdb::Vec3DMetadata(openvdb::Vec3d(x, y, z)));
  } else {
    meta.insertMeta(key, openvdb::DoubleMetadata(number(bytes)));
  }
}

void changeList(openvdb::GridPtrVec& grids, std::size_t which, Bytes& bytes) {
  if (bytes.take<std::uint8_t>() % 2 == 0) {
    grids.erase(grids.begin() + static_cast<std::ptrdiff_t>(which));
  } else {
    const std::string name = grids[bytes.take<std::uint8_t>() % grids.size()]->getName();
    grids[which]->setName(name);
  }
}

/// Gives the grids the frame that the metadata state: a file whose grids stand elsewhere is refused at once.
void placeGrids(const openvdb::MetaMap& meta, const openvdb::GridPtrVec& grids) {
  const auto h = meta.getMetadata<openvdb::DoubleMetadata>("resolution");
  const auto origin = meta.getMetadata<openvdb::Vec3DMetadata>("origin");
  if (!h || !origin || !std::isfinite(h->value()) || std::abs(h->value()) < 1e-6) return;
  try {
    auto transform = openvdb::math::Transform::createLinearTransform(h->value());
    transform->postTranslate(origin->value());
    for (const auto& grid : grids) grid->setTransform(transform->copy());
  } catch (const openvdb::Exception&) {
    return;  // no frame that OpenVDB can make
  }
}

/// The good file with the changes that the input lists.
std::string forge(const Saved& base, Bytes& bytes) {
  openvdb::MetaMap meta = *base.meta.deepCopyMeta();
  openvdb::GridPtrVec grids;
  for (const auto& grid : base.grids) grids.push_back(grid->deepCopyGrid());
  for (int change = 0; change < 12 && !bytes.empty() && !grids.empty(); ++change) {
    const auto what = bytes.take<std::uint8_t>();
    const std::size_t which = bytes.take<std::uint8_t>() % grids.size();
    if (what % 8 < 5) {
      changeGrid(*grids[which], bytes);
    } else if (what % 8 < 7) {
      changeMeta(meta, bytes);
    } else {
      changeList(grids, which, bytes);
    }
  }
  placeGrids(meta, grids);
  const std::string path = folder().at("forged.vdb");
  openvdb::io::File file(path);
  file.write(grids, meta);
  file.close();
  const std::string forged = bytesOf(path);
  return forged + trailer(forged);
}

/// Bytes of a good file, some of them changed or cut off.
std::string damage(std::string bytes, Bytes& changes) {
  while (!changes.empty()) {
    const std::size_t at = changes.take<std::uint16_t>() % bytes.size();
    const auto flip = changes.take<std::uint8_t>();
    if (flip == 0) {
      bytes.resize(at + 1);
    } else {
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(flip));
    }
  }
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes({reinterpret_cast<const char*>(data), size});
  const auto how = bytes.take<std::uint8_t>();
  const Saved& base = bases()[how % bases().size()];
  const bool damaged = how >= 192;
  const std::string forged = damaged ? damage(base.bytes, bytes) : forge(base, bytes);
  Result<Stock> stock = load(folder().write("stock.vdb", forged));
  if (damaged) {
    require(stock.ok() == (forged == base.bytes), "a damaged file is refused");
    return 0;
  }
  if (stock) checkSound(*stock, how % 8 == 0);
  require(stock.ok() || !stock.error().message.empty(), "a refusal has a reason");
  return 0;
}
