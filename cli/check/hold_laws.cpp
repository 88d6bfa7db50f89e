#include "cli/check/hold_laws.h"

#include <fmt/format.h>

#include <algorithm>

namespace reprise {
namespace {

using Frames = std::vector<HarnessFrame>;

ColorLaw lawOf(const LawTerms& terms, const std::string& name, ExactPixels pixels, std::size_t frame, double tolerance) {
  ColorLaw law;
  law.name = name;
  law.pixels = pixels;
  law.tolerance = tolerance;
  law.kinds = terms.kinds;
  law.computed_depth = terms.computed_depth;
  law.depth_tells_coverage = terms.depth_tells_coverage;
  if (!terms.left_out.empty()) law.left_out = &terms.left_out[frame];
  return law;
}

std::optional<BrokenLaw> brokenIn(const HarnessFrame& original, const HarnessFrame& played, const ColorLaw& law, std::size_t frame) {
  const std::optional<Violation> violation = findViolation(original, played, law);
  if (!violation) return std::nullopt;
  return BrokenLaw{*violation, static_cast<int>(frame)};
}

// Whether the frames hold against either of the originals. The prepared module's image has been judged by then.
bool holds(const Originals& originals, bool as_prepared, const VariantFrames& played, const LawTerms& terms, double tolerance) {
  if (!as_prepared && !findBrokenLaw(originals.given, played, terms, tolerance)) return true;
  return !findBrokenLaw(originals.prepared, played, terms, tolerance);
}

}  // namespace

Result<const Originals*> OriginalFrames::get(bool no_contraction) {
  std::optional<Originals>& frames = no_contraction ? strict_ : as_given_;
  if (!frames) {
    REPRISE_ASSIGN(frames, play_(no_contraction));
  }
  return &*frames;
}

std::optional<BrokenLaw> findDifference(const Frames& given, const Frames& prepared, const LawTerms& terms, double tolerance) {
  for (std::size_t frame = 0; frame < prepared.size(); ++frame)
    if (auto broken = brokenIn(given[frame], prepared[frame], lawOf(terms, "prepare", ExactPixels::kAll, frame, tolerance), frame)) return broken;
  return std::nullopt;
}

std::optional<BrokenLaw> findBrokenLaw(const Frames& originals, const VariantFrames& played, const LawTerms& terms, double tolerance) {
  const double at_hits = std::max(tolerance, terms.stated_at_hits), at_misses = std::max(tolerance, terms.stated_at_misses);
  for (std::size_t frame = 0; frame < played.period_one.size(); ++frame)
    if (auto broken = brokenIn(originals[frame], played.period_one[frame],
                               lawOf(terms, "law.always_refresh", ExactPixels::kAll, frame, at_misses), frame))
      return broken;
  for (std::size_t frame = 0; frame < played.moving.size(); ++frame)
    if (auto broken = brokenIn(originals[frame], played.moving[frame],
                               lawOf(terms, "law.misses_exact", ExactPixels::kMisses, frame, at_misses), frame))
      return broken;
  if (const std::size_t hits = played.moving.empty() ? 0 : countKind(played.moving.front(), 1); hits > 0)
    return BrokenLaw{{"law.books", 0, "no hit in the first frame", fmt::format("{} hits", hits)}, 0};
  for (const HarnessFrame& frame : played.frozen)
    if (auto broken = brokenIn(originals[kFrozenShot], frame, lawOf(terms, "law.frozen_world", ExactPixels::kAll, kFrozenShot, at_hits), kFrozenShot))
      return broken;
  return std::nullopt;
}

Result<Held> holdPrepared(OriginalFrames& originals, const LawTerms& terms, Computation interpreted) {
  Held held;
  REPRISE_ASSIGN(const Originals* as_given, originals.get(false));
  held.difference = findDifference(as_given->given, as_given->prepared, terms, 0);
  if (interpreted == Computation::kDifferent) {
    held.judgement = RoundingJudgement::kOurs;
    return held;
  }
  if (!held.difference) return held;
  const auto beyond = findDifference(as_given->given, as_given->prepared, terms, kRoundingTolerance);
  Evidence evidence{beyond ? Nearness::kBeyond : Nearness::kRounded, false, interpreted};
  if (judge(evidence) == RoundingJudgement::kOurs) {  // so far: it needs the other witness
    REPRISE_ASSIGN(const Originals* strict, originals.get(true));
    evidence.equal_without_contraction = !findDifference(strict->given, strict->prepared, terms, 0);
  }
  held.judgement = judge(evidence);
  if (beyond) held.difference = beyond;
  held.inconsistent = held.judgement == RoundingJudgement::kOurs && interpreted == Computation::kSame && !evidence.equal_without_contraction;
  return held;
}

Result<HeldVariant> holdVariant(OriginalFrames& originals, bool as_prepared, const PlayVariant& play, const LawTerms& terms,
                                const std::function<Computation()>& interpret) {
  HeldVariant variant;
  REPRISE_ASSIGN(const Originals* as_given, originals.get(false));
  REPRISE_ASSIGN(variant.frames, play(false));
  if (holds(*as_given, as_prepared, variant.frames, terms, 0)) return variant;
  const Frames& expected = as_prepared ? as_given->prepared : as_given->given;
  Held& held = variant.held;
  held.difference = findBrokenLaw(expected, variant.frames, terms, 0);
  held.judgement = RoundingJudgement::kOurs;
  if (held.difference->violation.law == "law.books") return variant;
  Evidence evidence{Nearness::kRounded, false, interpret()};
  if (!holds(*as_given, as_prepared, variant.frames, terms, kRoundingTolerance)) {
    held.difference = findBrokenLaw(expected, variant.frames, terms, kRoundingTolerance);
    evidence.as_given = Nearness::kBeyond;
  }
  held.judgement = judge(evidence);
  if (held.judgement != RoundingJudgement::kOurs || evidence.interpreted == Computation::kDifferent) return variant;
  REPRISE_ASSIGN(const Originals* strict, originals.get(true));
  REPRISE_ASSIGN(const VariantFrames strict_frames, play(true));
  evidence.equal_without_contraction = holds(*strict, as_prepared, strict_frames, terms, 0);
  held.judgement = judge(evidence);
  return variant;
}

}  // namespace reprise
