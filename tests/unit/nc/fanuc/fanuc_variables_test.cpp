// System variables.
#include <gtest/gtest.h>

#include "core/nc/fanuc/system_variables/offset_numbers.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

using Lines = std::vector<std::string>;
using Settings = std::map<std::string, double>;

ControlSettings withOffsets(const Settings& parameters = {}) {
  ControlSettings settings = runAtZero(parameters);
  settings.parameters.try_emplace("rapid", 1);
  for (const int row : {1, 7}) {
    settings.length_offsets[row] = {50.0, 0.5};
    settings.radius_offsets[row] = {4.0, 0.25};
  }
  return settings;
}

/// The value that a variable has behind those blocks; "null" or the code of an error.
std::string readVariable(const std::string& blocks, const std::string& variable,
                         const ControlSettings& settings = withOffsets(),
                         ControlId control = ControlId::kFanucMill) {
  const IsoRun run(control,
                   "O1\n" + blocks + "\n#500=" + variable +
                       "\nIF[#500 EQ #0]THEN #3000=99(NULL)\n#3000=[#500*10000]*0(X)\nM30\n",
                   settings);
  if (run.error() == "fanuc-3099") return "null";
  if (run.error() != "fanuc-3000") return run.error() + " " + run.message();
  // The value itself comes by way of the output file.
  MemoryProgramSource source("main.nc", "O1\n" + blocks + "\n#500=" + variable + "\nDPRNT[#500[84]]\nM30\n");
  Toolpath path;
  ToolpathBuilder sink(path);
  MemoryOutput output;
  ControlHost host;
  host.output = &output;
  interpret(control, source, settings, sink, nullptr, host);
  std::string text = output.files().at("macro.txt");
  std::erase(text, ' ');
  return IsoRun::number(std::stod(text));
}

// fan-13-offsets
TEST(FanucVariables, OffsetsOfMillsHaveTheirNumbersByMemory) {
  struct Cell {
    int number;
    const char* value;
  };
  // C: H wear, H geometry, D wear, D geometry.
  for (const Cell& one : {Cell{2001, "0.5"},
                          {2201, "50"},
                          {10001, "0.5"},
                          {11001, "50"},
                          {12001, "0.25"},
                          {13001, "4"},
                          {2007, "0.5"},
                          {2207, "50"},
                          {11007, "50"},
                          {13007, "4"},
                          {2200, "0"}})
    EXPECT_EQ(readVariable("", "#" + std::to_string(one.number)), one.value) << one.number;
  EXPECT_EQ(readVariable("#2201=12.5", "#11001"), "12.5");
  EXPECT_EQ(readVariable("#13003=6", "#13003"), "6");
  EXPECT_EQ(readVariable("", "#2401").substr(0, 9), "fanuc-115");
  // What programs write is in force with the next H and D.
  const IsoRun run(ControlId::kFanucMill, "O1\n#11002=20.\n#10002=-1.\nG43 H2 G0 Z10.\nM30\n", withOffsets());
  EXPECT_EQ(run.motions(), (Lines{"R 0 0 29"}));
  EXPECT_EQ(readVariable("#11002=20.\n#10002=-1.\nG43 H2 G0 Z10.", "#5023"), "29");
}

// A: one value a number; B: geometry and wear for H and D alike; C: H and D apart.
TEST(FanucVariables, TheMemorySaysWhichCellsThereAre) {
  using nc::OffsetColumn;
  struct Row {
    int base;
    OffsetColumn column;
    bool wear, both;
    bool operator==(const Row&) const = default;
  };
  const auto rows = [](int memory, bool v15) {
    std::vector<Row> out;
    for (const nc::OffsetNumbers& n : nc::millOffsetNumbers({memory, v15, false, false}))
      out.push_back({n.base, n.column, n.wear, n.both});
    return out;
  };
  constexpr OffsetColumn kH = OffsetColumn::kLength, kD = OffsetColumn::kRadius;
  EXPECT_EQ(rows(0, false), (std::vector<Row>{{2000, kH, false, true}, {10000, kH, false, true}}));
  EXPECT_EQ(rows(1, false), (std::vector<Row>{{2000, kH, true, true},
                                              {10000, kH, true, true},
                                              {2200, kH, false, true},
                                              {11000, kH, false, true}}));
  EXPECT_EQ(rows(1, true), (std::vector<Row>{{2000, kH, false, true},
                                             {10000, kH, false, true},
                                             {2200, kH, true, true},
                                             {11000, kH, true, true}}));
  EXPECT_EQ(rows(2, false).size(), 6u);
  EXPECT_EQ(rows(2, false).back(), (Row{13000, kD, false, false}));
}

