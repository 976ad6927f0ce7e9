// System variables and offset tables that no program text reaches alone.
// Proves nct-23.1.15-abskp nct-15.1-N1401 nct-23.1.14-#4401 nct-23.1.14-#4501
// nct-23.1.14-#4502 nct-23.1.14-#4503 nct-23.1.14-#4507 nct-23.1.14-#4508 nct-23.1.14-#4509 nct-23.1.14-#4511
// nct-23.1.14-#4513 nct-23.1.14-#4514 nct-23.1.14-#4515 nct-23.1.14-#4519 nct-23.1.14-#4520 nct-23.1.14-#4530
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/nc/iso/context/context.h"
#include "core/nc/iso/context/output.h"
#include "core/nc/iso/model/offset_tables.h"
#include "core/nc/iso/program/reset.h"
#include "core/nc/iso/system_variables/all_banks.h"
#include "core/nc/iso/system_variables/modal_bank.h"
#include "core/nc/iso/system_variables/position_bank.h"
#include "core/nc/nct/dialect.h"

namespace proveout::nc {
namespace {

class SystemVariablesTest : public testing::Test {
 protected:
  SystemVariablesTest() : source_("O0042.nc", "M30\n"), sink_(path_) {
    settings_.start = Vec3::Zero();
    settings_.work_offsets[0] = Vec3(0, 0, 20);
    context_ = std::make_unique<IsoContext>(nctDialect(), source_, settings_, sink_, nullptr, ControlHost{},
                                            summary_);
    variables_ = nctDialect().system_variables(*context_);
    CallFrame frame;
    const ProgramStore::Loaded main = context_->programs.main();
    frame.setProgram(*main.text, main.file);
    context_->calls.push(frame);
    powerOn(*context_);
  }
  double read(int number) {
    Value out;
    EXPECT_EQ(context_->variables.read(number, out), VariableStatus::kDone) << number;
    return out.vacant ? -1e99 : out.number;
  }
  IsoContext& c() { return *context_; }

