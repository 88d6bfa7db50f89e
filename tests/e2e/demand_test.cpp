// The words of the command line as thresholds.
#include "cli/demand.h"

#include <gtest/gtest.h>

#include "profiler/metrics/quality.h"

namespace reprise {
namespace {

std::string codeOf(const DemandWords& words) {
  const Result<Demand> demand = demandOf(words);
  return demand.ok() ? "" : demand.error().code;
}

TEST(Demand, IsTheDefaultLevelWhereNothingIsSaid) {
  const Demand demand = demandOf({}).value();
  EXPECT_EQ(demand.quality, kDefaultQuality);
  EXPECT_EQ(demand.binding, findQuality(kDefaultQuality)->binding);
  EXPECT_EQ(demand.planning, findQuality(kDefaultQuality)->planning);
}

TEST(Demand, OfMaxErrorAloneIsRmsAlone) {
  const Demand demand = demandOf({.max_error = 0.02}).value();
  EXPECT_EQ(demand.quality, "");
  EXPECT_EQ(demand.binding.thresholds, (std::vector<Threshold>{{"rms", 0.02}}));
  EXPECT_EQ(demand.planning, demand.binding);
  EXPECT_EQ(demandOf({.max_error = 0.03, .metric = "flip"}).value().binding.thresholds, (std::vector<Threshold>{{"flip", 0.03}}));
}

TEST(Demand, OfSeveralBindsAll) {
  const Demand demand = demandOf({.max_error = 0.02, .max = {"blocks=0.01", "rms=0.01", "flip=0.1"}}).value();
  EXPECT_EQ(demand.binding.thresholds, (std::vector<Threshold>{{"rms", 0.01}, {"blocks", 0.01}, {"flip", 0.1}})) << "the smaller of two binds";
  const Demand more = demandOf({.quality = "draft", .max = {"over8=0.05"}}).value();
  EXPECT_EQ(more.binding.thresholds.size(), findQuality("draft")->binding.thresholds.size() + 1);
}

TEST(Demand, ThatMakesNoSenseIsRefused) {
  EXPECT_EQ(codeOf({.quality = "best"}), "quality.unknown");
  EXPECT_EQ(codeOf({.max_error = 0.02, .metric = "rsm"}), "metric.unknown");
  EXPECT_NE(demandOf({.max_error = 0.02, .metric = "rsm"}).error().message.find("did you mean 'rms'?"), std::string::npos);
  EXPECT_EQ(codeOf({.metric = "flip"}), "metric.alone");
  for (const char* text : {"rms", "rms=", "rms=x", "rms=0", "rms=-1", "rms=nan", "rms=inf"}) EXPECT_EQ(codeOf({.max = {text}}), "threshold.value") << text;
  EXPECT_EQ(codeOf({.max_error = 0.0}), "threshold.value");
}

TEST(ErrorLimits, GiveTheLargestShareThatAnyMetricTakes) {
  const auto errorOf = [](const std::string& metric) -> std::optional<double> {
    return metric == "rms" ? std::optional(0.01) : metric == "blocks" ? std::optional(0.009) : std::nullopt;
  };
  const ErrorLimits one{{{"rms", 0.02}}}, two{{{"rms", 0.02}, {"blocks", 0.01}}}, missing{{{"rms", 0.02}, {"flip", 0.1}}};
  EXPECT_DOUBLE_EQ(one.error(errorOf).value(), 0.01);
  EXPECT_EQ(one.unit(), "rms");
  EXPECT_DOUBLE_EQ(two.error(errorOf).value(), 0.9);
  EXPECT_EQ(two.limit(), 1);
  EXPECT_FALSE(missing.error(errorOf).has_value());
}

// A stricter level allows less of everything.
TEST(Quality, LevelsOrder) {
  for (std::size_t i = 1; i < qualities().size(); ++i)
    for (const Threshold& looser : qualities()[i].binding.thresholds)
      for (const Threshold& stricter : qualities()[i - 1].binding.thresholds)
        if (looser.metric == stricter.metric) {
          EXPECT_LT(stricter.value, looser.value) << looser.metric;
        }
}

}  // namespace
}  // namespace reprise
