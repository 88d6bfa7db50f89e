#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "runtime/base/file.h"
#include "runtime/package/package.h"
#include "tests/runtime/sample_package.h"

namespace reprise {
namespace {

class PackageFiles : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::temp_directory_path() / ("reprise-package-test-" + std::to_string(::getpid()));
    ASSERT_TRUE(writePackageFiles(twoPassPackage(), directory_).ok());
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string codeOfReading() const {
    const Result<Package> package = readPackage(directory_);
    return package.ok() ? "" : package.error().code;
  }

  std::filesystem::path directory_;
};

TEST_F(PackageFiles, ReadBackEqualToWhatWasWritten) {
  const Package written = twoPassPackage();
  const Package read = readPackage(directory_).value();
  EXPECT_EQ(read.tool_version, written.tool_version);
  EXPECT_EQ(read.interface, written.interface);
  EXPECT_EQ(read.modules, written.modules);
  EXPECT_EQ(recipeToJson(read.original), recipeToJson(written.original));
  EXPECT_EQ(recipeToJson(read.variant), recipeToJson(written.variant));
  EXPECT_EQ(read.variant.constants.tolerance[0], 0.1f);
  EXPECT_EQ(read.variant.period_frames, kNeverRefresh);
}

TEST_F(PackageFiles, AreRefusedWithAnyByteOfTheManifestChanged) {
  const std::string manifest = readFile(directory_ / "manifest.json").value();
  for (std::size_t at = 0; at < manifest.size(); at += 7) {
    std::string changed = manifest;
    changed[at] = static_cast<char>(changed[at] ^ 0x11);
    ASSERT_TRUE(writeFile(directory_ / "manifest.json", changed).ok());
    const Result<Package> package = readPackage(directory_);
    // White space between tokens may change without a change of meaning; nothing else may.
    if (package.ok()) {
      EXPECT_EQ(recipeToJson(package->variant), recipeToJson(twoPassPackage().variant)) << "byte " << at;
    }
  }
}

TEST_F(PackageFiles, AreRefusedWithTheManifestCutShort) {
  const std::string manifest = readFile(directory_ / "manifest.json").value();
  for (std::size_t size = 0; size + 2 < manifest.size(); size += 97) {
    ASSERT_TRUE(writeFile(directory_ / "manifest.json", manifest.substr(0, size)).ok());
    EXPECT_EQ(codeOfReading(), "package.manifest");
  }
}

TEST_F(PackageFiles, AreRefusedWithAnotherModule) {
  const std::vector<std::uint32_t> other{0x07230203, 5, 0, 0, 0};
  ASSERT_TRUE(writeFile(directory_ / "fragment.spv", bytesOf(other)).ok());
  EXPECT_EQ(codeOfReading(), "package.tampered");
  ASSERT_TRUE(writeFile(directory_ / "fragment.spv", "abc").ok());
  EXPECT_EQ(codeOfReading(), "spirv.size");
}

TEST_F(PackageFiles, AreMissedWithoutAManifest) {
  std::filesystem::remove(directory_ / "manifest.json");
  EXPECT_EQ(codeOfReading(), "package.missing");
}

TEST(CheckPackage, FindsWhatContradictsItself) {
  EXPECT_TRUE(checkPackage(twoPassPackage()).ok());
  const auto codeWith = [](auto change) {
    Package package = twoPassPackage();
    change(package);
    const Result<void> checked = checkPackage(package);
    return checked.ok() ? std::string() : checked.error().code;
  };
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].fragment_module = "nothing"; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].vertex_module = "fragment"; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].colors[0].app_target = 3; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].reads[0].resource = "nothing"; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].reads[0].binding = 40; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.block_pixels = 12; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.period_frames = 3; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.previous_inputs[0].size_bytes = 0; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes.clear(); }), "package.inconsistent");
}

}  // namespace
}  // namespace reprise
