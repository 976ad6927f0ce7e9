#include "io/sha256.h"

#include <gtest/gtest.h>

#include "temp_folder.h"

namespace proveout {
namespace {

// Vectors of FIPS 180-2, appendix B, and of the NIST example files for SHA-256.
TEST(Sha256, MatchesThePublishedVectors) {
  EXPECT_EQ(sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256Hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256Hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += static_cast<char>(i * 7);
  for (std::size_t size = 0; size <= text.size(); size += 13) {
    Sha256 pieces;
    for (std::size_t at = 0; at < size; ++at) pieces.update(text.data() + at, 1);
    EXPECT_EQ(pieces.finish(), sha256Hex(std::string_view(text).substr(0, size))) << size;
  }
}

TEST(Sha256, HashesFiles) {
  const io_test::TempFolder folder;
  EXPECT_EQ(*sha256OfFile(folder.write("abc", "abc")), sha256Hex("abc"));
  EXPECT_EQ(*sha256OfFile(folder.write("long", std::string(200000, 'z'))),
            sha256Hex(std::string(200000, 'z')));
  EXPECT_FALSE(sha256OfFile(folder.path("none")).ok());
  EXPECT_FALSE(sha256OfFile(folder.path()).ok());
}

TEST(Sha256, HashesMeshesByGeometry) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  // Counts as 64 bits, floats and indices as 32 bits, all little endian.
  std::string bytes("\3\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0", 16);
  bytes += std::string(12, '\0') + std::string("\0\0\x80\x3f", 4) + std::string(8, '\0');
  bytes += std::string(4, '\0') + std::string("\0\0\x80\x3f", 4) + std::string(4, '\0');
  bytes += std::string("\0\0\0\0\1\0\0\0\2\0\0\0", 12);
  EXPECT_EQ(sha256OfMesh(mesh), sha256Hex(bytes));
  mesh.motion = {7};
  EXPECT_EQ(sha256OfMesh(mesh), sha256Hex(bytes));
  mesh.triangles[0] = {0, 2, 1};
  EXPECT_NE(sha256OfMesh(mesh), sha256Hex(bytes));
}

}  // namespace
}  // namespace proveout
