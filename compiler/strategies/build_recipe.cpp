#include "compiler/strategies/build_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "compiler/ir/optimize.h"
#include "compiler/source/validate.h"
#include "compiler/strategies/frame_macros.h"
#include "compiler/strategies/frame_source.h"
#include "compiler/strategies/kept_inputs.h"
#include "compiler/strategies/pair_passes.h"
#include "compiler/strategies/payload_bodies.h"
#include "compiler/strategies/refuse_variant.h"
#include "compiler/transforms/link_frame.h"
#include "compiler/transforms/previous_position.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr std::uint32_t kHistoryBinding = 2;
constexpr int kCountTargets = 2;

std::uint32_t firstFreeSet(const ShaderInterface& interface) {
  std::uint32_t free = 0;
  for (const Descriptor& descriptor : interface.descriptors) free = std::max(free, descriptor.set + 1);
  return free;
}

int firstFreeOutput(const ShaderInterface& interface) {
  std::uint32_t free = 0;
  for (const FragmentOutput& output : interface.outputs) free = std::max(free, output.location + 1);
  return static_cast<int>(free);
}

std::vector<int> guardsOf(const Candidate& candidate) {
  std::vector<int> guards;
  for (const CandidateValue& value : candidate.values)
    if (value.guard_channel != kNoGuard && std::find(guards.begin(), guards.end(), value.guard_channel) == guards.end())
      guards.push_back(value.guard_channel);
  return guards;
}

class RecipeBuilder {
 public:
  RecipeBuilder(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options, const Strategy& strategy)
      : program_(program), candidate_(candidate), options_(options), strategy_(strategy),
        pairs_(options.previous == PreviousImage::kOtherEye && storesOnceAPair(strategy)),
        plans_(pairs_ ? passesOfPairs(strategy) : strategy.passes), guards_(guardsOf(candidate)),
        layout_(cacheLayout(std::max(candidate.channels, 1), options.encoding, isInteger(candidate.scalar))),
        cache_location_(firstFreeOutput(program.interface)) {}

  Result<BuiltRecipe> build() {
    describeVariant();
    if (repairs(strategy_)) {
      REPRISE_ASSIGN(kept_, keptInputs(program_.fragment->module, options_.orthographic));
      kept_formats_ = keptFormats(kept_);
    }
    REPRISE_TRY(countTargets());
    declareResources();
    if (strategy_.caches) {
      REPRISE_TRY(buildVertex());
    } else {
      REPRISE_TRY(addModule("vertex", "vertex", program_.vertex_words));
    }
    for (const PassPlan& plan : plans_) REPRISE_TRY(addPass(plan));
    return std::move(built_);
  }

 private:
  Recipe& recipe() { return built_.recipe; }

  // Before any module is made: frames are written for the targets that there can be.
  Result<void> countTargets() {
    int most = 1;
    for (const PassPlan& plan : plans_) {
      Pass pass;
      attach(plan, pass);
      for (const ColorAttachment& color : pass.colors) most = std::max(most, color.location + 1);
    }
    if (static_cast<std::size_t>(most) > kMostColorTargets)
      return Error{ErrorKind::kRefused, "state.targets",
                   fmt::format("'{}' needs {} colour targets for this shader; devices have {}", strategy_.name, most, kMostColorTargets), {}};
    recipe().requirements.color_attachments = most;
    return {};
  }

  void describeVariant() {
    recipe().strategy = strategy_.name;
    recipe().pattern = options_.pattern;
    recipe().block_pixels = options_.block_pixels;
    recipe().filter = options_.filter;
    recipe().encoding = options_.encoding;
    recipe().period_frames = strategy_.caches ? options_.period_frames : 1;
    if (strategy_.caches) recipe().previous = options_.previous;
    recipe().orthographic = options_.orthographic;
    recipe().reprise_set = firstFreeSet(program_.interface);
    recipe().uses_reprise_set = strategy_.caches;
    recipe().requirements.depth_less_or_greater = strategy_.rejects_by_depth;
    recipe().requirements.stencil = strategy_.needs_stencil;
    recipe().requirements.independent_blend = options_.instrumented && strategy_.caches;
    recipe().flags = repairs(strategy_) ? MissFlagging::kTiles : flagsDraws(strategy_) ? MissFlagging::kDraws : MissFlagging::kNone;
    recipe().requirements.fragment_stores = recipe().flags != MissFlagging::kNone;
    recipe().requirements.shared_inputs = recipe().flags == MissFlagging::kTiles;
    recipe().requirements.rejected_lanes_load = needsRejectedLanes(strategy_, program_);
    recipe().requirements.conditional_rendering = recipe().flags == MissFlagging::kDraws;
    if (!strategy_.caches) return;
    recipe().requirements.linear_filter = options_.filter == Filter::kBilinear;
    recipe().constants = encodingConstants(layout_, options_.encoding, options_.filter, options_.ranges, guards_);
    for (const CandidateValue& value : candidate_.values) recipe().payload.push_back(describe(value));
  }

