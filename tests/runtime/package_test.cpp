#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "runtime/base/file.h"
#include "runtime/base/hash.h"
#include "runtime/package/package.h"

namespace reprise {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;

// Of the modules only the magic number and the hash are looked at here.
Package samplePackage() {
  Package package;
  package.tool_version = "1.2.3";
  package.interface.outputs = {{"color", 0, ScalarKind::kFloat, 4}};
  package.interface.descriptors = {{"Scene", 0, 0, 1, DescriptorKind::kUniformBlock, ImageDimension::kNone, kStageVertex, 64,
                                    {{"view_projection", ScalarKind::kFloat, 4, 4, 0, 16, false, 0, 0}}}};
  package.interface.push_constant_name = "Object";
  package.interface.push_constants = {{kStageVertex, 0, 64}};
  package.modules = {{"original_vertex", {kMagic, 1, 0, 0, 0}}, {"fragment", {kMagic, 2, 0, 0, 0}}, {"vertex", {kMagic, 3, 0, 0, 0}}, {"fragment_hits", {kMagic, 4, 0, 0, 0}}};
  const auto entry = [&](const std::string& name, const std::string& stage) {
    return ModuleEntry{name, stage, contentHash(bytesOf(package.modules.at(name)))};
  };
  Recipe& original = package.original;
  original.strategy = "original";
  original.uses_reprise_set = false;
  original.modules = {entry("original_vertex", "vertex"), entry("fragment", "fragment")};
  Pass pass;
  pass.name = "original";
  pass.vertex_module = "original_vertex";
  pass.fragment_module = "fragment";
  pass.colors = {{0, "", LoadOp::kClear, BlendKind::kReplace, 0}};
  original.passes = {pass};
  Recipe& variant = package.variant;
  variant.strategy = "two_pass";
  variant.period_frames = kNeverRefresh;
  variant.reprise_set = 1;
  variant.constants.tolerance[0] = 0.1f;  // not exact in binary: the text must bring back the same float
  variant.resources = {{"cache", ResourceFormat::kRg16Sfloat, 1, Lifetime::kHistory, {0, 0, 0, 0}}};
  variant.modules = {entry("vertex", "vertex"), entry("fragment_hits", "fragment")};
  pass.name = "hits";
  pass.vertex_module = "vertex";
  pass.fragment_module = "fragment_hits";
  pass.colors.push_back({-1, "cache", LoadOp::kClear, BlendKind::kReplace, 1});
  pass.reads = {{"cache", 2, Filter::kBilinear, false}};
  variant.passes = {pass};
  variant.previous_inputs = {{PreviousSource::kUniformBlock, "Scene", 0, 0, 64, 16}, {PreviousSource::kPushConstants, "Object", 0, 0, 64, 0}};
  variant.payload = {{"vein", "float", "marble.frag", 30, 9, 1, {-1, 0, 0, 0}, {1, 0, 0, 0}, {"varying object_position"}}};
  return package;
}

class PackageFiles : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::temp_directory_path() / ("reprise-package-test-" + std::to_string(::getpid()));
    ASSERT_TRUE(writePackageFiles(samplePackage(), directory_).ok());
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string codeOfReading() const {
    const Result<Package> package = readPackage(directory_);
    return package.ok() ? "" : package.error().code;
  }

  std::filesystem::path directory_;
};

TEST_F(PackageFiles, ReadBackEqualToWhatWasWritten) {
  const Package written = samplePackage();
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
      EXPECT_EQ(recipeToJson(package->variant), recipeToJson(samplePackage().variant)) << "byte " << at;
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
  const std::vector<std::uint32_t> other{kMagic, 5, 0, 0, 0};
  ASSERT_TRUE(writeFile(directory_ / "fragment_hits.spv", bytesOf(other)).ok());
  EXPECT_EQ(codeOfReading(), "package.tampered");
  ASSERT_TRUE(writeFile(directory_ / "fragment_hits.spv", "abc").ok());
  EXPECT_EQ(codeOfReading(), "spirv.size");
}

TEST_F(PackageFiles, AreMissedWithoutAManifest) {
  std::filesystem::remove(directory_ / "manifest.json");
  EXPECT_EQ(codeOfReading(), "package.missing");
}

TEST(CheckPackage, FindsWhatContradictsItself) {
  EXPECT_TRUE(checkPackage(samplePackage()).ok());
  const auto codeWith = [](auto change) {
    Package package = samplePackage();
    change(package);
    const Result<void> checked = checkPackage(package);
    return checked.ok() ? std::string() : checked.error().code;
  };
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].fragment_module = "nothing"; }), "package.inconsistent");
  EXPECT_EQ(codeWith([](Package& one) { one.variant.passes[0].vertex_module = "fragment_hits"; }), "package.inconsistent");
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
