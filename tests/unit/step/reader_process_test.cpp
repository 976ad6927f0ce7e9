// A reader that crashes, loops or floods does no harm.
#include "io/step/reader_process.h"

#include <gtest/gtest.h>

namespace proveout::test {
namespace {

ReaderEnd shell(const std::string& command, int most_s = 20) {
  const Result<ReaderEnd> end = runReader("/bin/sh", {"-c", command}, most_s);
  EXPECT_TRUE(end);
  return end ? *end : ReaderEnd{};
}

TEST(ReaderProcess, GivesBothOutputs) {
  const ReaderEnd end = shell("printf out; printf told >&2; exit 3");
  EXPECT_EQ(end.bytes, "out");
  EXPECT_EQ(end.told, "told");
  EXPECT_EQ(end.exit_code, 3);
}

TEST(ReaderProcess, TellsHowItEnded) {
  EXPECT_EQ(shell("kill -SEGV $$").signal, 11);
  EXPECT_TRUE(shell("kill -XCPU $$").too_long);
  EXPECT_TRUE(shell("kill -INT $$").interrupted);
  EXPECT_TRUE(shell("exec sleep 60", 1).too_long);
}

TEST(ReaderProcess, TakesLargeOutputsAndKeepsLittleOfMessages) {
  const ReaderEnd end = shell("head -c 5000000 /dev/zero; head -c 3000000 /dev/zero >&2");
  EXPECT_EQ(end.bytes.size(), 5'000'000u);
  EXPECT_LT(end.told.size(), 200'000u);
}

TEST(ReaderProcess, ToldWhereItCannotStart) { EXPECT_FALSE(runReader("/no/such/program", {}, 1)); }

}  // namespace
}  // namespace proveout::test
