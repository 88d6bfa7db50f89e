// What the margin of an annotated source says.
#include <gtest/gtest.h>

#include <sstream>

#include "cli/commands/annotate.h"
#include "cli/commands/analyze.h"
#include "compiler/analysis/line_costs.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

constexpr const char* kShader = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color; layout(set = 0, binding = 0) uniform Scene { vec4 tint; } scene;
void main() {
  float waves = sin(place.x * 9.0) + cos(place.y * 7.0) + exp(place.z);
  float light = max(place.y, 0.0);
  color = scene.tint * waves * light;
}
)";

TEST(LineCosts, SharesAddUpToOneAndFollowTheWork) {
  const CompiledShader compiled = compileText(kShader, "test.frag", {}).value();
  const PreparedShader shader = prepareForCaching(readModule(compiled.words).value(), "").value();
  const ShaderAnalysis analysis = analyse(shader);
  const auto shares = lineCosts(shader, analysis);
  double sum = 0;
  for (const auto& [place, share] : shares) sum += share;
  EXPECT_NEAR(sum, 1, 1e-9);
  EXPECT_GT(shares.at({"test.frag", 5}), 0.7);
  EXPECT_EQ(shares.count({"test.frag", 1}), 0u);
}

std::string analyzed(bool annotate, bool json) {
  TemporaryFolder folder;
  writeText(folder / "test.frag", kShader);
  AnalyzeArguments arguments;
  arguments.shader = (folder / "test.frag").string();
  arguments.annotate = annotate;
  arguments.json = json;
  std::ostringstream out;
  EXPECT_TRUE(analyzeShader(arguments, out).ok());
  return out.str();
}

TEST(Annotate, PrintsCostsAndCandidatesBesideTheirLines) {
  const std::string text = analyzed(true, false);
  std::istringstream lines(text);
  std::string line, waves;
  while (std::getline(lines, line))
    if (line.find("float waves =") != std::string::npos) waves = line;
  EXPECT_NE(waves.find('%'), std::string::npos) << text;
  EXPECT_NE(waves.find("  5 | "), std::string::npos) << waves;
  EXPECT_NE(text.find("float waves: "), std::string::npos) << text;
  EXPECT_NE(text.find("a hit saves"), std::string::npos) << text;
}

TEST(Analyze, JsonSaysWhyEachCandidateRanksWhereItDoes) {
  const std::string text = analyzed(false, true);
  EXPECT_NE(text.find("\"rank\": 1"), std::string::npos) << text;
  EXPECT_NE(text.find("\"ranked\": \"1st of "), std::string::npos) << text;
}

}  // namespace
}  // namespace reprise