// fan-13-v15
TEST(FanucVariables, V15PutsGeometryFirst) {
  const ControlSettings v15 = withOffsets({{"v15", 1}});
  struct Cell {
    int number;
    const char* value;
  };
  for (const Cell& one : {Cell{2001, "50"},
                          {2201, "0.5"},
                          {2401, "4"},
                          {2601, "0.25"},
                          {10001, "50"},
                          {11001, "0.5"},
                          {12001, "4"},
                          {13001, "0.25"}})
    EXPECT_EQ(readVariable("", "#" + std::to_string(one.number), v15), one.value) << one.number;
}

// fan-13-lathe
TEST(FanucVariables, OffsetsOfLathesHaveNumbersOfTheirOwn) {
  const auto lathe = [](const std::string& blocks, const std::string& variable) {
    return readVariable(blocks, variable, runAtZero(), ControlId::kFanucLathe);
  };
  struct Pair {
    int low, high;
  };
  for (const Pair& one : {Pair{2005, 10005},
                          {2105, 11005},
                          {2205, 12005},
                          {2305, 13005},
                          {2405, 14005},
                          {2705, 15005},
                          {2805, 16005},
                          {2905, 17005},
                          {2455, 19005}}) {
    EXPECT_EQ(lathe("#" + std::to_string(one.low) + "=3", "#" + std::to_string(one.high)), "3") << one.low;
  }
  EXPECT_EQ(lathe("", "#2065").substr(0, 9), "fanuc-115");
}

// fan-13-frames fan-13-frames2 fan-13-frames3
TEST(FanucVariables, FramesHaveTheirNumbers) {
  ControlSettings settings = withOffsets();
  settings.common_offset = Vec3(1, 2, 3);
  for (int k = 0; k < 6; ++k) {
    settings.work_offsets[static_cast<std::size_t>(k)] = Vec3(10 * (k + 1), 20, 30);
    settings.work_given[static_cast<std::size_t>(k)] = true;
  }
  settings.extended_offsets[1] = Vec3(100, 0, 0);
  settings.extended_offsets[48] = Vec3(148, 0, 7);
  struct Cell {
    int number;
    const char* value;
  };
  for (const Cell& one :
       {Cell{5201, "1"}, {5203, "3"},    {5221, "10"},   {5223, "30"},   {5241, "20"},   {5321, "60"},
        {7001, "100"},   {7941, "148"},  {7943, "7"},    {14001, "100"}, {14941, "148"}, {2500, "1"},
        {2501, "10"},    {2506, "60"},   {2600, "2"},    {2601, "20"},   {2700, "3"},    {2706, "30"},
        {100301, "1"},   {100351, "10"}, {101001, "100"}})
    EXPECT_EQ(readVariable("", "#" + std::to_string(one.number), settings), one.value) << one.number;
  EXPECT_EQ(readVariable("#5221=77", "#2501", settings), "77");
  EXPECT_EQ(readVariable("#2701=5", "#5223", settings), "5");
  EXPECT_EQ(readVariable("G20\n#5221=1", "#5221", settings), "1");
  EXPECT_EQ(readVariable("G20\n#5221=1\nG21", "#5221", settings), "25.4");
  // New data of the frame in force act from the next block.
  EXPECT_EQ(readVariable("#5221=[#5221+5]\nG0 X0", "#5021", settings), "16");
}

