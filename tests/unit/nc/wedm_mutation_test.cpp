// Damaged programs of the wire EDM control: none may crash, hang, or send what is not finite or has gaps.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "wedm_path.h"

namespace proveout {
namespace {

constexpr const char* kPrograms[] = {
    "H001=110;T84T86;G92X1.5Y-1.5;C007;G01Y-1.;G04X0.5;G41H000;Y0;G41H001;G29;G37X50T8.;X0Y0;Y3.;X3.R.5;Y0;"
    "G36;"
    "X1.5;G40H000G01Y-1.;M00;M02;",
    "G92X0Y0U0V0;C001;H001=.1;G01Y4.;G42H000;G51A0Y5.;G42H001;G51A2.X5.Y5.R1.R2.;Y-5.;X-5.;G51A0.Y5.;G51A2."
    "X0;"
    "G40H000G50A0Y4.5;Y0;M02;",
    "H001=.135;G92X0Y0;C001;G61;G41H000;G01Y10.:G01Y10.;G41H001;G02X-10.Y20.J10.:X-10.Y20.;X0Y30.I10.:X0Y30.;"
    "G40;G01X0Y0:X0Y0;G60;M02;",
    "G92X0Y-1.;G74;G01Y0;X10.;Y10.U-3.V-4.;X5.U0V0;G75;Y-1.;M98P0010L3;M02;N0010;G91;G31X1.;G01X1.;G03X2.I1.;"
    "G30;G90;G05;G08;M99;",
    "G92X-18.Y0;C001;H002=200;G42H002;G52A2.5;G01X-10.;Y-6.;G03X-6.Y-10.I4.;G01X6.;G03X10.Y-6.J4.;G01Y6.;"
    "G42H002G34X2.Y8.;G40G50X-18.;M02;",
};
constexpr const char* kWords[] = {
    "G40", "G41H001", "G42H002", "G51A3.", "G50", "X0", "Y5.",      "G02I1.", "G03J-2.5",   "R.5",
    ";",   ":",       "G61",     "G74",    "G91", "/",  "G92X0",    "U1.",    "H001=2H000", "M99",
    "(",   "G20",     "G00",     "L999",   "-",   ".",  "M98P0010", "G31X3.", "G37X.1"};

std::string damaged(std::mt19937& random) {
  std::string text = kPrograms[random() % std::size(kPrograms)];
  const int changes = 1 + static_cast<int>(random() % 6);
  for (int k = 0; k < changes; ++k) {
    const std::size_t at = random() % (text.size() + 1);
    switch (random() % 4) {
      case 0:
        text.erase(at, random() % 4);
        break;
      case 1:
        text.insert(at, 1, static_cast<char>(' ' + random() % 95));
        break;
      case 2: {
        const std::size_t end = text.find(';', at);
        if (end != std::string::npos)
          text.insert(end + 1, std::string(kWords[random() % std::size(kWords)]) + ";");
        break;
      }
      default:
        text.insert(at, kWords[random() % std::size(kWords)]);
    }
  }
  return text;
}

void checkTrack(const WireTrack& t, const std::string& text) {
  ASSERT_TRUE(t.from.allFinite() && t.to.allFinite() && t.center.allFinite() && std::isfinite(t.sweep_rad))
      << text;
  if (t.sweep_rad != 0.0) {
    EXPECT_NEAR((t.from - t.center).norm(), (t.to - t.center).norm(), 1e-6) << text;
    EXPECT_LT((test::wireTrackPoint(t, 1.0) - t.to).norm(), 1e-5) << text;
  }
}

TEST(WedmMutations, PathsOfDamagedProgramsAreSound) {
  std::mt19937 random(7);
  int errors = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const std::string text = damaged(random);
    ControlSettings settings;
    settings.block_limit = 2000;
    if (trial % 5 == 0)
      settings.parameters = {{"ZM", 20}, {"ZS", 0}, {"UV_UPPER", 1}, {"TAPER_ARC", 1}, {"H.1", 0.3}};
    settings.max_errors = 1 + trial % 3;
    const test::WedmPath run(text, settings);
    errors += run.summary.errors > 0;
    EXPECT_EQ(run.summary.errors, run.path.diagnostics.errorCount());
    if (run.summary.end == ProgramEnd::kAlarm) {
      EXPECT_GT(run.summary.errors, 0) << text;
    }
    for (std::size_t k = 0; k < run.count(); ++k) {
      checkTrack(run.wire(k).lower, text);
      checkTrack(run.wire(k).upper, text);
      EXPECT_TRUE(std::isfinite(run.path.motions[k].time_s) && run.path.motions[k].time_s >= 0.0) << text;
      if (k == 0 || run.summary.errors > 0) continue;
      EXPECT_LT((run.wire(k).lower.from - run.wire(k - 1).lower.to).norm(), 1e-6) << k << " " << text;
      EXPECT_LT((run.wire(k).upper.from - run.wire(k - 1).upper.to).norm(), 1e-6) << k << " " << text;
    }
  }
  EXPECT_GT(errors, 1000);
}

}  // namespace
}  // namespace proveout
