// Mistakes in a scenario: each is refused with file, line, what was found and what was expected, before
// anything is written.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

struct Mistake {
  std::string name;
  std::string wanted, replacement;  // in small.toml
  std::string at;                   // what stands on the line that is to be reported; empty: no line
  std::vector<std::string> words;   // of the message
};

const std::vector<Mistake> kMistakes = {
    {"UnknownKey", "frames = 12", "frmes = 12", "frmes = 12", {"frmes", "frames"}},
    {"WrongType", "frames = 12", "frames = \"eight\"", "frames = \"eight\"", {"frames"}},
    {"Syntax", "width = 64", "width = = 64", "width = = 64", {"error: "}},
    {"PeriodZero", "periods = [1, 2, 4]", "periods = [1, 0, 4]", "periods = [1, 0, 4]", {"period", "0"}},
    {"PeriodNoPowerOfTwo", "periods = [1, 2, 4]", "periods = [1, 3]", "periods = [1, 3]", {"period", "3"}},
    {"NegativeSize", "width = 64", "width = -64", "width = -64", {"width", "-64"}},
    {"MissingShader", "fragment = \"small.frag\"", "fragment = \"smell.frag\"", "", {"smell.frag"}},
    {"MissingTexture", "kind = \"checker\"", "file = \"nonesuch.png\"", "nonesuch.png", {"nonesuch.png"}},
    {"UniformThatTheShaderLacks", "\"Frame.gain\"", "\"Frame.gian\"", "Frame.gian", {"Frame.gian", "gain"}},
    {"UniformThatNobodyBinds", "\"Frame.gain\" = { value = 0.75 }", "", "", {"Frame.gain"}},
    {"TextureThatTheShaderLacks", "name = \"grain\"", "name = \"grian\"", "", {"grian", "grain"}},
    {"UnknownMesh", "kind = \"sphere\"", "kind = \"spere\"", "spere", {"spere", "sphere"}},
};

class BadScenario : public testing::TestWithParam<Mistake> {};

TEST_P(BadScenario, IsRefusedAtItsLine) {
  const Mistake& mistake = GetParam();
  const SmallScenario scenario;
  ASSERT_NO_FATAL_FAILURE(scenario.replace(scenario.toml(), mistake.wanted, mistake.replacement));
  std::vector<std::string> words = mistake.words;
  words.push_back("small.toml");
  if (!mistake.at.empty()) {
    words.push_back("small.toml:" + std::to_string(SmallScenario::lineOf(scenario.toml(), mistake.at)) + ":");
  }
  expectRefusal(runCommand(optimizeSmall(scenario)), kExitBadInput, words);
  EXPECT_EQ(leftovers(scenario.output()), "");
}

INSTANTIATE_TEST_SUITE_P(Mistakes, BadScenario, testing::ValuesIn(kMistakes),
                         [](const auto& each) { return each.param.name; });

TEST(BadScenarioFile, IsMissing) {
  const SmallScenario scenario;
  CommandSpec spec = optimizeSmall(scenario);
  spec.words[2] = scenario.file("nonesuch.toml");
  expectRefusal(runCommand(spec), kExitBadInput, {"nonesuch.toml"});
}

TEST(BadScenarioFile, IsNoTextAtAll) {
  const SmallScenario scenario;
  writeText(scenario.toml(), std::string("\x7f"
                                         "ELF\0\1\2\3",
                                         8));
  expectRefusal(runCommand(optimizeSmall(scenario)), kExitBadInput, {"small.toml"});
}

TEST(BadScenarioFile, HasATextureThatIsNoImage) {
  const SmallScenario scenario;
  writeText(scenario.file("grain.png"), "no image");
  scenario.replace(scenario.toml(), "kind = \"checker\"", "file = \"grain.png\"");
  expectRefusal(runCommand(optimizeSmall(scenario)), kExitBadInput, {"grain.png"});
  EXPECT_EQ(leftovers(scenario.output()), "");
}

}  // namespace
}  // namespace reprise
