// The laws of the design (0 to 4) for one set of inputs: the prepared module, uncached, and then a variant, held to the module as given.
//
// Whatever differs is judged as judgement.h has it; where a second look is needed all is played again with
// NoContraction on both sides.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cli/check/frame_laws.h"
#include "cli/check/judgement.h"
#include "runtime/base/result.h"

namespace reprise {

inline constexpr int kMovingFrames = 6, kFrozenFrames = 4, kFrozenShot = 2, kPeriodOneFrames = 3;

// What the laws must know of a shader and a candidate.
struct LawTerms {
  std::vector<ChannelKind> kinds;         // by output
  bool computed_depth = false;            // as ColorLaw has it
  bool depth_tells_coverage = true;
  double stated_at_hits = 0;              // a tolerance of its own that the candidate has: that of regrouped chains
  double stated_at_misses = 0;
  std::vector<std::vector<bool>> left_out;  // by frame and pixel: colours that are not compared; empty: all are
};

// Frames 0 .. kMovingFrames - 1 of the module as given (from the reference), and of the prepared module.
struct Originals {
  std::vector<HarnessFrame> given, prepared;
};

// Played when asked for, and kept: as given, and with NoContraction on both sides.
class OriginalFrames {
 public:
  using Play = std::function<Result<Originals>(bool no_contraction)>;
  explicit OriginalFrames(Play play) : play_(std::move(play)) {}
  Result<const Originals*> get(bool no_contraction);

 private:
  Play play_;
  std::optional<Originals> as_given_, strict_;
};

// What a variant shows: frames 0.. at period 1, frames 0.. under motion at its own period, and a world that stands still.
struct VariantFrames {
  std::vector<HarnessFrame> period_one, moving, frozen;
};
using PlayVariant = std::function<Result<VariantFrames>(bool no_contraction)>;

struct BrokenLaw {
  Violation violation;
  int frame = 0;
};

struct Held {
  RoundingJudgement judgement = RoundingJudgement::kEqual;
  std::optional<BrokenLaw> difference;  // as given, unless equal: the first one that is as far off as the judgement says
  // Of the prepared module: kOurs by its images alone, while the interpreter finds the same computation. The device may be to blame.
  bool inconsistent = false;
};

// The first broken law; floats may be off by `tolerance` or by what is stated.
std::optional<BrokenLaw> findDifference(const std::vector<HarnessFrame>& given, const std::vector<HarnessFrame>& prepared, const LawTerms& terms,
                                        double tolerance);
std::optional<BrokenLaw> findBrokenLaw(const std::vector<HarnessFrame>& originals, const VariantFrames& played, const LawTerms& terms,
                                       double tolerance);

// Law 0. Errors: those of the plays.
Result<Held> holdPrepared(OriginalFrames& originals, const LawTerms& terms, Computation interpreted);

struct HeldVariant {
  Held held;
  VariantFrames frames;  // as given
};

// Laws 1 to 4. What equals the prepared module's image bit for bit holds, once that has been judged. as_prepared: it alone is the
// original (of a device that draws the module itself inconsistently). `interpret` is asked where bits differ: what the interpreter says of
// the bodies that the variant is made from (interpreted_bodies.h). Errors: those of the plays.
Result<HeldVariant> holdVariant(OriginalFrames& originals, bool as_prepared, const PlayVariant& play, const LawTerms& terms,
                                const std::function<Computation()>& interpret);

}  // namespace reprise
