// Errors in the store that no metric gives.
#include <gtest/gtest.h>

#include <limits>

#include "profiler/training/measure.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

// What is read back after `value` was stored as the rms of a frame.
Result<std::vector<ErrorSeries>> readBack(double value, std::uint64_t nonfinite = 0) {
  const TemporaryFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  Measuring measuring;
  measuring.store = &store;
  SeriesKey key = measuring.base;
  key.session = "train";
  key.variant_hash = "variant";
  key.period_frames = 4;
  ErrorRow row;
  row.frame = 7;
  row.covered = row.hits = 100;
  row.nonfinite = nonfinite;
  row.errors["rms"] = value;
  EXPECT_TRUE(store.appendErrors(key, {row}).ok());
  SeriesRequest request;
  request.variant_hash = "variant";
  request.period_frames = 4;
  return measureErrors(measuring, "train", {request}, 1);
}

TEST(StoredErrors, ThatNoMetricGivesAreRefusedAsDamage) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {-1e-3, -inf, 1.5, inf, nan}) {
    const Result<std::vector<ErrorSeries>> read = readBack(value);
    ASSERT_FALSE(read.ok()) << value;
    EXPECT_EQ(read.error().code, "store.corrupt");
    for (const char* word : {"store.sqlite", "rms", "frame 7"}) EXPECT_NE(read.error().message.find(word), std::string::npos) << read.error().message;
  }
}

TEST(StoredErrors, ThatAMetricGivesAreTaken) {
  for (const double value : {0.0, 0.25, 1.0, 1.0000001}) {
    const Result<std::vector<ErrorSeries>> read = readBack(value);
    ASSERT_TRUE(read.ok()) << formatError(read.error());
    EXPECT_EQ(read->at(0).rows.at(0).errors.at("rms"), value);
  }
  EXPECT_TRUE(readBack(std::numeric_limits<double>::quiet_NaN(), 3).ok());
}

}  // namespace
}  // namespace reprise
