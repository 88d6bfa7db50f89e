// What a scenario file means, and where and how its mistakes are reported.
#include "profiler/scenario/read_scenario.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/scenario/scenario_file.h"

namespace reprise {
namespace {

struct Mistake {
  std::string name;
  std::string wanted, replacement;  // in validScenario()
  std::string code;
  int line = 0, column = 0;
  std::vector<std::string> words;  // of the message
};

const std::vector<Mistake> kMistakes = {
    {"Syntax", "width = 64", "width = = 64", "scenario.syntax", 8, 9, {"TOML"}},
    {"UnknownMotion", "[shader]", "motion = \"non\"\n[shader]", "scenario.value", 1, 10, {"'motion'", "'non'", "did you mean 'none'?"}},
    {"MotionOfAnotherType", "[shader]", "motion = false\n[shader]", "scenario.type", 1, 10, {"'motion'", "'vertex'", "'none'"}},
    {"UnknownKey",
     "frames = 8",
     "frmes = 8",
     "scenario.unknown_key",
     10,
     1,
     {"'frmes'", "did you mean 'frames'?"}},
    {"UnknownKeyWithNothingNear",
     "frames = 8",
     "zzzzzzzzz = 8",
     "scenario.unknown_key",
     10,
     1,
     {"expected one of", "'width'"}},
    {"UnknownSection",
     "[uniforms]",
     "[unifroms]",
     "scenario.unknown_key",
     21,
     2,
     {"did you mean 'uniforms'?"}},
    {"KeyOfAnotherMesh",
     "radius = 1.5",
     "tube_radius = 1.5",
     "scenario.unknown_key",
     15,
     27,
     {"'tube_radius'", "'radius'"}},
    {"MissingKey", "mesh = { kind = \"sphere\", radius = 1.5 }\n", "", "scenario.missing_key", 13, 1, {"[[object]]", "'mesh'"}},
    {"MissingName", "name = \"ball\"\n", "", "scenario.missing_key", 13, 1, {"'name'"}},
    {"WrongType",
     "frames = 8",
     "frames = \"eight\"",
     "scenario.type",
     10,
     10,
     {"the text 'eight'", "integer from 1 to 100000"}},
    {"FractionOfAPixel", "width = 64", "width = 64.5", "scenario.type", 8, 9, {"64.5", "integer"}},
    {"NegativeSize",
     "width = 64",
     "width = -64",
     "scenario.value",
     8,
     9,
     {"'width'", "-64", "from 1 to 8192"}},
    {"AbsurdResolution", "height = 48", "height = 8193", "scenario.value", 9, 10, {"8193"}},
    {"AbsurdFrames", "frames = 8", "frames = 100001", "scenario.value", 10, 10, {"100001"}},
    {"AbsurdSegments", "radius = 1.5", "segments_u = 2049", "scenario.value", 15, 40, {"2049", "2048"}},
    {"NegativeRadius", "radius = 1.5", "radius = -1.5", "scenario.value", 15, 36, {"-1.5", "above 0"}},
    {"NotANumber", "radius = 1.5", "radius = nan", "scenario.value", 15, 36, {"nan"}},
    {"Infinity",
     "\"Scene.gain\" = 0.5",
     "\"Scene.gain\" = inf",
     "scenario.value",
     23,
     16,
     {"Scene.gain", "inf"}},
    {"PeriodZero", "[1, 2, \"never\"]", "[1, 0]", "scenario.value", 11, 15, {"period", "0"}},
    {"PeriodNoPowerOfTwo", "[1, 2, \"never\"]", "[1, 3]", "scenario.value", 11, 15, {"3", "1, 2, 4, ... 64"}},
    {"PeriodTooLong", "[1, 2, \"never\"]", "[128]", "scenario.value", 11, 12, {"128"}},
    {"PeriodTwice", "[1, 2, \"never\"]", "[2, 2]", "scenario.value", 11, 15, {"twice"}},
    {"PeriodInWords", "[1, 2, \"never\"]", "[\"nevr\"]", "scenario.value", 11, 12, {"nevr", "never"}},
    {"MissingShader", "\"a.frag\"", "\"b.frag\"", "scenario.missing_file", 2, 12, {"b.frag"}},
    {"FolderAsShader", "\"a.frag\"", "\"common\"", "scenario.missing_file", 2, 12, {"common", "folder"}},
    {"MissingIncludeFolder", "[\"common\"]", "[\"comon\"]", "scenario.missing_file", 4, 17, {"comon"}},
    {"MissingTexture", "wood.png", "wod.png", "scenario.missing_file", 27, 8, {"wod.png"}},
    {"UnknownMesh",
     "\"sphere\"",
     "\"spere\"",
     "scenario.value",
     15,
     17,
     {"'spere'", "did you mean 'sphere'?"}},
    {"UnknownSemantic",
     "= \"view_projection\"",
     "= \"viewprojection\"",
     "scenario.value",
     22,
     27,
     {"'view_projection'"}},
    {"UniformWithoutBlock", "\"Scene.gain\"", "gain", "scenario.value", 23, 1, {"'gain'", "Block.member"}},
    {"UniformTwice",
     "\"Scene.gain\" = 0.5",
     "\"Scene.gain\" = 0.5\nScene.gain = 1",
     "scenario.value",
     24,
     7,
     {"bound twice"}},
    {"NoTraining", "\"training\"", "\"validation\"", "scenario.value", 29, 1, {"no training session"}},
    {"NoValidation", "\"validation\"", "\"training\"", "scenario.value", 29, 1, {"no validation session"}},
    {"ObjectsOfOneName",
     "\"floor\"",
     "\"ball\"",
     "scenario.value",
     17,
     1,
     {"two objects named 'ball'", "line 13"}},
    {"SessionsOfOneName", "\"check\"", "\"train\"", "scenario.value", 34, 1, {"two sessions named 'train'"}},
    {"NameThatIsAPath", "\"check\"", "\"../check\"", "scenario.value", 35, 8, {"../check"}},
    {"TrackOfWrongSize",
     "eye = [0, 1, 4]",
     "eye = [0, 1]",
     "scenario.value",
     37,
     18,
     {"'eye'", "2 numbers", "expected 3"}},
    {"CameraWithoutPath", "orbit = { radius = 3 }", "near = 1", "scenario.missing_key", 32, 10, {"'orbit'"}},
    {"FarBeforeNear", "{ radius = 3 }", "{ radius = 3 }, far = 0.01", "scenario.value", 32, 10, {"'far'"}},
    {"OrthographicToInfinity", "{ radius = 3 }", "{ radius = 3 }, orthographic = true, far = inf", "scenario.value", 32, 63, {"'far'", "inf", "orthographic"}},
    {"FarAtMinusInfinity", "{ radius = 3 }", "{ radius = 3 }, far = -inf", "scenario.value", 32, 42, {"'far'", "-inf"}},
    {"NearAtInfinity", "{ radius = 3 }", "{ radius = 3 }, near = inf", "scenario.value", 32, 43, {"'near'", "inf"}},
    {"ReverseZAgainstLess",
     "{ radius = 3 }",
     "{ radius = 3 }, reverse_z = true",
     "scenario.value",
     29,
     1,
     {"reverse_z", "depth_compare"}},
    {"OverrideOfUnknownObject",
     "role = \"training\"",
     "role = \"training\"\nmotions.bal = {}",
     "scenario.unknown_key",
     32,
     9,
     {"'bal'", "did you mean 'ball'?"}},
    {"OverrideOfUnknownUniform",
     "role = \"training\"",
     "role = \"training\"\nuniforms.\"Scene.gian\" = 1",
     "scenario.unknown_key",
     32,
     10,
     {"'Scene.gain'"}},
};

class ScenarioMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ScenarioMistake, IsReportedAtItsPlace) {
  const Mistake& mistake = GetParam();
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(changed(validScenario(), mistake.wanted, mistake.replacement));
  ASSERT_FALSE(read.ok());
  const Error& error = read.error();
  EXPECT_EQ(error.kind, ErrorKind::kInput);
  EXPECT_EQ(error.code, mistake.code);
  EXPECT_EQ(error.place, (Place{(folder.path() / "scene.toml").string(), mistake.line, mistake.column}));
  for (const std::string& word : mistake.words)
    EXPECT_NE(error.message.find(word), std::string::npos) << word << " in: " << error.message;
}

INSTANTIATE_TEST_SUITE_P(Mistakes, ScenarioMistake, testing::ValuesIn(kMistakes),
                         [](const auto& each) { return each.param.name; });

TEST(Scenario, ReportsAllMistakesInTheOrderOfTheFile) {
  const ScenarioFolder folder;
  std::string text = changed(validScenario(), "\"sphere\"", "\"spere\"");
  text = changed(text, "width = 64", "width = 0");
  const Result<Scenario> read = folder.read(text);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().place.line, 8);
  ASSERT_EQ(read.error().others.size(), 1u) << formatError(read.error());
  const Error& other = read.error().others.front();
  EXPECT_EQ(other.code, "scenario.value");
  EXPECT_EQ(other.place, (Place{(folder.path() / "scene.toml").string(), 15, 17}));
  EXPECT_EQ(other.message.find('\n'), std::string::npos) << other.message;
}

