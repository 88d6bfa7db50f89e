// The store and several processes: killed in the middle, and two at once (law 9).
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <thread>

#include "profiler/measurements/store.h"
#include "tests/metrics/scratch_folder.h"
#include "tests/metrics/store_rows.h"

namespace reprise {
namespace {

constexpr int kFrames = 200;

pid_t startChild(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  return child;
}

int exitStatusOf(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

int appendForever(const std::filesystem::path& path) {
  Result<Store> store = Store::open(path);
  if (!store.ok()) return 1;
  for (int i = 0;; ++i) {
    if (!store->appendErrors(keyOf(i), errorRowsOf(i, kFrames)).ok()) return 2;
  }
}

// Number of series from 0 on that are there; each must be whole, and none may lie beyond the first gap.
int countWholePrefix(const Store& store) {
  int count = 0;
  while (true) {
    const auto rows = store.errors(keyOf(count));
    if (!rows.ok() || !rows->has_value()) break;
    EXPECT_EQ(**rows, errorRowsOf(count, kFrames)) << count;
    ++count;
  }
  for (int i = count; i < count + 20; ++i) EXPECT_FALSE(store.errors(keyOf(i))->has_value()) << i;
  return count;
}

TEST(Store, KeepsWholeSeriesOnlyWhenKilled) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "store.sqlite";
  int before = 0;
  for (int round = 0; round < 8; ++round) {
    const pid_t child = startChild([&] { return appendForever(path); });
    // The delays fall at other places of a transaction each time.
    std::this_thread::sleep_for(std::chrono::milliseconds(60 + 37 * round));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the writer stopped by itself with " << WEXITSTATUS(status);

    Result<Store> store = Store::open(path);
    ASSERT_TRUE(store.ok()) << store.error().message;
    const int count = countWholePrefix(*store);
    EXPECT_GE(count, before);
    before = count;
  }
  EXPECT_GT(before, 0);
  // And it goes on from there.
  Store store = Store::open(path).value();
  ASSERT_TRUE(store.appendErrors(keyOf(before), errorRowsOf(before, kFrames)).ok());
  EXPECT_EQ(countWholePrefix(store), before + 1);
}

int appendShare(const std::filesystem::path& path, int first, int step, int count) {
  Result<Store> store = Store::open(path);
  if (!store.ok()) return 1;
  for (int i = first; i < count; i += step) {
    if (!store->appendErrors(keyOf(i), errorRowsOf(i, kFrames)).ok()) return 2;
    // All write this one; the first wins and all succeed.
    if (!store->appendErrors(keyOf(1000), errorRowsOf(1000, kFrames)).ok()) return 3;
    if (!store->errors(keyOf(first))->has_value()) return 4;
  }
  return 0;
}

TEST(Store, ServesTwoProcessesAtOnce) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder / "store.sqlite";
  // No store yet: both also race to make it.
  const pid_t even = startChild([&] { return appendShare(path, 0, 2, 40); });
  const pid_t odd = startChild([&] { return appendShare(path, 1, 2, 40); });
  EXPECT_EQ(exitStatusOf(even), 0);
  EXPECT_EQ(exitStatusOf(odd), 0);
  const Store store = Store::open(path).value();
  EXPECT_EQ(countWholePrefix(store), 40);
  EXPECT_EQ(*store.errors(keyOf(1000)).value(), errorRowsOf(1000, kFrames));
}

}  // namespace
}  // namespace reprise
