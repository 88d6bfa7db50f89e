#include "cli/device_lock.h"

#include <gtest/gtest.h>

#include <string>

#include "runtime/base/file.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

const std::string kDevice = "a device of this test";

TEST(DeviceLock, TellsWhoHoldsIt) {
  Result<DeviceLock> held = DeviceLock::take(kDevice, "reprise optimize marble.toml", {});
  ASSERT_TRUE(held.ok());
  std::string holder;
  const Result<DeviceLock> second = DeviceLock::take(kDevice, "second", {[&](const std::string& text) { holder = text; }, [] { return true; }});
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().kind, ErrorKind::kInterrupted);
  EXPECT_NE(holder.find("reprise optimize marble.toml"), std::string::npos) << holder;
}

TEST(DeviceLock, IsFreeAfterItsHolder) {
  { const Result<DeviceLock> held = DeviceLock::take(kDevice, "first", {}); }
  EXPECT_TRUE(DeviceLock::take(kDevice, "second", {{}, [] { return true; }}).ok());
}

// A killed process leaves the file with its words; they hold nothing.
TEST(DeviceLock, OfADeadProcessHoldsNothing) {
  ASSERT_TRUE(writeFile(deviceLockFile(kDevice), "process 999999: reprise optimize gone.toml\n").ok());
  EXPECT_TRUE(DeviceLock::take(kDevice, "second", {{}, [] { return true; }}).ok());
}

}  // namespace
}  // namespace reprise
