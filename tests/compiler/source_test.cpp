// GLSL in, SPIR-V with lines and names out; mistakes are reported where they are.
#include "compiler/source/compile.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "compiler/source/depfile.h"
#include "compiler/source/validate.h"
#include "runtime/base/file.h"
#include "tests/compiler/scratch_directory.h"

namespace reprise {
namespace {

const std::string kFragment =
    "#version 450\n"
    "layout(location = 0) in vec2 position;\n"
    "layout(location = 0) out vec4 color;\n"
    "void main() {\n"
    "  float brightness = dot(position, position);\n"
    "  color = vec4(brightness);\n"
    "}\n";

const std::string kVertex =
    "#version 450\n"
    "layout(location = 0) in vec3 corner;\n"
    "void main() { gl_Position = vec4(corner, 1.0); }\n";

CompileOptions fragmentOptions() {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  return options;
}

Error errorOf(const Result<CompiledShader>& result) {
  if (!result.ok()) return result.error();
  ADD_FAILURE() << "compiled, though it should not";
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Source, KeepsNamesAndLinesAndValidates) {
  const Result<CompiledShader> shader = compileText(kFragment, "disc.frag", {});
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  EXPECT_EQ(shader->stage, ShaderStage::kFragment);
  EXPECT_EQ(shader->main_path, "disc.frag");
  EXPECT_EQ(shader->words.at(1), 0x00010300u);
  EXPECT_TRUE(validateModule(shader->words).ok());
  const std::string text = disassemble(shader->words);
  EXPECT_TRUE(contains(text, "OpName %brightness \"brightness\"")) << text;
  EXPECT_TRUE(contains(text, "OpString \"disc.frag\"")) << text;
  EXPECT_TRUE(contains(text, " 5 0\n")) << "an OpLine for line 5\n" << text;
}

TEST(Source, DoesNotOptimize) {
  const Result<CompiledShader> shader = compileText(kFragment, "disc.frag", {});
  ASSERT_TRUE(shader.ok());
  EXPECT_TRUE(contains(disassemble(shader->words), "OpStore %brightness")) << "the local was optimized away";
}

TEST(Source, TellsTheStageFromTheSuffix) {
  for (const char* name : {"a.vert", "a.vs", "a.vert.glsl", "A.VERT"}) {
    const Result<CompiledShader> shader = compileText(kVertex, name, {});
    ASSERT_TRUE(shader.ok()) << name << ": " << formatError(shader.error());
    EXPECT_EQ(shader->stage, ShaderStage::kVertex) << name;
  }
  EXPECT_EQ(errorOf(compileText(kVertex, "shader.glsl", {})).code, "source.stage");
  EXPECT_EQ(errorOf(compileText(kVertex, "a.comp", {})).code, "source.stage");
}

TEST(Source, ReportsTheFirstErrorWithLineAndColumn) {
  const std::string text =
      "#version 450\n"
      "layout(location = 0) out vec4 color;\n"
      "void main() {\n"
      "  float known = 1.0;\n"
      "  color = vec4(known * unknown);\n"
      "}\n";
  const Error error = errorOf(compileText(text, "wrong.frag", {}));
  EXPECT_EQ(error.code, "source.syntax");
  EXPECT_EQ(error.kind, ErrorKind::kInput);
  EXPECT_EQ(error.place, (Place{"wrong.frag", 5, 24}));
  EXPECT_TRUE(contains(error.message, "'unknown'")) << error.message;
}

TEST(Source, FindsTheColumnOfUnexpectedPunctuationAndKeywords) {
  const Error parenthesis =
      errorOf(compileText("#version 450\nvoid main() {\n  float a = (1.0));\n}\n", "wrong.frag", {}));
  // The line's first ')' is not the superfluous one; the column names the first, as the header says.
  EXPECT_EQ(parenthesis.place.line, 3);
  EXPECT_EQ(parenthesis.place.column, 17);
  const Error keyword =
      errorOf(compileText("#version 450\nvoid main() {\n  float a = while;\n}\n", "wrong.frag", {}));
  EXPECT_EQ(keyword.place, (Place{"wrong.frag", 3, 13}));
}

TEST(Source, DoesNotTakePartOfAWordForTheToken) {
  const std::string text =
      "#version 450\nlayout(location = 0) out vec4 color;\nvoid main() { float abc = 1.0; color = vec4(abc, "
      "b, 0, 0); }\n";
  EXPECT_EQ(errorOf(compileText(text, "wrong.frag", {})).place, (Place{"wrong.frag", 3, 50}));
}

TEST(Source, PlacesErrorsInFilesWithColonsInTheirNames) {
  const std::string name = "C:3: odd.frag";
  EXPECT_EQ(errorOf(compileText("#version 450\nvoid main() { nothing(); }\n", name, {})).place,
            (Place{name, 2, 15}));
}

TEST(Source, PlacesAMissingMainInTheFile) {
  const Error error = errorOf(compileText("#version 450\nvoid other() {}\n", "wrong.frag", {}));
  EXPECT_EQ(error.code, "source.syntax");
  EXPECT_EQ(error.place, (Place{"wrong.frag", 0, 0}));
  EXPECT_TRUE(contains(error.message, "entry point")) << error.message;
}

TEST(Source, RefusesTextsWithoutCode) {
  for (const char* text :
       {"", " \n\t\n", "// only a comment", "/* one */ // and another\n", "\xef\xbb\xbf\n"}) {
    const Error error = errorOf(compileText(text, "empty.frag", {}));
    EXPECT_EQ(error.code, "source.empty") << "[" << text << "]";
    EXPECT_EQ(error.place.file, "empty.frag");
  }
}

TEST(Source, RefusesMissingFilesAndDirectories) {
  const ScratchDirectory scratch;
  EXPECT_EQ(errorOf(compile(scratch.path() / "none.frag", {})).code, "file.missing");
  EXPECT_EQ(errorOf(compile(scratch.path(), {})).code, "file.not_regular");
}

TEST(Source, RefusesNulBytesWithTheirPlace) {
  std::string text = kFragment;
  text[text.find("brightness")] = '\0';
  EXPECT_EQ(errorOf(compileText(text, "nul.frag", {})).place, (Place{"nul.frag", 5, 9}));
}

TEST(Source, RefusesTheWrongStageAndSaysBoth) {
  const Error by_suffix = errorOf(compileText(kVertex, "surface.vert", fragmentOptions()));
  EXPECT_EQ(by_suffix.code, "source.stage");
  EXPECT_TRUE(contains(by_suffix.message, "found a vertex")) << by_suffix.message;
  EXPECT_TRUE(contains(by_suffix.message, "expected a fragment")) << by_suffix.message;

  const Error by_content = errorOf(compileText(kVertex, "surface.glsl", fragmentOptions()));
  EXPECT_EQ(by_content.code, "source.stage");
  EXPECT_TRUE(contains(by_content.message, "found a vertex")) << by_content.message;
  EXPECT_EQ(by_content.place.line, 3);

  const Result<CompiledShader> vertex = compileText(kVertex, "surface.vert", {});
  ASSERT_TRUE(vertex.ok());
  const Error binary = errorOf(compileText(bytesOf(vertex->words), "surface.spv", fragmentOptions()));
  EXPECT_EQ(binary.code, "source.stage");
  EXPECT_TRUE(contains(binary.message, "found a vertex shader; expected a fragment")) << binary.message;
}

TEST(Source, DefinesReachTheShader) {
  const std::string text =
      "#version 450\nlayout(location = 0) out vec4 color;\n#ifdef DARK\nvoid main() { color = vec4(LEVEL); "
      "}\n#endif\n";
  EXPECT_FALSE(compileText(text, "a.frag", {}).ok());
  CompileOptions options;
  options.defines = {{"DARK", ""}, {"LEVEL", "0.25"}};
  const Result<CompiledShader> shader = compileText(text, "a.frag", options);
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  EXPECT_TRUE(contains(disassemble(shader->words), "0.25"));
  for (const char* name : {"", "2D", "A B", "A\nB", "MIN(a)"}) {
    options.defines = {{name, "1"}};
    const Error error = errorOf(compileText(text, "a.frag", options));
    EXPECT_EQ(error.code, "source.define") << name;
    EXPECT_EQ(error.kind, ErrorKind::kUsage);
  }
}

TEST(Source, StandardOverridesTheVersionLine) {
  const std::string text =
      "#version 300 es\nlayout(location = 0) out highp vec4 color;\nvoid main() { color = vec4(1); }\n";
  EXPECT_FALSE(compileText(text, "a.frag", {}).ok());
  CompileOptions options;
  options.standard = "450";
  EXPECT_TRUE(compileText(text, "a.frag", options).ok());
  options.standard = "310es";
  EXPECT_TRUE(compileText(text, "a.frag", options).ok());
  for (const char* standard : {"45", "999", "450x", "es", "310core", "4500"}) {
    options.standard = standard;
    EXPECT_EQ(errorOf(compileText(text, "a.frag", options)).code, "source.standard") << standard;
  }
}

class Includes : public ::testing::Test {
 protected:
  Result<CompiledShader> compileMain(const std::string& head, const std::string& value) {
    const std::string text = "#version 450\n" + head +
                             "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(" + value +
                             "); }\n";
    return compile(scratch_.write("main.frag", text), options_);
  }
  std::string path(const std::string& name) const { return (scratch_.path() / name).string(); }

