// Saved stocks for the fuzz targets: good ones, the checksum of forged ones, and what a stock that is taken
// must keep.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/mesh/tri_mesh.h"
#include "removal/grid/stock.h"
#include "tests/fuzz/laws.h"

namespace proveout::stocks {

inline const ScratchFolder& folder() {
  static const ScratchFolder folder;
  return folder;
}

inline RemovalOptions options(double resolution_mm) {
  RemovalOptions options;
  options.resolution_mm = resolution_mm;
  options.threads = 1;
  options.max_memory_gb = 0.2;
  return options;
}

inline Toolpath slot() {
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

inline std::vector<Tool> tools() { return {*parseToolOption("1=bull:3:0.5")}; }

inline std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The bytes of the file of a blank, with a slot in it or without.
inline std::string savedBytes(const StockShape& shape, double resolution_mm, bool cut) {
  Progress progress;
  Result<Stock> stock = Stock::create(shape, options(resolution_mm), progress);
  require(stock.ok(), "the blank can be made");
  if (cut) require(stock->remove(slot(), tools(), options(resolution_mm), progress).ok(), "it can be cut");
  const std::string path = folder().at("base.vdb");
  require(stock->save(path).ok(), "it can be saved");
  return bytesOf(path);
}

/// Three of them.
inline std::vector<std::string> goodFiles() {
  return {savedBytes(BoxShape{{0, 0, 0}, {6, 5, 4}}, 0.7, true),
          savedBytes(BoxShape{{-1, -1, -9}, {13, 12, 3}}, 0.7, false),
          savedBytes(CylinderShape{2, {1, 1, 0}, 4.0, 2.0, 4.0}, 0.5, true)};
}

/// The checksum that the reader asks for (FNV-1a, 64 bits).
inline std::string trailer(const std::string& bytes) {
  std::uint64_t sum = 14695981039346656037ull;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(sum));
  return std::string("proveout") + digits;
}

inline Result<Stock> load(const std::string& path) {
  Progress progress;
  return Stock::create(SavedStock{path}, options(1.0), progress);
}

inline void checkSound(Stock& stock, bool cut_again) {
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

}  // namespace proveout::stocks
