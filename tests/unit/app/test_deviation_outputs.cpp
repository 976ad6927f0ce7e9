// The files of deviations of whole runs, against what is known of the part in closed form.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "app/deviation/deviation_outputs.h"
#include "app/session/session.h"
#include "io/mesh_io.h"
#include "io/sha256.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/app/block_job.h"

namespace proveout {
namespace {

using app_test::blockJob;
using app_test::toolOf;

std::string bytesOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// What a deviation PLY holds, by names of properties; read by its header.
struct PlyTable {
  std::vector<std::map<std::string, double>> vertices;
  std::string head;
};

PlyTable readPlyTable(const std::string& bytes) {
  PlyTable out;
  const std::size_t body = bytes.find("end_header\n") + 11;
  out.head = bytes.substr(0, body);
  std::istringstream lines(out.head);
  std::vector<std::pair<std::string, std::string>> properties;
  std::size_t count = 0;
  bool of_vertex = false;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, kind, name;
    words >> word >> kind >> name;
    if (word == "element") of_vertex = kind == "vertex";
    if (word == "element" && of_vertex) count = std::stoul(name);
    if (word == "property" && of_vertex) properties.emplace_back(kind, name);
  }
  std::size_t at = body;
  for (std::size_t i = 0; i < count; ++i) {
    auto& vertex = out.vertices.emplace_back();
    for (const auto& [kind, name] : properties) {
      if (kind == "uchar") {
        vertex[name] = static_cast<unsigned char>(bytes[at++]);
        continue;
      }
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < 4; ++k)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
      at += 4;
      vertex[name] = kind == "float" ? std::bit_cast<float>(word) : static_cast<std::int32_t>(word);
    }
  }
  return out;
}

TriMesh boxMesh(const Vec3& low, const Vec3& high) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(Eigen::Vector3f(static_cast<float>((i & 1) != 0 ? high.x() : low.x()),
                                             static_cast<float>((i & 2) != 0 ? high.y() : low.y()),
                                             static_cast<float>((i & 4) != 0 ? high.z() : low.z())));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A run with its files in a folder.
class WrittenRun {
 public:
  WrittenRun(Job job, const TriMesh& nominal, const std::vector<std::string>& programs) {
    EXPECT_TRUE(writeMesh(nominal, folder_.path("nominal.stl"), MeshFormat::kStlBinary).ok());
    job.nominal.emplace();
    job.nominal->mesh.path = folder_.path("nominal.stl");
    job.simulation.causes = CauseSearch::kOff;
    job.output.deviation = {DeviationOutput::kPly, DeviationOutput::kGlb, DeviationOutput::kCsv};
    for (const std::string& program : programs) {
      memory_.push_back(std::make_unique<MemoryProgramSource>("part.nc", program));
      recorded_.push_back(std::make_unique<RecordingSource>(*memory_.back(), TextEncoding::kAuto));
      sources_.push_back(recorded_.back().get());
    }
    Result<RunResult> made = runRecorded(job, sources_, progress_);
    EXPECT_TRUE(made.ok()) << made.error().message;
    run = std::move(*made);
    write(job, "out");
    job_ = job;
  }

