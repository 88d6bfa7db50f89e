#include "cli/check/check_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

#include "cli/check/capabilities.h"
#include "cli/check/endless_loops.h"
#include "cli/check/frame_laws.h"
#include "cli/check/harness_program.h"
#include "cli/check/unsteady_pixels.h"
#include "compiler/ir/optimize.h"
#include "compiler/ir/reproducible.h"
#include "compiler/source/validate.h"
#include "compiler/strategies/build_package.h"
#include "compiler/strategies/registry.h"
#include "runtime/vulkan/lane_probe.h"

namespace reprise {
namespace {

constexpr double kRegroupedTolerance = 1e-4;  // of regrouped chains (compiler/transforms/regroup.h), times what the tail makes of it
constexpr int kFrames = 6, kFrozenFrames = 4, kFrozenShot = 2, kPeriodOneFrames = 3;
constexpr std::uint32_t kPeriod = 4;
constexpr std::uint32_t kBlock = 4;
constexpr double kRounding = 1e-3, kLittleRounding = 1e-5;
constexpr int kSeedsTried = 5;
constexpr std::size_t kCandidatesTried = 4;

struct Subject {
  ShaderProgram program;
  std::vector<Candidate> candidates;  // kept ones
};

CompileOptions compileOptionsOf(const CheckRequest& request) {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  options.entry_point = request.entry_point;
  for (const std::string& directory : request.include_dirs) options.include_dirs.emplace_back(directory);
  for (const std::string& define : request.defines) {
    const std::size_t equals = define.find('=');
    options.defines.emplace_back(define.substr(0, equals), equals == std::string::npos ? "" : define.substr(equals + 1));
  }
  return options;
}

// The reason that most values have for being no candidates.
std::string whyNone(const std::vector<Candidate>& values) {
  std::map<std::string, int> counts;
  const Candidate* most = nullptr;
  int best = 0;
  for (const Candidate& value : values)
    if (++counts[value.dropped.code] > best) best = counts[value.dropped.code], most = &value;
  if (most == nullptr) return "the shader computes nothing";
  return fmt::format("none of {} values can be kept; most often: {} [{}]", values.size(), most->dropped.message, most->dropped.code);
}

struct Exactness {
  double tolerance = 0;
  bool leave_out_unsteady = false;  // pixels (cli/check/unsteady_pixels.h)
};

class ModuleCheck {
 public:
  ModuleCheck(const CheckRequest& request, const Context& context, Commands& commands, const std::function<void()>& original_runs)
      : request_(request), original_runs_(original_runs), context_(context), commands_(commands) {
    verdict_.path = request.path;
  }

  ModuleVerdict run(const CompiledShader& fragment, const Exactness& exactness) {
    exactness_ = exactness;
    const Result<void> result = check(fragment);
    if (!result.ok()) {
      const Error& error = result.error();
      end(error.kind == ErrorKind::kRefused ? Verdict::kRefused : Verdict::kUntestable, error.code, error.message);
    }
    return verdict_;
  }

 private:
  void end(Verdict verdict, const std::string& code, const std::string& reason) {
    verdict_.verdict = verdict;
    verdict_.seed = seed_;
    verdict_.code = code;
    verdict_.reason = reason;
  }

  Result<void> check(const CompiledShader& fragment) {
    REPRISE_ASSIGN(subject_.program, harnessProgram(fragment));
    if (subject_.program.analysis.refusal) return *subject_.program.analysis.refusal;
    if (subject_.program.analysis.derivatives_read_buffers) {
      REPRISE_ASSIGN(const LaneLoads lanes, probeLanes(context_));
      limits_.rejected_lanes_load = lanes.rejected;
      limits_.device = context_.summary().name;
    }
    if (subject_.program.interface.outputs.empty())
      return Error{ErrorKind::kRefused, "output.none", "the shader has no colour output that a payload could serve", {}};
    CandidateOptions enumeration;
    enumeration.least_share = 0;
    const std::vector<Candidate> values = enumerateCandidates(*subject_.program.fragment, subject_.program.analysis, subject_.program.sources, enumeration);
    for (const Candidate& value : values)
      if (value.kept()) subject_.candidates.push_back(value);
    // Last, as their hits equal the original but for rounding, which a shader may make much of.
    std::stable_partition(subject_.candidates.begin(), subject_.candidates.end(), [](const Candidate& one) { return !isRegrouped(one); });
    if (subject_.candidates.empty()) return Error{ErrorKind::kRefused, "candidate.none", whyNone(values), {}};
    return trySeeds();
  }

