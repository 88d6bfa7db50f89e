// What the command line says of mistakes in it, and of several mistakes at once.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

using nlohmann::json;

CommandOutcome reprise(std::vector<std::string> words) {
  words.insert(words.begin(), REPRISE_EXECUTABLE);
  return runCommand(std::move(words));
}

// One JSON object a line.
std::vector<json> diagnosticsOf(const CommandOutcome& outcome) {
  std::vector<json> diagnostics;
  std::istringstream lines(outcome.errors);
  for (std::string line; std::getline(lines, line);) {
    diagnostics.push_back(json::parse(line, nullptr, false));
    EXPECT_TRUE(diagnostics.back().is_object()) << line;
  }
  return diagnostics;
}

TEST(Usage, UnknownCommandNamesTheNearOne) {
  expectRefusal(reprise({"optimise", "a.toml", "--max-error", "0.02"}), kExitBadCommandLine,
                {"unknown command 'optimise'; did you mean 'optimize'?", "usage.command"});
  expectRefusal(reprise({}), kExitBadCommandLine, {"no command", "'optimize'", "usage.command"});
}

TEST(Usage, UnknownOptionNamesTheNearOne) {
  expectRefusal(reprise({"analyze", "a.frag", "--jsn"}), kExitBadCommandLine, {"unknown option '--jsn'; did you mean '--json'?", "usage.option"});
  expectRefusal(reprise({"optimize", "a.toml", "--max-eror=0.02"}), kExitBadCommandLine, {"'--max-eror'", "'--max-error'"});
  expectRefusal(reprise({"emit", "a.toml", "--choice", "c.json", "-MX"}), kExitBadCommandLine, {"'-M"});
  expectRefusal(reprise({"analyze", "a.frag", "--wholly-unlike"}), kExitBadCommandLine, {"'--wholly-unlike'", "reprise analyze --help"});
}

TEST(Usage, UnknownMetricAndStrategyNameTheNearOnes) {
  const SmallScenario scenario;
  expectRefusal(reprise({"optimize", scenario.toml(), "--metric", "flickr"}), kExitBadCommandLine, {"did you mean 'flicker'?"});
  expectRefusal(reprise({"check", scenario.fragment(), "--strategy", "two_pas"}), kExitBadCommandLine, {"did you mean", "'two_pass'"});
}

TEST(Usage, SeveralMistakesAreADiagnosticEach) {
  const std::vector<json> found = diagnosticsOf(reprise({"analyze", "a.frag", "b.frag", "--jsn", "--al", "--error-format=json"}));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].at("code"), "usage.argument");
  EXPECT_NE(found[0].at("message").get<std::string>().find("'b.frag'"), std::string::npos);
  EXPECT_EQ(found[1].at("code"), "usage.option");
  EXPECT_NE(found[1].at("message").get<std::string>().find("'--jsn'"), std::string::npos);
  EXPECT_NE(found[2].at("message").get<std::string>().find("'--all'"), std::string::npos);
}

TEST(Usage, MistakesAreJsonWhereThatIsAskedFor) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--error-format=json", "optimise"}, {"optimize", "--error-format", "json"}, {"optimize", "a.toml", "--max-error", "much", "--error-format=json"},
        {"--error-format=json"}, {"check", "a.frag", "--jobs", "-3", "--error-format=json"}}) {
    const CommandOutcome outcome = reprise(words);
    EXPECT_EQ(outcome.status, kExitBadCommandLine);
    const std::vector<json> found = diagnosticsOf(outcome);
    ASSERT_EQ(found.size(), 1u) << outcome.errors;
    EXPECT_TRUE(found[0].at("code").get<std::string>().starts_with("usage.")) << outcome.errors;
  }
}

TEST(Diagnostics, OfAScenarioAreEachAtTheirOwnPlace) {
  const SmallScenario scenario;
  scenario.replace(scenario.toml(), "frames = 12", "frmes = 12");
  scenario.replace(scenario.toml(), "kind = \"sphere\"", "kind = \"spere\"");
  const std::vector<json> found = diagnosticsOf(runCommand(optimizeSmall(scenario, {"--error-format=json"})));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].at("code"), "scenario.unknown_key");
  EXPECT_EQ(found[0].at("line"), SmallScenario::lineOf(scenario.toml(), "frmes"));
  EXPECT_EQ(found[1].at("code"), "scenario.value");
  EXPECT_EQ(found[1].at("line"), SmallScenario::lineOf(scenario.toml(), "spere"));
  for (const json& one : found) {
    EXPECT_EQ(one.at("file"), scenario.toml().string());
    EXPECT_EQ(one.at("message").get<std::string>().find('\n'), std::string::npos);
  }
}

TEST(Diagnostics, OfAnIncludedFileNameThatFile) {
  const SmallScenario scenario;
  writeText(scenario.file("broken.glsl"), "float broken() { return missing_name; }\nfloat other() { return absent_name; }\n");
  writeText(scenario.file("includes.frag"), "#version 450\n#include \"broken.glsl\"\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(broken()); }\n");
  const std::vector<json> found = diagnosticsOf(reprise({"analyze", scenario.file("includes.frag"), "--error-format=json"}));
  ASSERT_FALSE(found.empty());
  for (const json& one : found) EXPECT_EQ(one.at("code"), "source.syntax");
  EXPECT_EQ(found[0].at("file"), scenario.file("broken.glsl").string());
  EXPECT_EQ(found[0].at("line"), 1);
}

TEST(Help, SpellsOptionsAsTheyAreTyped) {
  for (const std::string command : {"optimize", "emit", "validate", "analyze", "check", "play", "report", "devices"}) {
    const std::string help = reprise({command, "--help"}).output;
    for (const std::string wrong : {"--MD", "--MF", "--MT", "--M ", "--std", "--I", "--D", "--o ", "--j "}) EXPECT_EQ(help.find(wrong), std::string::npos) << command << " " << wrong;
  }
  EXPECT_NE(reprise({"analyze", "--help"}).output.find("-std"), std::string::npos);
}

TEST(Help, NamesHlslWhereAShaderIsNamed) {
  for (const std::string command : {"analyze", "check"}) EXPECT_NE(reprise({command, "--help"}).output.find("HLSL"), std::string::npos) << command;
}

}  // namespace
}  // namespace reprise
