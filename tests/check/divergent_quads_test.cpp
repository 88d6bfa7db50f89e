// Which pixels are left out for a derivative that lanes of a quad reach apart.
#include "cli/check/divergent_quads.h"

#include <gtest/gtest.h>

#include "cli/check/frame_laws.h"
#include "cli/check/harness_program.h"
#include "compiler/strategies/build_package.h"

namespace reprise {
namespace {

constexpr const char* kHead =
    "#version 450\nlayout(set = 0, binding = 0) uniform Light { vec4 tint; } light;\nlayout(location = 0) in vec3 place;\n"
    "layout(location = 0) out vec4 color;\n";

class DivergentQuadsTest : public testing::Test {
 protected:
  ShaderProgram programOf(const std::string& body) {
    CompileOptions options;
    options.stage = ShaderStage::kFragment;
    return harnessProgram(compileText(kHead + ("void main() {\n" + body + "\n}\n"), "test.frag", options).value()).value();
  }

  // Of frame 0.
  std::vector<bool> divergentIn(const ShaderProgram& program) {
    const auto divergent = DivergentQuads::create(context_, commands_, program).value().find({}, 1);
    EXPECT_TRUE(divergent.ok()) << (divergent.ok() ? "" : formatError(divergent.error()));
    return divergent.ok() && !divergent->empty() ? divergent->front() : std::vector<bool>{};
  }

  std::vector<bool> coveredIn(const ShaderProgram& program) {
    Harness harness = Harness::create(context_, commands_, program.interface, {}).value();
    VariantOptions original;
    original.strategy = "original";
    Player player = harness.createPlayer(buildPackage(program, {}, original, {}).value(), true).value();
    const HarnessFrame frame = harness.play(player, {0, 1}).value();
    std::vector<bool> pixels(frame.depth.size());
    for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) pixels[pixel] = covered(frame, pixel);
    return pixels;
  }

  // `expected` of x and y, where anything is drawn.
  template <typename Expected>
  void expectDivergent(const std::string& body, const Expected& expected) {
    const ShaderProgram program = programOf(body);
    const std::vector<bool> divergent = divergentIn(program), drawn = coveredIn(program);
    ASSERT_EQ(divergent.size(), drawn.size());
    std::size_t left_out = 0;
    for (std::size_t pixel = 0; pixel < drawn.size(); ++pixel) {
      const std::size_t x = pixel % HarnessOptions{}.width, y = pixel / HarnessOptions{}.width;
      ASSERT_EQ(divergent[pixel], drawn[pixel] && expected(x, y)) << body << " at " << x << ", " << y;
      left_out += divergent[pixel] ? 1 : 0;
    }
    EXPECT_GT(left_out, 0u) << body;
  }

  Context context_ = Context::create({}).value();
  Commands commands_ = Commands::create(context_).value();
};

TEST_F(DivergentQuadsTest, AreThoseThatStraddleABranch) {
  expectDivergent("color = vec4(sin(place), 1); if (int(gl_FragCoord.x) % 8 < 3) color += dFdx(color) + dFdy(place.x);",
                  [](std::size_t x, std::size_t) { return x % 8 == 2 || x % 8 == 3; });
  expectDivergent("color = vec4(sin(place), 1); if (int(gl_FragCoord.x) % 2 == 1 && int(gl_FragCoord.y) % 4 == 3) color += dFdx(color);",
                  [](std::size_t, std::size_t y) { return y % 4 >= 2; });
}

TEST_F(DivergentQuadsTest, AreThoseThatLeaveALoopApart) {
  expectDivergent("vec4 c = vec4(sin(place), 1); for (int i = 0; i < int(gl_FragCoord.y) % 8 / 3; ++i) c += fwidth(c.yzwx * float(i + 2)); color = c;",
                  [](std::size_t, std::size_t y) { return y % 8 == 2 || y % 8 == 3; });
}

TEST_F(DivergentQuadsTest, AreThoseThatASwitchSplits) {
  expectDivergent("color = vec4(sin(place), 1); switch (int(gl_FragCoord.x) / 3 % 2) { case 0: color += fwidth(place.x); break; default: color += fwidth(place.y); }",
                  [](std::size_t x, std::size_t) { return x / 2 * 2 / 3 != (x / 2 * 2 + 1) / 3; });
}

TEST_F(DivergentQuadsTest, OtherBranchesDoNotCount) {
  expectDivergent("vec4 c = vec4(sin(place), 1); if (int(gl_FragCoord.y) % 4 < 3) c *= 2.0; if (int(gl_FragCoord.x) % 4 < 1) c += fwidth(place.x); color = c;",
                  [](std::size_t x, std::size_t) { return x % 4 < 2; });
}

TEST_F(DivergentQuadsTest, AreNoneWhereLanesStayTogether) {
  const ShaderProgram program = programOf("color = vec4(sin(place), 1); if (light.tint.x > 0.1) color += dFdx(color);");
  const auto divergent = DivergentQuads::create(context_, commands_, program).value().find({}, 1);
  ASSERT_TRUE(divergent.ok());
  EXPECT_TRUE(divergent->empty());
  EXPECT_EQ(divergenceNote(program, *divergent), "");
}

TEST_F(DivergentQuadsTest, TheNoteSaysWhereAndHowMany) {
  const ShaderProgram program = programOf("color = vec4(sin(place), 1);\nif (place.x > 0.1)\n  color += dFdx(color);");
  const std::string note = divergenceNote(program, {{true, false, true, true}, {true, false, false, false}});
  EXPECT_NE(note.find("up to 3 pixels"), std::string::npos) << note;
  EXPECT_NE(note.find("test.frag:8"), std::string::npos) << note;
}

// The kept depth and the discards are the original's, or it would mask what something else hides.
TEST_F(DivergentQuadsTest, AreThoseThatAreSeen) {
  expectDivergent("if (int(gl_FragCoord.y) / 2 % 2 == 0) discard; color = vec4(sin(place), 1); if (int(gl_FragCoord.x) % 8 < 3) color += dFdx(color);",
                  [](std::size_t x, std::size_t) { return x % 8 == 2 || x % 8 == 3; });
}

}  // namespace
}  // namespace reprise
