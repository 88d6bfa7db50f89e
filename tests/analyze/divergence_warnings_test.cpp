// What `analyze` warns of.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/commands/analyze.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

constexpr const char* kShader = R"(#version 450
layout(location = 0) in vec3 place;
layout(location = 0) out vec4 color;
layout(set = 0, binding = 0) uniform sampler2D map;
void main() {
  vec4 waves = vec4(sin(place * 9.0), 1.0);
  if (place.x > 0.5) {
    waves += texture(map, place.xy);
    waves *= dFdx(place.y);
  }
  color = waves;
}
)";

std::string analyzed(const std::string& shader, bool json) {
  TemporaryFolder folder;
  writeText(folder / "test.frag", shader);
  AnalyzeArguments arguments;
  arguments.shader = (folder / "test.frag").string();
  arguments.json = json;
  std::ostringstream out;
  EXPECT_TRUE(analyzeShader(arguments, out).ok());
  return out.str();
}

TEST(Analyze, WarnsOfDerivativesThatLanesReachApart) {
  const std::string text = analyzed(kShader, false);
  EXPECT_NE(text.find("test.frag:8:5: warning: a sample with implicit level of detail stands where"), std::string::npos) << text;
  EXPECT_NE(text.find("test.frag:9:5: warning: a derivative stands where"), std::string::npos) << text;
  EXPECT_NE(text.find("[derivative.divergent]"), std::string::npos) << text;
  const nlohmann::json warnings = nlohmann::json::parse(analyzed(kShader, true)).at("warnings");
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].at("code"), "derivative.divergent");
  EXPECT_EQ(warnings[0].at("line"), 8);
  EXPECT_EQ(warnings[1].at("line"), 9);
}

TEST(Analyze, WarnsOfNothingWhereQuadsStayTogether) {
  std::string shader = kShader;
  shader.replace(shader.find("place.x > 0.5"), 13, "gl_FrontFacing");
  EXPECT_EQ(analyzed(shader, false).find("warning"), std::string::npos);
  EXPECT_TRUE(nlohmann::json::parse(analyzed(shader, true)).at("warnings").empty());
}

}  // namespace
}  // namespace reprise