  // Until the inputs mean something; a broken law ends it at once.
  Result<void> trySeeds() {
    for (int i = 0; i < kSeedsTried; ++i) {
      seed_ = request_.seed + static_cast<std::uint32_t>(i);
      REPRISE_ASSIGN(const std::string meaningless, playOriginal());
      if (!meaningless.empty()) {
        end(Verdict::kUntestable, "inputs.meaningless", fmt::format("with {} seeds from {}: {}", i + 1, request_.seed, meaningless));
        continue;
      }
      const std::size_t most = std::min(subject_.candidates.size(), std::max<std::size_t>(kCandidatesTried, static_cast<std::size_t>(request_.candidates)));
      int meaningful = 0;
      for (std::size_t c = 0; c < most && meaningful < request_.candidates; ++c) {
        ++verdict_.candidates;
        REPRISE_ASSIGN(const bool shows, checkCandidate(subject_.candidates[c]));
        if (verdict_.verdict == Verdict::kFailed) return {};
        meaningful += shows ? 1 : 0;
      }
      if (meaningful > 0) {
        end(Verdict::kVerified, "", "");
        return {};
      }
    }
    return {};
  }

  // "" or why this seed shows nothing.
  Result<std::string> playOriginal() {
    HarnessOptions options;
    options.seed = seed_;
    REPRISE_ASSIGN(Harness harness, Harness::create(context_, commands_, subject_.program.interface, options));
    harness_ = std::make_unique<Harness>(std::move(harness));
    originals_.clear();
    VariantOptions original;
    original.strategy = "original";
    REPRISE_ASSIGN(const Package package, buildPackage(subject_.program, subject_.candidates.front(), original, limits_));
    REPRISE_ASSIGN(Player player, harness_->createPlayer(package, true));
    for (int frame = 0; frame < kFrames; ++frame) {
      REPRISE_ASSIGN(HarnessFrame played, harness_->play(player, {frame, 1}));
      originals_.push_back(std::move(played));
    }
    original_runs_();
    const std::string meaningless = whyMeaningless(originals_[kFrozenShot], subject_.program.interface.outputs);
    if (!meaningless.empty() || !exactness_.leave_out_unsteady) return meaningless;
    REPRISE_ASSIGN(unsteady_, unsteadyPixels({context_, commands_, subject_.program.interface, package, options}, originals_));
    return whyMostlyUnsteady(unsteady_, originals_);
  }