TEST(Scenario, OfNothingNamesWhatIsNeeded) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read("");
  ASSERT_FALSE(read.ok());
  for (const char* word : {"[[object]]", "[[model]]", "training", "validation"})
    EXPECT_NE(formatError(read.error()).find(word), std::string::npos) << word << " in: " << formatError(read.error());
}

TEST(Scenario, OfBytesIsASyntaxError) {
  const ScenarioFolder folder;
  const Result<Scenario> read =
      folder.read(std::string("\x7f"
                              "ELF\0\1\2",
                              7));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().code, "scenario.syntax");
}

TEST(Scenario, ThatIsNotThereIsAMissingFile) {
  EXPECT_EQ(readScenario("nonesuch.toml").error().code, "file.missing");
}

TEST(Scenario, MakesPathsAbsolute) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(validScenario());
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->path, (folder.path() / "scene.toml").string());
  EXPECT_EQ(read->name, "scene");
  EXPECT_EQ(read->fragment_path, (folder.path() / "a.frag").string());
  EXPECT_EQ(read->vertex_path, (folder.path() / "a.vert").string());
  EXPECT_EQ(read->include_dirs, std::vector<std::string>{(folder.path() / "common").string()});
  ASSERT_EQ(read->textures.size(), 1u);
  EXPECT_EQ(read->textures[0].path, (folder.path() / "wood.png").string());
}

