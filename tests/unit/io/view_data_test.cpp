// The data of the 3-D view, read back by what the format says and zlib alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/report/view/scene_data.h"

namespace proveout {
namespace {

using ::testing::ElementsAre;

std::string fromBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) >= 8) out += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return out;
}

/// Head and numbers of a scene.
struct Read {
  nlohmann::json head;
  std::string bytes;
  std::size_t at = 0;

  explicit Read(const std::string& text) {
    const std::string packed = fromBase64(text);
    bytes.resize(1 << 20);
    uLongf size = bytes.size();
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                         reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
              Z_OK);
    bytes.resize(size);
    const std::uint64_t length = number();
    head = nlohmann::json::parse(bytes.substr(at, length));
    at += length;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes.at(at++));
      value |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) return value;
    }
  }
  std::int64_t whole() {
    const std::uint64_t code = number();
    return code % 2 == 1 ? -static_cast<std::int64_t>(code / 2) - 1 : static_cast<std::int64_t>(code / 2);
  }
  std::vector<Vec3> places(std::size_t count, const nlohmann::json& box) {
    std::vector<Vec3> out;
    std::array<std::int64_t, 3> sum{};
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += whole();
        const double low = box["min"][k], high = box["max"][k];
        p[static_cast<int>(k)] = low + (high - low) * static_cast<double>(sum[k]) / 65535.0;
      }
      out.push_back(p);
    }
    return out;
  }
};

ViewScene tetrahedron() {
  ViewScene scene;
  // The first vertex is used by no triangle.
  scene.part.mesh.positions = {{99, 99, 9}, {0, 0, 0}, {10, 0, 0}, {0, 20, 0}, {0, 0, 30}};
  scene.part.mesh.triangles = {{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}};
  scene.part.deviation_mm = {7, 0.5F, -0.25F, std::numeric_limits<float>::quiet_NaN(), 0};
  scene.part.made_of = 1234;
  scene.part.off_mm = 0.02;
  return scene;
}

TEST(ViewData, MeshComesBackWithinAStepOfTheGrid) {
  const ViewScene scene = tetrahedron();
  Read read(encodeView(scene));
  EXPECT_EQ(read.head["part"]["vertices"], 4);
  EXPECT_EQ(read.head["part"]["of"], 1234);
  EXPECT_TRUE(read.head["nominal"].is_null());
  const std::vector<Vec3> places = read.places(4, read.head["box"]);
  std::vector<std::uint64_t> corners;
  std::uint64_t next = 0;
  for (int i = 0; i < 12; ++i) {
    const std::uint64_t back = read.number();
    corners.push_back(next - back);
    next += back == 0 ? 1 : 0;
  }
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 meant = scene.part.mesh.positions[scene.part.mesh.triangles[t][k]].cast<double>();
      EXPECT_LE((places[corners[3 * t + k]] - meant).cwiseAbs().maxCoeff(), 99.0 / 65535.0);
    }
  }
  // In the order of first use: vertices 1, 3, 2, 4.
  const double unit = read.head["part"]["unit"];
  std::int64_t at = 0;
  for (const double meant : {0.5, std::nan(""), -0.25, 0.0}) {
    const std::uint64_t code = read.number();
    EXPECT_EQ(code == 0, std::isnan(meant));
    if (code == 0) continue;
    at += code % 2 == 1 ? static_cast<std::int64_t>(code / 2) : -static_cast<std::int64_t>(code / 2);
    EXPECT_NEAR(static_cast<double>(at) * unit, meant, unit);
  }
  EXPECT_EQ(read.at, read.bytes.size());
}

TEST(ViewData, PathComesBack) {
  ViewScene scene = tetrahedron();
  scene.part.deviation_mm.clear();
  ViewPath path;
  path.setups = {"top"};
  path.files = {"a\xff.nc"};
  path.tools = {{"T1", {{0, 0}, {4, 0}}}};
  path.blocks = {{0, 0, 0, 7, 120, 0}, {0, 0, 0, 5, -1, 2}};
  path.points = {{Vec3(0, 0, 50), 0.0, ViewMove::kStart},
                 {Vec3(100, 0, 50), 1.5, ViewMove::kRapid},
                 {Vec3(100, 80, -5), 4000.25, ViewMove::kFeed}};
  path.axes = {Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitX()};
  scene.path = path;
  Read read(encodeView(scene));
  for (int skip = 0; skip < 24; ++skip) read.number();  // the mesh
  const auto blockRow = [&] {
    std::vector<std::int64_t> row;
    for (int k = 0; k < 5; ++k) row.push_back(read.whole());
    row.push_back(static_cast<std::int64_t>(read.number()));
    return row;
  };
  EXPECT_THAT(blockRow(), ElementsAre(0, 0, 7, 120, 0, 2));
  EXPECT_THAT(blockRow(), ElementsAre(0, 0, -2, -121, 0, 1));  // steps from the row before
  const std::vector<Vec3> places = read.places(3, read.head["path"]["box"]);
  EXPECT_NEAR((places[2] - Vec3(100, 80, -5)).norm(), 0.0, 0.01);
  std::vector<std::uint64_t> times;
  for (int k = 0; k < 6; ++k) times.push_back(read.number());
  EXPECT_THAT(times, ElementsAre(4u, 0u, 0u, 1500u, 1u, 3998750u));
  std::vector<std::int64_t> axes;
  for (int k = 0; k < 9; ++k) axes.push_back(read.whole());
  EXPECT_THAT(axes, ElementsAre(0, 0, 1000, 1000, 0, -1000, -2000, 0, 0));
  EXPECT_EQ(read.at, read.bytes.size());
}

// RFC 4648, section 10.
TEST(ViewData, Base64) {
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(fromBase64(base64("foobar")), "foobar");
}

}  // namespace
}  // namespace proveout
