#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "cli/report/text.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

long codePoints(const std::string& line) {
  return std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
}

TEST(ChoiceSentence, SaysWhatHowFastAndHowWrong) {
  EXPECT_EQ(choiceSentence(sample::variantRun()),
            "Caching albedo (two_pass, refreshed every 32 frames) makes the shader 3.12 times as fast (95% "
            "interval 3.04 to 3.21) "
            "with a validation error of 0.0151 rms; allowed was rms 0.02.");
}

TEST(ChoiceSentence, SaysWhyForTheOriginal) {
  EXPECT_EQ(choiceSentence(sample::emptyRun()),
            "The original shader is the best answer: the shader has no value that is worth keeping.");
}

TEST(ChoiceSentence, NamesAllPayloadsAndNever) {
  RunResult run = sample::variantRun();
  run.choice.payload.push_back(run.choice.payload[0]);
  run.choice.payload[1].name = "gloss";
  run.choice.period_frames = 0;
  EXPECT_EQ(choiceSentence(run).find("Caching albedo and gloss (two_pass, never refreshed)"), 0u)
      << choiceSentence(run);
}

TEST(SummaryText, KeepsToEightyColumnsAndFreeOfControls) {
  RunResult long_words = sample::variantRun();
  long_words.command = std::string(300, 'x');
  for (const RunResult& run :
       {sample::variantRun(), sample::originalRun(), sample::emptyRun(), sample::hostileRun(), long_words}) {
    const std::string text = summaryText(run);
    EXPECT_EQ(text.back(), '\n');
    for (const std::string& line : linesOf(text)) {
      EXPECT_LE(codePoints(line), 80) << line;
      EXPECT_TRUE(std::none_of(line.begin(), line.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
      })) << line;
    }
  }
}

TEST(SummaryText, ListsTrainedCandidatesAttemptsAndWarnings) {
  const RunResult run = sample::variantRun();
  const std::string text = summaryText(run);
  for (const RunCandidate& candidate : run.candidates) {
    if (candidate.status != CandidateStatus::kTrained) continue;
    EXPECT_NE(text.find("\n  " + candidate.name + " "), std::string::npos) << candidate.name;
  }
  EXPECT_NE(text.find("not accepted"), std::string::npos);
  EXPECT_NE(text.find("Warnings"), std::string::npos);
  EXPECT_NE(text.find("Not reached"), std::string::npos);
}

TEST(SummaryText, BeginsWithTheSuspicionThatMotionIsMissing) {
  RunResult run = sample::variantRun();
  EXPECT_EQ(leadingWarning(run), std::nullopt);
  run.warnings.insert(run.warnings.begin(), "motion.suspect: no pixel moves");
  EXPECT_EQ(leadingWarning(run), run.warnings.front());
  const std::string text = summaryText(run);
  EXPECT_TRUE(text.starts_with("motion.suspect: no pixel moves\n\nCaching albedo")) << text;
  EXPECT_EQ(text.find("motion.suspect", 1), std::string::npos) << "said twice:\n" << text;
  EXPECT_NE(text.find("\nWarnings\n  - The machine was busy"), std::string::npos) << text;
  EXPECT_TRUE(summaryMarkdown(run).starts_with("**motion.suspect: no pixel moves**\n\n"));
}

TEST(SummaryText, TakesTheFastestPointUnderTheThreshold) {
  RunResult run = sample::emptyRun();
  RunCandidate candidate;
  candidate.name = "v", candidate.status = CandidateStatus::kTrained;
  RunConfiguration slow, fast;
  slow.strategy = "slow", fast.strategy = "fast";
  slow.points = {{1, {}, 0.0, {}, 1.0}, {2, {}, 0.01, {}, 30.0}};
  fast.points = {{4, 0.001, 0.5, {}, 1.0},
                 {2, 0.5, 0.019, 40.0, 20.0}};  // measured values count, not predicted ones
  candidate.configurations = {slow, fast};
  run.candidates = {candidate};
  EXPECT_NE(summaryText(run).find("fast               2       0.0190    20.0"), std::string::npos)
      << summaryText(run);
}

TEST(SummaryMarkdown, IsATableThatNoNameCanBreak) {
  const std::string text = summaryMarkdown(sample::hostileRun());
  EXPECT_EQ(text.find('<'), std::string::npos);
  for (const std::string& line : linesOf(text)) {
    if (!line.starts_with("|")) continue;
    EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 6) << line;
  }
  EXPECT_NE(summaryMarkdown(sample::variantRun()).find("| 3.12 (95%: 3.04 to 3.21) |"), std::string::npos);
}

TEST(FormatNumber, KeepsThreeDigits) {
  EXPECT_EQ(formatNumber(2.58), "2.58");
  EXPECT_EQ(formatNumber(9.996), "10.0");
  EXPECT_EQ(formatNumber(94.13), "94.1");
  EXPECT_EQ(formatNumber(1234.5), "1234");
  EXPECT_EQ(formatNumber(0.0147), "0.0147");
  EXPECT_EQ(formatNumber(0), "0");
  EXPECT_EQ(formatNumber(-0.5), "-0.500");
  EXPECT_EQ(formatNumber(2e-6), "2.00e-06");
  EXPECT_EQ(formatNumber(std::numeric_limits<double>::quiet_NaN()), "n/a");
}

TEST(Printable, ReplacesControlsAndBrokenUtf8Only) {
  EXPECT_EQ(printable("Δn\x1b[0m\n\xc2\x9b"
                      "5\xff"),
            "Δn?[0m ?5?");
}

}  // namespace
}  // namespace reprise
