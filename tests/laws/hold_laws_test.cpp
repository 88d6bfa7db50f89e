// Variants are held to the original before they are measured: what is right passes and is not compared again, what is wrong is told with
// its place.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/hold_laws.h"
#include "cli/open_bench.h"
#include "cli/train.h"
#include "cli/validate_choice.h"
#include "tests/e2e/small_scenario.h"
#include "tests/session/spoiled_package.h"

namespace reprise {
namespace {

class HoldLaws : public testing::Test {
 protected:
  void SetUp() override {
    subject_ = readSubject(scenario_.toml()).value();
    workspace_ = Workspace::open(scenario_.output()).value();
    ASSERT_TRUE(copyInputs(subject_, workspace_.scenarioFile()).ok());
    const DeviceSummary device = chosenDevice("").value();
    bench_ = std::make_unique<Bench>(openBench(subject_, workspace_, {"", REPRISE_EXECUTABLE, {"rms"}, {}}, device).value());
    bench_->measuring.store = &bench_->store;
  }

  VariantToHold variant(const std::string& strategy) const {
    const auto kept = std::find_if(subject_.candidates.begin(), subject_.candidates.end(), [](const Candidate& one) { return one.kept() && !isRegrouped(one); });
    REPRISE_CHECK(kept != subject_.candidates.end(), subject_.scenario.path);
    VariantToHold held{*kept, baseOptions(subject_, ranges(), *kept), {}};
    held.options.strategy = strategy;
    return held;
  }

  static ValueRanges ranges() {
    ValueRanges ranges;
    ranges.depth_near = 0.1f;
    ranges.depth_far = 100;
    ranges.payload_min.fill(-4);
    ranges.payload_max.fill(4);
    return ranges;
  }

  // The variant's package on disk, as it is measured, and a faulty copy.
  StoredVariant stored(const VariantToHold& held) const {
    return storeVariant(workspace_, subject_.program, held.candidate, held.options, subject_.limits).value();
  }
  std::string spoiled(const VariantToHold& held, const std::string& module) const {
    const std::string wrong = (scenario_.file("wrong_" + module)).string();
    spoilPackage(stored(held).dir, wrong, module, 0.8f, 0.4f);
    return wrong;
  }

  Result<std::vector<LawVerdict>> hold(const std::vector<VariantToHold>& variants) { return holdLaws(subject_, workspace_, bench_->measuring, variants, progress_); }

  SmallScenario scenario_;
  Subject subject_;
  Workspace workspace_;
  std::unique_ptr<Bench> bench_;
  Progress progress_{ProgressStyle::kQuiet};
};

TEST_F(HoldLaws, PassesWhatIsRightAndPlaysItOnce) {
  std::vector<VariantToHold> variants = {variant("branch"), variant("two_pass")};
  variants[1].packages = {stored(variants[1]).dir};
  const auto first = hold(variants);
  ASSERT_TRUE(first.ok()) << formatError(first.error());
  for (const LawVerdict& verdict : *first) {
    EXPECT_FALSE(verdict.conviction) << verdict.conviction->message;
    EXPECT_FALSE(verdict.refused);
    EXPECT_GT(verdict.frozen_hits, 0u);
  }
  bench_->measuring.supervisor.worker_path = "/nonexistent";
  const auto again = hold(variants);
  ASSERT_TRUE(again.ok()) << "played again: " << formatError(again.error());
  EXPECT_EQ(again->at(0).frozen_hits, first->at(0).frozen_hits);
  EXPECT_FALSE(hold({variant("three_pass")}).ok()) << "a variant that was never held needs a worker";
}

TEST_F(HoldLaws, TellsWhereAPackageDiffers) {
  VariantToHold held = variant("two_pass");
  held.packages = {spoiled(held, "fragment_misses")};
  const auto verdicts = hold({held, variant("branch")});
  ASSERT_TRUE(verdicts.ok()) << formatError(verdicts.error());
  ASSERT_TRUE(verdicts->at(0).conviction);
  EXPECT_EQ(verdicts->at(0).conviction->code, "law.exact_setting");
  for (const char* said : {"session 'train'", "frame 0", "pixel (", "of output 0", "expected (", "found ("})
    EXPECT_NE(verdicts->at(0).conviction->message.find(said), std::string::npos) << verdicts->at(0).conviction->message;
  EXPECT_FALSE(verdicts->at(1).conviction) << "another variant's fault";
}

TEST_F(HoldLaws, SaysWhichVariantsThereAreNot) {
  const auto verdicts = hold({variant("two_pass_stencil")});
  ASSERT_TRUE(verdicts.ok()) << formatError(verdicts.error());
  EXPECT_TRUE(verdicts->at(0).refused);
  EXPECT_FALSE(verdicts->at(0).conviction);
}

TEST_F(HoldLaws, BlamesTheOriginalForItsOwnEnd) {
  bench_->measuring.supervisor.worker_path = "/bin/false";
  const auto verdicts = hold({variant("branch")});
  ASSERT_FALSE(verdicts.ok());
  EXPECT_EQ(verdicts.error().code, "original.unplayable");
}

TEST_F(HoldLaws, NothingIsValidatedOfAPackageThatDiffers) {
  const VariantToHold held = variant("two_pass");
  subject_.candidates = {held.candidate};
  ValidationPlan plan;
  plan.options = held.options;
  plan.options.period_frames = 2;
  plan.packages = {spoiled(held, "fragment_misses")};
  const Result<ValidationRun> run = validateChoice(subject_, workspace_, bench_->measuring, plan, progress_);
  ASSERT_TRUE(run.ok()) << formatError(run.error());
  EXPECT_FALSE(run->judgement.accepted);
  EXPECT_EQ(run->judgement.code, "law.exact_setting");
  EXPECT_NE(run->judgement.reason.find("pixel ("), std::string::npos) << run->judgement.reason;
  for (const ValidatedSession& session : run->sessions) EXPECT_TRUE(session.rows.empty()) << session.name;
}

}  // namespace
}  // namespace reprise
