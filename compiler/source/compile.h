// From a shader file to a SPIR-V module with names and line numbers (stage 1).
//
// GLSL is translated by glslang for Vulkan 1.1, SPIR-V 1.3, without any optimization, so that every value can
// be traced to its line (OpLine) and its name (OpName). HLSL is known by the suffix .hlsl and goes through glslang's other
// front end: bindings are those of [[vk::binding]], else register numbers, where textures start at 16, samplers at 32 and storage
// at 48, else the next free ones; SV_TargetN is location N. SPIR-V binaries are known by their magic number,
// whatever the file is called, and pass through unchanged after validation, but for this: of several entry
// points the wanted one is kept, and called main; instructions for debuggers alone are dropped (debug_instructions.h); and what has no name gets one (interface_names.h). Text of the SPIR-V assembler is
// known by the suffix .spvasm. All SPIR-V that leaves here has passed the validator.
//
// `#include "file"` and `#include <file>` work with and without GL_GOOGLE_include_directive. The quoted form
// looks beside the including file first, both look through include_dirs in order. A cycle of includes that no
// include guard ends is an error.
//
// Known limits: columns are found by looking for the reported token in its line, so they name its first
// occurrence and are 0 where glslang reports no token (an unexpected identifier is one). glslang stops at the
// first error of most kinds. OpLine has columns for functions only, and the line of a macro's use. glslang
// recurses over expressions: one of more than some 10,000 terms overflows an 8 MiB stack.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

enum class ShaderStage { kVertex, kFragment };

// "vertex", "fragment".
const char* nameOf(ShaderStage stage);

struct CompileOptions {
  // The stage wanted. Without it: .vert and .vs are vertex, .frag, .fs and .ps are fragment (also before .glsl,
  // .hlsl, .spv and .spvasm), and SPIR-V tells its own stage.
  std::optional<ShaderStage> stage;
  std::vector<std::filesystem::path> include_dirs;           // -I, in order
  std::vector<std::pair<std::string, std::string>> defines;  // -D name, value; the value may be empty
  // Of SPIR-V and HLSL; GLSL always has main. SPIR-V without a "main" gives its only entry point of the stage.
  std::string entry_point = "main";
  // -std=: "450", "450core", "310es"; overrides the #version line. Empty: as the file says, 450 if it says
  // nothing.
  std::string standard;
};

struct SourceFile {
  std::string path;
  std::string text;
};

struct CompiledShader {
  ShaderStage stage = ShaderStage::kFragment;
  std::vector<std::uint32_t> words;
  std::string main_path;  // as given
  std::vector<std::string> dependencies;  // included files by first inclusion, each once; without main_path
  std::vector<SourceFile> sources;        // main_path and the dependencies; of SPIR-V what it carries (embedded_sources.h)
};

// Reads and compiles a file; "-" is standard input. Errors, kInput where not said otherwise, with the place
// where it is known:
//   those of readFile, of kMostShaderBytes, or kMostSpirvBytes for SPIR-V
//   source.empty        no text or only white space and comments
//   source.syntax       the first error of the compiler, with the further ones as its others
//   source.include      an included file that is not there (names the directories searched) or a cycle; one that is there and
//                       cannot be read is an error of readFile at its #include
//   source.stage        the stage cannot be told, is none of the two, or is not the one wanted (says both)
//   source.standard     an unknown -std (kUsage)
//   source.define       a -D whose name is no identifier or whose value has several lines (kUsage)
//   source.not_spirv    called .spv but no SPIR-V
//   source.truncated    SPIR-V that ends in the middle of an instruction or of a word
//   source.invalid      SPIR-V that the validator rejects, or assembler text that does not assemble
//   spirv.limit         SPIR-V with more of something than module_limits.h allows
//   source.entry_point  SPIR-V without the wanted entry point (lists those that it has)
Result<CompiledShader> compile(const std::filesystem::path& file, const CompileOptions& options);

// The same for text (or the bytes of a module) in memory. virtual_name stands for the file in messages, in
// debug information, for the suffix, and for where quoted includes are looked for.
Result<CompiledShader> compileText(std::string_view text, const std::string& virtual_name,
                                   const CompileOptions& options);

}  // namespace reprise
