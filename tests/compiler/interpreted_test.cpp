// Modules as given against what is made of them, by the reference interpreter.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <spirv-tools/optimizer.hpp>

#include "cli/check/interpreter/interpret.h"
#include "compiler/ir/prepare.h"
#include "compiler/source/compile.h"

namespace reprise {
namespace {

// spirv-opt --ssa-rewrite of SPIRV-Tools 2023.1 leaves `last` at 0 for the second time round.
constexpr const char* kNestedLoops = R"(#version 450
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
bool never(float x) { return x > 1e20; }
void main() {
  int outer = 1 + int(uv.x * 0.0), inner = 2 + int(uv.y * 0.0), acc = 0, last = 0;
  float w = 1.0;
  for (int i = 0; i < outer; ++i) {
    if (never(uv.x)) { if (never(uv.y)) continue; break; }
    else { acc = last; for (int j = 0; j < inner; ++j) { last = 1; w *= 0.5; } acc |= last; }
  }
  float heavy = 0.0;
  for (int s = 0; s < 40; ++s) heavy += sin(uv.x * float(s)) * w;
  color = vec4(vec3(float(acc)), 0.5 + 0.01 * heavy) * (0.5 + 0.5 * uv.y);
}
)";

std::vector<std::uint32_t> rewritten(const std::vector<std::uint32_t>& words) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.RegisterPass(spvtools::CreateInlineExhaustivePass()).RegisterPass(spvtools::CreateSSARewritePass());
  std::vector<std::uint32_t> out;
  EXPECT_TRUE(optimizer.Run(words.data(), words.size(), &out));
  return out;
}

TEST(Interpreted, ConvictsTheSsaRewriteOfNestedLoops) {
  const std::vector<std::uint32_t> words = compileText(kNestedLoops, "loops.frag", {}).value().words;
  const auto difference = compareComputations(words, rewritten(words), "main", {});
  ASSERT_TRUE(difference.ok()) << difference.error().message;
  ASSERT_TRUE(difference->has_value());
  EXPECT_NE((*difference)->expected.find("output 0."), std::string::npos) << (*difference)->expected;
}

std::vector<std::string> fragmentFiles() {
  std::vector<std::string> files;
  for (const char* folder : {"/shaders", "/tests/check/traps"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::string(REPRISE_SOURCE_DIR) + folder))
      if (entry.path().extension() == ".frag") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

class InterpretedFile : public testing::TestWithParam<std::string> {};

TEST_P(InterpretedFile, ComputesTheSameOncePrepared) {
  const std::vector<std::uint32_t> words = compile(GetParam(), {}).value().words;
  CompareCounts counts;
  const auto itself = compareComputations(words, words, "main", {}, &counts);
  if (!itself.ok()) {
    ASSERT_EQ(itself.error().code, "interpreter.unsupported") << itself.error().message;
    EXPECT_NE(GetParam().find("subgroup"), std::string::npos) << itself.error().message;
    return;
  }
  ASSERT_FALSE(itself->has_value()) << (*itself)->expected << "; " << (*itself)->found;
  EXPECT_GT(counts.returned + counts.discarded, 0);
  const auto prepared = prepareForCaching(readModule(words).value(), "main");
  if (!prepared.ok()) GTEST_SKIP() << prepared.error().message;
  const auto difference = compareComputations(words, writeModule(prepared->module), "main", {});
  ASSERT_TRUE(difference.ok()) << difference.error().message;
  if (difference->has_value())
    ADD_FAILURE() << "expected " << (*difference)->expected << ", found " << (*difference)->found << " at " << (*difference)->frag_x << ", "
                  << (*difference)->frag_y << " with seed " << (*difference)->seed;
}

INSTANTIATE_TEST_SUITE_P(All, InterpretedFile, testing::ValuesIn(fragmentFiles()), [](const testing::TestParamInfo<std::string>& test) {
  std::string name = std::filesystem::path(test.param).parent_path().filename().string() + "_" + std::filesystem::path(test.param).stem().string();
  std::replace_if(name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace reprise
