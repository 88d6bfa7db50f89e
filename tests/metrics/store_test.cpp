// The store within one process: round trips (law 6), append-only, and files that it must not take.
#include "profiler/measurements/store.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "runtime/base/file.h"
#include "tests/metrics/scratch_folder.h"
#include "tests/metrics/store_rows.h"

namespace reprise {
namespace {

RC_GTEST_PROP(Store, GivesErrorRowsBackAsTheyWere, (const SeriesKey& key, const std::vector<ErrorRow>& rows)) {
  const ScratchFolder folder;
  {
    Store store = Store::open(folder / "store.sqlite").value();
    RC_ASSERT(store.appendErrors(key, rows).ok());
  }
  const Store store = Store::open(folder / "store.sqlite").value();
  const auto read = store.errors(key);
  RC_ASSERT(read.ok());
  RC_ASSERT(read->has_value());
  RC_ASSERT(**read == rows);
}

RC_GTEST_PROP(Store, GivesTimesOfAllRunsBackInOrder, (const SeriesKey& key, const std::string& run)) {
  const auto first = *rc::gen::container<std::vector<TimeRow>>(anyTimeRow(run));
  const auto second = *rc::gen::container<std::vector<TimeRow>>(anyTimeRow(run + "+"));
  const ScratchFolder folder;
  {
    Store store = Store::open(folder / "store.sqlite").value();
    RC_ASSERT(store.appendTimes(key, first).ok());
    RC_ASSERT(store.appendTimes(key, second).ok());
  }
  std::vector<TimeRow> all = first;
  all.insert(all.end(), second.begin(), second.end());
  RC_ASSERT(Store::open(folder / "store.sqlite").value().times(key).value() == all);
}

RC_GTEST_PROP(Store, KeepsFailuresAndTexts, (const SeriesKey& key, const std::string& name, const std::string& text)) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  const FailureRow failure{name, text};
  RC_ASSERT(store.appendFailure(key, failure).ok());
  RC_ASSERT(store.putText(name, text).ok());
  RC_ASSERT(store.failure(key).value() == failure);
  RC_ASSERT(store.text(name).value() == text);
}

RC_GTEST_PROP(Store, TellsKeysApart, (const SeriesKey& key, const SeriesKey& other)) {
  RC_PRE(key != other);
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  RC_ASSERT(store.appendErrors(key, errorRowsOf(1, 2)).ok());
  RC_ASSERT(!store.errors(other).value().has_value());
  RC_ASSERT(store.times(other)->empty());
  RC_ASSERT(!store.failure(other).value().has_value());
}

TEST(Store, TellsKeysApartThatDifferInOneField) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  const SeriesKey key = keyOf(0);
  ASSERT_TRUE(store.appendErrors(key, errorRowsOf(0, 1)).ok());
  std::vector<SeriesKey> others(11, key);
  others[0].variant_hash += "x";
  others[1].shader_hash += "x";
  others[2].scenario_hash += "x";
  others[3].session += "x";
  others[4].device += "x";
  others[5].driver += "x";
  ++others[6].width;
  ++others[7].height;
  ++others[8].seed;
  others[9].period_frames = 0;
  others[10].tool_version += "x";
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_FALSE(store.errors(others[i])->has_value()) << i;
  EXPECT_TRUE(store.errors(key)->has_value());
}

TEST(Store, TellsAnEmptySeriesFromNone) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  ASSERT_TRUE(store.appendErrors(keyOf(1), {}).ok());
  ASSERT_TRUE(store.errors(keyOf(1))->has_value());
  EXPECT_TRUE((*store.errors(keyOf(1)))->empty());
  EXPECT_FALSE(store.errors(keyOf(2))->has_value());
}

TEST(Store, KeepsNanAndInfinity) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  std::vector<ErrorRow> rows = errorRowsOf(1, 1);
  rows[0].errors = {{"rms", std::numeric_limits<double>::quiet_NaN()}, {"p95", std::numeric_limits<double>::infinity()}};
  ASSERT_TRUE(store.appendErrors(keyOf(1), rows).ok());
  const std::vector<ErrorRow> read = *store.errors(keyOf(1)).value();
  EXPECT_TRUE(std::isnan(read[0].errors.at("rms")));
  EXPECT_EQ(read[0].errors.at("p95"), std::numeric_limits<double>::infinity());
}

TEST(Store, NeverChangesWhatIsThere) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  const SeriesKey key = keyOf(1);
  ASSERT_TRUE(store.appendErrors(key, errorRowsOf(1, 3)).ok());
  ASSERT_TRUE(store.appendErrors(key, errorRowsOf(2, 5)).ok());
  EXPECT_EQ(*store.errors(key).value(), errorRowsOf(1, 3));
  ASSERT_TRUE(store.appendFailure(key, {"worker.crashed", "first"}).ok());
  ASSERT_TRUE(store.appendFailure(key, {"worker.timeout", "second"}).ok());
  EXPECT_EQ(store.failure(key).value(), (FailureRow{"worker.crashed", "first"}));
  ASSERT_TRUE(store.putText("name", "first").ok());
  ASSERT_TRUE(store.putText("name", "second").ok());
  EXPECT_EQ(store.text("name").value(), "first");
}

TEST(Store, TakesTheTimesOfARunOnce) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  const std::vector<TimeRow> rows = {{"run", 0, 10, 1, 2, 3}, {"run", 1, 11, 1, 2, 4}};
  ASSERT_TRUE(store.appendTimes(keyOf(1), rows).ok());
  ASSERT_TRUE(store.appendTimes(keyOf(1), rows).ok());
  EXPECT_EQ(store.times(keyOf(1)).value(), rows);
}

