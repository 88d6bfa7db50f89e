// Packages that were tampered with: refused with the file that is wrong, never played.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

// One finished run for all tests of the suite; each works on a copy of its output.
class BadPackage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    finished_ = std::make_unique<SmallScenario>();
    const CommandOutcome outcome = runCommand(optimizeSmall(*finished_, {"--budget", "20s"}));
    ASSERT_EQ(outcome.status, kExitDone) << outcome.all();
  }
  static void TearDownTestSuite() { finished_.reset(); }

  void SetUp() override {
    ASSERT_TRUE(fs::exists(finished_->output() / "package" / "manifest.json"));
    fs::copy(finished_->output(), run(), fs::copy_options::recursive);
  }

  fs::path run() const { return folder_ / "run"; }
  fs::path manifest() const { return run() / "package" / "manifest.json"; }

  fs::path someModule() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(run() / "package")) {
      if (entry.path().extension() == ".spv") return entry.path();
    }
    ADD_FAILURE() << "the package holds no module";
    return {};
  }

  CommandOutcome play() const { return runCommand({REPRISE_EXECUTABLE, "play", run()}); }

 private:
  static std::unique_ptr<SmallScenario> finished_;
  TemporaryFolder folder_;
};
std::unique_ptr<SmallScenario> BadPackage::finished_;

TEST_F(BadPackage, IsPlayedAsLongAsItIsWhole) {
  const CommandOutcome outcome = play();
  EXPECT_EQ(outcome.status, kExitDone) << outcome.all();
}

TEST_F(BadPackage, ModuleWithAChangedByte) {
  const fs::path module = someModule();
  std::string bytes = textOf(module);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  writeText(module, bytes);
  expectRefusal(play(), kExitBadInput, {module.filename()});
}

TEST_F(BadPackage, ModuleThatIsCutShort) {
  const fs::path module = someModule();
  const std::string bytes = textOf(module);
  writeText(module, bytes.substr(0, bytes.size() / 2));
  expectRefusal(play(), kExitBadInput, {module.filename()});
}

TEST_F(BadPackage, ModuleThatIsMissing) {
  const fs::path module = someModule();
  fs::remove(module);
  expectRefusal(play(), kExitBadInput, {module.filename()});
}

TEST_F(BadPackage, ManifestThatIsNoJson) {
  const std::string text = textOf(manifest());
  writeText(manifest(), text.substr(0, text.size() / 2));
  expectRefusal(play(), kExitBadInput, {"manifest.json"});
}

TEST_F(BadPackage, ManifestThatIsMissing) {
  fs::remove(manifest());
  expectRefusal(play(), kExitBadInput, {"manifest.json"});
}

TEST_F(BadPackage, ManifestOfANewerFormat) {
  std::string text = textOf(manifest());
  const std::string key = "\"format_version\"";
  ASSERT_NE(text.find(key), std::string::npos);
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const std::size_t digit = text.find_first_of("0123456789", at + key.size());
    text.insert(digit, "99");
  }
  writeText(manifest(), text);
  expectRefusal(play(), kExitBadInput, {"manifest.json", "format"});
}

TEST_F(BadPackage, ManifestThatNamesAnotherModule) {
  std::string text = textOf(manifest());
  const std::string name = someModule().stem();
  const std::size_t place = text.find("\"" + name + "\"");
  ASSERT_NE(place, std::string::npos);
  writeText(manifest(), text.replace(place + 1, name.size(), "nonesuch"));
  expectRefusal(play(), kExitBadInput, {"manifest.json", "changed"});
}

}  // namespace
}  // namespace reprise
