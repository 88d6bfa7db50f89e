// Packages whose hashes are right and whose content is not, as somebody who forges one would make them.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "runtime/base/file.h"
#include "runtime/base/hash.h"
#include "tests/compiler/scratch_directory.h"
#include "tests/runtime/sample_package.h"

namespace reprise {
namespace {

using nlohmann::json;

class ForgedPackage : public testing::Test {
 protected:
  void SetUp() override {
    const Result<void> written = writePackageFiles(twoPassPackage(), scratch_.path());
    ASSERT_TRUE(written.ok()) << formatError(written.error());
    whole_ = *readFile(scratch_.path() / "manifest.json");
    ASSERT_EQ(errorWith([](json&) {}).code, "none");
  }

  // The error of reading the package with its manifest's body edited and hashed again.
  Error errorWith(const std::function<void(json&)>& edit) const {
    json document = json::parse(whole_);
    edit(document["package"]);
    document["hash"] = contentHash(document["package"].dump());
    scratch_.write("manifest.json", document.dump());
    return error();
  }
  Error error() const {
    const Result<Package> read = readPackage(scratch_.path());
    return read.ok() ? Error{ErrorKind::kInput, "none", "the package was read", {}} : read.error();
  }

  ScratchDirectory scratch_;
  std::string whole_;
};

TEST_F(ForgedPackage, EveryKeyIsNeededAndHasAType) {
  const json variant = json::parse(whole_)["package"]["variant"];
  for (const auto& [name, value] : variant.items()) {
    const std::string key = name;
    EXPECT_EQ(errorWith([&](json& body) { body["variant"].erase(key); }).code, "package.manifest") << key;
    EXPECT_EQ(errorWith([&](json& body) { body["variant"][key] = json::object({{"unexpected", -1.5}}); }).code, "package.manifest")
        << key;
  }
}

TEST_F(ForgedPackage, NumbersOutOfRangeAreRefusedByName) {
  for (const json& number : {json(-1), json(2.5), json(1e300), json(1ull << 40), json(true), json("1")}) {
    const Error refused = errorWith([&](json& body) { body["variant"]["reprise_set"] = number; });
    EXPECT_EQ(refused.code, "package.manifest") << number;
    EXPECT_NE(refused.message.find("reprise_set"), std::string::npos) << refused.message;
  }
}

TEST_F(ForgedPackage, UnknownSpellingsAreRefusedByName) {
  const std::pair<const char*, const char*> spellings[] = {{"/variant/pattern", "spiral"},
                                                           {"/variant/previous", "third_eye"},
                                                           {"/variant/passes/0/depth", "never"},
                                                           {"/variant/passes/0/colors/0/load", "keep"},
                                                           {"/variant/resources/0/lifetime", "for ever"},
                                                           {"/interface/outputs/0/scalar", "double"}};
  for (const auto& [place, text] : spellings) {
    const Error refused = errorWith([where = place, what = text](json& body) { body[json::json_pointer(where)] = what; });
    EXPECT_EQ(refused.code, "package.manifest") << text;
    EXPECT_NE(refused.message.find(text), std::string::npos) << refused.message;
  }
}

TEST_F(ForgedPackage, OlderAndNewerFormatsAreToldFromDamage) {
  for (const int version : {kRecipeFormatVersion - 1, kRecipeFormatVersion + 1}) {
    const Error refused = errorWith([&](json& body) { body["format_version"] = version; });
    EXPECT_EQ(refused.code, "package.version");
    EXPECT_NE(refused.message.find("format " + std::to_string(version) + ","), std::string::npos) << refused.message;
  }
}

TEST_F(ForgedPackage, DeepNestingIsRefusedBeforeItFillsTheStack) {
  const std::string deep = std::string(2'000'000, '[') + std::string(2'000'000, ']');
  scratch_.write("manifest.json", R"({"hash": "", "package": {"format_version": 1, "extra": )" + deep + "}}");
  EXPECT_EQ(error().code, "package.manifest");
}

TEST_F(ForgedPackage, ModuleNamesDoNotLeaveTheFolder) {
  for (const char* name : {"../fragment", "/fragment", "a\\b", "", "."})
    EXPECT_EQ(errorWith([&](json& body) { body["variant"]["modules"][0]["name"] = name; }).code, "package.inconsistent") << name;
}

TEST_F(ForgedPackage, ModulesThatAreNoSpirvAreRefused) {
  const std::string bytes = "these bytes are text, not code..";
  scratch_.write("fragment.spv", bytes);
  const Error refused = errorWith([&](json& body) {
    for (const char* recipe : {"original", "variant"})
      for (json& entry : body[recipe]["modules"])
        if (entry["name"] == "fragment") entry["hash"] = contentHash(bytes);
  });
  EXPECT_EQ(refused.code, "package.inconsistent");
  EXPECT_EQ(refused.place.file, (scratch_.path() / "fragment.spv").string());
}

TEST_F(ForgedPackage, TheHashesOfBothRecipesAreChecked) {
  for (const char* recipe : {"original", "variant"})
    EXPECT_EQ(errorWith([&](json& body) { body[recipe]["modules"][0]["hash"] = std::string(32, '0'); }).code, "package.tampered");
}

// One contradiction in an otherwise sound package.
struct Contradiction {
  const char* what;
  void (*apply)(Recipe&);
};

// A third pass, of tiles, in a rendering of its own: sound as it is.
Recipe& addTiles(Recipe& recipe) {
  recipe.flags = MissFlagging::kTiles;
  recipe.requirements.fragment_stores = recipe.requirements.shared_inputs = true;
  Pass tiles = recipe.passes.back();
  tiles.name = "tiles";
  tiles.kind = PassKind::kTiles;
  tiles.rendering = recipe.passes.back().rendering + 1;
  tiles.depth = DepthUse::kNone;
  recipe.passes.push_back(tiles);
  return recipe;
}

// A third pass, of flagged objects, in a rendering of its own: sound as it is.
Recipe& addFlaggedObjects(Recipe& recipe) {
  recipe.flags = MissFlagging::kDraws;
  recipe.requirements.fragment_stores = recipe.requirements.conditional_rendering = true;
  Pass again = recipe.passes.back();
  again.name = "again";
  again.rendering = recipe.passes.back().rendering + 1;
  again.objects = PassObjects::kFlagged;
  recipe.passes.push_back(again);
  return recipe;
}

const Contradiction kContradictions[] = {
    {"a thousand passes", [](Recipe& recipe) { recipe.passes.resize(1000, recipe.passes[0]); }},
    {"unknown resource written", [](Recipe& recipe) { recipe.passes[0].colors[1].resource = "nonesuch"; }},
    {"binding too low", [](Recipe& recipe) { recipe.passes[0].reads[0].binding = 1; }},
    {"one binding twice", [](Recipe& recipe) { recipe.passes[0].reads.push_back(recipe.passes[0].reads[0]); }},
    {"location out of range", [](Recipe& recipe) { recipe.passes[0].colors[0].location = -1; }},
    {"one location twice",
     [](Recipe& recipe) {
       for (Pass& pass : recipe.passes) pass.colors[1].location = 0;
     }},
    {"different attachments in a rendering", [](Recipe& recipe) { recipe.passes[1].colors.pop_back(); }},
    {"reads what it writes", [](Recipe& recipe) { recipe.passes[0].reads[0].current = true; }},
    {"reads before writing", [](Recipe& recipe) { recipe.resources[0].lifetime = Lifetime::kFrame; }},
    {"filtered integers", [](Recipe& recipe) { recipe.resources[0].format = ResourceFormat::kRg32Uint; }},
    {"reads without a set", [](Recipe& recipe) { recipe.uses_reprise_set = false; }},
    {"rendering that comes back",
     [](Recipe& recipe) {
       recipe.passes.push_back(recipe.passes[0]);
       recipe.passes[1].rendering = 1;
     }},
    {"stencil that is not required", [](Recipe& recipe) { recipe.passes[0].stencil = StencilUse::kMarkIfZero; }},
    {"other eye in a pattern that spreads over frames",
     [](Recipe& recipe) {
       recipe.previous = PreviousImage::kOtherEye;
       recipe.period_frames = 2;
     }},
    {"other eye at another period",
     [](Recipe& recipe) {
       recipe.previous = PreviousImage::kOtherEye;
       recipe.pattern = PatternKind::kWhole;
       recipe.period_frames = 4;
     }},
    {"frames without a pass",
     [](Recipe& recipe) {
       for (Pass& pass : recipe.passes) pass.frames = PassFrames::kWhollyDue;
     }},
    {"block of one", [](Recipe& recipe) { recipe.block_pixels = 1; }},
    {"set out of range", [](Recipe& recipe) { recipe.reprise_set = 4000000000u; }},
    {"scale of zero", [](Recipe& recipe) { recipe.resources[0].scale = 0; }},
    {"attachment of another size", [](Recipe& recipe) { recipe.resources[0].scale = 0.5f; }},
    {"one name for two resources", [](Recipe& recipe) { recipe.resources.push_back(recipe.resources[0]); }},
    {"previous block too large", [](Recipe& recipe) { recipe.previous_inputs[0].size_bytes = 1u << 31; }},
    {"previous block at a read's binding", [](Recipe& recipe) { recipe.previous_inputs[0].reprise_binding = 2; }},
    {"push constants twice", [](Recipe& recipe) { recipe.previous_inputs.push_back(recipe.previous_inputs[1]); }},
    {"pass that this version does not play", [](Recipe& recipe) { recipe.passes[0].kind = PassKind::kDispatch; }},
    {"read at the binding of the flags", [](Recipe& recipe) { recipe.passes[0].reads[0].binding = kFlagsBinding; }},
    {"flags without a requirement", [](Recipe& recipe) { recipe.flags = MissFlagging::kTiles; }},
    {"tiles that are not flagged", [](Recipe& recipe) { addTiles(recipe).flags = MissFlagging::kDraws; }},
    {"objects that are not flagged", [](Recipe& recipe) { addFlaggedObjects(recipe).flags = MissFlagging::kTiles; }},
    {"flagged objects without conditional rendering", [](Recipe& recipe) { addFlaggedObjects(recipe).requirements.conditional_rendering = false; }},
    {"flagged tiles", [](Recipe& recipe) { addFlaggedObjects(recipe).passes.back().kind = PassKind::kTiles; }},
    {"flagged objects before any draw",
     [](Recipe& recipe) {
       addFlaggedObjects(recipe);
       for (std::size_t i = 0; i + 1 < recipe.passes.size(); ++i) recipe.passes[i].frames = PassFrames::kWhollyDue;
     }},
    {"flagged objects in a rendering with others", [](Recipe& recipe) { addFlaggedObjects(recipe).passes.back().rendering = recipe.passes[0].rendering; }},
    {"tiles whose inputs need not be shared", [](Recipe& recipe) { addTiles(recipe).requirements.shared_inputs = false; }},
    {"tiles before any draw",
     [](Recipe& recipe) {
       addTiles(recipe);
       for (std::size_t i = 0; i + 1 < recipe.passes.size(); ++i) recipe.passes[i].frames = PassFrames::kWhollyDue;
     }},
    {"tiles in a rendering with others", [](Recipe& recipe) { addTiles(recipe).passes.back().rendering = recipe.passes[0].rendering; }}};

TEST(ContradictingPackage, IsFoundInMemory) {
  for (const Contradiction& contradiction : kContradictions) {
    Package package = twoPassPackage();
    ASSERT_TRUE(checkPackage(package).ok());
    contradiction.apply(package.variant);
    const Result<void> checked = checkPackage(package);
    ASSERT_FALSE(checked.ok()) << contradiction.what;
    EXPECT_EQ(checked.error().code, "package.inconsistent") << contradiction.what;
  }
}

TEST(ContradictingPackage, TilesAndFlaggedObjectsAfterADrawAreNone) {
  for (Recipe& (*add)(Recipe&) : {addTiles, addFlaggedObjects}) {
    Package package = twoPassPackage();
    add(package.variant);
    const Result<void> checked = checkPackage(package);
    EXPECT_TRUE(checked.ok()) << formatError(checked.error());
  }
}

TEST(ContradictingPackage, TheOriginalIsCheckedToo) {
  Package package = twoPassPackage();
  package.original.passes[0].vertex_module = "nonesuch";
  EXPECT_FALSE(checkPackage(package).ok());
}

}  // namespace
}  // namespace reprise