  void write(const Job& job, const std::string& name) {
    Result<StagingFolder> staging = StagingFolder::create(folder_.path(name));
    ASSERT_TRUE(staging.ok());
    OutputFailures failures;
    report = Report();
    writeRunDeviation(job, run, sources_, progress_, *staging, report, failures);
    EXPECT_TRUE(failures.empty());
    const Status written = staging->write("report.json", [](const std::string& path) -> Status {
      std::ofstream(path) << "{}";
      return Done{};
    });
    EXPECT_TRUE(written.ok());
    EXPECT_TRUE(staging->commit().ok());
  }
  void writeAgain(const std::string& name) { write(job_, name); }
  std::string file(const std::string& name) const { return folder_.path(name); }
  PlyTable ply() const { return readPlyTable(bytesOf(file("out/block-deviation.ply"))); }
  std::vector<std::vector<std::string>> points() const {
    std::ifstream in(file("out/points.csv"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) {
      auto& row = rows.emplace_back();
      std::istringstream fields(line.substr(0, line.size() - 1) + ",");
      for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    }
    return rows;
  }

  RunResult run;
  Report report;

 private:
  test::TemporaryFolder folder_;
  std::vector<std::unique_ptr<MemoryProgramSource>> memory_;
  std::vector<std::unique_ptr<RecordingSource>> recorded_;
  RunSources sources_;
  Progress progress_;
  Job job_;
};

/// Slots of two tools, 1 and 2 mm deep, into a block whose nominal is the whole block.
WrittenRun twoSlots() {
  return WrittenRun(blockJob("block", {40, 40, 10}, {toolOf(1, 6), toolOf(2, 8)}),
                    boxMesh({0, 0, -10}, {40, 40, 0}),
                    {"G21 G90 T1 M6\nS1000 M3\nG0 X10 Y-10 Z5\nG0 Z-1\nN50 G1 Y50 F200\nG0 Z50\n"
                     "T2 M6\nS1000 M3\nG0 X30 Y-10\nG0 Z-2\nN110 G1 Y50 F200\nG0 Z50\nM30\n"});
}

TEST(DeviationOutputs, TellDeviationBlockAndToolOfEachVertex) {
  const WrittenRun written = twoSlots();
  const PlyTable table = written.ply();
  int first = 0, second = 0, blank = 0;
  for (const auto& v : table.vertices) {
    const Vec3 p(v.at("x"), v.at("y"), v.at("z"));
    const double depth = -p.z(), side = std::min({p.x(), 40 - p.x(), p.y(), 40 - p.y()});
    const double expected = -std::max(0.0, std::min({depth, 10 - depth, side}));
    EXPECT_NEAR(v.at("deviation"), expected, 2e-5) << p.transpose();
    const bool in_first = std::abs(p.x() - 10) < 2.9 && std::abs(depth - 1) < 1e-4;
    const bool in_second = std::abs(p.x() - 30) < 3.9 && std::abs(depth - 2) < 1e-4;
    if (in_first || in_second) {
      ++(in_first ? first : second);
      EXPECT_EQ(v.at("tool"), in_first ? 1 : 2);
      EXPECT_EQ(v.at("line"), in_first ? 5 : 11);
      EXPECT_EQ(v.at("block"), in_first ? 50 : 110);
      EXPECT_EQ(v.at("file"), 0);
      EXPECT_EQ(v.at("setup"), 0);
      if (side > 1) {
        EXPECT_GT(v.at("blue"), v.at("red"));  // of missing material
      }
    } else if (std::abs(p.x() - 20) < 5 || depth > 3) {
      ++blank;
      for (const char* name : {"tool", "line", "block", "file", "setup"}) EXPECT_EQ(v.at(name), -1) << name;
      EXPECT_EQ(v.at("red"), v.at("green"));  // within tolerance
    }
  }
  EXPECT_GT(first, 100);
  EXPECT_GT(second, 100);
  EXPECT_GT(blank, 100);
  EXPECT_THAT(table.head, ::testing::HasSubstr("comment file 0 part.nc"));
}

TEST(DeviationOutputs, AreWhatWasCompared) {
  const WrittenRun written = twoSlots();
  const PlyTable table = written.ply();
  const Comparison& comparison = *written.run.comparison;
  ASSERT_GE(table.vertices.size(), comparison.vertex_deviation.size());
  EXPECT_EQ(table.vertices.size(), comparison.machined_samples);
  for (std::size_t i = 0; i < comparison.vertex_deviation.size(); ++i) {
    const auto& v = table.vertices[i];
    EXPECT_EQ(v.at("deviation"), comparison.vertex_deviation[i]);
    EXPECT_EQ(Eigen::Vector3f(v.at("x"), v.at("y"), v.at("z")), written.run.surface().mesh.positions[i]);
  }
}

TEST(DeviationOutputs, PointsOverToleranceAreThoseOfTheMesh) {
  const WrittenRun written = twoSlots();
  const auto rows = written.points();
  std::size_t over = 0;
  for (const auto& v : written.ply().vertices)
    over += v.at("deviation") < -0.02f || v.at("deviation") > 0.05f ? 1 : 0;
  ASSERT_EQ(rows.size(), over + 1);
  double before = 1e9;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size());
    const double x = std::stod(rows[i][0]), z = std::stod(rows[i][2]), deviation = std::stod(rows[i][3]);
    EXPECT_LE(std::abs(deviation), before);
    before = std::abs(deviation);
    EXPECT_EQ(rows[i][7], "0.02");
    if (z > -0.9 * std::min({x, 40 - x, std::stod(rows[i][1]), 40 - std::stod(rows[i][1])})) {
      EXPECT_EQ(rows[i][6], "1") << "the nearest place of the nominal is its top";
    }
    if (rows[i][13] == "1") {
      EXPECT_EQ(rows[i][11], "5");
    }
  }
}

