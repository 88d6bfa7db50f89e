// The judgement of law 0 on a table: whose witness counts.
#include "cli/check/judgement.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

TEST(RoundingJudgement, NeedsAWitness) {
  constexpr auto kUnknown = Computation::kUnknown, kSame = Computation::kSame, kDifferent = Computation::kDifferent;
  const struct {
    Evidence evidence;
    RoundingJudgement judgement;
  } cases[] = {
      {{Nearness::kEqual, false, kUnknown}, RoundingJudgement::kEqual},
      {{Nearness::kEqual, true, kDifferent}, RoundingJudgement::kOurs},
      {{Nearness::kRounded, false, kUnknown}, RoundingJudgement::kOurs},
      {{Nearness::kRounded, true, kUnknown}, RoundingJudgement::kRounded},
      {{Nearness::kRounded, false, kSame}, RoundingJudgement::kRounded},
      {{Nearness::kRounded, true, kDifferent}, RoundingJudgement::kOurs},
      {{Nearness::kBeyond, true, kUnknown}, RoundingJudgement::kOurs},
      {{Nearness::kBeyond, false, kSame}, RoundingJudgement::kOurs},
      {{Nearness::kBeyond, true, kSame}, RoundingJudgement::kEnlarged},
      {{Nearness::kBeyond, true, kDifferent}, RoundingJudgement::kOurs},
  };
  for (const auto& one : cases)
    EXPECT_EQ(judge(one.evidence), one.judgement) << static_cast<int>(one.evidence.as_given) << one.evidence.equal_without_contraction
                                                  << static_cast<int>(one.evidence.interpreted);
}

}  // namespace
}  // namespace reprise
