#include "compiler/ir/optimize.h"

#include <functional>
#include <spirv-tools/optimizer.hpp>

#include "compiler/ir/private_variables.h"
#include "compiler/ir/promote_to_ssa.h"

namespace reprise {

// None of the lists of passes below merges blocks: loops whose body or condition is merged with their continue block, or that are
// one block, give wrong values on Mesa's CPU driver where neighbouring pixels leave them after different numbers of turns.

namespace {

spv_target_env environmentOf(std::uint32_t version) {
  switch ((version >> 8) & 0xff) {
    case 0:
    case 1:
    case 2: return SPV_ENV_VULKAN_1_0;
    case 3: return SPV_ENV_VULKAN_1_1;
    case 4: return SPV_ENV_VULKAN_1_1_SPIRV_1_4;
    case 5: return SPV_ENV_VULKAN_1_2;
    default: return SPV_ENV_VULKAN_1_3;
  }
}

Result<Module> runPasses(const Module& module, const std::function<void(spvtools::Optimizer&)>& registerPasses) {
  spvtools::Optimizer optimizer(environmentOf(module.version));
  std::string message;
  optimizer.SetMessageConsumer([&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
    if (level <= SPV_MSG_ERROR && message.empty()) message = text;
  });
  registerPasses(optimizer);
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  options.set_preserve_bindings(true);
  options.set_preserve_spec_constants(true);
  const std::vector<std::uint32_t> words = writeModule(module);
  std::vector<std::uint32_t> optimized;
  if (!optimizer.Run(words.data(), words.size(), &optimized, options))
    return Error{ErrorKind::kInput, "spirv.optimize", "SPIRV-Tools could not transform the module: " + message, {}};
  return readModule(optimized);
}

}  // namespace

Result<Module> unrollMarkedLoops(const Module& module) {
  return runPasses(module, [](spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateLoopUnrollPass(true));
  });
}

Result<Module> removeDeadCode(const Module& module) {
  REPRISE_ASSIGN(const Module promoted, promoteToSsa(privatesToLocals(module)));
  return runPasses(promoted, [](spvtools::Optimizer& optimizer) { optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass(true)); });
}

Result<Module> stripForShipping(const Module& module) {
  Module bare = module;
  bare.debug_sources.clear();
  for (Instruction& global : bare.globals) global.line = {};
  for (Function& function : bare.functions)
    for (Block& block : function.blocks)
      for (Instruction& instruction : block.instructions) instruction.line = {};
  return runPasses(bare, [](spvtools::Optimizer& optimizer) {
    optimizer.RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass(true))
        .RegisterPass(spvtools::CreateEliminateDeadConstantPass())
        .RegisterPass(spvtools::CreateCompactIdsPass());
  });
}

}  // namespace reprise
