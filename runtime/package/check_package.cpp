// Cross references and bounds of a package. A package may come from anywhere; the player trusts what passed here.
#include <algorithm>
#include <bit>
#include <set>

#include "runtime/package/package.h"

namespace reprise {
namespace {

constexpr std::size_t kMaxPasses = 16, kMaxResources = 16, kMaxReads = 8, kMaxPrevious = 16;
constexpr std::uint32_t kMaxSet = 31, kMaxBlockBytes = 65536, kFirstReadBinding = 2, kFirstPreviousBinding = 16,
                        kMaxPreviousBinding = 64;

Error inconsistent(const std::string& what) {
  return {ErrorKind::kInput, "package.inconsistent", "the package contradicts itself: " + what, {}};
}

const Resource* findResource(const Recipe& recipe, const std::string& name) {
  const auto found =
      std::find_if(recipe.resources.begin(), recipe.resources.end(), [&](const Resource& one) { return one.name == name; });
  return found == recipe.resources.end() ? nullptr : &*found;
}

Result<void> checkModule(const Package& package, const Recipe& recipe, const std::string& name, const char* stage) {
  const auto entry = std::find_if(recipe.modules.begin(), recipe.modules.end(), [&](const ModuleEntry& one) { return one.name == name; });
  if (entry == recipe.modules.end() || package.modules.count(name) == 0) return inconsistent("there is no module '" + name + "'");
  if (entry->stage != stage) return inconsistent("module '" + name + "' is no " + stage + " module");
  return {};
}

Result<void> checkColors(const Package& package, const Recipe& recipe, const Pass& pass) {
  if (pass.colors.size() > kMostColorTargets) return inconsistent("pass '" + pass.name + "' has too many attachments");
  std::set<int> locations;
  std::set<std::string> targets;
  for (const ColorAttachment& color : pass.colors) {
    if (color.location < 0 || color.location >= static_cast<int>(kMostColorTargets)) return inconsistent("an output location is out of range");
    const bool is_app = color.resource.empty();
    if (is_app && (color.app_target < 0 || color.app_target >= static_cast<int>(package.interface.outputs.size())))
      return inconsistent("pass '" + pass.name + "' writes an application target that the shader does not have");
    const Resource* resource = findResource(recipe, color.resource);
    if (!is_app && resource == nullptr) return inconsistent("there is no resource '" + color.resource + "'");
    if (!is_app && resource->scale != 1)
      return inconsistent("pass '" + pass.name + "' writes '" + color.resource + "', whose size is not the target's");
    const bool is_new = locations.insert(color.location).second &&
                        targets.insert(is_app ? " " + std::to_string(color.app_target) : color.resource).second;
    if (!is_new) return inconsistent("pass '" + pass.name + "' attaches something twice");
  }
  return {};
}

// `written`: resources that earlier renderings of the frame have written.
Result<void> checkReads(const Recipe& recipe, const Pass& pass, const std::set<std::string>& written) {
  if (pass.reads.size() > kMaxReads) return inconsistent("pass '" + pass.name + "' reads too many images");
  if (!pass.reads.empty() && !recipe.uses_reprise_set) return inconsistent("pass '" + pass.name + "' reads without a descriptor set");
  std::set<std::uint32_t> bindings;
  for (const Read& read : pass.reads) {
    const Resource* resource = findResource(recipe, read.resource);
    if (resource == nullptr) return inconsistent("there is no resource '" + read.resource + "'");
    if (isUint(resource->format) && read.filter != Filter::kNearest)
      return inconsistent("pass '" + pass.name + "' filters the integers of '" + read.resource + "'");
    if (read.binding < kFirstReadBinding || read.binding >= kFlagsBinding) return inconsistent("a read's binding is out of range");
    if (!bindings.insert(read.binding).second) return inconsistent("pass '" + pass.name + "' reads two images at one binding");
    const bool this_frame = read.current || resource->lifetime == Lifetime::kFrame;
    if (this_frame && written.count(read.resource) == 0)
      return inconsistent("pass '" + pass.name + "' reads '" + read.resource + "' before a rendering has written it");
    const bool attached = std::any_of(pass.colors.begin(), pass.colors.end(),
                                      [&](const ColorAttachment& color) { return color.resource == read.resource; });
    if (attached && (read.current || resource->lifetime != Lifetime::kHistory))
      return inconsistent("pass '" + pass.name + "' reads '" + read.resource + "' while writing it");
  }
  return {};
}

Result<void> checkPass(const Package& package, const Recipe& recipe, const Pass& pass) {
  if (pass.kind != PassKind::kDraw && pass.kind != PassKind::kTiles)
    return inconsistent("pass '" + pass.name + "' is of a kind that this version does not play");
  if (pass.kind == PassKind::kTiles && (recipe.flags != MissFlagging::kTiles || !recipe.requirements.shared_inputs))
    return inconsistent("pass '" + pass.name + "' draws tiles, which the recipe does not flag or whose inputs it does not require to be shared");
  if (pass.objects == PassObjects::kFlagged && (pass.kind != PassKind::kDraw || recipe.flags != MissFlagging::kDraws || !recipe.requirements.conditional_rendering))
    return inconsistent("pass '" + pass.name + "' draws flagged objects, which the recipe does not flag or without requiring conditional rendering");
  if (pass.stencil != StencilUse::kNone && !recipe.requirements.stencil)
    return inconsistent("pass '" + pass.name + "' uses the stencil, which the recipe does not require");
  REPRISE_TRY(checkModule(package, recipe, pass.vertex_module, "vertex"));
  if (!pass.fragment_module.empty()) REPRISE_TRY(checkModule(package, recipe, pass.fragment_module, "fragment"));
  return checkColors(package, recipe, pass);
}

bool begins(const Recipe& recipe, std::size_t pass) { return pass == 0 || recipe.passes[pass].rendering != recipe.passes[pass - 1].rendering; }

// What a frame of one kind draws, and whether what it reads has been written by then.
Result<void> checkFrameKind(const Recipe& recipe, bool wholly_due) {
  std::set<std::string> written, attached;
  bool draws = false, drawn = false;
  for (std::size_t i = 0; i < recipe.passes.size(); ++i) {
    const Pass& pass = recipe.passes[i];
    if (begins(recipe, i)) {
      written.merge(attached);
      attached.clear();
      drawn = draws;
    }
    if (!drawsIn(pass, wholly_due)) continue;
    draws = true;
    REPRISE_TRY(checkReads(recipe, pass, written));
    // Flags are made visible between renderings, and what the tiles read is what a draw has bound.
    if ((pass.kind == PassKind::kTiles || pass.objects == PassObjects::kFlagged) && !drawn)
      return inconsistent("pass '" + pass.name + "' draws what is flagged before a rendering has flagged anything");
    for (const ColorAttachment& color : pass.colors)
      if (!color.resource.empty()) attached.insert(color.resource);
  }
  if (!draws) return inconsistent(std::string("no pass draws in frames that are ") + (wholly_due ? "wholly due" : "not wholly due"));
  return {};
}

Result<void> checkPasses(const Package& package, const Recipe& recipe) {
  if (recipe.passes.empty() || recipe.passes.size() > kMaxPasses) return inconsistent("a recipe needs 1 to 16 passes");
  std::set<int> renderings;
  for (std::size_t i = 0; i < recipe.passes.size(); ++i) {
    const Pass& pass = recipe.passes[i];
    REPRISE_TRY(checkPass(package, recipe, pass));
    if (begins(recipe, i)) {
      if (!renderings.insert(pass.rendering).second) return inconsistent("the passes of a rendering are not consecutive");
    } else if (pass.colors != recipe.passes[i - 1].colors) {
      return inconsistent("passes of one rendering have different attachments");
    } else if (pass.kind == PassKind::kTiles || recipe.passes[i - 1].kind == PassKind::kTiles) {
      return inconsistent("pass '" + pass.name + "' shares a rendering with others, which tiles may not");
    } else if (pass.objects != recipe.passes[i - 1].objects) {
      return inconsistent("pass '" + pass.name + "' draws flagged objects in a rendering that may flag them");
    }
  }
  REPRISE_TRY(checkFrameKind(recipe, true));
  return checkFrameKind(recipe, false);
}

Result<void> checkPreviousInputs(const Recipe& recipe) {
  if (recipe.previous_inputs.size() > kMaxPrevious) return inconsistent("too many previous inputs");
  std::set<std::uint32_t> bindings;
  int push_constants = 0;
  for (const PreviousInput& input : recipe.previous_inputs) {
    const bool is_block = input.source == PreviousSource::kUniformBlock;
    if (input.size_bytes == 0 || input.size_bytes > kMaxBlockBytes ||
        (is_block && (input.reprise_binding < kFirstPreviousBinding || input.reprise_binding > kMaxPreviousBinding)))
      return inconsistent("the previous input '" + input.name + "' has a size or binding out of range");
    if (is_block ? !bindings.insert(input.reprise_binding).second : ++push_constants > 1)
      return inconsistent("the previous input '" + input.name + "' lies where another one does");
  }
  return {};
}

Result<void> checkRecipe(const Package& package, const Recipe& recipe) {
  if (recipe.resources.size() > kMaxResources || recipe.modules.size() > kMostModules)
    return inconsistent("too many resources or modules");
  if (recipe.flags != MissFlagging::kNone && (!recipe.uses_reprise_set || !recipe.requirements.fragment_stores))
    return inconsistent("misses are flagged without a descriptor set or without requiring stores of fragments");
  if (recipe.reprise_set > kMaxSet) return inconsistent("the descriptor set is out of range");
  if (!std::has_single_bit(recipe.block_pixels) || recipe.block_pixels < 2 || recipe.block_pixels > 1024)
    return inconsistent("the refresh block must be a power of two from 2 to 1024");
  if (recipe.period_frames != kNeverRefresh && (!std::has_single_bit(recipe.period_frames) || recipe.period_frames > 64))
    return inconsistent("the period must be 1, 2, 4, ... 64 or null");
  if (recipe.previous == PreviousImage::kOtherEye && (recipe.pattern != PatternKind::kWhole || recipe.period_frames != 2))
    return inconsistent("the other eye can be the previous image with the pattern whole and the period 2 only");
  std::set<std::string> names;
  for (const Resource& resource : recipe.resources) {
    if (!(resource.scale > 0 && resource.scale <= 1)) return inconsistent("resource '" + resource.name + "' has a scale out of (0, 1]");
    if (resource.name.empty() || !names.insert(resource.name).second) return inconsistent("the name '" + resource.name + "' stands for no one resource");
  }
  REPRISE_TRY(checkPreviousInputs(recipe));
  return checkPasses(package, recipe);
}

}  // namespace

Result<void> checkPackage(const Package& package) {
  REPRISE_TRY(checkRecipe(package, package.original));
  return checkRecipe(package, package.variant);
}

}  // namespace reprise
