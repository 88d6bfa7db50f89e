#include "compiler/strategies/build_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "compiler/ir/optimize.h"
#include "compiler/source/validate.h"
#include "compiler/strategies/frame_source.h"
#include "compiler/strategies/payload_bodies.h"
#include "compiler/transforms/link_frame.h"
#include "compiler/transforms/previous_position.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"

namespace reprise {
namespace {

constexpr const char* kCache = "cache";
constexpr const char* kCacheDepth = "cache_depth";
constexpr std::uint32_t kHistoryBinding = 2;

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

// Nine digits give every float back.
std::string vec4Text(const float (&values)[4]) {
  return fmt::format("vec4({:#.9g}, {:#.9g}, {:#.9g}, {:#.9g})", values[0], values[1], values[2], values[3]);
}

class RecipeBuilder {
 public:
  RecipeBuilder(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options, const Strategy& strategy)
      : program_(program), candidate_(candidate), options_(options), strategy_(strategy),
        layout_(cacheLayout(std::max(candidate.channels, 1), options.encoding, isInteger(candidate.scalar))),
        cache_location_(firstFreeOutput(program.interface)) {}

  Result<BuiltRecipe> build() {
    describeVariant();
    declareResources();
    if (strategy_.caches) {
      REPRISE_TRY(buildVertex());
    } else {
      REPRISE_TRY(addModule("vertex", "vertex", program_.vertex_words));
    }
    for (const PassPlan& plan : strategy_.passes) REPRISE_TRY(addPass(plan));
    if (static_cast<std::size_t>(attachments_) > kMostColorTargets)
      return Error{ErrorKind::kRefused, "state.targets",
                   fmt::format("'{}' needs {} colour targets for this shader; devices have {}", strategy_.name, attachments_, kMostColorTargets), {}};
    recipe().requirements.color_attachments = attachments_;
    return std::move(built_);
  }

 private:
  Recipe& recipe() { return built_.recipe; }

  void describeVariant() {
    recipe().strategy = strategy_.name;
    recipe().pattern = options_.pattern;
    recipe().block_pixels = options_.block_pixels;
    recipe().filter = options_.filter;
    recipe().encoding = options_.encoding;
    recipe().period_frames = strategy_.caches ? options_.period_frames : 1;
    recipe().orthographic = options_.orthographic;
    recipe().reprise_set = firstFreeSet(program_.interface);
    recipe().uses_reprise_set = strategy_.caches;
    recipe().requirements.depth_less_or_greater = strategy_.rejects_by_depth;
    recipe().requirements.stencil = strategy_.needs_stencil;
    recipe().requirements.independent_blend = options_.instrumented && strategy_.caches;
    if (!strategy_.caches) return;
    recipe().requirements.linear_filter = options_.filter == Filter::kBilinear;
    recipe().constants = encodingConstants(layout_, options_.encoding, options_.filter, options_.ranges);
    PayloadValue value{candidate_.name.empty() ? candidate_.id : candidate_.name, candidate_.type, candidate_.place.file,
                       candidate_.place.line, candidate_.place.column, candidate_.channels, options_.ranges.payload_min,
                       options_.ranges.payload_max, inputNames(candidate_, program_.analysis)};
    recipe().payload = {std::move(value)};
  }

  bool keepsHistory() const {
    return std::any_of(strategy_.passes.begin(), strategy_.passes.end(), [](const PassPlan& plan) { return plan.writes_cache; });
  }

  void declareResources() {
    if (keepsHistory()) {
      recipe().resources.push_back({kCache, layout_.payload_format, 1, Lifetime::kHistory, {0, 0, 0, 0}});
      if (!layout_.depth_in_alpha) recipe().resources.push_back({kCacheDepth, layout_.depth_format, 1, Lifetime::kHistory, {0, 0, 0, 0}});
      if (options_.instrumented) {
        recipe().resources.push_back({"kind", ResourceFormat::kR8Unorm, 1, Lifetime::kFrame, {0, 0, 0, 0}});
        recipe().resources.push_back({"counts", ResourceFormat::kRgba32Sfloat, 1, Lifetime::kFrame, {0, 0, 0, 0}});
      }
    }
  }

  using Macros = std::map<std::string, std::string>;

