// Every class of bad mesh file is refused with its reason, and none crashes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "io/mesh_io.h"
#include "mesh_text.h"
#include "temp_folder.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::HasSubstr;

std::string reasonFor(std::string_view bytes, const std::string& extension) {
  const auto mesh = parseMesh(bytes, extension, "part." + extension);
  return mesh.ok() ? "accepted" : mesh.error().message;
}

TEST(BadMesh, Empty) {
  for (const char* extension : {"stl", "obj", "ply"}) {
    EXPECT_THAT(reasonFor("", extension), HasSubstr("is empty"));
    EXPECT_THAT(reasonFor("\n", extension), ::testing::Not("accepted"));
  }
  EXPECT_THAT(reasonFor("# nothing\n", "obj"), HasSubstr("has no surface"));
  EXPECT_THAT(reasonFor("solid\nendsolid\n", "stl"), HasSubstr("has no surface"));
  EXPECT_THAT(reasonFor(binaryStl(TriMesh()), "stl"), HasSubstr("has no surface"));
}

TEST(BadMesh, WrongMagic) {
  EXPECT_THAT(reasonFor("GIF89a what is this", "stl"), HasSubstr("no STL file"));
  EXPECT_THAT(reasonFor("plx\n", "ply"), HasSubstr("no PLY file"));
  EXPECT_THAT(reasonFor(binaryStl(tetrahedron()), "ply"), HasSubstr("no PLY file"));
  EXPECT_THAT(reasonFor(binaryStl(tetrahedron()), "obj"), HasSubstr("no OBJ file"));
  EXPECT_THAT(reasonFor(kObj, "step"), HasSubstr("must end in .stl, .obj, .ply, .3mf, .glb, .step or .stp"));
}

TEST(BadMesh, EveryTruncationOfBinaryStl) {
  const std::string whole = binaryStl(tetrahedron());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(reasonFor(whole.substr(0, size), "stl"), "accepted") << size;
  }
  EXPECT_THAT(reasonFor(whole.substr(0, 200), "stl"), HasSubstr("cut short"));
  EXPECT_THAT(reasonFor(whole + "x", "stl"), HasSubstr("too long"));
  const std::string solid = binaryStl(tetrahedron(), "solid x");
  EXPECT_THAT(reasonFor(solid.substr(0, 250), "stl"), HasSubstr("cut short"));
}

TEST(BadMesh, EveryTruncationOfAsciiStl) {
  // From "endsolid" on nothing of the shape is missing.
  const std::size_t complete = kAsciiStl.find("endsolid") + 8;
  for (std::size_t size = 0; size < complete; ++size) {
    EXPECT_NE(reasonFor(kAsciiStl.substr(0, size), "stl"), "accepted") << size;
  }
  EXPECT_THAT(reasonFor(kAsciiStl.substr(0, 300), "stl"), HasSubstr("cut short"));
}

TEST(BadMesh, NumbersThatAPlyDoesNotDeclareAreNamed) {
  for (const bool windows : {false, true}) {
    const auto reason = [&](const std::string& from, const std::string& to) {
      std::string text = replaced(kAsciiPly, from, to);
      for (std::size_t at = 0; windows && (at = text.find('\n', at)) != std::string::npos; at += 2)
        text.insert(at, "\r");
      return reasonFor(text, "ply");
    };
    EXPECT_THAT(reason("3 0 2 1", "3 0 2 1 9 1 1 1"), HasSubstr("4 extra numbers behind face 1"));
    EXPECT_THAT(reason("1 0 0 9", "1 0 0 9 255"), HasSubstr("1 extra number behind vertex"));
    EXPECT_THAT(reason("1 0 0 9", "1 0 0 9 255"), HasSubstr("line "));
  }
}

TEST(BadMesh, EveryTruncationOfPly) {
  // The last character is a line end, and the last digit of a number can be missed in a text.
  for (std::size_t size = 0; size < kAsciiPly.size() - 2; ++size) {
    EXPECT_NE(reasonFor(kAsciiPly.substr(0, size), "ply"), "accepted") << size;
  }
  const TempFolder folder;
  ASSERT_TRUE(writeMesh(tetrahedron(), folder.path("a.ply"), MeshFormat::kPly).ok());
  const std::string binary = readBytes(folder.path("a.ply"));
  for (std::size_t size = 0; size < binary.size(); ++size) {
    EXPECT_NE(reasonFor(binary.substr(0, size), "ply"), "accepted") << size;
  }
  EXPECT_THAT(reasonFor(binary + "x", "ply"), HasSubstr("more data than its header counts"));
  EXPECT_THAT(reasonFor(kAsciiPly + "1", "ply"), HasSubstr("more data than its header counts"));
}

