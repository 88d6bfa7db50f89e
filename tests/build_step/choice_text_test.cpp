// choice.json keeps the slice itself, so that a stale choice names the edit that made it so; one of an earlier version has no text.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/choice.h"
#include "cli/package_of_choice.h"
#include "cli/subject.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

class ChoiceText : public testing::Test {
 protected:
  void SetUp() override { fs::copy(fs::path(REPRISE_SOURCE_DIR) / "examples/cmake_project/shaders", shaders()); }

  fs::path shaders() const { return folder_ / "shaders"; }

  Choice committed() const {
    Result<Choice> choice = readChoice(shaders() / "granite.choice.json");
    REPRISE_CHECK(choice.ok(), "granite.choice.json");
    for (IdentifiedValue& value : choice->payload) value.text.clear();
    return *choice;
  }

  // As a run of this version writes it: with the text of the payload.
  Choice withText() const {
    Choice choice = committed();
    const Result<Subject> subject = readSubjectUnranked(shaders() / "granite.toml");
    REPRISE_CHECK(subject.ok(), "granite.toml");
    const Result<ChosenVariant> variant = variantOf(*subject, choice);
    REPRISE_CHECK(variant.ok(), "granite's payload");
    choice.payload = identifyPayload(*subject->program.fragment, subject->program.analysis, variant->candidate);
    return choice;
  }

  void edit(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = textOf(shaders() / file);
    ASSERT_NE(text.find(from), std::string::npos) << from;
    writeText(shaders() / file, text.replace(text.find(from), from.size(), to));
  }

  // Through the file, as it is committed.
  std::string saidOf(const Choice& choice) const {
    writeText(folder_ / "choice.json", choiceToJson(choice));
    const Result<Choice> read = readChoice(folder_ / "choice.json");
    if (!read.ok()) return formatError(read.error());
    const Result<Subject> subject = readSubjectUnranked(shaders() / "granite.toml");
    if (!subject.ok()) return formatError(subject.error());
    const Result<ChosenVariant> variant = variantOf(*subject, *read);
    return variant.ok() ? "" : variant.error().code + ": " + variant.error().message;
  }

  TemporaryFolder folder_;
};

TEST_F(ChoiceText, IsReadAsItWasWritten) {
  const Choice choice = withText();
  ASSERT_FALSE(choice.payload[0].text.empty());
  writeText(folder_ / "choice.json", choiceToJson(choice));
  const Result<Choice> again = readChoice(folder_ / "choice.json");
  ASSERT_TRUE(again.ok()) << formatError(again.error());
  EXPECT_EQ(again->payload, choice.payload);
  EXPECT_EQ(choiceToJson(*again), textOf(folder_ / "choice.json"));
  EXPECT_EQ(saidOf(choice), "");
}

TEST_F(ChoiceText, NamesAnEditedConstantWithItsPlace) {
  const Choice choice = withText();
  edit("noise.glsl", "1.37", "1.41");
  const std::string said = saidOf(choice), payload = "the payload 'grain' of line 13 of granite.frag";
  EXPECT_TRUE(said.starts_with("choice.stale: " + payload + " has changed since it was chosen: the constant 1.37 is now 1.41 (noise.glsl:7)")) << said;
}

TEST_F(ChoiceText, NamesAnAddedTerm) {
  const Choice choice = withText();
  edit("noise.glsl", "return sum * 0.15;", "return (sum + point.x) * 0.15;");
  EXPECT_NE(saidOf(choice).find("there is an added `FAdd` of "), std::string::npos) << saidOf(choice);
  EXPECT_NE(saidOf(choice).find("(noise.glsl:10)"), std::string::npos) << saidOf(choice);
}

TEST_F(ChoiceText, SaysNothingOfNewNames) {
  const Choice choice = withText();
  edit("granite.frag", "float grain", "float speckle");
  edit("granite.frag", "0.8), grain)", "0.8), speckle)");
  EXPECT_EQ(saidOf(choice), "");
}

TEST_F(ChoiceText, OfAnOldChoiceIsNotNeeded) {
  const Choice choice = committed();
  EXPECT_EQ(saidOf(choice), "");
  edit("noise.glsl", "1.37", "1.41");
  EXPECT_NE(saidOf(choice).find("has changed since it was chosen: a constant in what computes it"), std::string::npos) << saidOf(choice);
}

TEST_F(ChoiceText, ThatIsDamagedIsAsGoodAsNone) {
  Choice choice = withText();
  choice.payload[0].text = {"value = FMul(", "nothing"};
  edit("noise.glsl", "1.37", "1.41");
  EXPECT_NE(saidOf(choice).find("a constant in what computes it"), std::string::npos) << saidOf(choice);
}

}  // namespace
}  // namespace reprise
