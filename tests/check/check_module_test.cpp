// The differential test itself: shaders that must pass, shaders that must be refused, and a rewrite that is wrong on purpose.
#include "cli/check/check_module.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>

#include "cli/check/harness_program.h"
#include "cli/check/module_player.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

class CheckModule : public testing::Test {
 protected:
  ModuleVerdict checkText(const std::string& text) {
    writeText(folder_ / "test.frag", text);
    CheckRequest request;
    request.path = (folder_ / "test.frag").string();
    return checkWith(request, REPRISE_EXECUTABLE);
  }

  ModuleVerdict checkWith(const CheckRequest& request, const std::string& executable) {
    CheckHooks hooks;
    hooks.enters = [](CheckStage) {};
    hooks.start_reference = [this, executable](const ReferenceModule& module) {
      ++references_;
      return startReferenceProcess(executable, module, request_timeout_s_);
    };
    return checkModule(request, hooks);
  }

  TemporaryFolder folder_;
  int references_ = 0;
  double request_timeout_s_ = 60;
};

constexpr const char* kHead = "#version 450\nlayout(location = 0) in vec3 place;\nlayout(location = 0) out vec4 color;\n";

TEST_F(CheckModule, VerifiesEveryStrategy) {
  const ModuleVerdict verdict = checkText(std::string(kHead) + "void main() { color = vec4(sin(place * 7.0) * exp(place.x), 1.0) * 0.5; }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kVerified) << verdict.code << ' ' << verdict.reason;
  EXPECT_EQ(verdict.variants, 6);
  EXPECT_EQ(references_, 1);
}

TEST_F(CheckModule, MakesUpInputsOfEveryKind) {
  const ModuleVerdict verdict = checkText(std::string(kHead) + R"(
layout(set = 0, binding = 0) uniform Light { vec4 colors[3]; ivec2 counts; mat3 turn; } light;
layout(set = 0, binding = 1) readonly buffer Data { vec4 head; float tail[]; } data;
layout(set = 1, binding = 0) uniform sampler2D flat_map;
layout(set = 1, binding = 1) uniform samplerCube sky;
layout(set = 1, binding = 2) uniform sampler3D volume;
layout(set = 1, binding = 3) uniform sampler2DArray sheets;
layout(set = 1, binding = 4) uniform sampler2DShadow shadow;
layout(set = 1, binding = 5) uniform isampler2D whole;
layout(set = 1, binding = 6) uniform samplerBuffer texels;
layout(set = 1, binding = 7) uniform texture2D image;
layout(set = 1, binding = 8) uniform sampler smooth_sampler;
layout(push_constant) uniform Push { float gain; } push;
layout(location = 1) flat in ivec2 index;
void main() {
  vec4 sum = texture(flat_map, place.xy) + texture(sky, place) + texture(volume, place) + texture(sheets, place) + texelFetch(texels, 3);
  sum += texture(shadow, place) + vec4(texelFetch(whole, ivec2(1), 0)) + texture(sampler2D(image, smooth_sampler), place.yz);
  sum += light.colors[light.counts.x % 3] + data.head * data.tail[2] + vec4(light.turn * place, float(index.x));
  color = sin(sum * push.gain * exp(place.x));
}
)");
  EXPECT_EQ(verdict.verdict, Verdict::kVerified) << verdict.code << ' ' << verdict.reason;
}

TEST_F(CheckModule, RefusesWhatCannotBeCached) {
  const ModuleVerdict writes = checkText(std::string(kHead) + "layout(binding = 0) buffer Log { float last; } log_block;\n"
                                                             "void main() { log_block.last = place.x; color = vec4(sin(place), 1.0); }\n");
  EXPECT_EQ(writes.verdict, Verdict::kRefused);
  EXPECT_EQ(writes.code, "shader.side_effects");
  const ModuleVerdict constant = checkText("#version 450\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
  EXPECT_EQ(constant.code, "candidate.none");
  EXPECT_EQ(references_, 0);
}

TEST_F(CheckModule, HoldsTheLawsWhereNothingCanShow) {
  const ModuleVerdict verdict = checkText(std::string(kHead) + "void main() { color = vec4(max(sin(place.x) - 5.0, 0.0)); }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kUnshown) << verdict.code << ' ' << verdict.reason;
  EXPECT_EQ(verdict.code, "image.constant");
  EXPECT_EQ(verdict.variants, 6);
}

TEST_F(CheckModule, SaysWhenInputsShowNothing) {
  const ModuleVerdict verdict = checkText(std::string(kHead) + "void main() { color = sqrt(vec4(-5.0 - sin(place.x))); }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kUntestable);
  EXPECT_EQ(verdict.code, "inputs.meaningless");
  EXPECT_NE(verdict.reason.find("not finite"), std::string::npos) << verdict.reason;
}

TEST_F(CheckModule, AModuleThatTakesItsProcessDownIsNoFaultOfOurs) {
  writeText(folder_ / "reference", "#!/bin/sh\nkill -SEGV $$\n");
  std::filesystem::permissions(folder_ / "reference", std::filesystem::perms::owner_all);
  writeText(folder_ / "test.frag", std::string(kHead) + "void main() { color = vec4(sin(place * 7.0) * exp(place.x), 1.0); }\n");
  CheckRequest request;
  request.path = (folder_ / "test.frag").string();
  const ModuleVerdict verdict = checkWith(request, (folder_ / "reference").string());
  EXPECT_EQ(verdict.verdict, Verdict::kUntestable);
  EXPECT_EQ(verdict.code, "original.crashed");
  EXPECT_NE(verdict.reason.find("signal 11"), std::string::npos) << verdict.reason;
  EXPECT_NE(verdict.reason.find("test.frag"), std::string::npos) << verdict.reason;
}

// The seed's own count may be any; a loop that runs 0 to 3 times is looked at in each of them.
TEST_F(CheckModule, CountsAreTriedInAllSmallValues) {
  const ModuleVerdict verdict =
      checkText(std::string(kHead) + "layout(set = 0, binding = 0) uniform Counts { int outer; int inner; } counts;\n"
                                     "void main() { float sum = exp(place.x); for (int i = 0; i < counts.outer; ++i) for (int j = 0; j < counts.inner; ++j) "
                                     "sum += sin(place.y * float(i * 3 + j)); color = vec4(sum); }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kVerified) << verdict.code << ' ' << verdict.reason;
}

// Where the device ends an endless loop the shader's other loops end with it, on either side as it happens.
TEST_F(CheckModule, EndlessLoopsAreTheShadersOwnFault) {
  const ModuleVerdict verdict = checkText(std::string(kHead) +
                                          "void main() {\n  float sum = 0.0;\n"
                                          "  for (int i = 0; i < 40; i += min(int(abs(place.x) * 50.0), 20)) sum += 0.01;\n"
                                          "  int key = int(place.y * 9.0) * 7;\n"
                                          "  do { sum += 10.0 + sin(float(key)); } while (sum < 100.0);\n"
                                          "  color = vec4(sum * exp(sin(float(key)) * 0.1) * exp(place.z * 0.1));\n}\n");
  EXPECT_EQ(verdict.verdict, Verdict::kUntestable) << verdict.code << ' ' << verdict.reason;
  EXPECT_EQ(verdict.code, "original.endless");
}

TEST_F(CheckModule, UndefinedValuesAreNothingToCompareWith) {
  const ModuleVerdict verdict = checkText(std::string(kHead) + "void main() { vec4 sum; sum.xyz += sin(place * 5.0); color = sum; }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kUntestable) << verdict.code << ' ' << verdict.reason;
  EXPECT_EQ(verdict.code, "inputs.undefined");
}

// Declared without a value and assigned on every way.
TEST_F(CheckModule, WhatOnlyLooksUndefinedIsCompared) {
  const ModuleVerdict verdict = checkText(std::string(kHead) + "void main() { vec4 sum; for (int i = 0; i < 9; ++i) { if (i == 0) sum = vec4(place, 1.0); "
                                                               "sum = sin(sum * 1.3 + float(i)); } color = sum; }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kVerified) << verdict.code << ' ' << verdict.reason;
}

TEST_F(CheckModule, BrokenSourceIsSaidToBeThat) {
  const ModuleVerdict verdict = checkText("#version 450\nvoid main() { nonsense }\n");
  EXPECT_EQ(verdict.verdict, Verdict::kUntestable);
  EXPECT_EQ(verdict.code, "source.syntax");
}

struct Made {
  CompiledShader fragment, vertex;
  ShaderProgram program;
};

Made makeWaves() {
  Made made;
  made.fragment = compileText(std::string(kHead) + "void main() { color = vec4(sin(place * 7.0) * exp(place.x), 1.0); }\n", "test.frag", {}).value();
  made.vertex = harnessVertex(made.fragment).value();
  made.program = harnessProgram(made.vertex, made.fragment).value();
  return made;
}

// One wrong constant in the prepared module stands for a preparation that is wrong: all variants would agree with it.
TEST(Laws, ConvictAWrongPreparation) {
  const Context context = Context::create({}).value();
  Commands commands = Commands::create(context).value();
  for (const bool wrong : {false, true}) {
    Made made = makeWaves();
    PreparedShader prepared = *made.program.fragment;
    for (Instruction& global : prepared.module.globals)
      if (wrong && global.opcode == spv::Op::OpConstant && global.word(0) == std::bit_cast<std::uint32_t>(7.0f)) global.operands[0].words[0] = std::bit_cast<std::uint32_t>(7.125f);
    made.program.fragment = std::make_shared<const PreparedShader>(std::move(prepared));
    const auto reference = startReferenceProcess(REPRISE_EXECUTABLE, {"test.frag", "", made.vertex.words, made.fragment.words}, 60);
    ASSERT_TRUE(reference.ok());
    ModulePlayer player(context, commands, made.program, *reference);
    ASSERT_TRUE(player.setInputs({}).ok());
    OriginalFrames frames([&](bool no_contraction) { return player.originals(no_contraction); });
    const auto held = holdPrepared(frames, player.terms(nullptr, ""), Computation::kUnknown);
    ASSERT_TRUE(held.ok()) << held.error().message;
    EXPECT_EQ(held->judgement, wrong ? RoundingJudgement::kOurs : RoundingJudgement::kEqual);
  }
}

// Hits with wrong payloads stand for a rewrite that is wrong: the frozen world must not be exact then.
TEST(Laws, NoticeAPoisonedCache) {
  const ShaderProgram program = makeWaves().program;
  const std::vector<Candidate> candidates = enumerateCandidates(*program.fragment, program.analysis, program.sources, {});
  ASSERT_FALSE(candidates.empty());
  const Context context = Context::create({}).value();
  Commands commands = Commands::create(context).value();
  Harness harness = Harness::create(context, commands, program.interface, {}).value();
  VariantOptions options;
  options.filter = Filter::kNearest;
  options.encoding = Encoding::kRgba32f;
  options.instrumented = true;
  options.ranges = {0.3f, 20, {}, {}};
  for (const bool poisoned : {false, true}) {
    options.poisoned = poisoned;
    const Package package = buildPackage(program, candidates.front(), options, {true, true, true}).value();
    Player original = harness.createPlayer(package, true).value(), variant = harness.createPlayer(package, false).value();
    const HarnessFrame expected = harness.play(original, {0, 1}).value();
    harness.play(variant, {0, 4}).value();
    const HarnessFrame played = harness.play(variant, {0, 4}).value();
    EXPECT_GT(countKind(played, 1), 500u);
    const auto violation = findViolation(expected, played, {"law.frozen_world", ExactPixels::kAll, 0, {}});
    EXPECT_EQ(violation.has_value(), poisoned) << (violation ? violation->expected + " / " + violation->found : "");
  }
}

}  // namespace
}  // namespace reprise
