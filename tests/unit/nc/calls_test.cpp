// Variables, open programs and alarm texts of the nct control.
#include <gtest/gtest.h>

#include "core/nc/iso/model/call_stack.h"
#include "core/nc/macro/variables.h"
#include "core/nc/nct/alarms.h"

namespace proveout::nc {
namespace {

double number(VariableStore& store, int n) {
  Value value;
  EXPECT_EQ(store.read(n, value), VariableStatus::kDone);
  return value.vacant ? -999 : value.number;
}

TEST(Variables, LocalsBelongToTheirLevel) {
  VariableStore store;
  EXPECT_EQ(number(store, 1), -999) << "vacant at first";
  EXPECT_EQ(store.write(1, {5}), VariableStatus::kDone);
  Arguments arguments;
  arguments.v[24] = {7};
  ASSERT_TRUE(store.enter(arguments));
  EXPECT_EQ(number(store, 1), -999);
  EXPECT_EQ(number(store, 24), 7);
  store.write(1, {6});
  store.write(100, {1});
  store.leave();
  EXPECT_EQ(number(store, 1), 5);
  EXPECT_EQ(number(store, 24), -999);
  EXPECT_EQ(number(store, 100), 1);
  store.leave();
  EXPECT_EQ(store.level(), 0) << "the main program's level stays";
}

TEST(Variables, SixteenLevelsMayBeOpen) {
  VariableStore store;
  for (int k = 0; k < 16; ++k) EXPECT_TRUE(store.enter({}));
  EXPECT_FALSE(store.enter({}));
  EXPECT_EQ(store.level(), 16);
  store.write(33, {1});
  EXPECT_EQ(number(store, 33), 1);
}

TEST(Variables, ChannelsShareTheFirstGlobalsOfEachKind) {
  VariableStore first, second;
  second.share(first, 40, 30);
  for (const int n : {100, 139, 500, 529}) {
    EXPECT_EQ(second.write(n, {n + 0.5}), VariableStatus::kDone);
    EXPECT_EQ(number(first, n), n + 0.5);
    first.write(n, {1});
    EXPECT_EQ(number(second, n), 1);
  }
  for (const int n : {140, 499, 530, 999}) {
    second.write(n, {7});
    EXPECT_EQ(number(first, n), -999) << n;
    EXPECT_EQ(number(second, n), 7) << n;
  }
}

TEST(Variables, TheEmptyConstantAndProtectedOnesCannotBeWritten) {
  VariableStore store;
  for (const int n : {0, 3100}) {
    EXPECT_EQ(number(store, n), -999);
    EXPECT_EQ(store.write(n, {1}), VariableStatus::kReadOnly);
  }
  store.protect(530, 540);
  EXPECT_EQ(store.write(530, {1}), VariableStatus::kReadOnly);
  EXPECT_EQ(store.write(540, {1}), VariableStatus::kReadOnly);
  EXPECT_EQ(store.write(541, {1}), VariableStatus::kDone);
  for (const int n : {34, 99, 1000, -1}) {
    Value value;
    EXPECT_EQ(store.read(n, value), VariableStatus::kUnknown) << n;
    EXPECT_EQ(store.write(n, {1}), VariableStatus::kUnknown) << n;
  }
  EXPECT_EQ(number(store, 541), 1);
}

class Doubling : public VariableBank {
 public:
  VariableStatus read(int n, Value& out) override {
    out = {2.0 * n};
    return VariableStatus::kDone;
  }
  VariableStatus write(int, const Value&) override { return VariableStatus::kLimit; }
};

TEST(Variables, BanksServeTheirRange) {
  VariableStore store;
  Doubling high, low;
  store.addBank(5000, 5010, high);
  store.addBank(2000, 2000, low);
  EXPECT_EQ(number(store, 5010), 10020);
  EXPECT_EQ(number(store, 2000), 4000);
  EXPECT_EQ(store.write(5000, {1}), VariableStatus::kLimit);
  Value value;
  for (const int n : {1999, 2001, 4999, 5011}) EXPECT_EQ(store.read(n, value), VariableStatus::kUnknown) << n;
}

TEST(CallStack, CallsPutOffRunInOrderAtTheirOwnLevel) {
  CallStack calls;
  CallFrame frame, next;
  calls.push(frame);
  frame.system_code = 1;
  calls.defer(frame);
  frame.system_code = 2;
  calls.defer(frame);
  ASSERT_TRUE(calls.takeDeferred(next));
  EXPECT_EQ(next.system_code, 1);
  calls.push(next);
  EXPECT_FALSE(calls.hasDeferred()) << "the second waits for the first to return";
  frame.system_code = 3;
  calls.defer(frame);
  EXPECT_TRUE(calls.hasDeferred());
  calls.pop();  // drops the third
  ASSERT_TRUE(calls.takeDeferred(next));
  EXPECT_EQ(next.system_code, 2);
  EXPECT_FALSE(calls.takeDeferred(next));
}

TEST(Alarms, TextsTakeTheirSubject) {
  const AlarmTable& alarms = nctAlarms();
  EXPECT_EQ(alarms.message(SharedAlarm::kIllegalAddress, "Q"), "illegal address Q");
  EXPECT_EQ(alarms.message(SharedAlarm::kMissingData, ""), "missing data");
  EXPECT_EQ(alarms.message(SharedAlarm::kProgramNotFound, ""), "file not found");
  EXPECT_EQ(alarms.message(SharedAlarm::kOutOfRange, "L"), "L data out of range");
  EXPECT_EQ(alarms.message(SharedAlarm::kOutOfRange, ""), "data out of range");
  EXPECT_EQ(alarms.message(SharedAlarm::kNotImplemented, "G777"), "function not implemented: G777");
}

}  // namespace
}  // namespace proveout::nc
