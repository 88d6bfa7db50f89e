#include "cli/check/module_player.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/check/reference/play_original.h"
#include "compiler/ir/reproducible.h"
#include "compiler/strategies/refuse_variant.h"
#include "compiler/strategies/registry.h"

namespace reprise {
namespace {

constexpr double kRegroupedTolerance = 1e-4;  // of regrouped chains (compiler/transforms/regroup.h), times what the tail makes of it
constexpr std::uint32_t kPeriod = 4, kBlock = 4;

VariantOptions optionsFor(const std::string& strategy) {
  VariantOptions options;
  options.strategy = strategy;
  options.pattern = PatternKind::kInterleaved;
  options.block_pixels = kBlock;
  options.filter = Filter::kNearest;
  options.encoding = Encoding::kRgba32f;
  options.period_frames = kPeriod;
  options.instrumented = true;
  options.ranges.depth_near = 0.3f;
  options.ranges.depth_far = 20;
  return options;
}

// Ids stay, so that analysis and candidates hold for it.
ShaderProgram strictProgram(const ShaderProgram& program) {
  ShaderProgram strict = program;
  PreparedShader fragment = *program.fragment;
  fragment.module = withoutContraction(fragment.module);
  strict.fragment = std::make_shared<const PreparedShader>(std::move(fragment));
  return strict;
}

}  // namespace

std::vector<std::uint32_t> preparedWords(const ShaderProgram& program) { return writeModule(program.fragment->module); }

ModulePlayer::ModulePlayer(const Context& context, Commands& commands, ShaderProgram program, Reference reference, const StateLimits& limits)
    : context_(context), commands_(commands), program_(std::move(program)), reference_(std::move(reference)), limits_(limits) {}

const ShaderProgram& ModulePlayer::programOf(bool no_contraction) {
  if (!no_contraction) return program_;
  if (strict_ == nullptr) strict_ = std::make_unique<const ShaderProgram>(strictProgram(program_));
  return *strict_;
}

Result<void> ModulePlayer::setInputs(const HarnessOptions& inputs) {
  inputs_ = inputs;
  REPRISE_ASSIGN(Harness harness, Harness::create(context_, commands_, program_.interface, inputs));
  harness_ = std::make_unique<Harness>(std::move(harness));
  if (!divergent_quads_) {
    REPRISE_ASSIGN(divergent_quads_, DivergentQuads::create(context_, commands_, program_));
  }
  REPRISE_ASSIGN(left_out_, divergent_quads_->find(inputs, kMovingFrames));
  return {};
}

Result<Player*> ModulePlayer::playerFor(const std::string& key, const std::function<Result<Player>()>& make) {
  auto known = players_.find(key);
  if (known == players_.end()) {
    REPRISE_ASSIGN(Player made, make());
    known = players_.emplace(key, std::move(made)).first;
  }
  known->second.restart();
  return &known->second;
}

Result<std::vector<HarnessFrame>> ModulePlayer::playWords(const std::vector<std::uint32_t>& fragment_words) {
  return playOriginal(*harness_, {program_.interface, program_.vertex_words, fragment_words}, kMovingFrames);
}

Result<Originals> ModulePlayer::originals(bool no_contraction) {
  Originals originals;
  REPRISE_ASSIGN(originals.given, reference_({inputs_, kMovingFrames, no_contraction}));
  REPRISE_ASSIGN(Player* player, playerFor(no_contraction ? "prepared, strict" : "prepared", [&] {
    const std::vector<std::uint32_t> words = preparedWords(programOf(no_contraction));
    return harness_->createPlayer(originalPackage({program_.interface, program_.vertex_words, words}), true);
  }));
  REPRISE_ASSIGN(originals.prepared, playFrames(*harness_, *player, kMovingFrames));
  return originals;
}

Result<Player*> ModulePlayer::variantPlayer(const Candidate& candidate, const VariantOptions& options, bool no_contraction) {
  const std::string key = fmt::format("{} in {}{}{}", candidate.id, options.strategy, no_contraction ? ", strict" : "", options.poisoned ? ", poisoned" : "");
  return playerFor(key, [&]() -> Result<Player> {
    REPRISE_ASSIGN(const Package package, buildPackage(programOf(no_contraction), candidate, options, limits_));
    REPRISE_ASSIGN(Player player, harness_->createPlayer(package, false));
    if (!player.originalReason().empty()) return Error{ErrorKind::kRefused, "device.requirement", player.originalReason(), {}};
    return player;
  });
}

Result<VariantFrames> ModulePlayer::variant(const Candidate& candidate, const std::string& strategy, bool no_contraction) {
  REPRISE_ASSIGN(Player* player, variantPlayer(candidate, optionsFor(strategy), no_contraction));
  VariantFrames frames;
  const auto play = [&](std::vector<HarnessFrame>& into, int frame, std::uint32_t period) -> Result<void> {
    REPRISE_ASSIGN(HarnessFrame played, harness_->play(*player, {frame, period}));
    into.push_back(std::move(played));
    return {};
  };
  for (int frame = 0; frame < kPeriodOneFrames; ++frame) REPRISE_TRY(play(frames.period_one, frame, 1));
  player->invalidate();
  for (int frame = 0; frame < kMovingFrames; ++frame) REPRISE_TRY(play(frames.moving, frame, kPeriod));
  player->invalidate();
  for (int frame = 0; frame < kFrozenFrames; ++frame) REPRISE_TRY(play(frames.frozen, kFrozenShot, kPeriod));
  return frames;
}

Result<bool> ModulePlayer::poisonShows(const Candidate& candidate, const std::string& strategy, const std::vector<HarnessFrame>& moving) {
  VariantOptions options = optionsFor(strategy);
  options.poisoned = true;
  REPRISE_ASSIGN(Player* player, variantPlayer(candidate, options, false));
  for (std::size_t frame = 0; frame < moving.size(); ++frame) {
    REPRISE_ASSIGN(const HarnessFrame played, harness_->play(*player, {static_cast<int>(frame), kPeriod}));
    if (played.colors != moving[frame].colors) return true;
  }
  return false;
}

LawTerms ModulePlayer::terms(const Candidate* candidate, const std::string& strategy) const {
  const std::vector<Instruction>& modes = program_.fragment->module.execution_modes;
  LawTerms terms;
  terms.left_out = left_out_;
  terms.kinds = channelKinds(program_.interface.outputs);
  terms.computed_depth = program_.interface.writes_depth;
  terms.depth_tells_coverage = !(std::any_of(modes.begin(), modes.end(), isEarlyTests) && program_.analysis.discards);
  // A regrouped chain feeds the cache, and what reads it: hits, and the tail of three passes for misses too.
  if (candidate == nullptr || !isRegrouped(*candidate)) return terms;
  terms.stated_at_hits = kRegroupedTolerance;
  terms.stated_at_misses = findStrategy(strategy)->keeps_raw_payload ? kRegroupedTolerance : 0;
  return terms;
}

}  // namespace reprise