TEST(Store, RefusesOtherTimesUnderTheSameRun) {
  const ScratchFolder folder;
  Store store = Store::open(folder / "store.sqlite").value();
  ASSERT_TRUE(store.appendTimes(keyOf(1), {{"run", 0, 10, 1, 2, 3}}).ok());
  const Result<void> again = store.appendTimes(keyOf(1), {{"run", 0, 10, 5, 6, 7}});
  ASSERT_FALSE(again.ok());
  EXPECT_EQ(again.error().code, "store.run_reused");
  EXPECT_EQ(store.times(keyOf(1))->size(), 1u);
  // The run of another series is another matter: all variants of a job share its run id.
  EXPECT_TRUE(store.appendTimes(keyOf(2), {{"run", 0, 10, 5, 6, 7}}).ok());
}

std::string codeOfOpening(const std::filesystem::path& path) {
  const Result<Store> store = Store::open(path);
  return store.ok() ? "" : store.error().code;
}

TEST(Store, RefusesWhatIsNoDatabase) {
  const ScratchFolder folder;
  ASSERT_TRUE(writeFile(folder / "text", std::string(5000, 'x')).ok());
  EXPECT_EQ(codeOfOpening(folder / "text"), "store.corrupt");
  EXPECT_EQ(readFile(folder / "text").value(), std::string(5000, 'x'));
}

TEST(Store, RefusesAFileWhosePagesAreDamaged) {
  const ScratchFolder folder;
  {
    Store store = Store::open(folder / "store.sqlite").value();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(store.appendErrors(keyOf(i), errorRowsOf(i, 50)).ok());
  }
  std::string bytes = readFile(folder / "store.sqlite").value();
  for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 8192; ++i) bytes[i] = '\x5a';
  ASSERT_TRUE(writeFile(folder / "damaged", bytes).ok());
  EXPECT_EQ(codeOfOpening(folder / "damaged"), "store.corrupt");
  ASSERT_TRUE(writeFile(folder / "truncated", bytes.substr(0, bytes.size() / 3)).ok());
  EXPECT_EQ(codeOfOpening(folder / "truncated"), "store.corrupt");
}

// Offsets of big-endian numbers in the header of every SQLite file (its file format, section 1.3).
constexpr std::size_t kUserVersionOffset = 60, kApplicationIdOffset = 68;

std::filesystem::path storeWithHeaderByte(const ScratchFolder& folder, std::size_t offset, char value) {
  { const Store store = Store::open(folder / "store.sqlite").value(); }
  std::string bytes = readFile(folder / "store.sqlite").value();
  bytes[offset] = value;
  REPRISE_CHECK(writeFile(folder / "changed.sqlite", bytes).ok(), folder.path().string());
  return folder / "changed.sqlite";
}

TEST(Store, RefusesAFileOfANewerVersion) {
  const ScratchFolder folder;
  const Result<Store> store = Store::open(storeWithHeaderByte(folder, kUserVersionOffset + 3, 99));
  ASSERT_FALSE(store.ok());
  EXPECT_EQ(store.error().code, "store.version");
  EXPECT_EQ(store.error().kind, ErrorKind::kInput);
  EXPECT_NE(store.error().message.find("99"), std::string::npos);
}

TEST(Store, RefusesADatabaseOfAnotherProgram) {
  const ScratchFolder folder;
  EXPECT_EQ(codeOfOpening(storeWithHeaderByte(folder, kApplicationIdOffset, 1)), "store.corrupt");
}

TEST(Store, RefusesAFolderAndAPathBelowAFile) {
  const ScratchFolder folder;
  EXPECT_EQ(codeOfOpening(folder.path()), "store.unwritable");
  ASSERT_TRUE(writeFile(folder / "file", "x").ok());
  EXPECT_EQ(codeOfOpening(folder / "file" / "store.sqlite"), "store.unwritable");
}

TEST(Store, MakesTheFolderItLiesIn) {
  const ScratchFolder folder;
  EXPECT_TRUE(Store::open(folder / "a" / "b" / "store.sqlite").ok());
}

// A limit on the size of files stands for the full disk: writing beyond it fails in the middle of a transaction.
void appendUntilFull(const std::filesystem::path& path) {
  std::signal(SIGXFSZ, SIG_IGN);
  Result<Store> store = Store::open(path);
  if (!store.ok()) _exit(10);
  const rlimit limit{200'000, 200'000};
  if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(11);
  for (int i = 0; i < 1000; ++i) {
    const Result<void> appended = store->appendErrors(keyOf(i), errorRowsOf(i, 100));
    if (appended.ok()) continue;
    if (appended.error().code != "store.unwritable") _exit(12);
    if (i == 0) _exit(13);
    // What was there before can still be read.
    _exit(store->errors(keyOf(0)).ok() ? 0 : 14);
  }
  _exit(15);
}

TEST(Store, SaysThatTheDiskIsFullAndKeepsWhatItHas) {
  const ScratchFolder folder;
  const pid_t child = fork();
  if (child == 0) appendUntilFull(folder / "store.sqlite");
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 0);

  const Store store = Store::open(folder / "store.sqlite").value();
  int whole = 0;
  while (store.errors(keyOf(whole))->has_value()) {
    EXPECT_EQ(*store.errors(keyOf(whole)).value(), errorRowsOf(whole, 100)) << whole;
    ++whole;
  }
  EXPECT_GT(whole, 0);
}

}  // namespace
}  // namespace reprise
