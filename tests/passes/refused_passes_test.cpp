// Passes in scenario files: what is refused, with its place, and that they are written as they were read.
#include <gtest/gtest.h>

#include "cli/subject.h"
#include "profiler/scenario/read_scenario.h"
#include "tests/e2e/run_command.h"
#include "tests/passes/two_passes.h"

namespace reprise {
namespace {

Result<Subject> readWith(const TemporaryFolder& folder, const std::string& scenario) {
  writeText(folder / "a.frag", kShades);
  writeText(folder / "light.frag", kLight);
  writeText(folder / "scene.toml", scenario);
  return readSubject(folder / "scene.toml");
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REPRISE_CHECK(at != std::string::npos, from);
  return text.replace(at, from.size(), to);
}

struct Refused {
  std::string name, from, to, code, says;
};

class RefusedPass : public testing::TestWithParam<Refused> {};

TEST_P(RefusedPass, IsReportedWithItsPlace) {
  const TemporaryFolder folder;
  const Result<Subject> read = readWith(folder, with(kTwoPasses, GetParam().from, GetParam().to));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, GetParam().code);
  EXPECT_NE(read.error().message.find(GetParam().says), std::string::npos) << read.error().message;
  EXPECT_GT(read.error().place.line, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Passes, RefusedPass,
    testing::Values(
        Refused{"Unknown", "pass_position = \"shadow_map\"", "pass_position = \"shadowmap\"", "scenario.value", "'shadowmap', which is not there"},
        Refused{"Unsampled", "texture = \"light_map\"", "texture = \"lightmap\"", "scenario.unknown_texture", "no shader samples the texture 'lightmap'"},
        Refused{"ReadsItself", "texture = \"light_map\", format = \"rgba32_sfloat\" }", "texture = \"light_map\", format = \"rgba32_sfloat\" }]\ndepth = \"shadow_map\"\n#",
                "scenario.value", "two textures named 'shadow_map'"},
        Refused{"Kind", "kind = \"gbuffer\"", "kind = \"g_buffer\"", "scenario.value", "gbuffer"},
        Refused{"Format", "format = \"rgba32_sfloat\" }", "format = \"rgb32\" }", "scenario.value", "'rgb32'"},
        Refused{"Outputs", "texture = \"light_map\", format = \"rgba32_sfloat\" }", "texture = \"light_map\" }, { texture = \"more\" }", "scenario.unknown_texture", "'more'"},
        Refused{"ReverseZ", "near = 0.5, far = 14", "near = 0.5, far = 14, reverse_z = true", "scenario.value", "reverse_z"},
        Refused{"Key", "size = 512", "sise = 512", "scenario.unknown_key", "sise"},
        Refused{"Objects", "size = 512", "size = 512\nobjects = [\"bal\"]", "scenario.value", "'ball'"},
        Refused{"File", "light.frag", "lights.frag", "scenario.missing_file", "lights.frag"}),
    [](const auto& each) { return each.param.name; });

TEST(RefusedPasses, ReadWhatIsMadeAfterThem) {
  const TemporaryFolder folder;
  const std::size_t sun = kTwoPasses.find("[[pass]]"), light = kTwoPasses.find("[[pass]]", sun + 1), rest = kTwoPasses.find("[uniforms]");
  const std::string turned = kTwoPasses.substr(0, sun) + kTwoPasses.substr(light, rest - light) + kTwoPasses.substr(sun, light - sun) + kTwoPasses.substr(rest);
  const Result<Subject> read = readWith(folder, turned);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "scenario.pass_order");
  EXPECT_NE(read.error().message.find("the later pass 'shadow_map'"), std::string::npos) << read.error().message;
}

TEST(WrittenPasses, ReadBackTheSame) {
  const TemporaryFolder folder;
  const Result<Subject> first = readWith(folder, with(kTwoPasses, "size = 512", "size = 512\nobjects = [\"ball\"]\ncolor = [1, 2, 3]"));
  ASSERT_TRUE(first.ok()) << formatError(first.error());
  writeText(folder / "again.toml", writeScenario(first->scenario, folder.path()));
  Result<Scenario> again = readScenario(folder / "again.toml");
  ASSERT_TRUE(again.ok()) << formatError(again.error());
  ASSERT_EQ(again->passes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    again->passes[i].place = first->scenario.passes[i].place;
    EXPECT_EQ(again->passes[i], first->scenario.passes[i]);
  }
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(again->uniforms[i].source, first->scenario.uniforms[i].source);
  EXPECT_EQ(readScenario(folder / "scene.toml")->hash, again->hash);
}

TEST(WrittenPasses, AreToldApartByTheHash) {
  const TemporaryFolder folder;
  const Result<Subject> before = readWith(folder, kTwoPasses);
  const Result<Subject> softer = readWith(folder, with(kTwoPasses, "slope_bias = 3", "slope_bias = 4"));
  ASSERT_TRUE(before.ok() && softer.ok());
  EXPECT_NE(before->scenario.hash, softer->scenario.hash);
  writeText(folder / "scene.toml", kTwoPasses);
  writeText(folder / "light.frag", with(kLight, "at.z)", "at.z - 0.01)"));
  const Result<Subject> other_shader = readSubject(folder / "scene.toml");
  ASSERT_TRUE(other_shader.ok());
  EXPECT_NE(before->scenario.hash, other_shader->scenario.hash);
}

}  // namespace
}  // namespace reprise
