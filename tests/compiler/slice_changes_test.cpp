// Slices as text, and what was changed between two of them.
#include "compiler/candidates/slice_changes.h"

#include <gtest/gtest.h>

#include <string>

#include "compiler/candidates/slice_text.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

SliceTerms read(const std::vector<std::string>& lines) {
  const std::optional<SliceTerms> terms = termsOfText(lines);
  REPRISE_CHECK(terms.has_value(), lines.empty() ? "" : lines[0]);
  return *terms;
}

std::vector<std::string> changesOf(const std::vector<std::string>& before, const std::vector<std::string>& after) {
  std::vector<std::string> texts;
  for (const SliceChange& change : changesBetween(read(before), read(after))) texts.push_back(change.text);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(SliceText, IsReadAsItWasWritten) {
  for (const Texts& lines : {Texts{"value = 0.5"}, Texts{"value = FMul(varying p, -0.5)"}, Texts{"value = FAdd(#1, #1)", "#1 = Sin(uniform Frame.gain)"},
                             Texts{"value = #1", "#1 = Phi(0.0, FAdd(#1, 1.5), BranchConditional(SLessThan:bool(#2, 40)))", "#2 = Phi:int(0, IAdd:int(#2, 1))"}})
    EXPECT_EQ(textOf(read(lines)), lines);
}

TEST(SliceText, OfEveryValueIsReadAsItWasWrittenAndIsTheSameAgain) {
  for (const std::string& file : shippedFragmentShaders()) {
    const ShaderProgram program = shippedProgram(file);
    const ValueGraph& graph = program.analysis.graph;
    for (std::size_t i = 0; i < graph.nodes.size(); i += 7) {
      if (graph.nodes[i].instruction->type_id == 0) continue;
      const SliceTerms terms = termsOfValue(*program.fragment, program.analysis, static_cast<int>(i));
      const Texts text = textOf(terms);
      const std::optional<SliceTerms> again = termsOfText(text);
      ASSERT_TRUE(again) << file << "\n" << text[0];
      EXPECT_EQ(textOf(*again), text) << file;
      EXPECT_TRUE(changesBetween(*again, terms).empty()) << file << "\n" << text[0];
      EXPECT_EQ(textOf(termsOfValue(*program.fragment, program.analysis, static_cast<int>(i))), text);
    }
  }
}

TEST(SliceText, IsCutOffAfterWholeLinesAndWhatIsMissingEqualsAnything) {
  const Texts whole = {"value = FAdd(#1, #1)", "#1 = FMul(#2, #2)", "#2 = Sin(varying position)"};
  const Texts cut = textOf(read(whole), 42);
  EXPECT_EQ(cut, (Texts{"value = FAdd(#1, #1)", "#1 = FMul(#2, #2)", "..."}));
  EXPECT_EQ(changesOf(cut, whole), Texts{});
  EXPECT_EQ(changesOf(cut, {"value = FAdd(#1, #1)", "#1 = FSub(#2, #2)", "#2 = Cos(varying position)"}), Texts{"`FMul` is now `FSub`"});
}

TEST(SliceText, RefusesWhatIsNone) {
  for (const Texts& lines : {Texts{}, Texts{"#1 = Sin(0.5)"}, Texts{"value = Sin(0.5"}, Texts{"value = Sin(0.5))"}, Texts{"value = "}, Texts{"value = Sin()"},
                             Texts{"value = 0.5", "no line"}, Texts{"value = " + std::string(500, '(')}})
    EXPECT_FALSE(termsOfText(lines)) << (lines.empty() ? "" : lines[0]);
  std::string deep = "value = ";
  for (int i = 0; i < 100000; ++i) deep += "Sin(";
  EXPECT_FALSE(termsOfText({deep}));
}

TEST(SliceChanges, NameConstantsAndInputs) {
  EXPECT_EQ(changesOf({"value = FMul(varying p, 0.5)"}, {"value = FMul(varying p, 0.6)"}), Texts{"the constant 0.5 is now 0.6"});
  EXPECT_EQ(changesOf({"value = Sample(texture detail, varying uv)"}, {"value = Sample(texture noise, varying uv)"}),
            Texts{"texture 'noise' is read in place of 'detail'"});
  EXPECT_EQ(changesOf({"value = Sin(varying p)"}, {"value = Sin(uniform Frame.p)"}), Texts{"uniform 'Frame.p' is read in place of varying 'p'"});
}

TEST(SliceChanges, NameWhatIsAddedAndGone) {
  const Texts two = {"value = FAdd(FAdd(varying a, varying b), varying c)"}, three = {"value = FAdd(FAdd(FAdd(varying a, varying b), Sin(varying d)), varying c)"};
  EXPECT_EQ(changesOf(two, three), Texts{"there is an added `FAdd` of Sin(varying d)"});
  EXPECT_EQ(changesOf(three, two), Texts{"there is no more `FAdd` of Sin(varying d)"});
  EXPECT_EQ(changesOf({"value = FMul(varying a, 0.5)"}, {"value = FAbs(FMul(varying a, 0.5))"}), Texts{"there is an added `FAbs`"});
}

TEST(SliceChanges, NameSeveralEditsEachOnce) {
  EXPECT_EQ(changesOf({"value = FAdd(Sin(FMul(varying a, 0.5)), Cos(FMul(varying b, 0.5)))"}, {"value = FAdd(Sin(FMul(varying a, 0.6)), Tan(FMul(varying b, 0.6)))"}),
            (Texts{"the constant 0.5 is now 0.6", "`Cos` is now `Tan`"}));
}

TEST(SliceChanges, FindEditsInLoops) {
  EXPECT_EQ(changesOf({"value = #1", "#1 = Phi(0.0, FAdd(#1, 1.5))"}, {"value = #1", "#1 = Phi(0.0, FAdd(#1, 2.5))"}), Texts{"the constant 1.5 is now 2.5"});
  EXPECT_EQ(changesOf({"value = #1", "#1 = Phi(0.0, FAdd(#1, 1.5))"}, {"value = FMul(#1, varying a)", "#1 = Phi(0.0, FAdd(#1, 1.5))"}),
            Texts{"there is an added `FMul` of varying a"});
}

TEST(SliceChanges, TellAnotherThingAsAnother) {
  EXPECT_EQ(changesOf({"value = Sin(varying a)"}, {"value = FMul(uniform u, 2.0)"}), Texts{"`Sin(varying a)` is now `FMul(uniform u, 2.0)`"});
}

// Numbers are called in another order, nothing else.
TEST(SliceChanges, SayNothingOfEqualTerms) {
  EXPECT_EQ(changesOf({"value = FAdd(FMul(#1, #1), #1)", "#1 = Sin(varying a)"}, {"value = FAdd(FMul(#7, #7), #7)", "#7 = Sin(varying a)"}), Texts{});
}

TEST(SliceChanges, EndSoonWhereTwoLongSlicesShareLittle) {
  const auto chain = [](const std::string& operation, const std::string& other) {
    Texts lines = {"value = " + operation + "(#1, #1)"};
    for (int i = 1; i < 2000; ++i)
      lines.push_back("#" + std::to_string(i) + " = " + (i % 3 == 0 ? other : operation) + "(#" + std::to_string(i + 1) + ", #" + std::to_string(i + 1) + ")");
    lines.push_back("#2000 = varying " + other);
    return lines;
  };
  EXPECT_FALSE(changesOf(chain("FMul", "FAdd"), chain("FSub", "FDiv")).empty());
}

TEST(SliceChanges, OfKeptTermsLeaveTheOthersAlone) {
  const SliceTerms kept = read({"value = sum(Sin(varying a), Cos(varying b))"});
  const SliceTerms all = read({"value = sum(varying c, Sin(varying a), FMul(varying d, 2.0), Cos(varying e))"});
  const std::vector<SliceChange> changes = changesOfKept(kept, all);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].text, "varying 'e' is read in place of 'b'");
  const std::vector<SliceChange> gone = changesOfKept(kept, read({"value = sum(Sin(varying a), varying c)"}));
  ASSERT_EQ(gone.size(), 1u);
  EXPECT_EQ(gone[0].text, "the kept term `Cos(varying b)` is gone");
}

}  // namespace
}  // namespace reprise