  MemoryProgramSource source_;
  ControlSettings settings_;
  Toolpath path_;
  ToolpathBuilder sink_;
  InterpretSummary summary_;
  std::unique_ptr<IsoContext> context_;
  std::unique_ptr<SystemVariables> variables_;
};

constexpr double kVacant = -1e99;

// Length 100, contact with the tip at Z-5, zero point at 20 (manual 21.1, 25.19): the machine stands at 115.
TEST_F(SystemVariablesTest, SkipPositionsWithAndWithoutLength) {
  c().state.length = AxisPoint(0, 0, 100);
  recordSkip(c(), AxisPoint(7, 8, 115));
  EXPECT_NEAR(read(5061), 7, 1e-12);
  EXPECT_NEAR(read(5063), 95, 1e-12);
  EXPECT_NEAR(read(100153), 95, 1e-12);
  EXPECT_NEAR(read(151003), 95, 1e-12);
  EXPECT_NEAR(read(151103) - read(5063), 20, 1e-12);
  ASSERT_EQ(c().parameters.write(1755, 6, 0, 1, false), ParamStatus::kOk);
  EXPECT_NEAR(read(5063), -5, 1e-12);
  EXPECT_NEAR(read(151103), 15, 1e-12);
  c().state.length = AxisPoint();
  recordSkip(c(), AxisPoint(7, 8, 15));
  EXPECT_NEAR(read(5063), -5, 1e-12) << "without a length both readings agree";
}

TEST_F(SystemVariablesTest, OfTheInterruptedBlock) {
  EXPECT_EQ(read(4401), kVacant);
  EXPECT_EQ(read(4507), kVacant);
  EXPECT_EQ(read(4515), kVacant);
  EXPECT_EQ(read(4530), kVacant);
  InterruptedBlock block;
  block.program = 42;
  IsoState& s = block.state;
  s = c().state;
  s.active[kGroupMotion] = 842;
  s.d = 7;
  s.h = 11;
  s.feed = 250;
  s.spindle_rpm = 500;
  s.next_tool = 8;
  s.work_system = kFirstExtended + 4;
  s.last = {0.5, 120, 77, 3, {1, 2, 4}};
  c().interrupted = block;
  EXPECT_EQ(read(4401), 284) << "G84.2";
  EXPECT_EQ(read(4001), 0) << "the block in hand stays what it is";
  EXPECT_EQ(read(4501), 1);
  EXPECT_EQ(read(4502), 2);
  EXPECT_EQ(read(4503), 4);
  EXPECT_EQ(read(4507), 7);
  EXPECT_EQ(read(4508), 0.5);
  EXPECT_EQ(read(4509), 250);
  EXPECT_EQ(read(4511), 11);
  EXPECT_EQ(read(4513), 77);
  EXPECT_EQ(read(4514), 120);
  EXPECT_EQ(read(4515), 42);
  EXPECT_EQ(read(4519), 500);
  EXPECT_EQ(read(4520), 8);
  EXPECT_EQ(read(4530), 5);
}

TEST(ModalVariables, CodesAndPrograms) {
  EXPECT_EQ(modalCode(10), 1);
  EXPECT_EQ(modalCode(511), 151);
  EXPECT_EQ(modalCode(501), 150);
  EXPECT_EQ(modalCode(541), 154);
  EXPECT_EQ(modalCode(434), 443);
  EXPECT_EQ(modalCode(842), 284);
  EXPECT_EQ(modalCode(808), 880);
  EXPECT_EQ(programNumber("O0011.nc"), 11);
  EXPECT_EQ(programNumber("sub/o12345678"), 12345678);
  EXPECT_EQ(programNumber("O123456789.nc"), 0);
  EXPECT_EQ(programNumber("O.nc"), 0);
  EXPECT_EQ(programNumber("O12a.nc"), 0);
  EXPECT_EQ(programNumber("part.nc"), 0);
}

// Three channels with 30, 40 and 60 rows, 10 of them common: 10 + 20 + 30 + 50 rows are used (manual 15.1).
TEST(OffsetTables, ChannelsShareTheFirstRows) {
  OffsetTables tables[3];
  const int rows[3] = {30, 40, 60};
  for (int k = 1; k < 3; ++k) tables[k].share(tables[0], 10);
  int next = 1, used = 0;
  for (int k = 0; k < 3; ++k) {
    for (int row = 1; row <= rows[k]; ++row) {
      if (tables[k].given(OffsetColumn::kLength, row)) continue;
      tables[k].set(OffsetColumn::kLength, row, false, next++);
      ++used;
    }
  }
  EXPECT_EQ(used, 110);
  for (int row = 1; row <= 10; ++row) {
    EXPECT_EQ(tables[0].effective(OffsetColumn::kLength, row), row);
    EXPECT_EQ(tables[2].effective(OffsetColumn::kLength, row), row);
  }
  tables[2].set(OffsetColumn::kLength, 10, true, 0.5);
  EXPECT_EQ(tables[0].effective(OffsetColumn::kLength, 10), 10.5);
  tables[1].set(OffsetColumn::kLength, 11, true, 0.5);
  EXPECT_EQ(tables[0].effective(OffsetColumn::kLength, 11), 11.0);
  EXPECT_EQ(tables[1].effective(OffsetColumn::kLength, 0), 0.0) << "row 0 is 0 and is nobody's";
  tables[2].setTip(3, 4);
  EXPECT_EQ(tables[1].tip(3), 4);
}

TEST(Output, NumbersAsTheManualPrintsThem) {
  EXPECT_EQ(decimalText(35.897421, 5, 3, false), "    35.897");
  EXPECT_EQ(decimalText(-150.8, 5, 3, false), "-  150.800");
  EXPECT_EQ(decimalText(14.8, 2, 0, false), " 15");
  EXPECT_EQ(decimalText(4567, 4, 0, false), " 4567");
  EXPECT_EQ(decimalText(35.897421, 5, 3, true), "35.897");
  EXPECT_EQ(decimalText(-150.8, 5, 3, true), "-150.800");
  EXPECT_EQ(decimalText(14.8, 2, 0, true), "15");
  EXPECT_EQ(decimalText(-0.0004, 1, 3, true), "0.000") << "nothing is left of the sign";
  EXPECT_EQ(decimalText(12345.6, 2, 0, true), "12346") << "all digits where there are more";
  const auto bytes = [](double value, int decimals) {
    std::string out;
    EXPECT_TRUE(binaryBytes(value, decimals, out));
    return out;
  };
  EXPECT_EQ(bytes(318.49362, 3), std::string("\x00\x04\xDC\x1E", 4));
  EXPECT_EQ(bytes(0.723415, 3), std::string("\x00\x00\x02\xD3", 4));
  EXPECT_EQ(bytes(23.9, 0), std::string("\x00\x00\x00\x18", 4));
  EXPECT_EQ(bytes(258.647673, 3), std::string("\x00\x03\xF2\x58", 4));
  EXPECT_EQ(bytes(-1, 0), std::string("\xFF\xFF\xFF\xFF", 4));
  std::string out;
  EXPECT_FALSE(binaryBytes(2147483648.0, 0, out));
  EXPECT_TRUE(binaryBytes(21.0, 8, out));
  EXPECT_FALSE(binaryBytes(22.0, 8, out));
}

TEST(Output, NamesStayInTheFolder) {
  EXPECT_EQ(outputName(" a.txt "), "a.txt");
  EXPECT_EQ(outputName("\\sub\\a.txt"), "sub/a.txt");
  EXPECT_EQ(outputName("данные.txt"), "данные.txt");
  for (const char* bad : {"", " ", "/", "..", "../a", "a/../b", "a/.", "a//b", "a/", "c:a", "a\nb", "a*"}) {
    EXPECT_EQ(outputName(bad), "") << bad;
  }
  EXPECT_EQ(outputName(std::string(61, 'a')), "");
}

}  // namespace
}  // namespace proveout::nc
