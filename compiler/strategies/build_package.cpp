#include "compiler/strategies/build_package.h"

#include <utility>

namespace reprise {

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
