#include "compiler/source/glsl.h"

#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <spirv-tools/optimizer.hpp>

#include "compiler/source/glslang_log.h"
#include "compiler/source/include_resolver.h"
#include "compiler/source/validate.h"

namespace reprise {
namespace {

// glslang keeps its tables of built-in functions between compilations once it is initialized.
class GlslangProcess {
 public:
  GlslangProcess() { REPRISE_CHECK(glslang::InitializeProcess(), "glslang::InitializeProcess"); }
  ~GlslangProcess() { glslang::FinalizeProcess(); }
  GlslangProcess(const GlslangProcess&) = delete;
  GlslangProcess& operator=(const GlslangProcess&) = delete;
};

void initializeOnce() {
  static const GlslangProcess process;
}

class Includer : public glslang::TShader::Includer {
 public:
  explicit Includer(IncludeResolver& resolver) : resolver_(resolver) {}

  IncludeResult* includeLocal(const char* name, const char* includer, std::size_t /*depth*/) override {
    return handOver(resolver_.openBeside(name, includer));
  }
  IncludeResult* includeSystem(const char* name, const char* includer, std::size_t /*depth*/) override {
    return handOver(resolver_.openFromDirectories(name, includer));
  }
  void releaseInclude(IncludeResult* result) override {
    if (result == nullptr) return;
    resolver_.close();
    std::unique_ptr<IncludeResult>(result).reset();
  }

 private:
  static IncludeResult* handOver(const SourceFile* file) {
    if (file == nullptr) return nullptr;
    return std::make_unique<IncludeResult>(file->path, file->text.data(), file->text.size(), nullptr)
        .release();
  }

