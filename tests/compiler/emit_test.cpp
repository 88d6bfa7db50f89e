// Readable GLSL is GLSL, and a package on disk reads back.
#include "compiler/emit/emit.h"

#include <gtest/gtest.h>

#include "compiler/source/compile.h"
#include "compiler/source/reflect.h"
#include "runtime/base/file.h"
#include "runtime/base/hash.h"
#include "tests/compiler/scratch_directory.h"

namespace reprise {
namespace {

CompiledShader shaderOf(const std::string& name) {
  const Result<CompiledShader> shader =
      compile(std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders" / name, {});
  REPRISE_CHECK(shader.ok(), formatError(shader.error()));
  return *shader;
}

Package smallPackage() {
  Package package;
  package.tool_version = "test";
  package.modules["vertex"] = shaderOf("marble/marble.vert").words;
  package.modules["fragment"] = shaderOf("marble/marble.frag").words;
  const Result<ShaderInterface> interface =
      reflectInterface(package.modules["vertex"], package.modules["fragment"]);
  REPRISE_CHECK(interface.ok(), formatError(interface.error()));
  package.interface = *interface;
  Pass pass;
  pass.name = "shade";
  pass.vertex_module = "vertex";
  pass.fragment_module = "fragment";
  pass.colors = {ColorAttachment{0, "", LoadOp::kClear, BlendKind::kReplace, 0}};
  Recipe recipe;
  recipe.strategy = "original";
  recipe.uses_reprise_set = false;
  recipe.passes = {pass};
  for (const auto& [name, words] : package.modules)
    recipe.modules.push_back({name, name, contentHash(bytesOf(words))});
  package.original = recipe;
  package.variant = recipe;
  return package;
}

TEST(ReadableGlsl, CompilesAgainAndKeepsNames) {
  for (const char* name : {"marble/marble.vert", "marble/marble.frag", "laws/law.vert", "laws/loop/loop.frag",
                           "laws/discard/discard.frag", "laws/textures/textures.frag"}) {
    const CompiledShader shader = shaderOf(name);
    const Result<std::string> text = readableGlsl(shader.words);
    ASSERT_TRUE(text.ok()) << formatError(text.error());
    EXPECT_TRUE(text->starts_with("#version 450")) << name;
    CompileOptions options;
    options.stage = shader.stage;
    const Result<CompiledShader> again = compileText(*text, "again.glsl", options);
    EXPECT_TRUE(again.ok()) << name << ": " << formatError(again.error()) << "\n" << *text;
  }
  const Result<std::string> marble = readableGlsl(shaderOf("marble/marble.frag").words);
  ASSERT_TRUE(marble.ok());
  for (const char* name : {"uniform Scene", "turbulence", "albedo", "world_normal"}) {
    EXPECT_NE(marble->find(name), std::string::npos) << name;
  }
}

TEST(ReadableGlsl, RefusesInvalidModules) {
  const std::vector<std::uint32_t> words = {1, 2, 3, 4, 5, 6};
  const Result<std::string> text = readableGlsl(words);
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.error().code, "spirv.invalid");
}

TEST(WritePackage, WritesModulesWithGlslBesideThem) {
  const ScratchDirectory scratch;
  const Package package = smallPackage();
  const Result<void> written = writePackage(package, scratch.path() / "package");
  ASSERT_TRUE(written.ok()) << formatError(written.error());
  const Result<std::string> text = readFile(scratch.path() / "package" / "fragment.glsl");
  ASSERT_TRUE(text.ok()) << formatError(text.error());
  EXPECT_EQ(*text, *readableGlsl(package.modules.at("fragment")));
  const Result<Package> read = readPackage(scratch.path() / "package");
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->modules, package.modules);
}

TEST(WritePackage, AModuleWithoutGlslStillShipsWithTheReason) {
  const ScratchDirectory scratch;
  Package package = smallPackage();
  // A bound too low: GLSL refuses it, the package's files do not look into modules.
  package.modules["fragment"][3] = 2;
  for (Recipe* recipe : {&package.original, &package.variant}) {
    for (ModuleEntry& entry : recipe->modules)
      entry.hash = contentHash(bytesOf(package.modules.at(entry.name)));
  }
  const Result<void> written = writePackage(package, scratch.path());
  ASSERT_TRUE(written.ok()) << formatError(written.error());
  const Result<std::string> text = readFile(scratch.path() / "fragment.glsl");
  ASSERT_TRUE(text.ok());
  EXPECT_TRUE(text->starts_with("// No GLSL for this module: ")) << *text;
}

TEST(WritePackage, ADirectoryThatIsAFileIsAnError) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch.write("occupied", "text");
  const Result<void> written = writePackage(smallPackage(), file);
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(*readFile(file), "text");
}

}  // namespace
}  // namespace reprise