TEST(Scenario, ReadsWhatTheFileSays) {
  const ScenarioFolder folder;
  const Result<Scenario> read = folder.read(validScenario());
  ASSERT_TRUE(read.ok()) << formatError(read.error());
  EXPECT_EQ(read->width, 64u);
  EXPECT_EQ(read->periods, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_EQ(read->defines, (std::vector<std::pair<std::string, std::string>>{{"LAYERS", "4"}}));
  ASSERT_EQ(read->objects.size(), 2u);
  EXPECT_EQ(read->objects[0].mesh.kind, MeshKind::kSphere);
  EXPECT_EQ(read->objects[0].mesh.radius, 1.5f);
  ASSERT_EQ(read->uniforms.size(), 2u);
  EXPECT_EQ(read->uniforms[0].member, "Scene.view_projection");
  EXPECT_EQ(std::get<Semantic>(read->uniforms[0].source), Semantic::kViewProjection);
  EXPECT_EQ(std::get<Track>(read->uniforms[1].source), Track(FixedTrack{{0.5f}}));
  EXPECT_EQ(read->uniforms[1].place.line, 23);
  ASSERT_EQ(read->sessions.size(), 2u);
  EXPECT_EQ(std::get<OrbitPath>(read->sessions[0].camera.path).radius, 3);
  EXPECT_EQ(read->sessions[1].role, SessionRole::kValidation);
}

TEST(Scenario, TakesUniformsByBlock) {
  const ScenarioFolder folder;
  const auto flat = folder.read(validScenario());
  const auto nested = folder.read(changed(
      changed(validScenario(), "[uniforms]\n\"Scene.view_projection\"", "[uniforms.Scene]\nview_projection"),
      "\"Scene.gain\"", "gain"));
  ASSERT_TRUE(nested.ok()) << formatError(nested.error());
  EXPECT_EQ(withoutPlaces(*nested), withoutPlaces(*flat));
}

TEST(ScenarioHash, IgnoresCommentsNameAndPlaceButNoValue) {
  const ScenarioFolder here, there;
  const std::string hash = here.read(validScenario())->hash;
  EXPECT_EQ(there.read("# moved\nname = \"other\"\n" + validScenario())->hash, hash);
  EXPECT_NE(here.read(changed(validScenario(), "0.5", "0.25"))->hash, hash);
  EXPECT_NE(here.read(changed(validScenario(), "LAYERS = 4", "LAYERS = 5"))->hash, hash);
}

TEST(ScenarioHash, CoversTheContentOfTextures) {
  const ScenarioFolder folder;
  const std::string before = folder.read(validScenario())->hash;
  folder.write("wood.png", "repainted");
  EXPECT_NE(folder.read(validScenario())->hash, before);
}

}  // namespace
}  // namespace reprise
