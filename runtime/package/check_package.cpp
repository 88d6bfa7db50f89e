// Cross references and bounds of a package. A package may come from anywhere; the player trusts what passed here.
#include <algorithm>
#include <bit>

#include "runtime/package/package.h"

namespace reprise {
namespace {

constexpr std::size_t kMaxPasses = 16, kMaxResources = 16, kMaxAttachments = 8, kMaxReads = 8, kMaxPrevious = 16;
constexpr std::uint32_t kMaxSet = 31, kMaxBlockBytes = 65536, kFirstReadBinding = 2, kFirstPreviousBinding = 16;

Error inconsistent(const std::string& what) {
  return {ErrorKind::kInput, "package.inconsistent", "the package contradicts itself: " + what, {}};
}

bool hasResource(const Recipe& recipe, const std::string& name) {
  return std::any_of(recipe.resources.begin(), recipe.resources.end(), [&](const Resource& one) { return one.name == name; });
}

Result<void> checkModule(const Package& package, const Recipe& recipe, const std::string& name, const char* stage) {
  const auto entry = std::find_if(recipe.modules.begin(), recipe.modules.end(), [&](const ModuleEntry& one) { return one.name == name; });
  if (entry == recipe.modules.end() || package.modules.count(name) == 0) return inconsistent("there is no module '" + name + "'");
  if (entry->stage != stage) return inconsistent("module '" + name + "' is no " + stage + " module");
  return {};
}

Result<void> checkPass(const Package& package, const Recipe& recipe, const Pass& pass) {
  if (pass.kind != PassKind::kDraw) return inconsistent("pass '" + pass.name + "' is of a kind that version 1 does not play");
  REPRISE_TRY(checkModule(package, recipe, pass.vertex_module, "vertex"));
  if (!pass.fragment_module.empty()) REPRISE_TRY(checkModule(package, recipe, pass.fragment_module, "fragment"));
  if (pass.colors.size() > kMaxAttachments) return inconsistent("pass '" + pass.name + "' has too many attachments");
  for (const ColorAttachment& color : pass.colors) {
    if (color.location < 0 || color.location >= static_cast<int>(kMaxAttachments)) return inconsistent("an output location is out of range");
    const bool is_app = color.resource.empty();
    if (is_app && (color.app_target < 0 || color.app_target >= static_cast<int>(package.interface.outputs.size())))
      return inconsistent("pass '" + pass.name + "' writes an application target that the shader does not have");
    if (!is_app && !hasResource(recipe, color.resource)) return inconsistent("there is no resource '" + color.resource + "'");
  }
  if (pass.reads.size() > kMaxReads) return inconsistent("pass '" + pass.name + "' reads too many images");
  for (const Read& read : pass.reads) {
    if (!hasResource(recipe, read.resource)) return inconsistent("there is no resource '" + read.resource + "'");
    if (read.binding < kFirstReadBinding || read.binding >= kFirstPreviousBinding) return inconsistent("a read's binding is out of range");
  }
  return {};
}

Result<void> checkRecipe(const Package& package, const Recipe& recipe) {
  if (recipe.passes.empty() || recipe.passes.size() > kMaxPasses) return inconsistent("a recipe needs 1 to 16 passes");
  if (recipe.resources.size() > kMaxResources || recipe.previous_inputs.size() > kMaxPrevious)
    return inconsistent("too many resources or inputs");
  if (recipe.reprise_set > kMaxSet) return inconsistent("the descriptor set is out of range");
  if (!std::has_single_bit(recipe.block_pixels) || recipe.block_pixels < 2 || recipe.block_pixels > 1024)
    return inconsistent("the refresh block must be a power of two from 2 to 1024");
  if (recipe.period_frames != kNeverRefresh && (!std::has_single_bit(recipe.period_frames) || recipe.period_frames > 64))
    return inconsistent("the period must be 1, 2, 4, ... 64 or null");
  for (const Resource& resource : recipe.resources)
    if (!(resource.scale > 0 && resource.scale <= 1)) return inconsistent("resource '" + resource.name + "' has a scale out of (0, 1]");
  for (const PreviousInput& input : recipe.previous_inputs)
    if (input.size_bytes == 0 || input.size_bytes > kMaxBlockBytes ||
        (input.source == PreviousSource::kUniformBlock && (input.reprise_binding < kFirstPreviousBinding || input.reprise_binding > 64)))
      return inconsistent("the previous input '" + input.name + "' has a size or binding out of range");
  for (std::size_t i = 0; i < recipe.passes.size(); ++i) {
    REPRISE_TRY(checkPass(package, recipe, recipe.passes[i]));
    if (i > 0 && recipe.passes[i].rendering == recipe.passes[i - 1].rendering && recipe.passes[i].colors != recipe.passes[i - 1].colors)
      return inconsistent("passes of one rendering have different attachments");
  }
  return {};
}

}  // namespace

Result<void> checkPackage(const Package& package) {
  REPRISE_TRY(checkRecipe(package, package.original));
  return checkRecipe(package, package.variant);
}

}  // namespace reprise
