// Recorded camera paths: what CSV and JSON files say, what is refused and where.
#include <gtest/gtest.h>

#include "profiler/scenario/read_scenario.h"
#include "tests/scenario/scenario_file.h"

namespace reprise {
namespace {

const std::string kHeader = "at_s,x,y,z,qx,qy,qz,qw\n";
const std::string kCamera = "camera = { orbit = { radius = 3 } }";

// validScenario() with the recording as the camera of its training session.
Result<Scenario> readWith(const std::string& file_name, const std::string& content, const std::string& more = "") {
  const ScenarioFolder folder;
  folder.write(file_name, content);
  return folder.read(changed(validScenario(), kCamera, "camera = { recorded = \"" + file_name + "\"" + more + " }"));
}

const RecordedPath& pathOf(const Scenario& scenario) { return std::get<RecordedPath>(scenario.sessions[0].camera.path); }

TEST(Recording, IsReadFromCsv) {
  const auto read = readWith("walk.csv", "# dumped\n" + kHeader + "10,1,2,3,0,0,0,1\r\n\n10.5, 4, 5, 6, 0, 1, 0, 0\n");
  ASSERT_TRUE(read) << formatError(read.error());
  const std::vector<CameraKey> expected = {{0, {1, 2, 3}, {0, 0, 0, 1}, 0}, {0.5f, {4, 5, 6}, {0, 1, 0, 0}, 0}};
  EXPECT_EQ(pathOf(*read).keys, expected);
}

TEST(Recording, IsTheSameFromJson) {
  const auto csv = readWith("walk.csv", "at_s,x,y,z,qx,qy,qz,qw,fov_y_deg\n0,1,2,3,0,0,0,1,40\n1,4,5,6,0,0.6,0,0.8,50\n");
  const auto json = readWith("walk.json", R"([{"at_s":0,"x":1,"y":2,"z":3,"qx":0,"qy":0,"qz":0,"qw":1,"fov_y_deg":40},
    {"at_s":1,"x":4,"y":5,"z":6,"qx":0,"qy":0.6,"qz":0,"qw":0.8,"fov_y_deg":50}])");
  ASSERT_TRUE(csv) << formatError(csv.error());
  ASSERT_TRUE(json) << formatError(json.error());
  EXPECT_EQ(pathOf(*csv), pathOf(*json));
  EXPECT_EQ(csv->hash, json->hash);
}

TEST(Recording, LiesInWrittenScenariosWithoutItsFile) {
  const ScenarioFolder folder;
  folder.write("walk.csv", kHeader + "3,0.1,0.2,0.3,0,0.3,0.4,0.866\n3.1,1,2,3,0,0,0,1\n");
  const auto read = folder.read(changed(validScenario(), kCamera, "camera = { recorded = \"walk.csv\", handheld = { move = 0.01 }, cuts = [{ at_s = 1 }] }"));
  ASSERT_TRUE(read) << formatError(read.error());
  std::filesystem::remove(folder.path() / "walk.csv");
  const auto again = folder.read(writeScenario(*read, folder.path()));
  ASSERT_TRUE(again) << formatError(again.error());
  EXPECT_EQ(read->sessions, again->sessions);
  EXPECT_EQ(read->hash, again->hash);
}

TEST(Recording, NormalisesQuaternionsWithinTheTolerance) {
  const auto read = readWith("walk.csv", kHeader + "0,0,0,0,0,0,0,1.005\n");
  ASSERT_TRUE(read) << formatError(read.error());
  EXPECT_EQ(pathOf(*read).keys[0].rotation[3], 1);
}

struct Refusal {
  std::string name, file, content, where, words;
};
class RefusedRecording : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedRecording, IsToldWithItsPlace) {
  const auto read = readWith(GetParam().file, GetParam().content);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, "scenario.recording");
  const std::string told = formatError(read.error());
  EXPECT_NE(told.find(GetParam().where), std::string::npos) << told;
  EXPECT_NE(told.find(GetParam().words), std::string::npos) << told;
}

