// The shipped marble with both shaders stripped of their names: what its scenario has to say, and what is told where it does not.
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/subject.h"
#include "compiler/ir/module.h"
#include "tests/compiler/scratch_directory.h"

namespace reprise {
namespace {

const std::filesystem::path kMarble = REPRISE_SOURCE_DIR "/shaders/marble";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
  return text;
}

class StrippedScenario : public testing::Test {
 protected:
  StrippedScenario() {
    for (const char* file : {"marble.vert", "marble.frag"}) {
      CompileOptions options;
      options.defines = {{"OCTAVES", "5"}};
      Module module = readModule(compile(kMarble / file, options).value().words).value();
      module.names.clear();
      folder_.write(file + std::string(".spv"), bytesOf(writeModule(module)));
    }
    text_ = readFile(kMarble / "marble.toml").value();
    text_ = replaced(replaced(text_, "marble.frag", "marble.frag.spv"), "marble.vert", "marble.vert.spv");
  }

  Result<Subject> read(const std::string& text) { return readSubject(folder_.write("marble.toml", text)); }

  // The scenario as a user would write it for these modules.
  std::string bound() const {
    const Subject named = readSubject(kMarble / "marble.toml").value();
    std::string text = text_;
    const ShaderInterface& interface = named.program.interface;
    for (std::size_t i = 0; i < interface.descriptors.at(0).members.size(); ++i)
      text = replaced(text, "\"Scene." + interface.descriptors[0].members[i].name + "\"", "\"block_0_0.member" + std::to_string(i) + "\"");
    for (std::size_t i = 0; i < interface.push_constant_members.size(); ++i)
      text = replaced(text, "\"Object." + interface.push_constant_members[i].name + "\"", "\"push_constants.member" + std::to_string(i) + "\"");
    std::string inputs = "vertex_inputs = {";
    for (std::size_t i = 0; i < interface.vertex_inputs.size(); ++i)
      inputs += (i > 0 ? ", " : " ") + ("input_" + std::to_string(interface.vertex_inputs[i].location)) + " = \"" + interface.vertex_inputs[i].name + "\"";
    return replaced(text, "[render]", inputs + " }\n[render]");
  }

  ScratchDirectory folder_;
  std::string text_;
};

TEST_F(StrippedScenario, IsReadWithNamesByPlace) {
  const Result<Subject> subject = read(bound());
  ASSERT_TRUE(subject.ok()) << formatError(subject.error());
  const Subject named = readSubject(kMarble / "marble.toml").value();
  EXPECT_EQ(subject->program.interface.vertex_inputs, named.program.interface.vertex_inputs);
  const auto kept = [](const Subject& one) {
    return std::count_if(one.candidates.begin(), one.candidates.end(), [](const Candidate& candidate) { return candidate.kept(); });
  };
  EXPECT_EQ(kept(*subject), kept(named));
}

TEST_F(StrippedScenario, SaysWhatIsMissing) {
  const Result<Subject> subject = read(text_);
  ASSERT_FALSE(subject.ok());
  const std::string message = formatError(subject.error());
  for (const char* text : {"block_0_0.member0", "mat4x4 at byte 0", "vertex_inputs = { \"input_0\" = \"position\" }"})
    EXPECT_NE(message.find(text), std::string::npos) << message;
}

TEST_F(StrippedScenario, TellsAVertexInputThatIsNotThere) {
  const Result<Subject> subject = read(replaced(bound(), "input_0 = \"position\"", "input_0 = \"position\", input_9 = \"color\""));
  ASSERT_FALSE(subject.ok());
  EXPECT_EQ(subject.error().code, "scenario.vertex_input");
  EXPECT_NE(subject.error().message.find("input_9"), std::string::npos) << subject.error().message;
}

}  // namespace
}  // namespace reprise
