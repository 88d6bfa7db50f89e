// What the report shows beside the figures: costs of lines, the cut of the shader, the points that get pictures, doubtful fits.
#include "cli/describe_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "cli/describe_run.h"
#include "cli/evidence_pictures.h"
#include "tests/report/sample_run.h"

namespace reprise {
namespace {

// The first line, from 1, that holds `text` in the source whose path ends with `name`.
EvidenceLine lineWith(const std::vector<EvidenceSource>& sources, const std::string& name, const std::string& text) {
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!sources[i].path.ends_with(name)) continue;
    const std::size_t at = sources[i].text.find(text);
    if (at == std::string::npos) break;
    return {i, static_cast<int>(1 + std::count(sources[i].text.begin(), sources[i].text.begin() + static_cast<std::ptrdiff_t>(at), '\n'))};
  }
  ADD_FAILURE() << name << " has no line with " << text;
  return {};
}

bool holds(const std::vector<EvidenceLine>& lines, const EvidenceLine& wanted) { return std::find(lines.begin(), lines.end(), wanted) != lines.end(); }

class MarbleEvidence : public testing::Test {
 protected:
  void SetUp() override {
    Result<Subject> read = readSubject(REPRISE_SOURCE_DIR "/shaders/marble/marble.toml");
    ASSERT_TRUE(read.ok()) << formatError(read.error());
    subject_ = std::move(*read);
    sources_ = describeSources(subject_->program);
  }

  std::optional<Subject> subject_;
  std::vector<EvidenceSource> sources_;
};

TEST_F(MarbleEvidence, SharesOfLinesAddUpToTheShader) {
  double sum = 0;
  for (const EvidenceSource& source : sources_) sum += std::accumulate(source.line_shares.begin(), source.line_shares.end(), 0.0);
  EXPECT_NEAR(sum, 1, 1e-6);
  const EvidenceLine noise = lineWith(sources_, "marble.frag", "turbulence += amplitude"), light = lineWith(sources_, "marble.frag", "float diffuse =");
  const auto shareOf = [&](const EvidenceLine& line) { return sources_[line.source].line_shares[static_cast<std::size_t>(line.line) - 1]; };
  EXPECT_GT(shareOf(light), 0);
  EXPECT_GT(shareOf(noise), 0);
}

TEST_F(MarbleEvidence, CutsTheShaderAtTheVein) {
  const std::vector<EvidenceSlice> slices = describeSlices(subject_->program, subject_->candidates, sources_);
  const auto vein = std::find_if(slices.begin(), slices.end(), [](const EvidenceSlice& slice) { return slice.candidate_id.starts_with("vein@"); });
  ASSERT_NE(vein, slices.end());
  for (const char* cached : {"turbulence += amplitude", "float vein ="}) EXPECT_TRUE(holds(vein->slice, lineWith(sources_, "marble.frag", cached))) << cached;
  for (const char* computed : {"vec3 to_light =", "float diffuse =", "vec3 stone ="}) EXPECT_TRUE(holds(vein->tail, lineWith(sources_, "marble.frag", computed))) << computed;
}

TEST(PointsToShow, BeginWithTheChoiceAndGiveEveryAcceptableCandidateOne) {
  FittedTraining fitted;
  Selection selection;
  for (std::size_t i = 0; i < 12; ++i) {
    Configuration configuration;
    configuration.candidate_id = "candidate " + std::to_string(i % 6);
    fitted.input.configurations.push_back(configuration);
    TradeoffPoint point;
    point.configuration = i;
    point.period_frames = 8;
    point.predicted_error = i % 6 == 5 ? 0.5 : 0.01;
    point.predicted_frame_ms = 10.0 + static_cast<double>(i);
    selection.points.push_back(point);
  }
  selection.pareto = {selection.points[2], selection.points[0]};
  const std::vector<TradeoffPoint> shown = pointsToShow(selection.points[7], selection, fitted, 0.02);
  ASSERT_FALSE(shown.empty());
  EXPECT_LE(shown.size(), kMostPictures);
  EXPECT_EQ(shown.front().configuration, 7u);
  std::vector<std::string> candidates;
  for (const TradeoffPoint& point : shown) candidates.push_back(fitted.input.configurations[point.configuration].candidate_id);
  std::sort(candidates.begin(), candidates.end());
  EXPECT_EQ(candidates, (std::vector<std::string>{"candidate 0", "candidate 1", "candidate 2", "candidate 3", "candidate 4"}));
}

TEST(PointsToShow, AreNeverMoreThanThePageHolds) {
  FittedTraining fitted;
  Selection selection;
  for (std::size_t i = 0; i < 40; ++i) {
    Configuration configuration;
    configuration.candidate_id = "candidate " + std::to_string(i);
    fitted.input.configurations.push_back(configuration);
    TradeoffPoint point;
    point.configuration = i;
    selection.points.push_back(point);
  }
  selection.pareto = selection.points;
  const std::vector<TradeoffPoint> shown = pointsToShow({}, selection, fitted, 0.02);
  EXPECT_EQ(shown.size(), kMostPictures);
  EXPECT_EQ(shown.front().configuration, selection.pareto.front().configuration);
}

RunCandidate& chosenCandidate(RunResult& run) {
  return *std::find_if(run.candidates.begin(), run.candidates.end(), [&](const RunCandidate& one) { return one.id == run.choice.candidate_id; });
}

TEST(FitWarnings, TellOfDoubtfulModelsOfTheChoiceAlone) {
  RunResult run = sample::variantRun();
  for (RunCandidate& candidate : run.candidates) {
    if (candidate.error_model) candidate.error_model->verdict = "good: misses the measured errors by 5%";
    for (RunConfiguration& one : candidate.configurations) one.cost_verdict = "good: frame times scatter about the model by 3%";
  }
  EXPECT_TRUE(fitWarnings(run).empty());

  for (RunCandidate& candidate : run.candidates)
    if (candidate.id != run.choice.candidate_id && candidate.error_model) candidate.error_model->verdict = "poor: misses the measured errors by 60%";
  EXPECT_TRUE(fitWarnings(run).empty());

  RunCandidate& chosen = chosenCandidate(run);
  ASSERT_TRUE(chosen.error_model.has_value());
  chosen.error_model->verdict = "poor: misses the measured errors by 60%";
  for (RunConfiguration& one : chosen.configurations) one.cost_verdict = "unidentifiable: coverage does not vary";
  const std::vector<std::string> warnings = fitWarnings(run);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("model of the error is poor: misses the measured errors by 60%"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[1].find("model of the cost is unidentifiable"), std::string::npos) << warnings[1];
}

TEST(FitWarnings, SayNothingWhereTheOriginalIsTheAnswer) {
  RunResult run = sample::originalRun();
  for (RunCandidate& candidate : run.candidates)
    if (candidate.error_model) candidate.error_model->verdict = "poor: misses the measured errors by 60%";
  EXPECT_TRUE(fitWarnings(run).empty());
}

}  // namespace
}  // namespace reprise
