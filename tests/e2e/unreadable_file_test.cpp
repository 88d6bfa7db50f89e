// Files that cannot be read to an end, or not as what they are named for: each is refused at once, where it is named.
#include <gtest/gtest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/e2e/refusal.h"
#include "tests/e2e/run_command.h"
#include "tests/e2e/small_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

void makeSparse(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(ftruncate(descriptor, 20'000'000'000), 0);
  close(descriptor);
}

void makePipe(const fs::path& file) { ASSERT_EQ(mkfifo(file.c_str(), 0600), 0); }

// Memory enough for the tool and for no endless file.
CommandOutcome runSmall(const std::string& command) {
  CommandSpec spec;
  spec.words = {"sh", "-c", "ulimit -v 8000000; exec " + command};
  spec.time_limit = std::chrono::seconds(60);
  return runCommand(spec);
}

std::string optimizeCommand(const SmallScenario& scenario, const fs::path& toml) {
  return std::string(REPRISE_EXECUTABLE) + " optimize " + toml.string() + " -o " + scenario.output().string();
}

TEST(UnreadableFile, TextureIsRefusedWhereTheScenarioNamesIt) {
  const SmallScenario scenario;
  makePipe(scenario.file("pipe.png"));
  makeSparse(scenario.file("sparse.png"));
  const std::string generated = "kind = \"checker\"", text = textOf(scenario.toml());
  for (const auto& [name, code] : {std::pair<std::string, std::string>{"/proc/self/mem", "file.unreadable"}, {"/dev/zero", "file.not_regular"},
                                   {"pipe.png", "file.not_regular"}, {"sparse.png", "file.too_large"}}) {
    SCOPED_TRACE(name);
    writeText(scenario.toml(), text);
    scenario.replace(scenario.toml(), generated, "file = \"" + name + "\"");
    const int line = SmallScenario::lineOf(scenario.toml(), "file = \"" + name);
    expectRefusal(runSmall(optimizeCommand(scenario, scenario.toml())), kExitBadInput, {"small.toml:" + std::to_string(line) + ":8: ", code, name, "'grain'"});
    EXPECT_FALSE(fs::exists(scenario.output()));
  }
}

TEST(UnreadableFile, TextureThatIsNoImageIsNamedAndNotItsCopy) {
  const SmallScenario scenario;
  writeText(scenario.file("grain.png"), "no image");
  scenario.replace(scenario.toml(), "kind = \"checker\"", "file = \"grain.png\"");
  const int line = SmallScenario::lineOf(scenario.toml(), "grain.png");
  const CommandOutcome outcome = runCommand(optimizeSmall(scenario));
  expectRefusal(outcome, kExitBadInput, {scenario.toml().string() + ":" + std::to_string(line) + ":8: ", scenario.file("grain.png").string(), "texture.format"});
  EXPECT_EQ(outcome.errors.find(scenario.output().string()), std::string::npos) << outcome.errors;
}

TEST(UnreadableFile, ScenarioIsRefused) {
  const SmallScenario scenario;
  makePipe(scenario.file("pipe.toml"));
  makeSparse(scenario.file("sparse.toml"));
  expectRefusal(runSmall(optimizeCommand(scenario, scenario.file("pipe.toml"))), kExitBadInput, {"file.not_regular", "pipe.toml"});
  expectRefusal(runSmall(optimizeCommand(scenario, "/dev/zero")), kExitBadInput, {"file.not_regular"});
  expectRefusal(runSmall(optimizeCommand(scenario, scenario.file("sparse.toml"))), kExitBadInput, {"file.too_large", "20000000000", "67108864"});
}

TEST(UnreadableFile, ModelIsRefused) {
  const SmallScenario scenario;
  makeSparse(scenario.file("sparse.glb"));
  makePipe(scenario.file("pipe.bin"));
  writeText(scenario.file("pipe.gltf"), R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4, "uri": "pipe.bin"}]})");
  expectRefusal(runSmall(optimizeCommand(scenario, scenario.file("sparse.glb"))), kExitBadInput, {"file.too_large", "sparse.glb"});
  expectRefusal(runSmall(optimizeCommand(scenario, scenario.file("pipe.gltf"))), kExitBadInput, {"pipe.bin", "a pipe"});
}

TEST(UnreadableFile, ImageOfAModelIsNamedWithItsModel) {
  const SmallScenario scenario;
  writeText(scenario.file("tiles.gltf"), R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}], "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "tiles.png"}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}]})");
  writeText(scenario.file("tiles.png"), "no image");
  expectRefusal(runSmall(optimizeCommand(scenario, scenario.file("tiles.gltf"))), kExitBadInput,
                {scenario.file("tiles.gltf").string() + ": error: ", "images[0] ('tiles.png')", "texture.format"});
}

TEST(UnreadableFile, RecordingIsRefusedWhereTheScenarioNamesIt) {
  const SmallScenario scenario;
  makePipe(scenario.file("walk.csv"));
  scenario.replace(scenario.toml(), "orbit = { radius = 3.0, radians_per_frame = 0.02 }", "recorded = \"walk.csv\"");
  const int line = SmallScenario::lineOf(scenario.toml(), "walk.csv");
  expectRefusal(runSmall(optimizeCommand(scenario, scenario.toml())), kExitBadInput, {"small.toml:" + std::to_string(line) + ":", "file.not_regular", "walk.csv"});
}

TEST(UnreadableFile, ShaderAndWhatItIncludesAreRefused) {
  const SmallScenario scenario;
  const std::string analyze = std::string(REPRISE_EXECUTABLE) + " analyze ";
  makeSparse(scenario.file("sparse.frag"));
  makePipe(scenario.file("pipe.glsl"));
  writeText(scenario.file("includes.frag"), "#version 450\n#include \"pipe.glsl\"\nvoid main() {}\n");
  expectRefusal(runSmall(analyze + "/dev/zero"), kExitBadInput, {"file.not_regular"});
  expectRefusal(runSmall(analyze + scenario.file("sparse.frag").string()), kExitBadInput, {"file.too_large", "20000000000"});
  expectRefusal(runSmall(analyze + scenario.file("includes.frag").string()), kExitBadInput, {"includes.frag:2:", "file.not_regular", "pipe.glsl"});
  expectRefusal(runSmall(analyze + "- < /dev/zero"), kExitBadInput, {"file.too_large"});
  for (const std::string input : {"-", "/dev/stdin"}) {
    const CommandOutcome outcome = runSmall(analyze + input + " < " + scenario.fragment().string());
    EXPECT_EQ(outcome.status, kExitDone) << outcome.all();
  }
}

}  // namespace
}  // namespace reprise
