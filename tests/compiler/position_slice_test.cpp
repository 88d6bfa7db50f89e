// What gl_Position reads, found in the text of vertex shaders.
#include <gtest/gtest.h>

#include "compiler/ir/inline_calls.h"
#include "compiler/ir/optimize.h"
#include "compiler/transforms/position_slice.h"
#include "compiler/transforms/type_size.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

Module vertexOf(const std::string& globals, const std::string& body) {
  return inlineCalls(moduleOf("#version 450\n" + globals + "layout(location = 0) in vec3 position;\nlayout(location = 0) out vec3 place;\nvoid main() {\n" +
                                  body + "\n}\n", "test.vert")).value();
}

std::vector<PositionInput> inputsOf(const std::string& globals, const std::string& body) { return positionInputs(vertexOf(globals, body)).value(); }

const std::string kScene = "layout(set = 1, binding = 2) uniform Scene { vec4 sun; mat4 view_projection; float time; } scene;\n";

TEST(PositionInputs, AreNoneOfAPositionFromTheVertexAlone) {
  EXPECT_TRUE(inputsOf("", "gl_Position = vec4(position.xy * 2.0 - 1.0, 0.5, 1.0); place = position;").empty());
  EXPECT_TRUE(inputsOf("", "gl_Position = vec4(float(gl_VertexIndex & 2) * 2.0 - 1.0, float(gl_VertexIndex & 1) * 4.0 - 1.0, 0.0, 1.0);").empty());
}

TEST(PositionInputs, LeaveOutWhatOnlyVaryingsRead) {
  EXPECT_TRUE(inputsOf(kScene, "gl_Position = vec4(position, 1.0); place = scene.sun.xyz * scene.time;").empty());
}

TEST(PositionInputs, NameTheMembersThatAreRead) {
  const std::vector<PositionInput> inputs = inputsOf(kScene, "gl_Position = scene.view_projection * vec4(position, 1.0); place = scene.sun.xyz * scene.time;");
  ASSERT_EQ(inputs.size(), 1u);
  EXPECT_EQ(inputs[0].source, PositionSource::kUniformBlock);
  EXPECT_EQ(inputs[0].name, "Scene");
  EXPECT_EQ(inputs[0].set, 1u);
  EXPECT_EQ(inputs[0].binding, 2u);
  EXPECT_EQ(inputs[0].read, (std::vector<ByteRange>{{16, 64}}));
}

TEST(PositionInputs, NameMembersOfStructsAndWholeArrays) {
  const std::vector<PositionInput> inputs =
      inputsOf("struct View { vec4 eye; mat4 matrix; };\nlayout(push_constant) uniform Draw { vec4 tint; View view; mat4 bones[3]; } draw;\n",
               "gl_Position = draw.view.matrix * draw.bones[gl_VertexIndex % 3] * vec4(position, 1.0);");
  ASSERT_EQ(inputs.size(), 1u);
  EXPECT_EQ(inputs[0].source, PositionSource::kPushConstants);
  EXPECT_EQ(inputs[0].name, "Draw");
  EXPECT_EQ(inputs[0].read, (std::vector<ByteRange>{{32, 64}, {96, 192}}));
}

TEST(PositionInputs, CountWhatDecidesAndWhatFunctionsRead) {
  EXPECT_EQ(inputsOf(kScene, "gl_Position = vec4(position, 1.0); if (scene.time > 1.0) gl_Position.x += 0.5;").size(), 1u);
  EXPECT_EQ(inputsOf(kScene + "vec4 placed(vec3 p) { if (p.x > 0.0) return scene.sun; return vec4(p, 1.0); }\n", "gl_Position = placed(position);").size(), 1u);
}

TEST(PositionInputs, TellOfBuffersAndTextures) {
  const std::vector<PositionInput> buffer = inputsOf("layout(set = 0, binding = 3) readonly buffer Instances { mat4 model[]; } instances;\n",
                                                     "gl_Position = instances.model[gl_InstanceIndex] * vec4(position, 1.0);");
  ASSERT_EQ(buffer.size(), 1u);
  EXPECT_EQ(buffer[0].source, PositionSource::kOther);
  EXPECT_EQ(buffer[0].binding, 3u);
  const std::vector<PositionInput> texture = inputsOf("layout(set = 0, binding = 0) uniform sampler2D heights;\n",
                                                      "gl_Position = vec4(position + textureLod(heights, position.xy, 0.0).rgb, 1.0);");
  ASSERT_EQ(texture.size(), 1u);
  EXPECT_EQ(texture[0].source, PositionSource::kOther);
  EXPECT_EQ(texture[0].name, "heights");
}

TEST(PositionInputs, AreRefusedWithoutAPosition) {
  const Module stripped = stripForShipping(vertexOf("", "place = position;")).value();
  const auto inputs = positionInputs(removeDeadCode(stripped).value());
  ASSERT_FALSE(inputs.ok());
  EXPECT_EQ(inputs.error().code, "vertex.no_position");
}

// Rows lie a stride apart where the matrix is row-major: four of them in a mat3x4, which has three columns.
TEST(BlockSizes, FollowTheOrderOfMatrices) {
  const auto sizeOfBlock = [](const std::string& layout) {
    const Module vertex = vertexOf("layout(set = 0, binding = 0, " + layout + ") uniform Scene { mat3x4 turn; } scene;\n",
                                   "gl_Position = vec4(scene.turn[0] * position.x);");
    for (const Instruction& global : vertex.globals)
      if (global.opcode == spv::Op::OpTypeStruct && nameOf(vertex, global.result_id) == "Scene") return sizeOf(vertex, global.result_id);
    return 0u;
  };
  EXPECT_EQ(sizeOfBlock("column_major"), 48u);
  EXPECT_EQ(sizeOfBlock("row_major"), 64u);
}

}  // namespace
}  // namespace reprise