  IncludeResolver& resolver_;
};

struct Standard {
  int version = 450;
  EProfile profile = ENoProfile;
  bool forced = false;
};

Result<Standard> standardOf(const std::string& spelling) {
  if (spelling.empty()) return Standard{};
  constexpr std::array<int, 16> kDesktop = {110, 120, 130, 140, 150, 330, 400, 410,
                                            420, 430, 440, 450, 460, 0,   0,   0};
  constexpr std::array<int, 3> kEmbedded = {300, 310, 320};
  std::size_t digits = 0;
  int version = 0;
  while (digits < spelling.size() && digits < 3 &&
         std::isdigit(static_cast<unsigned char>(spelling[digits]))) {
    version = version * 10 + (spelling[digits++] - '0');
  }
  const std::string profile = spelling.substr(digits);
  const bool desktop = version != 0 && std::find(kDesktop.begin(), kDesktop.end(), version) != kDesktop.end();
  const bool embedded = std::find(kEmbedded.begin(), kEmbedded.end(), version) != kEmbedded.end();
  if (desktop && (profile.empty() || profile == "core")) {
    return Standard{version, version >= 150 ? ECoreProfile : ENoProfile, true};
  }
  if (desktop && version >= 150 && profile == "compatibility")
    return Standard{version, ECompatibilityProfile, true};
  if (embedded && profile == "es") return Standard{version, EEsProfile, true};
  return Error{ErrorKind::kUsage,
               "source.standard",
               "-std=" + spelling +
                   " is no GLSL version; expected a number from 110 to 460 with core, compatibility "
                   "or es after it where wanted, such as 450, 450core or 310es",
               {}};
}

// Text that is read before the shader. It does not shift the shader's lines.
Result<std::string> preambleOf(const CompileOptions& options, bool hlsl) {
  std::string preamble = hlsl ? "" : "#extension GL_GOOGLE_include_directive : require\n";
  for (const auto& [name, value] : options.defines) {
    const bool identifier = !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
                            std::all_of(name.begin(), name.end(), [](unsigned char c) {
                              return c < 128 && (std::isalnum(c) != 0 || c == '_');
                            });
    if (!identifier || value.find_first_of("\n\r") != std::string::npos) {
      return Error{
          ErrorKind::kUsage,
          "source.define",
          "-D" + name + " cannot be defined: expected an identifier and a value of one line, as -DOCTAVES=5",
          {}};
    }
    preamble += "#define " + name + " " + value + "\n";
  }
  return preamble;
}

// glslang reads texts as C strings in places, and its lexer takes NUL for the end.
Result<void> refuseNul(std::string_view text, const std::string& name) {
  const std::size_t at = text.find('\0');
  if (at == std::string_view::npos) return {};
  const std::string_view before = text.substr(0, at);
  const int line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return Error{ErrorKind::kInput,
               "source.syntax",
               "found a NUL byte; expected GLSL text or a SPIR-V binary (which begins with 0x07230203)",
               {name, line, static_cast<int>(at - line_start) + 1}};
}

// The line of the #include that failed, which only the log knows.
Error includeError(const Error& failure, const Error& logged) {
  Error error = failure;
  if (logged.place.line > 0 && logged.message.starts_with("'#include'")) error.place = logged.place;
  return error;
}

void listSources(std::string_view text, const IncludeResolver& resolver, CompiledShader& shader) {
  shader.sources.push_back({shader.main_path, std::string(text)});
  for (const SourceFile& file : resolver.files()) {
    shader.dependencies.push_back(file.path);
    shader.sources.push_back(file);
  }
}

// HLSL passes textures and structs of them about as values, which SPIR-V for Vulkan does not allow.
Result<CompiledShader> legalized(CompiledShader shader) {
  if (validateModule(shader.words).ok()) return shader;
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.RegisterLegalizationPasses();
  spvtools::OptimizerOptions run;
  run.set_run_validator(false);
  std::vector<std::uint32_t> words;
  if (!optimizer.Run(shader.words.data(), shader.words.size(), &words, run))
    return Error{ErrorKind::kInput, "source.invalid", "the HLSL cannot be brought into a form that Vulkan takes", {shader.main_path, 0, 0}};
  shader.words = std::move(words);
  return shader;
}

bool isHlsl(const std::string& name) { return name.ends_with(".hlsl") || name.ends_with(".HLSL"); }

// HLSL has registers by kind of resource, Vulkan one sequence of bindings.
constexpr unsigned kTextureShift = 16, kSamplerShift = 32, kStorageShift = 48;

void readAsHlsl(glslang::TShader& shader, EShLanguage language, const std::string& entry_point) {
  shader.setEnvInput(glslang::EShSourceHlsl, language, glslang::EShClientVulkan, 100);
  shader.setSourceEntryPoint(entry_point.c_str());
  shader.setEntryPoint("main");
  shader.setAutoMapBindings(true);
  shader.setAutoMapLocations(true);
  shader.setShiftBinding(glslang::EResTexture, kTextureShift);
  shader.setShiftBinding(glslang::EResImage, kStorageShift);
  shader.setShiftBinding(glslang::EResSsbo, kStorageShift);
  shader.setShiftBinding(glslang::EResUav, kStorageShift);
  shader.setShiftBinding(glslang::EResSampler, kSamplerShift);
}

}  // namespace

Result<CompiledShader> translateGlsl(std::string_view text, const std::string& name, ShaderStage stage,
                                     const CompileOptions& options) {
  REPRISE_ASSIGN(const Standard standard, standardOf(options.standard));
  REPRISE_ASSIGN(const std::string preamble, preambleOf(options, isHlsl(name)));
  REPRISE_TRY(refuseNul(text, name));
  initializeOnce();

  const EShLanguage language = stage == ShaderStage::kVertex ? EShLangVertex : EShLangFragment;
  const bool hlsl = isHlsl(name);
  const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgEnhanced | EShMsgSuppressWarnings |
                                                 (hlsl ? EShMsgReadHlsl | EShMsgHlslOffsets : 0));
  // The program refers to the shader and is destroyed before it.
  glslang::TShader shader(language);
  const std::string whole(text);
  const char* texts[] = {whole.c_str()};
  const int lengths[] = {static_cast<int>(whole.size())};
  const char* names[] = {name.c_str()};
  shader.setStringsWithLengthsAndNames(texts, lengths, names, 1);
  shader.setPreamble(preamble.c_str());
  if (hlsl) {
    readAsHlsl(shader, language, options.entry_point);
  } else {
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
  }
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
  shader.setEnhancedMsgs();
  if (standard.forced) shader.setOverrideVersion(standard.version);

  IncludeResolver resolver(name, options.include_dirs);
  Includer includer(resolver);
  CompiledShader compiled;
  compiled.stage = stage;
  compiled.main_path = name;
  const bool parsed = shader.parse(GetDefaultResources(), standard.version, standard.profile, standard.forced,
                                   /*forwardCompatible=*/false, messages, includer);
  listSources(text, resolver, compiled);
  if (!parsed) {
    const Error logged = errorOfLog(shader.getInfoLog(), name, compiled.sources);
    return resolver.failure() ? includeError(*resolver.failure(), logged) : logged;
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages) || (hlsl && !program.mapIO())) return errorOfLog(program.getInfoLog(), name, compiled.sources);

  glslang::SpvOptions spirv_options;
  spirv_options.generateDebugInfo = true;
  spirv_options.disableOptimizer = true;
  // OpLine refers to the name of the source file, so the intermediate form has to know it.
  glslang::TIntermediate* intermediate = program.getIntermediate(language);
  intermediate->setSourceFile(name.c_str());
  intermediate->addSourceText(whole.c_str(), whole.size());
  spv::SpvBuildLogger logger;
  glslang::GlslangToSpv(*intermediate, compiled.words, &logger, &spirv_options);
  if (hlsl) return legalized(std::move(compiled));
  return compiled;
}

}  // namespace reprise