  Macros macros() const {
    const CacheConstants& constants = built_.recipe.constants;
    const auto flag = [](bool set) { return std::string(set ? "1" : "0"); };
    const auto number = [](auto value) { return std::to_string(value); };
    return {{"REPRISE_SET", number(firstFreeSet(program_.interface))},
            {"PREVIOUS_LOCATION", number(firstFreeVarying(program_.vertex, program_.fragment->module))},
            {"CACHE_LOCATION", "0"},
            {"COUNT_LOCATION", "0"},
            {"CHANNELS", number(candidate_.channels)},
            {"PAYLOAD_VEC", layout_.integer ? "uvec4" : "vec4"},
            {"PAYLOAD_SAMPLER", layout_.integer ? "usampler2D" : "sampler2D"},
            {"INTEGER", flag(layout_.integer)},
            {"SIGNED", flag(candidate_.scalar == PayloadScalar::kInt)},
            {"NARROW", flag(layout_.narrow)},
            {"DEPTH_IN_ALPHA", flag(layout_.depth_in_alpha)},
            {"AFFINE", flag(layout_.affine)},
            {"KEEP_RAW", flag(strategy_.keeps_raw_payload)},
            {"QUAD_UNIFORM", flag(program_.analysis.takes_derivatives)},
            {"ORTHOGRAPHIC", flag(options_.orthographic)},
            {"BILINEAR", flag(options_.filter == Filter::kBilinear)},
            {"INSTRUMENTED", flag(options_.instrumented)},
            {"POISONED", flag(options_.poisoned)},
            {"BLOCK_SHIFT", number(std::countr_zero(options_.block_pixels))},
            {"PATTERN_TILED", "0"},
            {"PATTERN_RANDOM", "1"},
            {"PATTERN_INTERLEAVED", "2"},
            {"PATTERN", number(options_.pattern == PatternKind::kTiled ? 0 : options_.pattern == PatternKind::kRandom ? 1 : 2)},
            {"DEPTH_RANGE", vec4Text(constants.depth_range)},
            {"TOLERANCE", vec4Text(constants.tolerance)},
            {"PAYLOAD_SCALE", vec4Text(constants.payload_scale)},
            {"PAYLOAD_OFFSET", vec4Text(constants.payload_offset)},
            {"PAYLOAD_RANGE", vec4Text(constants.payload_range)}};
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
    REPRISE_ASSIGN(const PayloadBodies bodies, makeBodies(*program_.fragment, candidate_.value, plan.bodies));
    Macros values = macros();
    const int cache_location = plan.app_targets ? cache_location_ : 0;
    values["CACHE_LOCATION"] = std::to_string(cache_location);
    values["COUNT_LOCATION"] = std::to_string(cache_location + (layout_.depth_in_alpha ? 1 : 2));
    const Module frame = compileFrame(plan.frame, ShaderStage::kFragment, values);
    FrameBindings bindings;
    if (plan.bodies.hit) bindings.functions["reprise_hit"] = bodies.hit;
    if (plan.bodies.miss) bindings.functions["reprise_miss"] = bodies.miss;
    bindings.variables = {{"reprise_payload", bodies.payload_variable}, {"reprise_payload_valid", bodies.valid_variable}};
    return addRewritten(name, "fragment", linkFrame(bodies.module, frame, bindings));
  }

  bool decidesDepth() const { return program_.analysis.discards || program_.interface.writes_depth; }