// Row 39. fan-13-position fan-13-5021 fan-13-5041 fan-13-5081 fan-13-5101 fan-13-100001
TEST(FanucVariables, PositionsAreOfTheBlockBefore) {
  ControlSettings settings = withOffsets();
  settings.work_offsets[0] = Vec3(1, 2, 3);
  settings.work_given[0] = true;
  settings.length_offsets[1] = {50.0, 0.0};
  const std::string there = "G43 H1 G0 Z30.\nG0 X10. Y20.";
  struct Cell {
    int number;
    const char* value;
  };
  for (const Cell& one : {Cell{5001, "10"},
                          {5002, "20"},
                          {5003, "30"},
                          {5021, "11"},
                          {5022, "22"},
                          {5023, "83"},
                          {5041, "10"},
                          {5043, "80"},
                          {5083, "50"},
                          {5081, "0"},
                          {5101, "0"},
                          {5181, "0"},
                          {100001, "10"},
                          {100003, "30"},
                          {100053, "83"},
                          {100103, "80"},
                          {100203, "50"}})
    EXPECT_EQ(readVariable(there, "#" + std::to_string(one.number), settings), one.value) << one.number;
  EXPECT_EQ(readVariable(there, "#5004", settings).substr(0, 9), "fanuc-115") << "there are three axes";
  EXPECT_EQ(readVariable("G20\nG0 X1.", "#5001"), "1");
}

// fan-13-modal
TEST(FanucVariables, ModalCodesAndWordsAreTold) {
  struct Cell {
    const char *blocks, *variable, *value;
  };
  for (const Cell& one : {Cell{"G1 X1 F100", "#4001", "1"},
                          {"G18", "#4002", "18"},
                          {"G91", "#4003", "91"},
                          {"", "#4003", "90"},
                          {"G94", "#4005", "94"},
                          {"G20", "#4006", "20"},
                          {"", "#4007", "40"},
                          {"G43 H1 Z1", "#4008", "43"},
                          {"", "#4009", "80"},
                          {"G99", "#4010", "99"},
                          {"", "#4011", "50"},
                          {"", "#4012", "67"},
                          {"G55", "#4014", "55"},
                          {"G54.1 P3", "#4014", "54.1"},
                          {"G54.1 P3", "#4130", "3"},
                          {"", "#4016", "69"},
                          {"F123.5", "#4109", "123.5"},
                          {"S800", "#4119", "800"},
                          {"T7", "#4120", "7"},
                          {"D7", "#4107", "7"},
                          {"G43 H7 Z1", "#4111", "7"},
                          {"M8", "#4113", "8"},
                          {"N40 G0 X1", "#4114", "40"},
                          {"", "#4115", "1"},
                          {"G91", "#4203", "91"},
                          {"S800", "#4319", "800"}})
    EXPECT_EQ(readVariable(one.blocks, one.variable), one.value) << one.blocks << " " << one.variable;
  const ControlSettings haas = withOffsets({{"flavour", 1}});
  EXPECT_EQ(IsoRun(ControlId::kFanucMill, "O1\nG56\nG0 X#4012\nM30\n", haas).motions().size(), 1u);
  EXPECT_EQ(
      IsoRun(ControlId::kFanucLathe,
             "O1\nG96 S100 M3\nG99\n#500=[#4002*1000]+#4005\nG97 S100\nIF[#500 NE 96099]THEN #3000=1\nM30\n")
          .error(),
      "");
  EXPECT_EQ(IsoRun(ControlId::kFanucMill, "O5\nG65 P77\nG0 Y#4115\nM30\nO77\nG0 X#4115\nM99\n", withOffsets())
                .motions(),
            (Lines{"R 77 0 0", "R 77 5 0"}));
}

