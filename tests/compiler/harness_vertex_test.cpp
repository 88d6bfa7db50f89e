// The vertex shader that is made up for a fragment shader fits it.
#include <gtest/gtest.h>

#include "compiler/source/compile.h"
#include "compiler/source/harness_vertex.h"
#include "compiler/source/reflect.h"

namespace reprise {
namespace {

CompiledShader fragmentWith(const std::string& declarations, const std::string& color) {
  return compileText("#version 450\n" + declarations + "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(" + color + "); }\n",
                     "test.frag", {})
      .value();
}

// The interface of the fragment shader with the vertex shader made for it.
Result<ShaderInterface> interfaceOf(const CompiledShader& fragment) {
  REPRISE_ASSIGN(const std::string text, harnessVertexText(fragment.words));
  REPRISE_ASSIGN(const CompiledShader vertex, compileText(text, "harness.vert", {}));
  return reflectInterface(vertex.words, fragment.words);
}

TEST(HarnessVertex, GivesVaryingsOfEveryType) {
  const CompiledShader fragment = fragmentWith(
      "layout(location = 0) in float a;\nlayout(location = 0, component = 1) in vec2 b;\nlayout(location = 1) flat in ivec3 c;\n"
      "layout(location = 2) in mat3 d;\nlayout(location = 5) in vec2 e[2];\nlayout(location = 7) flat in uint f;\n"
      "layout(location = 8) flat in dvec2 g;\nlayout(location = 9) in Block { vec4 h; noperspective float i; } block;\n",
      "a + b.x + float(c.x) + d[1].y + e[1].x + float(f) + float(g.x) + block.h.x + block.i");
  const auto interface = interfaceOf(fragment);
  ASSERT_TRUE(interface.ok()) << formatError(interface.error());
}

TEST(HarnessVertex, TakesTheFirstSetThatIsFree) {
  const auto interface = interfaceOf(fragmentWith("layout(set = 2, binding = 1) uniform Light { vec4 value; } light;\n", "light.value"));
  ASSERT_TRUE(interface.ok()) << formatError(interface.error());
  ASSERT_EQ(interface->descriptors.size(), 2u);
  EXPECT_EQ(interface->descriptors[1].name, "HarnessScene");
  EXPECT_EQ(interface->descriptors[1].set, 3u);
}

TEST(HarnessVertex, KeepsIntegersWithinArraysOfDescriptors) {
  const CompiledShader fragment = fragmentWith("layout(location = 3) flat in int which;\nlayout(binding = 0) uniform sampler2D maps[3];\n",
                                               "texture(maps[which], vec2(0.5))");
  const auto text = harnessVertexText(fragment.words);
  ASSERT_TRUE(text.ok());
  EXPECT_NE(text->find("% 3u"), std::string::npos);
  EXPECT_NE(text->find("= int(wholeIndex(12u))"), std::string::npos);
  EXPECT_TRUE(interfaceOf(fragment).ok());
}

}  // namespace
}  // namespace reprise
