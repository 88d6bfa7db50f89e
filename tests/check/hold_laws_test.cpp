// How frames that are made by hand are held to the original's: which plays are asked for, and what comes of the answers.
#include "cli/check/hold_laws.h"

#include <gtest/gtest.h>

#include <bit>

namespace reprise {
namespace {

constexpr std::uint32_t kNear = 0x3f000000u;  // 0.5f

// One hit and one miss.
HarnessFrame frameOf(float hit, float miss) {
  HarnessFrame frame;
  frame.depth = {kNear, kNear};
  frame.kind = {1, 2};
  frame.colors = {{std::bit_cast<std::uint32_t>(hit), 0, 0, 0, std::bit_cast<std::uint32_t>(miss), 0, 0, 0}};
  return frame;
}

std::vector<HarnessFrame> original(float value) {
  HarnessFrame frame = frameOf(value, value);
  frame.kind.clear();
  return std::vector<HarnessFrame>(kMovingFrames, frame);
}

// As given the values are these, and with NoContraction those.
OriginalFrames originals(float given, float prepared, float strict_given = 7, float strict_prepared = 7) {
  return OriginalFrames([=](bool no_contraction) -> Result<Originals> {
    if (no_contraction) return Originals{original(strict_given), original(strict_prepared)};
    return Originals{original(given), original(prepared)};
  });
}

VariantFrames variantOf(float hit, float miss) {
  VariantFrames frames;
  frames.period_one.assign(kPeriodOneFrames, frameOf(miss, miss));
  frames.moving.assign(kMovingFrames, frameOf(hit, miss));
  frames.moving.front().kind = {2, 2};
  frames.moving.front().colors = frameOf(miss, miss).colors;
  frames.frozen.assign(kFrozenFrames, frameOf(hit, miss));
  return frames;
}

PlayVariant playing(float as_given, float strict = 7) {
  return [=](bool no_contraction) -> Result<VariantFrames> { return variantOf(no_contraction ? strict : as_given, no_contraction ? strict : as_given); };
}

constexpr auto kUnknown = Computation::kUnknown, kSame = Computation::kSame, kDifferent = Computation::kDifferent;

TEST(HoldPrepared, JudgesByTheRuleOfRounding) {
  const struct {
    float prepared, strict_prepared;
    Computation interpreted;
    RoundingJudgement judgement;
    bool inconsistent;
  } cases[] = {
      {1, 7, kUnknown, RoundingJudgement::kEqual, false},         {1, 7, kDifferent, RoundingJudgement::kOurs, false},
      {1.000001f, 7, kUnknown, RoundingJudgement::kRounded, false}, {1.000001f, 8, kUnknown, RoundingJudgement::kOurs, false},
      {1.000001f, 8, kSame, RoundingJudgement::kRounded, false},  {1.1f, 7, kUnknown, RoundingJudgement::kOurs, false},
      {1.1f, 7, kSame, RoundingJudgement::kEnlarged, false},      {1.1f, 8, kSame, RoundingJudgement::kOurs, true},
      {1.1f, 8, kUnknown, RoundingJudgement::kOurs, false},       {1.1f, 8, kDifferent, RoundingJudgement::kOurs, false},
  };
  for (const auto& one : cases) {
    OriginalFrames frames = originals(1, one.prepared, 7, one.strict_prepared);
    const Held held = holdPrepared(frames, {}, one.interpreted).value();
    EXPECT_EQ(held.judgement, one.judgement) << one.prepared << ' ' << one.strict_prepared;
    EXPECT_EQ(held.inconsistent, one.inconsistent) << one.prepared << ' ' << one.strict_prepared;
    EXPECT_EQ(held.difference.has_value(), one.prepared != 1);
    if (held.difference) {
      EXPECT_EQ(held.difference->violation.law, "prepare");
    }
  }
}

TEST(HoldPrepared, NoContractionIsPlayedOnlyWhereItIsAWitness) {
  int strict = 0;
  const auto framesOf = [&](float prepared) {
    return OriginalFrames([&strict, prepared](bool no_contraction) -> Result<Originals> {
      strict += no_contraction ? 1 : 0;
      return Originals{original(1), original(prepared)};
    });
  };
  OriginalFrames equal = framesOf(1), rounded = framesOf(1.000001f);
  ASSERT_TRUE(holdPrepared(equal, {}, kUnknown).ok());
  ASSERT_TRUE(holdPrepared(rounded, {}, kSame).ok());
  EXPECT_EQ(strict, 0);
  ASSERT_TRUE(holdPrepared(rounded, {}, kUnknown).ok());
  EXPECT_EQ(strict, 1);
}

std::function<Computation()> told(Computation computation) { return [computation] { return computation; }; }

TEST(HoldVariant, JudgesByTheRuleOfRounding) {
  const struct {
    float as_given, strict;
    Computation interpreted;
    RoundingJudgement judgement;
  } cases[] = {
      {1, 9, kUnknown, RoundingJudgement::kEqual},         {1.000001f, 7, kUnknown, RoundingJudgement::kRounded},
      {1.000001f, 9, kSame, RoundingJudgement::kRounded},   {1.000001f, 9, kUnknown, RoundingJudgement::kOurs},
      {1.1f, 7, kSame, RoundingJudgement::kEnlarged},      {1.1f, 7, kUnknown, RoundingJudgement::kOurs},
      {1.1f, 9, kSame, RoundingJudgement::kOurs},
  };
  for (const auto& one : cases) {
    OriginalFrames frames = originals(1, 1);
    const HeldVariant variant = holdVariant(frames, false, playing(one.as_given, one.strict), {}, told(one.interpreted)).value();
    EXPECT_EQ(variant.held.judgement, one.judgement) << one.as_given << ' ' << one.strict;
    EXPECT_EQ(variant.held.difference.has_value(), one.as_given != 1);
  }
}

TEST(HoldVariant, TheImageOfThePreparedModuleWillDo) {
  OriginalFrames frames = originals(1, 1.1f);
  EXPECT_EQ(holdVariant(frames, false, playing(1.1f, 9), {}, told(kSame))->held.judgement, RoundingJudgement::kEqual);
  // Of a device that draws the module inconsistently it alone will do.
  EXPECT_EQ(holdVariant(frames, true, playing(1.1f, 9), {}, told(kSame))->held.judgement, RoundingJudgement::kEqual);
  EXPECT_EQ(holdVariant(frames, true, playing(1, 9), {}, told(kSame))->held.judgement, RoundingJudgement::kOurs);
}

TEST(HoldVariant, RegroupedChainsHaveTheirToleranceAtHitsOnly) {
  LawTerms terms;
  terms.stated_at_hits = 1e-4;
  const auto play = [](float hit, float miss) { return [=](bool) -> Result<VariantFrames> { return variantOf(hit, miss); }; };
  OriginalFrames frames = originals(1, 1, 1, 1);
  EXPECT_EQ(holdVariant(frames, false, play(1.00005f, 1), terms, told(kUnknown))->held.judgement, RoundingJudgement::kEqual);
  EXPECT_EQ(holdVariant(frames, false, play(1.0005f, 1), terms, told(kUnknown))->held.judgement, RoundingJudgement::kOurs);
  const Held miss = holdVariant(frames, false, play(1, 1.00005f), terms, told(kUnknown))->held;
  EXPECT_EQ(miss.judgement, RoundingJudgement::kOurs);
  EXPECT_EQ(miss.difference->violation.law, "law.always_refresh");
}

TEST(HoldVariant, AHitInTheFirstFrameBreaksTheBooks) {
  OriginalFrames frames = originals(1, 1);
  const PlayVariant play = [](bool) -> Result<VariantFrames> {
    VariantFrames played = variantOf(1, 1);
    played.moving.front().kind = {1, 2};
    return played;
  };
  const Held held = holdVariant(frames, false, play, {}, told(kSame))->held;
  EXPECT_EQ(held.judgement, RoundingJudgement::kOurs);
  EXPECT_EQ(held.difference->violation.law, "law.books");
}

TEST(HoldVariant, IntegersMustBeEqual) {
  LawTerms terms;
  terms.kinds = {ChannelKind::kInteger};
  OriginalFrames frames([](bool) -> Result<Originals> {
    std::vector<HarnessFrame> given = original(0);
    return Originals{given, given};
  });
  // As floats the integers 0 and 1 would be next to nothing apart.
  const PlayVariant play = [](bool) -> Result<VariantFrames> { return variantOf(std::bit_cast<float>(1u), std::bit_cast<float>(1u)); };
  EXPECT_EQ(holdVariant(frames, false, play, terms, told(kSame))->held.judgement, RoundingJudgement::kOurs);
}

TEST(HoldVariant, PixelsLeftOutAreNotCompared) {
  LawTerms terms;
  OriginalFrames frames = originals(1, 1, 1, 1);
  const PlayVariant play = [](bool) -> Result<VariantFrames> { return variantOf(1, 2); };
  EXPECT_EQ(holdVariant(frames, false, play, terms, told(kSame))->held.judgement, RoundingJudgement::kOurs);
  terms.left_out.assign(kMovingFrames, {true, true});
  EXPECT_EQ(holdVariant(frames, false, play, terms, told(kSame))->held.judgement, RoundingJudgement::kEqual);
}

}  // namespace
}  // namespace reprise
