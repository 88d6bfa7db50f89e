#include "tests/e2e/small_scenario.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

namespace reprise {

namespace fs = std::filesystem;

namespace {

// Bytes of all files below a folder.
std::uintmax_t sizeOf(const fs::path& folder) {
  std::uintmax_t size = 0;
  std::error_code vanished;
  if (!fs::is_directory(folder, vanished)) return 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, vanished)) {
    if (entry.is_regular_file(vanished)) size += entry.file_size(vanished);
  }
  return size;
}

}  // namespace

SmallScenario::SmallScenario() {
  fs::copy(fs::path(REPRISE_SOURCE_DIR) / "tests/e2e/small", folder_.path(), fs::copy_options::recursive);
}

void SmallScenario::replace(const fs::path& file, const std::string& wanted,
                            const std::string& replacement) const {
  std::string text = textOf(file);
  const std::size_t place = text.find(wanted);
  ASSERT_NE(place, std::string::npos) << file << " does not hold " << wanted;
  ASSERT_EQ(text.find(wanted, place + 1), std::string::npos) << file << " holds several of " << wanted;
  writeText(file, text.replace(place, wanted.size(), replacement));
}

int SmallScenario::lineOf(const fs::path& file, const std::string& wanted) {
  const std::string text = textOf(file);
  const std::size_t place = text.find(wanted);
  if (place == std::string::npos) return 0;
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

CommandSpec optimizeSmall(const SmallScenario& scenario, std::vector<std::string> more) {
  CommandSpec spec;
  spec.words = {REPRISE_EXECUTABLE, "optimize", scenario.toml(), "--max-error", "0.05", "-o",
                scenario.output()};
  spec.words.insert(spec.words.end(), more.begin(), more.end());
  return spec;
}

std::string leftovers(const fs::path& output) {
  std::string found;
  if (!fs::is_directory(output)) return found;
  for (const std::string name : {"result.json", "report.html", "package"}) {
    if (fs::exists(output / name)) found += (output / name).string() + "\n";
  }
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(output)) {
    const std::string name = entry.path().filename().string();
    if (name.find(".tmp") != std::string::npos) found += entry.path().string() + "\n";
  }
  return found;
}

bool waitForMeasurements(Command& run, const fs::path& output) {
  for (std::uintmax_t last_size = 0; run.running();) {
    const std::uintmax_t size = sizeOf(output);
    if (last_size > 0 && size > last_size) return true;
    last_size = std::max(last_size, size);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace reprise
