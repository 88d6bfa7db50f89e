#include "compiler/source/compile.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "compiler/source/glsl.h"
#include "compiler/source/interface_names.h"
#include "compiler/source/module_limits.h"
#include "compiler/source/spirv_input.h"
#include "compiler/source/validate.h"
#include "runtime/base/file.h"

namespace reprise {
namespace {

std::string extensionOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// "a.vert", "a.vert.glsl", "a.vert.spv"; nullopt where the name does not say.
std::optional<ShaderStage> stageOfName(const std::string& name) {
  std::filesystem::path path(name);
  std::string extension = extensionOf(path);
  if (extension == ".glsl" || extension == ".hlsl" || extension == ".spv" || extension == ".spvasm")
    extension = extensionOf(path.stem());
  if (extension == ".vert" || extension == ".vs") return ShaderStage::kVertex;
  if (extension == ".frag" || extension == ".fs" || extension == ".ps") return ShaderStage::kFragment;
  return std::nullopt;
}

// Suffixes of stages that Reprise does not take.
bool isOtherStage(const std::string& extension) {
  constexpr std::string_view kOthers[] = {".comp", ".geom", ".tesc",  ".tese", ".mesh",
                                          ".task", ".rgen", ".rchit", ".rmiss"};
  return std::find(std::begin(kOthers), std::end(kOthers), extension) != std::end(kOthers);
}

// True if nothing is left but white space and comments.
bool isEmptySource(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  while (!text.empty()) {
    if (std::isspace(static_cast<unsigned char>(text.front()))) {
      text.remove_prefix(1);
    } else if (text.starts_with("//")) {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else if (text.starts_with("/*")) {
      const std::size_t end = text.find("*/", 2);
      if (end == std::string_view::npos) return false;
      text.remove_prefix(end + 2);
    } else {
      return false;
    }
  }
  return true;
}

Result<ShaderStage> stageOfGlsl(const std::string& name, const CompileOptions& options) {
  const std::optional<ShaderStage> named = stageOfName(name);
  if (isOtherStage(extensionOf(name))) {
    return Error{
        ErrorKind::kInput,
        "source.stage",
        "found a shader of another stage (" + extensionOf(name) + "); expected a vertex or fragment shader",
        {name, 0, 0}};
  }
  if (options.stage && named && *named != *options.stage) {
    return Error{ErrorKind::kInput,
                 "source.stage",
                 std::string("found a ") + nameOf(*named) + " shader by its suffix; expected a " +
                     nameOf(*options.stage) + " shader",
                 {name, 0, 0}};
  }
  if (options.stage) return *options.stage;
  if (named) return *named;
  return Error{ErrorKind::kInput,
               "source.stage",
               "the stage cannot be told from the name; call the file .vert or .frag (.vs.hlsl or .ps.hlsl), or name the stage",
               {name, 0, 0}};
}

Result<CompiledShader> compileGlsl(std::string_view text, const std::string& name,
                                   const CompileOptions& options) {
  REPRISE_ASSIGN(const ShaderStage stage, stageOfGlsl(name, options));
  Result<CompiledShader> shader = translateGlsl(text, name, stage, options);
  if (!shader) {
    if (shader.error().code != "source.syntax") return shader;
    // A file without a telling suffix may be a sound shader of the other stage.
    const ShaderStage other = stage == ShaderStage::kVertex ? ShaderStage::kFragment : ShaderStage::kVertex;
    if (stageOfName(name) || !translateGlsl(text, name, other, options)) return shader;
    Error error = eachOf(shader.error()).front();
    error.code = "source.stage";
    error.message = std::string("found a ") + nameOf(other) + " shader; expected a " + nameOf(stage) +
                    " shader, as which it does not compile: " + error.message;
    return error;
  }
  REPRISE_TRY(checkModuleLimits(shader->words));
  const Result<void> valid = validateModule(shader->words);
  if (!valid) {
    return Error{ErrorKind::kInput,
                 "source.invalid",
                 "glslang made SPIR-V that the validator rejects: " + valid.error().message,
                 {name, 0, 0}};
  }
  if (extensionOf(name) == ".hlsl") shader->words = withInterfaceNames(shader->words);
  return shader;
}

Result<CompiledShader> compileAssembly(std::string_view text, const std::string& name,
                                       const CompileOptions& options) {
  Result<std::vector<std::uint32_t>> words = assemble(text);
  if (!words) {
    Error error = words.error();
    error.code = "source.invalid";
    error.place.file = name;
    return error;
  }
  REPRISE_ASSIGN(CompiledShader shader, readSpirv(bytesOf(*words), name, options));
  shader.sources.push_back({name, std::string(text)});
  return shader;
}

}  // namespace

const char* nameOf(ShaderStage stage) {
  return stage == ShaderStage::kVertex ? "vertex" : "fragment";
}

Result<CompiledShader> compile(const std::filesystem::path& file, const CompileOptions& options) {
  REPRISE_ASSIGN(const std::string bytes, file == "-" ? readStandardInput(file, kMostSpirvBytes) : readFile(file, kMostSpirvBytes));
  const bool source = !looksLikeSpirv(bytes) && extensionOf(file) != ".spvasm";
  if (source && bytes.size() > kMostShaderBytes) return tooLarge(file, bytes.size(), kMostShaderBytes);
  return compileText(bytes, file.string(), options);
}

Result<CompiledShader> compileText(std::string_view text, const std::string& virtual_name,
                                   const CompileOptions& options) {
  if (looksLikeSpirv(text)) return readSpirv(text, virtual_name, options);
  if (isEmptySource(text)) {
    return Error{ErrorKind::kInput,
                 "source.empty",
                 "the file has no code; expected a shader with a function main",
                 {virtual_name, 0, 0}};
  }
  const std::string extension = extensionOf(virtual_name);
  if (extension == ".spv") {
    return Error{
        ErrorKind::kInput,
        "source.not_spirv",
        "the file is called .spv but does not begin with SPIR-V's magic number 0x07230203; give a SPIR-V "
        "binary, or call GLSL .vert or .frag and assembler text .spvasm",
        {virtual_name, 0, 0}};
  }
  if (extension == ".spvasm") return compileAssembly(text, virtual_name, options);
  return compileGlsl(text, virtual_name, options);
}

}  // namespace reprise
