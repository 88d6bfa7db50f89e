#include "cli/check/judgement.h"

namespace reprise {

Judgement judge(const Evidence& evidence) {
  if (evidence.interpreted == Computation::kDifferent) return Judgement::kOurs;
  const bool same = evidence.interpreted == Computation::kSame;
  switch (evidence.as_given) {
    case Nearness::kEqual: return Judgement::kEqual;
    case Nearness::kRounded: return evidence.equal_without_contraction || same ? Judgement::kRounded : Judgement::kOurs;
    case Nearness::kBeyond: return evidence.equal_without_contraction && same ? Judgement::kEnlarged : Judgement::kOurs;
  }
  return Judgement::kOurs;
}

}  // namespace reprise