  Result<void> chooseFragment(const PassPlan& plan, Pass& pass) {
    if (plan.source == FragmentSource::kNone || (plan.only_if_discards && !decidesDepth())) {
      // The original's prepass needs its fragment code too where that decides which fragments there are.
      if (plan.source == FragmentSource::kNone && decidesDepth())
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

  void attach(const PassPlan& plan, Pass& pass) {
    if (plan.app_targets)
      for (std::size_t i = 0; i < program_.interface.outputs.size(); ++i)
        pass.colors.push_back({static_cast<int>(i), "", LoadOp::kClear, BlendKind::kReplace,
                               static_cast<int>(program_.interface.outputs[i].location)});
    if (plan.writes_cache) {
      int location = plan.app_targets ? cache_location_ : 0;
      const auto add = [&](const char* resource, BlendKind blend) {
        pass.colors.push_back({-1, resource, LoadOp::kClear, blend, location++});
      };
      add(kCache, BlendKind::kReplace);
      if (!layout_.depth_in_alpha) add(kCacheDepth, BlendKind::kReplace);
      if (options_.instrumented) {
        add("kind", BlendKind::kReplace);
        add("counts", BlendKind::kAdd);
      }
    }
    int used = 0;
    for (const ColorAttachment& color : pass.colors) used = std::max(used, color.location + 1);
    attachments_ = std::max(attachments_, used);
  }

  Result<void> addPass(const PassPlan& plan) {
    Pass pass;
    pass.name = plan.name;
    pass.rendering = plan.rendering;
    pass.vertex_module = "vertex";
    pass.depth_clear = plan.depth_clear;
    pass.depth = plan.depth;
    pass.stencil = plan.stencil;
    REPRISE_TRY(chooseFragment(plan, pass));
    attach(plan, pass);
    if (plan.reads_history) {
      pass.reads.push_back({kCache, kHistoryBinding, options_.filter, false});
      if (!layout_.depth_in_alpha) pass.reads.push_back({kCacheDepth, kHistoryBinding + 1, options_.filter, false});
    }
    if (plan.reads_current) pass.reads.push_back({kCache, kHistoryBinding, Filter::kNearest, true});
    recipe().passes.push_back(std::move(pass));
    return {};
  }

  const ShaderProgram& program_;
  const Candidate& candidate_;
  const VariantOptions& options_;
  const Strategy& strategy_;
  CacheLayout layout_;
  int cache_location_ = 1;
  int attachments_ = 1;
  BuiltRecipe built_;
};

}  // namespace

Result<BuiltRecipe> buildRecipe(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                                const StateLimits& limits) {
  const Strategy* strategy = findStrategy(options.strategy);
  if (strategy == nullptr)
    return Error{ErrorKind::kInput, "strategy.unknown", "there is no strategy '" + options.strategy + "'", {}};
  REPRISE_CHECK(std::has_single_bit(options.block_pixels) && options.block_pixels >= 2, options.block_pixels);
  if (strategy->caches && program.analysis.refusal) return *program.analysis.refusal;
  if (strategy->rejects_by_depth && !limits.strict_depth_with_writes)
    return Error{ErrorKind::kRefused, "state.depth_compare",
                 "'" + strategy->name + "' tells hits from misses by depth and needs a LESS or GREATER test with writes", {}};
  if (strategy->needs_stencil && !limits.stencil)
    return Error{ErrorKind::kRefused, "state.no_stencil", "'" + strategy->name + "' needs a depth target with stencil", {}};
  if (strategy->caches && isInteger(candidate.scalar) && options.filter != Filter::kNearest)
    return Error{ErrorKind::kRefused, "filter.integer",
                 "'" + candidate.id + "' is of type " + candidate.type +
                     ", which is kept bit by bit and cannot be interpolated; fetch it with the nearest filter", {}};
  return RecipeBuilder(program, candidate, options, *strategy).build();
}

Result<Package> buildPackage(const ShaderProgram& program, const Candidate& candidate, const VariantOptions& options,
                             const StateLimits& limits) {
  VariantOptions original_options = options;
  original_options.strategy = "original";
  original_options.instrumented = false;
  REPRISE_ASSIGN(BuiltRecipe original, buildRecipe(program, candidate, original_options, limits));
  REPRISE_ASSIGN(BuiltRecipe variant, buildRecipe(program, candidate, options, limits));
  Package package;
  package.interface = program.interface;
  package.original = std::move(original.recipe);
  package.variant = std::move(variant.recipe);
  package.modules = std::move(original.modules);
  // Both have a module "vertex"; the original's is kept under a name of its own.
  const auto rename = [](Recipe& recipe, std::map<std::string, std::vector<std::uint32_t>>& modules) {
    const auto node = modules.extract("vertex");
    modules["original_vertex"] = node.mapped();
    for (ModuleEntry& entry : recipe.modules)
      if (entry.name == "vertex") entry.name = "original_vertex";
    for (Pass& pass : recipe.passes) pass.vertex_module = "original_vertex";
  };
  rename(package.original, package.modules);
  if (!package.variant.uses_reprise_set) rename(package.variant, variant.modules);
  package.modules.merge(variant.modules);
  return package;
}

}  // namespace reprise
