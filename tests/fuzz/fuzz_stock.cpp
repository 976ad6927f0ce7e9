// Saved stocks whose bytes are forged: the input is a list of changes to the grids and metadata of a good
// file, which is then written by OpenVDB with a right checksum, or damaged without one. A stock that is taken
// must be sound: it has a closed surface, can be cut, and saved and read again it is the same. Bytes that are
// no OpenVDB file at all never reach OpenVDB; the checksum sees to that.
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/ChangeBackground.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/grid/stock.h"
#include "removal/vdb/vdb_extern.h"
#include "tests/fuzz/laws.h"

namespace {

using namespace proveout;

const ScratchFolder& folder() {
  static const ScratchFolder folder;
  return folder;
}

RemovalOptions options(double resolution_mm) {
  RemovalOptions options;
  options.resolution_mm = resolution_mm;
  options.threads = 1;
  options.max_memory_gb = 0.2;
  return options;
}

Toolpath slot() {
  Toolpath path;
  path.files = {"slot"};
  Motion m;
  m.from = Vec3(-5, 1, 3.2);
  m.to = Vec3(15, 2, 2.9);
  m.kind = MotionKind::kFeed;
  m.spindle = 1000;
  m.tool = 1;
  path.motions.push_back(m);
  return path;
}

std::vector<Tool> tools() { return {*parseToolOption("1=bull:3:0.5")}; }

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A good file, in memory.
struct Saved {
  std::string bytes;
  openvdb::MetaMap meta;
  openvdb::GridPtrVec grids;
};

Saved save(const StockShape& shape, double resolution_mm, bool cut) {
  Progress progress;
  Result<Stock> stock = Stock::create(shape, options(resolution_mm), progress);
  require(stock.ok(), "the blank can be made");
  if (cut) require(stock->remove(slot(), tools(), options(resolution_mm), progress).ok(), "it can be cut");
  const std::string path = folder().at("base.vdb");
  require(stock->save(path).ok(), "it can be saved");
  Saved saved;
  saved.bytes = bytesOf(path);
  openvdb::io::File file(path);
  file.open(false);  // all of it now: the file will be another one
  saved.meta = *file.getMetadata();
  saved.grids = *file.getGrids();
  for (auto& grid : saved.grids) grid = grid->deepCopyGrid();
  file.close();
  return saved;
}

const std::vector<Saved>& bases() {
  static const std::vector<Saved> bases = [] {
    openvdb::initialize();
    std::vector<Saved> out;
    out.push_back(save(BoxShape{{0, 0, 0}, {6, 5, 4}}, 0.7, true));
    out.push_back(save(BoxShape{{-1, -1, -9}, {13, 12, 3}}, 0.7, false));
    out.push_back(save(CylinderShape{2, {1, 1, 0}, 4.0, 2.0, 4.0}, 0.5, true));
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

/// The checksum that the reader asks for (FNV-1a, 64 bits).
std::string trailer(const std::string& bytes) {
  std::uint64_t sum = 14695981039346656037ull;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(sum));
  return std::string("proveout") + digits;
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

Result<Stock> load(const std::string& path) {
  Progress progress;
  return Stock::create(SavedStock{path}, options(1.0), progress);
}

void checkSound(Stock& stock, bool cut_again) {
  Progress progress;
  require(std::isfinite(stock.resolution()) && stock.resolution() > 0.0, "the grid has a spacing");
  require(!stock.bounds().empty() && stock.bounds().min.allFinite() && stock.bounds().max.allFinite(),
          "the blank has bounds");
  require(std::isfinite(stock.initialVolume()) && stock.initialVolume() >= 0.0, "the blank had a volume");
  const std::string first = folder().at("first.vdb"), second = folder().at("second.vdb");
  require(stock.save(first).ok(), "what was read can be saved");
  const Result<Stock> again = load(first);
  require(again.ok() && again->save(second).ok() && bytesOf(first) == bytesOf(second),
          "saved and read again it is the same");
  const Result<StockSurface> surface = stock.surface(1, progress);
  require(surface.ok() && std::isfinite(surface->volume_mm3), "it has a surface");
  require(analyseTopology(surface->mesh).closedManifold(), "the surface is closed");
  if (!cut_again) return;
  const Result<RemovalSummary> cut = stock.remove(slot(), tools(), options(1.0), progress);
  require(cut.ok() || !cut.error().message.empty(), "it can be cut");
  if (!cut) return;
  const Result<StockSurface> left = stock.surface(1, progress);
  require(left.ok() && analyseTopology(left->mesh).closedManifold(), "what is left has a closed surface");
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
