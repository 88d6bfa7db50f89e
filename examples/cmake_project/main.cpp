// Says what the packages hold: of the one in the program, and of the one in a folder beside it.
#include <cstdio>
#include <filesystem>

#include "granite.h"
#include "runtime/package/embedded.h"
#include "runtime/package/package.h"

namespace {

int show(const char* name, const reprise::Result<reprise::Package>& package) {
  if (!package.ok()) {
    std::fprintf(stderr, "%s: %s\n", name, reprise::formatError(package.error()).c_str());
    return 1;
  }
  const reprise::Recipe& variant = package->variant;
  std::printf("%s: %s, period %u, payload %s\n", name, variant.strategy.c_str(), variant.period_frames,
              variant.payload.empty() ? "none" : variant.payload.front().name.c_str());
  return 0;
}

}  // namespace

int main() {
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return show("granite", reprise::readEmbeddedPackage(reprise_packages::granite)) |
         show("agate", reprise::readPackage(folder / "agate"));
}
