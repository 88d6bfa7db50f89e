// The shaders that ship: they compile, and their scenarios bind all that they read.
#include <gtest/gtest.h>

#include <filesystem>

#include "compiler/source/compile.h"
#include "compiler/source/reflect.h"
#include "profiler/scenario/read_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shippedScenarios() {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(REPRISE_SOURCE_DIR) / "shaders")) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  }
  return paths;
}

class ShippedShaders : public testing::TestWithParam<std::string> {};

TEST_P(ShippedShaders, AreBoundByTheirScenario) {
  const Result<Scenario> scenario = readScenario(GetParam());
  ASSERT_TRUE(scenario.ok()) << formatError(scenario.error());
  if (scenario->fragment_path.empty()) GTEST_SKIP() << "drawn by the standard shaders, which this test does not make";
  CompileOptions options;
  options.defines = scenario->defines;
  options.include_dirs.assign(scenario->include_dirs.begin(), scenario->include_dirs.end());
  const Result<CompiledShader> vertex = compile(scenario->vertex_path, options);
  ASSERT_TRUE(vertex.ok()) << formatError(vertex.error());
  const Result<CompiledShader> fragment = compile(scenario->fragment_path, options);
  ASSERT_TRUE(fragment.ok()) << formatError(fragment.error());
  const Result<ShaderInterface> interface = reflectInterface(vertex->words, fragment->words);
  ASSERT_TRUE(interface.ok()) << formatError(interface.error());
  const Result<void> checked = checkBindings(*scenario, *interface);
  EXPECT_TRUE(checked.ok()) << formatError(checked.error());
}

INSTANTIATE_TEST_SUITE_P(Scenarios, ShippedShaders, testing::ValuesIn(shippedScenarios()),
                         [](const auto& each) { return fs::path(each.param).stem().string(); });

}  // namespace
}  // namespace reprise