  ScratchDirectory scratch_;
  CompileOptions options_;
};

TEST_F(Includes, NestWithAndWithoutTheExtension) {
  scratch_.write("lib/outer.glsl", "#include \"inner.glsl\"\nfloat outer() { return inner() + 1.0; }\n");
  scratch_.write("lib/inner.glsl", "float inner() { return 0.5; }\n");
  for (const char* head : {"", "#extension GL_GOOGLE_include_directive : require\n"}) {
    const Result<CompiledShader> shader =
        compileMain(std::string(head) + "#include \"lib/outer.glsl\"\n", "outer()");
    ASSERT_TRUE(shader.ok()) << formatError(shader.error());
    EXPECT_EQ(shader->dependencies,
              (std::vector<std::string>{path("lib/outer.glsl"), path("lib/inner.glsl")}));
    ASSERT_EQ(shader->sources.size(), 3u);
    EXPECT_EQ(shader->sources[0].path, path("main.frag"));
    EXPECT_EQ(shader->sources[2].text, "float inner() { return 0.5; }\n");
  }
}

TEST_F(Includes, QuotedNamesAreLookedForBesideTheFileFirst) {
  scratch_.write("value.glsl", "float value() { return 0.125; }\n");
  scratch_.write("other/value.glsl", "float value() { return 0.75; }\n");
  options_.include_dirs = {scratch_.path() / "other"};
  const Result<CompiledShader> quoted = compileMain("#include \"value.glsl\"\n", "value()");
  ASSERT_TRUE(quoted.ok()) << formatError(quoted.error());
  EXPECT_EQ(quoted->dependencies, std::vector<std::string>{path("value.glsl")});
  const Result<CompiledShader> bracketed = compileMain("#include <value.glsl>\n", "value()");
  ASSERT_TRUE(bracketed.ok()) << formatError(bracketed.error());
  EXPECT_EQ(bracketed->dependencies, std::vector<std::string>{path("other/value.glsl")});
}

TEST_F(Includes, ErrorsInsideArePlacedInTheIncludedFile) {
  scratch_.write("broken.glsl", "\nfloat broken() { return missing_name; }\n");
  const Error error = errorOf(compileMain("#include \"broken.glsl\"\n", "broken()"));
  EXPECT_EQ(error.code, "source.syntax");
  EXPECT_EQ(error.place, (Place{path("broken.glsl"), 2, 25}));
}

TEST_F(Includes, AfterAnIncludeLinesCountOnInTheMainFile) {
  scratch_.write("long.glsl", "\n\n\n\n\nfloat one() { return 1.0; }\n");
  const Error error = errorOf(compileMain("#include \"long.glsl\"\n", "one() + two_of_it"));
  EXPECT_EQ(error.place.file, path("main.frag"));
  EXPECT_EQ(error.place.line, 4);
}

TEST_F(Includes, AMissingFileNamesTheDirectoriesSearched) {
  options_.include_dirs = {scratch_.path() / "first", scratch_.path() / "second"};
  const Error error = errorOf(compileMain("\n#include \"absent.glsl\"\n", "1"));
  EXPECT_EQ(error.code, "source.include");
  EXPECT_EQ(error.place.file, path("main.frag"));
  EXPECT_EQ(error.place.line, 3);
  for (const std::string& part :
       {std::string("absent.glsl"), scratch_.path().string(), path("first"), path("second")}) {
    EXPECT_TRUE(contains(error.message, part)) << part << " in " << error.message;
  }
}

TEST_F(Includes, ACycleIsAnErrorUnlessGuardsEndIt) {
  scratch_.write("a.glsl", "#include \"b.glsl\"\n");
  scratch_.write("b.glsl", "#include \"a.glsl\"\n");
  const Error error = errorOf(compileMain("#include \"a.glsl\"\n", "1"));
  EXPECT_EQ(error.code, "source.include");
  EXPECT_TRUE(contains(error.message, path("a.glsl")) && contains(error.message, path("b.glsl")))
      << error.message;

  scratch_.write("a.glsl", "#ifndef A\n#define A\n#include \"b.glsl\"\nfloat a() { return b(); }\n#endif\n");
  scratch_.write("b.glsl", "#ifndef B\n#define B\n#include \"a.glsl\"\nfloat b() { return 1.0; }\n#endif\n");
  const Result<CompiledShader> guarded = compileMain("#include \"a.glsl\"\n", "a()");
  EXPECT_TRUE(guarded.ok()) << formatError(guarded.error());
}

TEST_F(Includes, DoublingCyclesEnd) {
  scratch_.write("twice.glsl", "#include \"twice.glsl\"\n#include \"twice.glsl\"\n");
  EXPECT_EQ(errorOf(compileMain("#include \"twice.glsl\"\n", "1")).code, "source.include");
}

TEST_F(Includes, AFileIncludedTwiceIsOneDependency) {
  scratch_.write("step.glsl", "value += 0.25;\n");
  const std::string text =
      "#version 450\nlayout(location = 0) out vec4 color;\nvoid main() {\nfloat value = 0.0;\n"
      "#include \"step.glsl\"\n#include \"step.glsl\"\ncolor = vec4(value);\n}\n";
  const Result<CompiledShader> shader = compile(scratch_.write("twice.frag", text), {});
  ASSERT_TRUE(shader.ok()) << formatError(shader.error());
  EXPECT_EQ(shader->dependencies, std::vector<std::string>{path("step.glsl")});
}

TEST(Source, CompilesTheMarble) {
  const std::filesystem::path folder = std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders/marble";
  CompileOptions options;
  options.defines = {{"OCTAVES", "20"}};
  const Result<CompiledShader> fragment = compile(folder / "marble.frag", options);
  ASSERT_TRUE(fragment.ok()) << formatError(fragment.error());
  EXPECT_FALSE(fragment->dependencies.empty());
  const Result<CompiledShader> vertex = compile(folder / "marble.vert", {});
  ASSERT_TRUE(vertex.ok()) << formatError(vertex.error());
}

RC_GTEST_PROP(Source, NoTextMakesTheCompilerCrash, (const std::string& text)) {
  const Result<CompiledShader> shader = compileText(text, "random.frag", {});
  if (!shader.ok()) RC_ASSERT(!shader.error().code.empty());
}

// Texts that are nearly shaders get further into the compiler than random ones.
RC_GTEST_PROP(Source, DamagedShadersEitherCompileOrSayWhy, ()) {
  std::string text = kFragment;
  const int edits = *rc::gen::inRange(1, 6);
  for (int i = 0; i < edits; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    const auto length = *rc::gen::inRange<std::size_t>(0, 12);
    const auto from = *rc::gen::inRange<std::size_t>(0, kFragment.size());
    text.replace(at, length, kFragment.substr(from, *rc::gen::inRange<std::size_t>(0, 12)));
  }
  const Result<CompiledShader> shader = compileText(text, "damaged.frag", {});
  if (shader.ok()) {
    RC_ASSERT(validateModule(shader->words).ok());
  } else {
    RC_ASSERT(!shader.error().message.empty());
    RC_ASSERT(shader.error().place.file == "damaged.frag");
  }
}

TEST(Depfile, EscapesWhatMakeReads) {
  const Result<std::string> text =
      depfileText("out/a b.spv", {"main.frag", "dir with space/x.glsl", "cost$.glsl", "a#b"});
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(*text,
            "out/a\\ b.spv: \\\n  main.frag \\\n  dir\\ with\\ space/x.glsl \\\n  cost$$.glsl \\\n  a\\#b\n");
}

TEST(Depfile, RefusesLineBreaksAndWritesNothing) {
  const ScratchDirectory scratch;
  const Result<void> written = writeDepfile(scratch.path() / "a.d", "a.spv", {"bad\nname"});
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, "depfile.name");
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "a.d"));
  ASSERT_TRUE(writeDepfile(scratch.path() / "a.d", "a.spv", {"good"}).ok());
  EXPECT_EQ(*readFile(scratch.path() / "a.d"), "a.spv: \\\n  good\n");
}

}  // namespace
}  // namespace reprise