// fan-13-time fan-13-3003 fan-13-parts fan-13-dio
TEST(FanucVariables, ClocksCountersInputsAndOutputs) {
  EXPECT_EQ(readVariable("#3001=0\nG1 X100. F6000", "#3001"), "1000");
  EXPECT_EQ(readVariable("#3002=2\nG1 X100. F1", "#3002"), "3.6667");
  EXPECT_EQ(readVariable("", "#3011"), "20000101") << "never from the wall clock";
  EXPECT_EQ(readVariable("", "#3012"), "0");
  EXPECT_EQ(readVariable("#3003=3", "#3003"), "3");
  EXPECT_EQ(readVariable("#3004=5", "#3004"), "5");
  EXPECT_EQ(readVariable("", "#3007"), "0");
  EXPECT_EQ(readVariable("G51.1 X0", "#3007"), "1");
  EXPECT_EQ(readVariable("#3901=12", "#3901"), "12");
  EXPECT_EQ(readVariable("#3902=3", "#3902"), "3");
  EXPECT_EQ(readVariable("", "#1000"), "0");
  EXPECT_EQ(readVariable("", "#1032"), "0");
  EXPECT_EQ(readVariable("#1103=1", "#1132"), "8");
  EXPECT_EQ(readVariable("#1132=5", "#1102"), "1");
  EXPECT_EQ(readVariable("", "#3100"), "null");
}

// Row 60. fan-12-vars
TEST(FanucVariables, CommonVariablesAreKeptForTheNextProgram) {
  MemoryProgramSource first("a.nc", "O1\n#1=5\n#100=2\n#500=1\n#900001=7\n#510=3\n#510=#0\nM30\n");
  Toolpath path;
  ToolpathBuilder sink(path);
  ControlHost host;
  host.person.kept = interpret(ControlId::kFanucMill, first, runAtZero(), sink, nullptr, host).kept;
  MemoryProgramSource second(
      "b.nc", "O2\nG0 X[#500+0] Y[#900001+0] Z[#1+#100+#510]\nIF[#100 NE #0]THEN #3000=1\nM30\n");
  Toolpath next;
  ToolpathBuilder next_sink(next);
  EXPECT_TRUE(interpret(ControlId::kFanucMill, second, withOffsets(), next_sink, nullptr, host).ok());
  ASSERT_EQ(next.motions.size(), 1u);
  EXPECT_EQ(next.motions[0].to, Vec3(1, 7, 0));
}

class Plate : public Probe {
 public:
  explicit Plate(double z) : z_(z) {}
  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry*,
                                             const AxisSweep*) override {
    const double from = from_.z(), to = move.to.z();
    from_ = move.to;
    if (!(from > z_ && to <= z_)) return std::optional<double>();
    return std::optional<double>((from - z_) / (from - to));
  }
  void standAt(const Vec3& at) { from_ = at; }

 private:
  double z_;
  Vec3 from_ = Vec3::Zero();
};

// The probe macro of section 12. fan-13-5061
TEST(FanucVariables, AProbeMacroReadsTheContact) {
  const std::string program =
      "O1\nG90 G54 G43 H1 G0 Z20.\n#100=#5003\nG31 Z-10. F100\n#101=#5063\nIF[#5063 LE -9.99]GOTO90\n"
      "G10 L2 P1 Z[#5223+#5063]\nGOTO 99\nN90 #3000=1(NO "
      "CONTACT)\nN99\nDPRNT[#101[44]]\nDPRNT[#5223[44]]\nM30\n";
  const auto run = [&](Probe* probe, MemoryOutput& output, Toolpath& path) {
    MemoryProgramSource source("main.nc", program);
    ToolpathBuilder sink(path);
    ControlSettings settings = withOffsets();
    settings.length_offsets[1] = {50.0, 0.0};
    settings.start = Vec3(0, 0, 20);
    ControlHost host;
    host.output = &output;
    host.probe = probe;
    return interpret(ControlId::kFanucMill, source, settings, sink, nullptr, host);
  };
  Plate plate(53.0);  // the path is that of the spindle nose
  plate.standAt(Vec3(0, 0, 70));
  MemoryOutput output;
  Toolpath path;
  EXPECT_TRUE(run(&plate, output, path).ok())
      << (path.diagnostics.all().empty() ? "" : path.diagnostics.all().front().message);
  if (output.files().contains("macro.txt")) {
    EXPECT_EQ(output.files().at("macro.txt"), "    3.0000\r\n    3.0000\r\n");
  }
  Toolpath without;
  MemoryOutput none;
  EXPECT_FALSE(run(nullptr, none, without).ok());
  bool told = false;
  for (const Diagnostic& d : without.diagnostics.all()) told = told || d.code == "fanuc-3001";
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace proveout::test