TEST(BadMesh, CoordinatesThatAreNotFinite) {
  const char* const kText = "not a finite number";
  for (const char* bad : {"nan", "inf", "-inf", "1e39", "1e999"}) {
    EXPECT_THAT(reasonFor(replaced(kAsciiStl, "vertex 1 0 0", std::string("vertex 1 ") + bad + " 0"), "stl"),
                HasSubstr(kText));
    EXPECT_THAT(reasonFor(replaced(kObj, "v 1 0 0", std::string("v 1 0 ") + bad), "obj"), HasSubstr(kText));
    EXPECT_THAT(reasonFor(replaced(kAsciiPly, "1 0 0 9", std::string(bad) + " 0 0 9"), "ply"),
                HasSubstr(kText));
  }
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    TriMesh mesh = tetrahedron();
    mesh.positions[2].y() = bad;
    EXPECT_THAT(reasonFor(binaryStl(mesh), "stl"),
                HasSubstr("triangle 1 has a coordinate that is " + std::string(kText)));
  }
  // Finite in the file, but not in mm.
  TriMesh mesh = tetrahedron();
  mesh.positions[1].x() = 1e37f;
  MeshLoadOptions metre;
  metre.unit = MeshUnit::kMetre;
  EXPECT_FALSE(parseMesh(binaryStl(mesh), "stl", "a.stl", metre).ok());
}

TEST(BadMesh, HugeCountsTakeNoMemory) {
  std::string stl = binaryStl(tetrahedron());
  for (int i = 80; i < 84; ++i) stl[i] = static_cast<char>(0xFF);
  EXPECT_THAT(reasonFor(stl, "stl"), HasSubstr("counts 4294967295 triangles"));
  for (const char* count : {"4294967295", "18446744073709551615"}) {
    EXPECT_THAT(reasonFor(replaced(kAsciiPly, "vertex 4", std::string("vertex ") + count), "ply"),
                HasSubstr("more than the file can hold"));
    EXPECT_THAT(reasonFor(replaced(kAsciiPly, "face 4", std::string("face ") + count), "ply"),
                HasSubstr("more than the file can hold"));
  }
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "vertex 4", "vertex 99999999999999999999999"), "ply"),
              HasSubstr("a name and a count"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "vertex 4", "vertex -4"), "ply"),
              HasSubstr("a name and a count"));
  // An element without properties would be counted to for ever.
  EXPECT_THAT(
      reasonFor(replaced(kAsciiPly, "element vertex", "element nothing 9999999999999999\nelement vertex"),
                "ply"),
      HasSubstr("has no properties"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "3 0 2 1", "4000000000 0 2 1"), "ply"),
              HasSubstr("cut short or damaged"));
}

TEST(BadMesh, IndicesOutOfRange) {
  for (const char* face : {"f 1 2 5", "f 0 1 2", "f -5 1 2", "f 1 2 99999999999999999999", "f 1 2 x",
                           "f 1 2 3/1/1/1", "f 1.5 2 3"}) {
    EXPECT_THAT(reasonFor(replaced(kObj, "f 1/1/1 3/1/1 2/1/1", face), "obj"),
                HasSubstr("is no vertex of this file"))
        << face;
  }
  for (const char* face : {"3 0 2 4", "3 0 2 -1", "3 0 2 1.5", "3 0 2 nan"}) {
    EXPECT_THAT(reasonFor(replaced(kAsciiPly, "3 0 2 1", face), "ply"),
                HasSubstr("is no vertex of this file"))
        << face;
  }
}

TEST(BadMesh, PointsAndLines) {
  EXPECT_THAT(reasonFor(kObj + "l 1 2\n", "obj"), HasSubstr("points and lines"));
  EXPECT_THAT(reasonFor(kObj + "p 1\n", "obj"), HasSubstr("points and lines"));
  EXPECT_THAT(reasonFor(kObj + "f 1 2\n", "obj"), HasSubstr("fewer than three corners"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "3 0 2 1", "2 0 2"), "ply"),
              HasSubstr("fewer than three corners"));
  EXPECT_THAT(
      reasonFor(replaced(kAsciiPly, "end_header", "element edge 1\nproperty int vertex1\nend_header") + "1\n",
                "ply"),
      HasSubstr("has edges"));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 1 1\n", "obj"), HasSubstr("has no surface"));
  EXPECT_THAT(reasonFor("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 1\n", "obj"), HasSubstr("has no surface"));
}