TEST(DeviationOutputs, ShowAPocketThatWasNeverCut) {
  // One large face of the blank over it: the difference is between the vertices of the part's mesh.
  TriMesh nominal = boxMesh({0, 0, -10}, {40, 40, 0});
  const TriMesh pocket = boxMesh({10, 10, -5}, {30, 30, 0});
  nominal.triangles.erase(nominal.triangles.begin() + 2, nominal.triangles.begin() + 4);  // its top
  for (const Eigen::Vector3f& p : pocket.positions) nominal.positions.push_back(p);
  for (std::size_t t = 0; t < pocket.triangles.size(); ++t) {
    auto [a, b, c] = pocket.triangles[t];
    if (t != 2 && t != 3) nominal.triangles.push_back({8 + a, 8 + c, 8 + b});
  }
  const std::uint32_t outer[] = {4, 5, 7, 6}, inner[] = {12, 13, 15, 14};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = (i + 1) % 4;
    nominal.triangles.push_back({outer[i], outer[k], inner[k]});
    nominal.triangles.push_back({outer[i], inner[k], inner[i]});
  }
  const WrittenRun written(blockJob("block", {40, 40, 10}, {toolOf(1, 6)}), nominal,
                           {"G21 G90 T1 M6\nS1000 M3\nG0 X-20 Y-20 Z5\nG1 Y-30 F100\nM30\n"});
  std::size_t shown = 0;
  for (const auto& v : written.ply().vertices) {
    if (std::abs(v.at("x") - 20) > 4 || std::abs(v.at("y") - 20) > 4 || v.at("z") < -1e-3) continue;
    ++shown;
    EXPECT_NEAR(v.at("deviation"), 5.0, 1e-4);  // to its floor, 5 mm below
    EXPECT_EQ(v.at("tool"), -1);
  }
  EXPECT_GT(shown, 50u);
}

TEST(DeviationOutputs, NameTheClampingThatLeftAPlace) {
  Job job = blockJob("block", {20, 20, 10}, {toolOf(1, 6)});
  SetupSpec top, bottom;
  top.name = "top";
  bottom.name = "bottom";
  bottom.from_previous = {rotationAbout(Vec3::UnitX(), 180), {0, 20, -10}};
  job.setups = {top, bottom};
  const char* const slot = "G21 G90 T1 M6\nS1000 M3\nG0 X10 Y-10 Z5\nG0 Z-2\nG1 Y30 F200\nG0 Z50\nM30\n";
  const char* const shallow =
      "\n\nG21 G90 T1 M6\nS1000 M3\nG0 X10 Y-10 Z5\nG0 Z-1\nG1 Y30 F200\nG0 Z50\nM30\n";
  const WrittenRun written(job, boxMesh({0, 0, -10}, {20, 20, 0}), {slot, shallow});
  // In the frame of the last clamping the first one's floor is 2 mm above the bottom.
  std::size_t of_top = 0, of_bottom = 0;
  for (const auto& v : written.ply().vertices) {
    if (std::abs(v.at("x") - 10) > 2.5) continue;
    const bool left_first = std::abs(v.at("z") + 8) < 1e-3, left_last = std::abs(v.at("z") + 1) < 1e-3;
    if (!left_first && !left_last) continue;
    ++(left_first ? of_top : of_bottom);
    EXPECT_EQ(v.at("setup"), left_first ? 0 : 1);
    EXPECT_EQ(v.at("line"), left_first ? 5 : 7);
    EXPECT_EQ(v.at("tool"), 1);
  }
  EXPECT_GT(of_top, 50u);
  EXPECT_GT(of_bottom, 50u);
}

TEST(DeviationOutputs, AreRecordedWithTheirHashesAndComeOutTheSame) {
  WrittenRun written = twoSlots();
  ASSERT_EQ(written.report.outputs.data.size(), 3u);
  for (const ReportData& data : written.report.outputs.data)
    EXPECT_EQ(data.sha256, *sha256OfFile(written.file("out/" + data.path)));
  EXPECT_EQ(written.report.outputs.data[2].what, "points");
  const Report first = written.report;
  written.writeAgain("again");
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_EQ(written.report.outputs.data[k].sha256, first.outputs.data[k].sha256);
  const Result<TriMesh> glb = loadMesh(written.file("out/block-deviation.glb"));
  ASSERT_TRUE(glb.ok()) << glb.error().message;
  EXPECT_NEAR(meshVolume(*glb), meshVolume(written.run.surface().mesh), 1e-3);
  EXPECT_TRUE(analyseTopology(*glb).closedManifold());
}

TEST(DeviationOutputs, HaveNamesThatAreGuarded) {
  Job job = blockJob("deviation", {1, 1, 1}, {});
  job.output.formats = {OutputFormat::kPly, OutputFormat::kGlb, OutputFormat::kThreeMf};
  job.output.deviation = {DeviationOutput::kPly, DeviationOutput::kGlb, DeviationOutput::kCsv};
  job.output.csv = true;
  std::vector<std::string> names = outputNames(job);
  for (const char* name : {"deviation.ply", "deviation.3mf", "deviation-deviation.ply",
                           "deviation-deviation.glb", "points.csv", "findings.csv"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end()) << "two files of one name";
}

}  // namespace
}  // namespace proveout
