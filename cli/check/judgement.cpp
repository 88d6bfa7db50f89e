#include "cli/check/judgement.h"

namespace reprise {

RoundingJudgement judge(const Evidence& evidence) {
  if (evidence.interpreted == Computation::kDifferent) return RoundingJudgement::kOurs;
  const bool same = evidence.interpreted == Computation::kSame;
  switch (evidence.as_given) {
    case Nearness::kEqual: return RoundingJudgement::kEqual;
    case Nearness::kRounded: return evidence.equal_without_contraction || same ? RoundingJudgement::kRounded : RoundingJudgement::kOurs;
    case Nearness::kBeyond: return evidence.equal_without_contraction && same ? RoundingJudgement::kEnlarged : RoundingJudgement::kOurs;
  }
  return RoundingJudgement::kOurs;
}

}  // namespace reprise