TEST(BadMesh, MalformedText) {
  EXPECT_THAT(reasonFor(replaced(kAsciiStl, "endloop", "vertex 1 2 3\nendloop"), "stl"),
              HasSubstr("line 7: 'endloop' expected, not 'vertex'"));
  EXPECT_THAT(reasonFor(replaced(kAsciiStl, "vertex 0 1 0", "vertex 0 1"), "stl"),
              HasSubstr("three numbers"));
  EXPECT_THAT(reasonFor(kAsciiStl + "rubbish\n", "stl"), HasSubstr("'solid' expected"));
  EXPECT_THAT(reasonFor(kObj + "v 1 2\n", "obj"), HasSubstr("three coordinates"));
  EXPECT_THAT(reasonFor(kObj + "v 1 2 3,5\n", "obj"), HasSubstr("a vertex is"));
  EXPECT_THAT(reasonFor(kObj + "curv 0 1 1 2 3\n", "obj"),
              HasSubstr("line 18: statement 'curv' is not supported"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "ascii", "ebcdic"), "ply"),
              HasSubstr("format 'ebcdic' is not known"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "double z", "quad z"), "ply"),
              HasSubstr("type 'quad' is not known"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "double z", "double w"), "ply"), HasSubstr("no x, y and z"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "list uchar", "list float"), "ply"),
              HasSubstr("whole number type"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "vertex_indices", "corners"), "ply"),
              HasSubstr("no list of vertex indices"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "format ascii 1.0\n", ""), "ply"), HasSubstr("states no format"));
  EXPECT_THAT(reasonFor(replaced(kAsciiPly, "1 0 0 9", "1 0 oops 9"), "ply"),
              HasSubstr("damaged at vertex 2 of 4"));
}

TEST(BadMesh, FacesThatCrossThemselves) {
  const std::string star =
      "v 0 1 0\nv 0.59 -0.81 0\nv -0.95 0.31 0\nv 0.95 0.31 0\nv -0.59 -0.81 0\nf 1 2 3 4 5\n";
  const std::string bow = "v 0 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4\n";
  EXPECT_THAT(reasonFor(star, "obj"), HasSubstr("crosses itself"));
  EXPECT_THAT(reasonFor(bow, "obj"), HasSubstr("crosses itself"));
}

TEST(BadMesh, ConcaveFacesWithoutBound) {
  std::string text, face = "f";
  for (int i = 0; i < 4000; ++i) {
    const double angle = i * 2 * kPi / 4000, radius = i % 2 == 0 ? 1.0 : 0.5;
    text += "v " + std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) +
            " 0\n";
    face += " " + std::to_string(i + 1);
  }
  EXPECT_THAT(reasonFor(text + face + "\n", "obj"), HasSubstr("a concave face with 4000 corners"));
}

TEST(BadMesh, EveryByteOfASmallFileDamaged) {
  // Whatever comes out, it must be a mesh with indices in range or an error.
  const TempFolder folder;
  ASSERT_TRUE(writeMesh(tetrahedron(), folder.path("a.ply"), MeshFormat::kPly).ok());
  const std::string binary_ply = readBytes(folder.path("a.ply"));
  const std::vector<std::pair<std::string, std::string>> files = {{"stl", binaryStl(tetrahedron())},
                                                                  {"stl", kAsciiStl},
                                                                  {"obj", kObj},
                                                                  {"ply", kAsciiPly},
                                                                  {"ply", binary_ply}};
  for (const auto& [extension, good] : files) {
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (const int value : {0x00, 0xFF, 0x20, 0x2D, 0x39, 0x80}) {
        std::string bad = good;
        bad[at] = static_cast<char>(value);
        const auto mesh = parseMesh(bad, extension, "damaged");
        if (!mesh.ok()) continue;
        const MeshTopology topology = analyseTopology(*mesh);
        EXPECT_EQ(topology.degenerate_triangles + topology.non_finite_positions, 0u)
            << extension << " " << at;
      }
    }
  }
}

TEST(BadMesh, Files) {
  const TempFolder folder;
  std::filesystem::create_directories(folder.path("folder.stl"));
  EXPECT_THAT(loadMesh(folder.path("folder.stl")).error().message, HasSubstr("is a folder"));
  EXPECT_THAT(loadMesh(folder.path("none.stl")).error().message, HasSubstr("no such file"));
  EXPECT_THAT(loadMesh(folder.write("part", kObj)).error().message, HasSubstr("must end in"));
  MeshLoadOptions small;
  small.max_bytes = 100;
  EXPECT_THAT(loadMesh(folder.write("a.obj", kObj), small).error().message,
              HasSubstr("larger than 100 bytes"));
  std::filesystem::create_symlink("/dev/zero", folder.path("zero.stl"));
  EXPECT_THAT(loadMesh(folder.path("zero.stl")).error().message, HasSubstr("not a regular file"));
}

}  // namespace
}  // namespace proveout
