// The judgement of law 0 on a table: whose witness counts.
#include "cli/check/judgement.h"

#include <gtest/gtest.h>

namespace reprise {
namespace {

TEST(Judgement, NeedsAWitness) {
  constexpr auto kUnknown = Computation::kUnknown, kSame = Computation::kSame, kDifferent = Computation::kDifferent;
  const struct {
    Evidence evidence;
    Judgement judgement;
  } cases[] = {
      {{Nearness::kEqual, false, kUnknown}, Judgement::kEqual},
      {{Nearness::kEqual, true, kDifferent}, Judgement::kOurs},
      {{Nearness::kRounded, false, kUnknown}, Judgement::kOurs},
      {{Nearness::kRounded, true, kUnknown}, Judgement::kRounded},
      {{Nearness::kRounded, false, kSame}, Judgement::kRounded},
      {{Nearness::kRounded, true, kDifferent}, Judgement::kOurs},
      {{Nearness::kBeyond, true, kUnknown}, Judgement::kOurs},
      {{Nearness::kBeyond, false, kSame}, Judgement::kOurs},
      {{Nearness::kBeyond, true, kSame}, Judgement::kEnlarged},
      {{Nearness::kBeyond, true, kDifferent}, Judgement::kOurs},
  };
  for (const auto& one : cases)
    EXPECT_EQ(judge(one.evidence), one.judgement) << static_cast<int>(one.evidence.as_given) << one.evidence.equal_without_contraction
                                                  << static_cast<int>(one.evidence.interpreted);
}

}  // namespace
}  // namespace reprise
