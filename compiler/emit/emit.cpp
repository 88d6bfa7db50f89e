#include "compiler/emit/emit.h"

#include <exception>
#include <spirv_cross/spirv_glsl.hpp>

#include "compiler/source/validate.h"

namespace reprise {

Result<std::string> readableGlsl(std::span<const std::uint32_t> words) {
  // SPIRV-Cross trusts its input.
  REPRISE_TRY(validateModule(words));
  try {
    spirv_cross::CompilerGLSL compiler(words.data(), words.size());
    spirv_cross::CompilerGLSL::Options options = compiler.get_common_options();
    options.version = 450;
    options.es = false;
    options.vulkan_semantics = true;
    compiler.set_common_options(options);
    return compiler.compile();
  } catch (const std::exception& thrown) {
    return Error{ErrorKind::kInput,
                 "emit.unreadable",
                 std::string("the module cannot be written as GLSL: ") + thrown.what(),
                 {}};
  }
}

Result<void> writePackage(const Package& package, const std::filesystem::path& directory) {
  Package complete = package;
  complete.readable.clear();
  for (const auto& [name, words] : package.modules) {
    const Result<std::string> text = readableGlsl(words);
    complete.readable[name] = text ? *text : "// No GLSL for this module: " + text.error().message + "\n";
  }
  return writePackageFiles(complete, directory);
}

}  // namespace reprise