  PayloadValue describe(const CandidateValue& value) const {
    PayloadValue described;
    described.name = !value.name.empty() ? value.name : candidate_.values.size() == 1 ? candidate_.id : value.operation;
    described.type = value.type;
    described.file = value.place.file;
    described.line = value.place.line;
    described.column = value.place.column;
    described.channels = value.channels;
    described.first_channel = value.first_channel;
    described.guard_channel = value.guard_channel;
    for (int channel = 0; channel < value.channels; ++channel) {
      const auto from = static_cast<std::size_t>(value.first_channel + channel), to = static_cast<std::size_t>(channel);
      described.range_min[to] = options_.ranges.payload_min[from];
      described.range_max[to] = options_.ranges.payload_max[from];
    }
    described.inputs = inputNames(candidate_, program_.analysis);
    return described;
  }

  bool keepsHistory() const {
    return std::any_of(plans_.begin(), plans_.end(), [](const PassPlan& plan) { return plan.writes_cache; });
  }

  void declareResources() {
    if (keepsHistory()) {
      const Lifetime lifetime = pairs_ ? Lifetime::kPersistent : Lifetime::kHistory;
      for (std::size_t target = 0; target < targets(); ++target)
        recipe().resources.push_back({payloadTarget(target), layout_.payload_formats[target], 1, lifetime, {0, 0, 0, 0}});
      if (!layout_.depth_in_alpha) recipe().resources.push_back({kPayloadDepth, layout_.depth_format, 1, lifetime, {0, 0, 0, 0}});
      if (options_.instrumented) {
        if (ages()) recipe().resources.push_back({kKindAndAge, ResourceFormat::kRg16Sfloat, 1, fetchesAges() ? Lifetime::kHistory : Lifetime::kFrame, {0, 0, 0, 0}});
        else recipe().resources.push_back({kKind, ResourceFormat::kR8Unorm, 1, Lifetime::kFrame, {0, 0, 0, 0}});
        recipe().resources.push_back({"counts", ResourceFormat::kRgba32Sfloat, 1, Lifetime::kFrame, {0, 0, 0, 0}});
      }
    }
    for (std::size_t target = 0; target < kept_formats_.size(); ++target)
      recipe().resources.push_back({keptTarget(target), kept_formats_[target], 1, Lifetime::kFrame, {0, 0, 0, 0}});
  }

  std::size_t targets() const { return layout_.payload_formats.size(); }

  // The targets of a history: those of the payload, and its depth's.
  int cacheTargets() const { return static_cast<int>(targets()) + (layout_.depth_in_alpha ? 0 : 1); }

  bool ages() const { return options_.instrumented && options_.aged; }

  // Of pairs of eyes the second takes from the first alone, which has age 0 everywhere.
  bool fetchesAges() const { return ages() && !pairs_; }

  FrameMacros macros() const {
    FrameMacros values = frameMacros({program_, options_, layout_, built_.recipe.constants, guards_, candidate_.scalar, strategy_.keeps_raw_payload,
                                      built_.recipe.reprise_set});
    if (fetchesAges()) values["AGE_BINDING"] = std::to_string(kHistoryBinding + static_cast<std::uint32_t>(cacheTargets()));
    return values;
  }

  Result<void> addModule(const std::string& name, const std::string& stage, const std::vector<std::uint32_t>& words) {
    const std::string hash = contentHash(bytesOf(words));
    const auto existing = std::find_if(recipe().modules.begin(), recipe().modules.end(),
                                       [&](const ModuleEntry& entry) { return entry.name == name; });
    if (existing != recipe().modules.end()) return {};
    const Result<void> valid = validateModule(words);
    if (!valid.ok())
      return Error{ErrorKind::kRefused, "rewrite.invalid",
                   "the rewritten module '" + name + "' is not valid SPIR-V (" + valid.error().message +
                       "); please report this shader", {}};
    recipe().modules.push_back({name, stage, hash});
    built_.modules[name] = words;
    return {};
  }

