#include "io/path_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "core/nc/registry/interpreter.h"

namespace proveout {
namespace {

std::string write(std::string_view format, const std::string& program) {
  std::ostringstream out;
  {
    auto writer = makePathWriter(format, out, "nct");
    EXPECT_TRUE(writer.ok());
    ControlSettings settings;
    settings.start = Vec3(0, 0, 5);
    settings.tool_change_s = 2.5;
    interpret(ControlId::kNct, MemoryProgramSource("a \"b\".nc", program), settings, **writer);
  }
  return out.str();
}

TEST(PathWriter, JsonLines) {
  const std::string text =
      write("jsonl", "N10 T3 M6\nG0 X-0 Y0 Z0.1\nS1500 M4\nG3 X0 Y20 I0 J10 F600\nM30\n");
  const std::string place = R"("source":{"file":"a \"b\".nc","line":)";
  EXPECT_EQ(
      text,
      std::string(R"({"type":"header","schema":"proveout.path/1","control":"nct","frame":"workpiece"})") +
          "\n" + R"({"type":"event","event":"tool","data":{"tool":3},"time_s":2.5,)" + place +
          R"(1,"block":"N10","depth":0}})" + "\n" +
          R"({"type":"motion","id":0,"kind":"rapid","shape":"line","from":[0,0,5],"to":[0,0,0.1],"feed":0,"tool":3,"spindle":0,"time_s":0.0196,)" +
          place + R"(2,"block":"","depth":0}})" + "\n" +
          R"({"type":"event","event":"spindle","data":{"rpm":1500,"direction":"ccw"},)" + place +
          R"(3,"block":"","depth":0}})" + "\n" +
          R"({"type":"motion","id":1,"kind":"feed","shape":"arc","from":[0,0,0.1],"to":[0,20,0.1],"center":[0,10,0.1],"normal":[0,0,1],"sweep_deg":180,"feed":600,"tool":3,"spindle":-1500,"time_s":3.141592654,)" +
          place + R"(4,"block":"","depth":0}})" + "\n" +
          R"({"type":"event","event":"end","data":{"code":"M30"},)" + place + R"(5,"block":"","depth":0}})" +
          "\n");
}

TEST(PathWriter, JsonLinesDiagnostic) {
  const std::string text = write("jsonl", "G777\n");
  EXPECT_NE(text.find(R"({"type":"diagnostic","severity":"error","code":"nct-2123","message":)"),
            std::string::npos);
  EXPECT_NE(text.find(R"("source":{"file":"a \"b\".nc","line":1,"column":1,"text":"G777"}})"),
            std::string::npos);
}

TEST(PathWriter, RotaryAxesAndTurningTools) {
  std::ostringstream out;
  {
    JsonLinesPathWriter writer(out, "nct");
    Motion m;
    AxisSweep sweep;
    sweep.rotary_count = 2;
    sweep.rotary[0] = {{'C'}, 0, 90};
    sweep.rotary[1] = {{'B', '2'}, -1.5, -1.5};
    writer.motion(m, nullptr, &sweep);
    sweep.rotary_count = 0;
    sweep.to = Vec3::UnitX();
    m.channel = 2;
    writer.motion(m, nullptr, &sweep);
  }
  const std::string text = out.str();
  EXPECT_NE(text.find(R"("to":[0,0,0],"rotary":{"C":[0,90],"B2":[-1.5,-1.5]},"feed":0)"), std::string::npos)
      << text;
  EXPECT_NE(text.find(R"("axis_from":[0,0,1],"axis_to":[1,0,0],"law":"vector","feed":0)"), std::string::npos)
      << text;
  EXPECT_NE(text.find(R"("time_s":0,"channel":2,"source")"), std::string::npos) << text;
}

TEST(PathWriter, ThreadsTellTheirAngleAndTheChangeOfTheirLead) {
  std::ostringstream out;
  {
    JsonLinesPathWriter writer(out, "wl4-lathe");
    Motion m;
    m.kind = MotionKind::kThread;
    m.feed = 600;
    m.spindle = 400;
    writer.motion(m, nullptr);
    m.thread_start_deg = 180.1F;
    writer.motion(m, nullptr);
    m.thread_pitch_change = -0.1F;
    writer.motion(m, nullptr);
    m.kind = MotionKind::kFeed;
    writer.motion(m, nullptr);
  }
  std::istringstream in(out.str());
  std::string line;
  std::getline(in, line);  // the header
  for (const char* want :
       {R"("spindle":400,"time_s")", R"("spindle":400,"start_deg":180.1,"time_s")",
        R"("spindle":400,"start_deg":180.1,"pitch_change":-0.1,"time_s")", R"("spindle":400,"time_s")"}) {
    ASSERT_TRUE(std::getline(in, line));
    EXPECT_NE(line.find(want), std::string::npos) << line;
  }
}

TEST(PathWriter, Csv) {
  const std::string text = write("csv", "N10 G1 X1.5 F90\nM30\n");
  EXPECT_NE(text.find("\n0,feed,line,0,0,5,1.5,0,5,90,0,0,1,,,,,,,,\"a \"\"b\"\".nc\",1,N10,0\n"),
            std::string::npos)
      << text;
  const std::size_t header_fields = std::count(text.begin(), text.begin() + text.find('\n'), ',');
  const std::string row = text.substr(text.find('\n') + 1);
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), static_cast<std::ptrdiff_t>(header_fields));
}

TEST(PathWriter, UnknownFormat) {
  std::ostringstream out;
  ASSERT_FALSE(makePathWriter("xml", out, "nct").ok());
}

WireSweep leaningSweep() {
  WireSweep sweep;
  sweep.z_high = 20;
  sweep.lower = {{1, 0}, {0, 1}, {0, 0}, kPi / 2};
  sweep.upper.to = Vec2(3, 4);
  return sweep;
}

TEST(PathWriter, WiresHaveTwoTracks) {
  std::ostringstream jsonl, csv;
  Motion cut;
  cut.kind = MotionKind::kFeed;
  cut.feed = 3;
  {
    JsonLinesPathWriter writer(jsonl, "wedm");
    writer.wireMotion(cut, leaningSweep());
    CsvPathWriter table(csv);
    table.wireMotion(cut, leaningSweep());
    table.wireMotion(cut, leaningSweep());
  }
  EXPECT_NE(
      jsonl.str().find(R"("id":0,"kind":"cut","z":[0,20],"lower":{"from":[1,0],"to":[0,1],"center":[0,0],)"
                       R"("sweep_deg":90},"upper":{"from":[0,0],"to":[3,4]},"feed":3)"),
      std::string::npos)
      << jsonl.str();
  std::ostringstream unusual;
  {
    JsonLinesPathWriter writer(unusual, "wedm");
    WireSweep sweep = leaningSweep();
    sweep.state = {false, true, false, false, false};
    Motion rapid;
    rapid.compensated = true;
    writer.wireMotion(rapid, sweep);
  }
  EXPECT_NE(unusual.str().find(R"("to":[3,4]},"offset":true,"threaded":false,"by_hand":true,"runs":false,)"
                               R"("fluid":false,"condition":false,"feed":0)"),
            std::string::npos)
      << unusual.str();
  EXPECT_NE(csv.str().find("\n0,cut,arc,1,0,0,0,1,0,"), std::string::npos) << csv.str();
  EXPECT_NE(csv.str().find("\n0,cut,line,0,0,20,3,4,20,"), std::string::npos) << csv.str();
  EXPECT_NE(csv.str().find("\n1,cut,arc,"), std::string::npos) << csv.str();
}

}  // namespace
}  // namespace proveout