const std::string kFirst = "0,0,0,0,0,0,0,1\n";
const std::string kFirstJson = R"([{"at_s":0,"x":0,"y":0,"z":0,"qx":0,"qy":0,"qz":0,"qw":1},)";
INSTANTIATE_TEST_SUITE_P(
    Recording, RefusedRecording,
    testing::Values(Refusal{"TimesThatStand", "a.csv", kHeader + kFirst + kFirst, "a.csv:3:", "after that of the row before"},
                    Refusal{"NotANumber", "a.csv", kHeader + kFirst + "1,nan,0,0,0,0,0,1\n", "a.csv:3:", "finite"},
                    Refusal{"Words", "a.csv", kHeader + "0,zero,0,0,0,0,0,1\n", "a.csv:2:", "'zero', expected a number"},
                    Refusal{"LongQuaternion", "a.csv", kHeader + "0,0,0,0,0,0,0,1.2\n", "a.csv:2:", "length 1.2"},
                    Refusal{"NoRows", "a.csv", kHeader, "scene.toml", "no rows"},
                    Refusal{"EmptyFile", "a.csv", "", "scene.toml", "no rows"},
                    Refusal{"ShortRow", "a.csv", kHeader + "0,0,0\n", "a.csv:2:", "3 numbers, expected 8"},
                    Refusal{"WrongHeader", "a.csv", "t,x,y,z\n" + kFirst, "a.csv:1:", "the header is 't,x,y,z'"},
                    Refusal{"OtherEnding", "a.txt", kHeader + kFirst, "scene.toml", "expected .csv or .json"},
                    Refusal{"BrokenJson", "a.json", "[{\n\"at_s\":", "a.json:2:", "no JSON"},
                    Refusal{"JsonOfNumbers", "a.json", "[1, 2]", "a.json:1:", "list of objects"},
                    Refusal{"MissingKey", "a.json", kFirstJson + "\n{\"at_s\":1}]", "a.json:2:", "no 'x'"},
                    Refusal{"UnknownKey", "a.json", "[\n{\"time\":1}]", "a.json:2:", "no key 'time'"},
                    Refusal{"SomeAngles", "a.json", kFirstJson + "\n" + R"({"at_s":1,"x":0,"y":0,"z":0,"qx":0,"qy":0,"qz":0,"qw":1,"fov_y_deg":9}])", "a.json:2:", "some rows only"}),
    [](const auto& each) { return each.param.name; });

TEST(Recording, OfTooManyRowsIsRefused) {
  std::string text = kHeader;
  for (int row = 0; row <= 20000; ++row) text += std::to_string(row) + ",0,0,0,0,0,0,1\n";
  const auto read = readWith("long.csv", text);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("more than 20000 rows"), std::string::npos);
}

TEST(CameraKeys, OfTwoPathsAreRefused) {
  const ScenarioFolder folder;
  const auto read = folder.read(changed(validScenario(), kCamera, "camera = { orbit = { radius = 3 }, gltf = \"man\" }"));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("'orbit' and 'gltf'"), std::string::npos) << read.error().message;
}

TEST(CameraKeys, OfAModelThatIsNotThereAreRefused) {
  const ScenarioFolder folder;
  const auto read = folder.read(changed(validScenario(), kCamera, "camera = { gltf = \"man\" }"));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("no [[model]] 'man'"), std::string::npos) << read.error().message;
}

TEST(CameraKeys, OfCutsMustRise) {
  const ScenarioFolder folder;
  const auto read = folder.read(changed(validScenario(), kCamera, "camera = { orbit = { radius = 3 }, cuts = [{ at_s = 1 }, { at_s = 1 }] }"));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("not after that of the cut before"), std::string::npos) << read.error().message;
}

}  // namespace
}  // namespace reprise