  Result<void> addRewritten(const std::string& name, const std::string& stage, const Module& module) {
    REPRISE_ASSIGN(const Module stripped, stripForShipping(module));
    return addModule(name, stage, writeModule(stripped));
  }

  Result<void> buildVertex() {
    const Module frame = compileFrame("previous_position.vert", ShaderStage::kVertex, macros());
    REPRISE_ASSIGN(const PreviousPosition previous,
                   addPreviousPosition(program_.vertex, {recipe().reprise_set,
                                                         firstFreeVarying(program_.vertex, program_.fragment->module), &frame}));
    recipe().previous_inputs = previous.inputs;
    return addRewritten("vertex", "vertex", previous.module);
  }

  Result<void> buildFragment(const PassPlan& plan, const std::string& name) {
    Bodies wanted = plan.bodies;
    wanted.wants = plan.reads_history && !guards_.empty();
    REPRISE_ASSIGN(PayloadBodies bodies, makeBodies(*program_.fragment, candidate_.values, wanted));
    // A pass that discards what another draws must not have written its depth by then. The shader itself does not mind: it
    // neither discards nor writes depth.
    if (strategy_.passes.size() > 1) std::erase_if(bodies.module.execution_modes, isEarlyTests);
    const Module frame = compileFrame(plan.frame, ShaderStage::kFragment, macrosOf(plan));
    FrameBindings bindings;
    if (plan.bodies.hit) bindings.functions["reprise_hit"] = bodies.hit;
    if (plan.bodies.miss) bindings.functions["reprise_miss"] = bodies.miss;
    if (wanted.wants) bindings.functions["reprise_wants"] = bodies.wants;
    bindings.variables = {{"reprise_payload", bodies.payload_variable}};
    if (wanted.wants) bindings.variables["reprise_wanted"] = bodies.wanted_variable;
    if (plan.keeps_inputs) bindGivenInputs(kept_, bodies.module, bindings);
    if (plan.kind == PassKind::kTiles) bindTakenInputs(kept_, bodies.module, bindings);
    return addRewritten(name, "fragment", linkFrame(bodies.module, frame, bindings));
  }

  // Outputs in order: the application's, the history's, the counts, what is kept.
  FrameMacros macrosOf(const PassPlan& plan) const {
    FrameMacros values = macros();
    int location = plan.app_targets ? cache_location_ : 0;
    values["CACHE_LOCATION"] = std::to_string(location);
    values["STORES"] = plan.writes_cache ? "1" : "0";
    if (plan.writes_cache) location += cacheTargets();
    values["COUNT_LOCATION"] = std::to_string(location);
    if (plan.counts && options_.instrumented) location += kCountTargets;
    values["KEPT_LOCATION"] = std::to_string(location);
    if (plan.flags_draws) values["FLAGS_DRAWS"] = "1";
    if (plan.kind == PassKind::kTiles) values["FRAG_COORD"] = "reprise_frag_coord";
    if (repairs(strategy_))
      for (const auto& [macro, text] : keptMacros(kept_)) values[macro] = text;
    return values;
  }

  Result<void> chooseFragment(const PassPlan& plan, Pass& pass) {
    if (plan.source == FragmentSource::kNone || (plan.only_if_discards && !decidesDepth(program_))) {
      // The original's prepass needs its fragment code too where that decides which fragments there are.
      if (plan.source == FragmentSource::kNone && decidesDepth(program_))
        return Error{ErrorKind::kRefused, "state.prepass_discards",
                     "a depth prepass of this shader would have to run it, as it discards or writes depth", {}};
      return {};
    }
    if (plan.source == FragmentSource::kOriginal) {
      pass.fragment_module = "fragment";
      return addModule("fragment", "fragment", program_.fragment_words);
    }
    pass.fragment_module = "fragment_" + plan.name;
    return buildFragment(plan, pass.fragment_module);
  }