  VariantOptions optionsFor(const std::string& strategy) const {
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

  // Whether what was seen says something; the verdict is untestable so far where it does not. Seen in the first strategy that takes
  // the candidate, before time is spent on the others.
  Result<bool> checkCandidate(const Candidate& candidate) {
    int held = 0;
    for (const Strategy& strategy : strategies()) {
      if (!strategy.selectable || (!request_.strategy.empty() && strategy.name != request_.strategy)) continue;
      const Result<std::vector<HarnessFrame>> frames = checkStrategy(candidate, strategy.name);
      if (verdict_.verdict == Verdict::kFailed) return false;
      if (!frames.ok()) {
        if (frames.error().kind != ErrorKind::kRefused) return frames.error();
        note(strategy.name + ": " + frames.error().code);
        last_refusal_ = frames.error();
        continue;
      }
      ++verdict_.variants;
      if (held++ > 0) continue;
      REPRISE_ASSIGN(const bool shows, showsSomething(candidate, strategy.name, *frames));
      if (!shows) return false;
    }
    return held == 0 ? Result<bool>(last_refusal_) : Result<bool>(true);
  }

  Result<bool> showsSomething(const Candidate& candidate, const std::string& strategy, const std::vector<HarnessFrame>& moving) {
    std::size_t hits = 0, misses = 0;
    for (int frame = 1; frame < kFrames; ++frame) {
      hits += countKind(moving[static_cast<std::size_t>(frame)], 1);
      misses += countKind(moving[static_cast<std::size_t>(frame)], 2);
    }
    if (hits == 0 || misses == 0) {
      end(Verdict::kUntestable, "inputs.one_sided", fmt::format("{}: {} pixels hit and {} missed", candidate.id, hits, misses));
      return false;
    }
    REPRISE_ASSIGN(const bool matters, poisonShows(candidate, strategy, moving));
    if (!matters) end(Verdict::kUntestable, "inputs.no_effect", candidate.id + ": a poisoned cache changes no pixel");
    return matters;
  }

  void note(const std::string& text) {
    if (std::find(verdict_.refused_strategies.begin(), verdict_.refused_strategies.end(), text) == verdict_.refused_strategies.end())
      verdict_.refused_strategies.push_back(text);
  }

  Result<Player> variantPlayer(const Candidate& candidate, const VariantOptions& options) {
    REPRISE_ASSIGN(const Package package, buildPackage(subject_.program, candidate, options, limits_));
    REPRISE_ASSIGN(Player player, harness_->createPlayer(package, false));
    if (!player.originalReason().empty()) return Error{ErrorKind::kRefused, "device.requirement", player.originalReason(), {}};
    return player;
  }

  // The frames under motion, all laws held; a broken one is in the verdict.
  Result<std::vector<HarnessFrame>> checkStrategy(const Candidate& candidate, const std::string& strategy) {
    REPRISE_ASSIGN(Player player, variantPlayer(candidate, optionsFor(strategy)));
    // A regrouped chain feeds the cache, and what reads it: hits, and the tail of three passes for misses too.
    const double at_hits = isRegrouped(candidate) ? std::max(exactness_.tolerance, kRegroupedTolerance) : exactness_.tolerance;
    const double at_misses = findStrategy(strategy)->keeps_raw_payload ? at_hits : exactness_.tolerance;
    std::vector<HarnessFrame> moving;
    for (int frame = 0; frame < kPeriodOneFrames; ++frame) {
      REPRISE_ASSIGN(const HarnessFrame played, harness_->play(player, {frame, 1}));
      if (broken(candidate, strategy, frame, findViolation(original(frame), played, lawOf("law.always_refresh", ExactPixels::kAll, frame, at_misses)))) return moving;
    }
    player.invalidate();
    for (int frame = 0; frame < kFrames; ++frame) {
      REPRISE_ASSIGN(HarnessFrame played, harness_->play(player, {frame, kPeriod}));
      if (broken(candidate, strategy, frame, findViolation(original(frame), played, lawOf("law.misses_exact", ExactPixels::kMisses, frame, at_misses)))) return moving;
      moving.push_back(std::move(played));
    }
    if (countKind(moving.front(), 1) > 0) {
      broken(candidate, strategy, 0, Violation{"law.books", 0, "no hit in the first frame", fmt::format("{} hits", countKind(moving.front(), 1))});
      return moving;
    }
    player.invalidate();
    for (int frame = 0; frame < kFrozenFrames; ++frame) {
      REPRISE_ASSIGN(const HarnessFrame played, harness_->play(player, {kFrozenShot, kPeriod}));
      const ColorLaw law = lawOf("law.frozen_world", ExactPixels::kAll, kFrozenShot, at_hits);
      if (broken(candidate, strategy, kFrozenShot, findViolation(original(kFrozenShot), played, law))) return moving;
    }
    return moving;
  }

  ColorLaw lawOf(const std::string& name, ExactPixels pixels, int frame, double tolerance) const {
    const auto& modes = subject_.program.fragment->module.execution_modes;
    const bool early = std::any_of(modes.begin(), modes.end(), [](const Instruction& mode) {
      return mode.opcode == spv::Op::OpExecutionMode &&
             static_cast<spv::ExecutionMode>(mode.word(1)) == spv::ExecutionMode::EarlyFragmentTests;
    });
    ColorLaw law{name, pixels, tolerance, subject_.program.interface.writes_depth};
    law.depth_tells_coverage = !(early && subject_.program.analysis.discards);
    if (!unsteady_.empty()) law.left_out = &unsteady_[static_cast<std::size_t>(frame)];
    return law;
  }

  const HarnessFrame& original(int frame) const { return originals_[static_cast<std::size_t>(frame)]; }

  bool broken(const Candidate& candidate, const std::string& strategy, int frame, const std::optional<Violation>& violation) {
    if (!violation) return false;
    const std::size_t width = HarnessOptions{}.width;
    end(Verdict::kFailed, violation->law,
        fmt::format("{} in {}, seed {}, frame {}, pixel ({}, {}): expected {}, found {}; again with: {}",
                    candidate.id, strategy, seed_, frame, violation->pixel % width, violation->pixel / width, violation->expected,
                    violation->found, repeatCommand(request_, seed_, strategy)));
    return true;
  }

  Result<bool> poisonShows(const Candidate& candidate, const std::string& strategy, const std::vector<HarnessFrame>& moving) {
    VariantOptions options = optionsFor(strategy);
    options.poisoned = true;
    Result<Player> player = variantPlayer(candidate, options);
    if (!player.ok()) return player.error();
    for (int frame = 0; frame < kFrames; ++frame) {
      REPRISE_ASSIGN(const HarnessFrame played, harness_->play(*player, {frame, kPeriod}));
      if (played.colors != moving[static_cast<std::size_t>(frame)].colors) return true;
    }
    return false;
  }

  const CheckRequest& request_;
  const std::function<void()>& original_runs_;
  const Context& context_;
  Commands& commands_;
  ModuleVerdict verdict_;
  Subject subject_;
  StateLimits limits_{true, true, true};
  std::unique_ptr<Harness> harness_;
  std::vector<HarnessFrame> originals_;
  std::uint32_t seed_ = 1;
  Exactness exactness_;
  std::vector<std::vector<bool>> unsteady_;  // by frame
  Error last_refusal_{ErrorKind::kRefused, "strategy.none", "no strategy takes this shader", {}};
};

ModuleVerdict endedBy(const CheckRequest& request, const Error& error) {
  ModuleVerdict verdict;
  verdict.path = request.path;
  verdict.verdict = error.kind == ErrorKind::kRefused ? Verdict::kRefused : Verdict::kUntestable;
  verdict.code = error.code;
  verdict.reason = error.message;
  return verdict;
}

Result<CompiledShader> changed(const CompiledShader& shader, Module (*change)(const Module&)) {
  REPRISE_ASSIGN(const Module module, readModule(shader.words));
  CompiledShader result = shader;
  result.words = writeModule(change(module));
  REPRISE_TRY(validateModule(result.words));
  return result;
}

// The same shader with its variables as values, the form that the rewrites start from.
Result<CompiledShader> withValues(const CompiledShader& shader) {
  REPRISE_ASSIGN(const Module module, readModule(shader.words));
  REPRISE_ASSIGN(const Module inlined, inlineCalls(module));
  REPRISE_ASSIGN(const Module promoted, promoteToSsa(inlined));
  CompiledShader values = shader;
  values.words = writeModule(promoted);
  return values;
}

ModuleVerdict untestable(ModuleVerdict verdict, const std::string& code, const std::string& reason) {
  verdict.verdict = Verdict::kUntestable;
  verdict.code = code;
  verdict.reason = reason;
  return verdict;
}

// Of a module whose variants differ from it by more than rounding: whether it differs from itself, so that the device is to blame.
ModuleVerdict blamed(const ModuleVerdict& failed, const ModuleVerdict& of_values) {
  if (of_values.verdict != Verdict::kVerified) return failed;
  return untestable(of_values, "device.inconsistent",
                    "the device draws the original differently once its variables are values, and then all variants equal it");
}

// A broken law says nothing where the device ended the shader's loops. Looked at last, and whatever hinders the look leaves the
// failure as it is.
ModuleVerdict unlessEndless(const ModuleVerdict& failed, const CompiledShader& fragment, const Context& context, Commands& commands) {
  if (failed.verdict != Verdict::kFailed) return failed;
  const Result<bool> endless = loopsEndlessly(fragment, failed.seed, context, commands);
  if (!endless.ok() || !*endless) return failed;
  return untestable(failed, "original.endless",
                    fmt::format("with seed {} the shader itself loops more than {} times, and the device decides what comes of that",
                                failed.seed, kEndlessIterations));
}

// Holds the laws, first bit by bit, then with the liberties that rounding takes.
Result<ModuleVerdict> checkFragment(const CheckRequest& request, const CompiledShader& fragment, const Context& context, Commands& commands,
                                    const std::function<void()>& original_runs) {
  const auto check = [&](const CompiledShader& shader, double tolerance, bool leave_out_unsteady = false) {
    return ModuleCheck(request, context, commands, original_runs).run(shader, {tolerance, leave_out_unsteady});
  };
  ModuleVerdict verdict = check(fragment, 0);
  if (verdict.verdict != Verdict::kFailed || verdict.code == "law.books") return verdict;
  // A driver may round the same expression differently in another surrounding. That is no fault of the rewrite if it is little, and if
  // it is next to nothing, or gone where the driver has no such freedom.
  REPRISE_ASSIGN(const CompiledShader strict, changed(fragment, withoutContraction));
  ModuleVerdict nearly = check(fragment, kLittleRounding);
  if (nearly.verdict == Verdict::kVerified) {
    nearly.reason = "within 1e-5; not bit for bit, as the device rounds differently";
    return nearly;
  }
  ModuleVerdict rounded = check(strict, 0);
  if (rounded.verdict == Verdict::kVerified && check(fragment, kRounding).verdict == Verdict::kVerified) {
    rounded.reason = "bit for bit with NoContraction on both sides; as given the device rounds differently";
    return rounded;
  }
  ModuleVerdict steady = check(fragment, kRounding, true);
  if (steady.verdict == Verdict::kVerified) {
    steady.reason = "within 1e-3 where the shader does not enlarge rounding errors";
    return steady;
  }
  REPRISE_ASSIGN(const CompiledShader of_values, withValues(fragment));
  return blamed(rounded.verdict == Verdict::kFailed ? rounded : verdict, check(of_values, kLittleRounding));
}

Result<ModuleVerdict> checkCompiled(const CheckRequest& request, const std::function<void()>& original_runs) {
  REPRISE_ASSIGN(const CompiledShader given, compile(request.path, compileOptionsOf(request)));
  ContextOptions options;
  options.device = request.device;
  REPRISE_ASSIGN(const Context context, Context::create(options));
  const std::string lacking = missingCapability(given.words, context);
  if (!lacking.empty())
    return Error{ErrorKind::kRefused, "device.capability", "the module needs the capability " + lacking + ", which the device lacks", {}};
  REPRISE_ASSIGN(Commands commands, Commands::create(context));
  REPRISE_ASSIGN(const CompiledShader fragment, changed(given, withDefinedValues));
  REPRISE_ASSIGN(const ModuleVerdict verdict, checkFragment(request, fragment, context, commands, original_runs));
  return unlessEndless(verdict, fragment, context, commands);
}

}  // namespace

ModuleVerdict checkModule(const CheckRequest& request, const std::function<void()>& original_runs) {
  const auto start = std::chrono::steady_clock::now();
  const Result<ModuleVerdict> checked = checkCompiled(request, original_runs);
  ModuleVerdict verdict = checked.ok() ? *checked : endedBy(request, checked.error());
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return verdict;
}

}  // namespace reprise
