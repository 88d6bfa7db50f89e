// The reference's process: what goes through its pipes, NoContraction in the words, and modules that take it down.
#include "cli/check/reference/reference.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>

#include "cli/check/harness_program.h"
#include "cli/check/reference/no_contraction.h"
#include "cli/check/reference/reference_messages.h"
#include "cli/check/reference/time_limit.h"
#include "compiler/ir/reproducible.h"
#include "compiler/source/validate.h"
#include "tests/e2e/run_command.h"

namespace reprise {
namespace {

TEST(ReferenceMessages, ComeBackAsTheyWere) {
  const ReferenceModule module{"a \"b\".frag", "some device", {1, 2}, {3, 4, 5}};
  const ReferenceModule module_back = moduleFrom(messageOf(module));
  EXPECT_EQ(module_back.path, module.path);
  EXPECT_EQ(module_back.device, module.device);
  EXPECT_EQ(module_back.vertex_words, module.vertex_words);
  EXPECT_EQ(module_back.fragment_words, module.fragment_words);
  ReferenceAsk ask;
  ask.inputs.seed = 9;
  ask.frames = 4;
  ask.no_contraction = true;
  IntegerInput input;
  input.kind = IntegerInput::Kind::kBlock;
  input.set = 1, input.binding = 2, input.offsets = {4, 20};
  ask.inputs.integers = {{input, 3}, {IntegerInput{}, 1}};
  const ReferenceAsk ask_back = askFrom(messageOf(ask));
  EXPECT_EQ(ask_back.inputs.seed, 9u);
  EXPECT_EQ(ask_back.frames, 4);
  EXPECT_TRUE(ask_back.no_contraction);
  EXPECT_EQ(ask_back.inputs.integers, ask.inputs.integers);
  HarnessFrame frame;
  frame.colors = {{1, 2, 3, 4}, {5, 6, 7, 8}};
  frame.depth = {9};
  const auto answer = answerFrom(messageOf(std::vector<HarnessFrame>{frame, frame}));
  ASSERT_TRUE(answer.ok());
  ASSERT_EQ(answer->size(), 2u);
  EXPECT_EQ(answer->back().colors, frame.colors);
  EXPECT_EQ(answer->back().depth, frame.depth);
  const auto error = answerFrom(messageOf(Result<std::vector<HarnessFrame>>(Error{ErrorKind::kMachine, "device.lost", "gone", {}})));
  ASSERT_FALSE(error.ok());
  EXPECT_EQ(error.error().code, "device.lost");
  EXPECT_EQ(error.error().kind, ErrorKind::kMachine);
}

std::vector<std::uint32_t> wordsOf(const std::string& text) {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  return compileText(text, "test.frag", options).value().words;
}

TEST(NoContraction, InTheWordsIsThatOfOurIr) {
  for (const char* text : {"#version 450\nlayout(location = 0) in vec3 a;\nlayout(location = 0) out vec4 c;\n"
                           "float f(vec3 v) { return dot(v, v.zyx) - mod(v.x, 0.3); }\n"
                           "void main() { precise vec3 p = a * 2.0 + a; mat3 m = outerProduct(a, p); c = vec4(mix(m * a, a * m, f(-p)) / 3.0, f(p)); }\n",
                           "#version 450\nlayout(location = 0) out vec4 c;\nvoid main() { c = vec4(1.0); }\n",
                           "#version 450\nlayout(location = 0) flat in int a;\nlayout(location = 0) out vec4 c;\nvoid main() { c = vec4(a + 1); }\n"}) {
    const std::vector<std::uint32_t> given = wordsOf(text);
    const std::vector<std::uint32_t> strict = withNoContraction(given);
    EXPECT_TRUE(validateModule(strict).ok());
    EXPECT_TRUE(readModule(strict).value() == withoutContraction(readModule(given).value())) << text;
  }
}

TEST(TimeLimit, CountsTheWorkThatAProcessDoesItself) {
  EXPECT_FALSE(isOverTime(59, 59, 60));
  EXPECT_TRUE(isOverTime(61, 61, 60));
  EXPECT_FALSE(isOverTime(200, 30, 60));  // it waited for a core
  EXPECT_TRUE(isOverTime(241, 1, 60));    // it waits for nothing
  EXPECT_FALSE(isOverTime(10, 100, 60));  // on many cores
  EXPECT_GE(workedSeconds(::getpid()), 0);
}

class ReferenceProcess : public testing::Test {
 protected:
  // What comes of a reference that does this.
  Error errorOf(const std::string& script) {
    writeText(folder_ / "reference", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(folder_ / "reference", std::filesystem::perms::owner_all);
    const auto reference = startReferenceProcess((folder_ / "reference").string(), {"some.frag", "", {}, {}}, 1);
    if (!reference.ok()) return reference.error();
    const auto frames = (*reference)({});
    return frames.ok() ? Error{} : frames.error();
  }

  TemporaryFolder folder_;
};

TEST_F(ReferenceProcess, TellsTheSignalThatTheModuleAloneEndsIn) {
  const Error error = errorOf("kill -SEGV $$");
  EXPECT_EQ(error.code, "original.crashed");
  EXPECT_NE(error.message.find("signal 11"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("some.frag"), std::string::npos) << error.message;
}

TEST_F(ReferenceProcess, HalfAnAnswerIsACrash) {
  EXPECT_EQ(errorOf("head -c 16 > /dev/null\nprintf 'nonsense'\nexit 3").code, "original.crashed");
}

TEST_F(ReferenceProcess, AHangIsEnded) { EXPECT_EQ(errorOf("exec sleep 60").code, "original.hung"); }

TEST(Reference, ShowsTheModuleAsGiven) {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;
  const CompiledShader fragment =
      compileText("#version 450\nlayout(location = 0) in vec3 place;\nlayout(location = 0) out vec4 color;\n"
                  "void main() { color = vec4(0.25, place.x > 0.0 ? 0.5 : 0.75, 0.125, 1.0); }\n", "test.frag", options).value();
  const CompiledShader vertex = harnessVertex(fragment).value();
  const auto reference = startReferenceProcess(REPRISE_EXECUTABLE, {"test.frag", "", vertex.words, fragment.words}, 60);
  ASSERT_TRUE(reference.ok());
  for (const bool no_contraction : {false, true}) {
    const auto frames = (*reference)({{}, 2, no_contraction});
    ASSERT_TRUE(frames.ok()) << frames.error().message;
    ASSERT_EQ(frames->size(), 2u);
    const HarnessFrame& frame = frames->front();
    ASSERT_EQ(frame.colors.size(), 1u);
    ASSERT_EQ(frame.colors[0].size(), 4 * frame.depth.size());
    std::size_t drawn = 0;
    for (std::size_t pixel = 0; pixel < frame.depth.size(); ++pixel) {
      if (frame.depth[pixel] == 0x3f800000u) continue;
      ++drawn;
      EXPECT_EQ(frame.colors[0][4 * pixel], 0x3e800000u);
      EXPECT_EQ(frame.colors[0][4 * pixel + 2], 0x3e000000u);
    }
    EXPECT_GT(drawn, 400u);
  }
}

}  // namespace
}  // namespace reprise