  void attach(const PassPlan& plan, Pass& pass) const {
    if (plan.app_targets)
      for (std::size_t i = 0; i < program_.interface.outputs.size(); ++i)
        pass.colors.push_back({static_cast<int>(i), "", LoadOp::kClear, BlendKind::kReplace,
                               static_cast<int>(program_.interface.outputs[i].location)});
    int location = plan.app_targets ? cache_location_ : 0;
    LoadOp load = completesEarlierRendering(plan) ? LoadOp::kLoad : LoadOp::kClear;
    const auto add = [&](const std::string& resource, BlendKind blend) { pass.colors.push_back({-1, resource, load, blend, location++}); };
    if (plan.writes_cache) {
      for (std::size_t target = 0; target < targets(); ++target) add(payloadTarget(target), BlendKind::kReplace);
      if (!layout_.depth_in_alpha) add(kPayloadDepth, BlendKind::kReplace);
    }
    if (plan.counts && keepsHistory() && options_.instrumented) {
      add(ages() ? kKindAndAge : kKind, BlendKind::kReplace);
      add("counts", BlendKind::kAdd);
    }
    // What is kept of a pixel without a miss does not matter, but for the word that says so.
    if (plan.keeps_inputs)
      for (std::size_t target = 0; target < kept_formats_.size(); ++target) {
        load = target == 0 ? LoadOp::kClear : LoadOp::kDontCare;
        add(keptTarget(target), BlendKind::kReplace);
      }
  }

  // Whether the history that the pass writes, or what it counts, has been begun by another rendering of its frame.
  bool completesEarlierRendering(const PassPlan& plan) const {
    return std::any_of(plans_.begin(), plans_.end(), [&](const PassPlan& earlier) {
      return earlier.rendering < plan.rendering && earlier.counts && earlier.frames == plan.frames;
    });
  }

  Result<void> addPass(const PassPlan& plan) {
    Pass pass;
    pass.name = plan.name;
    pass.rendering = plan.rendering;
    pass.kind = plan.kind;
    pass.vertex_module = "vertex";
    if (plan.kind == PassKind::kTiles) {
      pass.vertex_module = "vertex_tiles";
      REPRISE_TRY(addRewritten("vertex_tiles", "vertex", compileFrame("tiles.vert", ShaderStage::kVertex, macros())));
    }
    pass.depth_clear = plan.depth_clear;
    pass.depth = plan.depth;
    pass.stencil = plan.stencil;
    // Without history nothing can hit; what a later pass is told of misses it is told in all frames.
    const bool only_hits = plan.reads_history && plan.bodies.hit && !plan.bodies.miss && !plan.keeps_inputs && !plan.flags_draws;
    pass.frames = only_hits ? PassFrames::kNotWhollyDue : plan.frames;
    pass.objects = plan.objects;
    REPRISE_TRY(chooseFragment(plan, pass));
    attach(plan, pass);
    const auto read = [&](const std::string& resource, Filter filter) {
      const auto binding = kHistoryBinding + static_cast<std::uint32_t>(pass.reads.size());
      pass.reads.push_back({resource, binding, filter, plan.reads_current});
    };
    if (plan.reads_history || plan.reads_current)
      for (std::size_t target = 0; target < targets(); ++target)
        read(payloadTarget(target), plan.reads_current ? Filter::kNearest : options_.filter);
    if (plan.reads_history && !layout_.depth_in_alpha) read(kPayloadDepth, options_.filter);
    if (plan.reads_history && fetchesAges()) read(kKindAndAge, Filter::kNearest);
    if (plan.kind == PassKind::kTiles)
      for (std::size_t target = 0; target < kept_formats_.size(); ++target)
        pass.reads.push_back({keptTarget(target), kHistoryBinding + static_cast<std::uint32_t>(target), Filter::kNearest, true});
    recipe().passes.push_back(std::move(pass));
    return {};
  }

  const ShaderProgram& program_;
  const Candidate& candidate_;
  const VariantOptions& options_;
  const Strategy& strategy_;
  bool pairs_ = false;
  std::vector<PassPlan> plans_;
  std::vector<int> guards_;  // channels
  CacheLayout layout_;
  KeptInputs kept_;  // of strategies that repair
  std::vector<ResourceFormat> kept_formats_;
  int cache_location_ = 1;
  BuiltRecipe built_;
};

}  // namespace

Result<BuiltRecipe> buildRecipe(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                                const StateLimits& limits) {
  const Strategy* strategy = findStrategy(options.strategy);
  if (strategy == nullptr)
    return Error{ErrorKind::kInput, "strategy.unknown", "there is no strategy '" + options.strategy + "'", {}};
  REPRISE_CHECK(std::has_single_bit(options.block_pixels) && options.block_pixels >= 2, options.block_pixels);
  if (auto refusal = refuseVariant(program, candidate, options, limits)) return *refusal;
  return RecipeBuilder(program, candidate, options, *strategy).build();
}

}  // namespace reprise
