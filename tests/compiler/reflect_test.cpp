// The interface that reflection tells is the one that the sources declare.
#include "compiler/source/reflect.h"

#include <gtest/gtest.h>

#include "compiler/source/compile.h"

namespace reprise {
namespace {

const std::string kHead = "#version 450\n";
const std::string kPlainVertex =
    "#version 450\nlayout(location = 0) in vec3 position;\nlayout(location = 0) out vec2 uv;\n"
    "void main() { uv = position.xy; gl_Position = vec4(position, 1.0); }\n";

std::vector<std::uint32_t> words(const std::string& text, const std::string& name) {
  const Result<CompiledShader> shader = compileText(text, name, {});
  REPRISE_CHECK(shader.ok(), formatError(shader.error()));
  return shader->words;
}

Result<ShaderInterface> reflect(const std::string& vertex, const std::string& fragment) {
  return reflectInterface(words(vertex, "a.vert"), words(fragment, "a.frag"));
}

// A fragment shader with `declarations` whose colour is `value`.
std::string fragmentWith(const std::string& declarations, const std::string& value) {
  return kHead + declarations + "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(" + value +
         "); }\n";
}

Error errorOf(const Result<ShaderInterface>& result) {
  if (!result.ok()) return result.error();
  ADD_FAILURE() << "reflected, though it should not";
  return {};
}

const BlockMember* memberOf(const std::vector<BlockMember>& members, const std::string& name) {
  for (const BlockMember& member : members) {
    if (member.name == name) return &member;
  }
  return nullptr;
}

TEST(Reflect, MarbleHasItsBlocksInputsAndOutput) {
  const std::filesystem::path folder = std::filesystem::path(REPRISE_SOURCE_DIR) / "shaders/marble";
  const Result<CompiledShader> vertex = compile(folder / "marble.vert", {});
  const Result<CompiledShader> fragment = compile(folder / "marble.frag", {});
  ASSERT_TRUE(vertex.ok() && fragment.ok());
  const Result<ShaderInterface> found = reflectInterface(vertex->words, fragment->words);
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  ASSERT_EQ(found->descriptors.size(), 1u);
  EXPECT_EQ(found->descriptors[0].name, "Scene");
  EXPECT_EQ(found->descriptors[0].stages, kStageVertex | kStageFragment);
  const BlockMember* matrix = memberOf(found->descriptors[0].members, "view_projection");
  ASSERT_NE(matrix, nullptr);
  EXPECT_EQ(matrix->matrix_stride, 16u);
  EXPECT_EQ(matrix->columns, 4);
  EXPECT_EQ(found->push_constant_name, "Object");
  EXPECT_NE(memberOf(found->push_constant_members, "model"), nullptr);
  EXPECT_FALSE(found->vertex_inputs.empty());
  ASSERT_EQ(found->outputs.size(), 1u);
  EXPECT_EQ(found->outputs[0].components, 4);
}

TEST(Reflect, JoinsAnImageAndASamplerAtOneBinding) {
  const Result<ShaderInterface> found =
      reflect(kPlainVertex, fragmentWith("layout(set = 0, binding = 2) uniform texture3D fog;\n"
                                         "layout(set = 0, binding = 2) uniform sampler fog_sampler;\n",
                                         "textureLod(sampler3D(fog, fog_sampler), vec3(0.5), 0.0).x"));
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  ASSERT_EQ(found->descriptors.size(), 1u);
  EXPECT_EQ(found->descriptors[0].name, "fog");
  EXPECT_EQ(found->descriptors[0].kind, DescriptorKind::kCombinedImageSampler);
  EXPECT_EQ(found->descriptors[0].dimension, ImageDimension::k3D);
}

TEST(Reflect, RefusesASamplerWhereAnotherShaderHasABlock) {
  const std::string message =
      errorOf(reflect(kPlainVertex, fragmentWith("layout(set = 0, binding = 2) uniform texture2D fog;\n"
                                                 "layout(set = 0, binding = 3) uniform sampler fog_sampler;\n"
                                                 "layout(set = 0, binding = 3) uniform Wind { float gust; } wind;\n",
                                                 "wind.gust * textureLod(sampler2D(fog, fog_sampler), vec2(0.5), 0.0).x")))
          .message;
  EXPECT_NE(message.find("binding 3"), std::string::npos) << message;
}

TEST(Reflect, FlattensStructsArraysAndMatrices) {
  const Result<ShaderInterface> found =
      reflect(kPlainVertex, fragmentWith("struct Light { vec3 place; float power; };\n"
                                         "layout(set = 1, binding = 3, std140) uniform Room {\n"
                                         "  mat3 turn; Light lamps[2]; float steps[4]; ivec2 grid[2][3]; "
                                         "layout(row_major) mat2x3 skew; uint last;\n"
                                         "} room;\n",
                                         "room.lamps[1].power + room.steps[2] + room.turn[1][1] + "
                                         "float(room.grid[1][2].x + room.last) + room.skew[1][2]"));
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  ASSERT_EQ(found->descriptors.size(), 1u);
  const Descriptor& room = found->descriptors[0];
  EXPECT_EQ(room.name, "Room");
  EXPECT_EQ(room.set, 1u);
  EXPECT_EQ(room.binding, 3u);
  EXPECT_EQ(room.stages, kStageFragment);
  const std::vector<BlockMember> expected = {
      {"turn", ScalarKind::kFloat, 3, 3, 0, 16, false, 0, 0},
      {"lamps[0].place", ScalarKind::kFloat, 3, 1, 48, 0, false, 0, 0},
      {"lamps[0].power", ScalarKind::kFloat, 1, 1, 60, 0, false, 0, 0},
      {"lamps[1].place", ScalarKind::kFloat, 3, 1, 64, 0, false, 0, 0},
      {"lamps[1].power", ScalarKind::kFloat, 1, 1, 76, 0, false, 0, 0},
      {"steps", ScalarKind::kFloat, 1, 1, 80, 0, false, 4, 16},
      {"grid[0]", ScalarKind::kInt, 2, 1, 144, 0, false, 3, 16},
      {"grid[1]", ScalarKind::kInt, 2, 1, 192, 0, false, 3, 16},
      {"skew", ScalarKind::kFloat, 3, 2, 240, 16, true, 0, 0},
      {"last", ScalarKind::kUint, 1, 1, 288, 0, false, 0, 0},
  };
  EXPECT_EQ(room.members, expected);
  EXPECT_EQ(room.size_bytes, 304u);
}

TEST(Reflect, TellsTheKindsOfImages) {
  const Result<ShaderInterface> found = reflect(
      kPlainVertex,
      fragmentWith(
          "layout(location = 0) in vec2 uv;\n"
          "layout(binding = 0) uniform sampler2D albedo;\nlayout(binding = 1) uniform samplerCube sky;\n"
          "layout(binding = 2) uniform texture2DArray sheets;\nlayout(binding = 4) uniform sampler "
          "smooth_sampler;\n"
          "layout(binding = 5) uniform sampler2D layers[3];\nlayout(binding = 6, r32f) uniform image2D "
          "store;\n"
          "layout(binding = 9) uniform sampler2D unused;\n",
          "texture(albedo, uv) + texture(sky, uv.xyx) + texture(sampler2DArray(sheets, smooth_sampler), "
          "uv.xyx) +"
          " texture(layers[1], uv) + imageLoad(store, ivec2(0))"));
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  const std::vector<Descriptor> expected = {
      {"albedo", 0, 0, 1, DescriptorKind::kCombinedImageSampler, ImageDimension::k2D, kStageFragment, 0, {}},
      {"sky", 0, 1, 1, DescriptorKind::kCombinedImageSampler, ImageDimension::kCube, kStageFragment, 0, {}},
      {"sheets", 0, 2, 1, DescriptorKind::kSampledImage, ImageDimension::k2DArray, kStageFragment, 0, {}},
      {"smooth_sampler", 0, 4, 1, DescriptorKind::kSampler, ImageDimension::kNone, kStageFragment, 0, {}},
      {"layers", 0, 5, 3, DescriptorKind::kCombinedImageSampler, ImageDimension::k2D, kStageFragment, 0, {}},
      {"store", 0, 6, 1, DescriptorKind::kStorageImage, ImageDimension::k2D, kStageFragment, 0, {}, ScalarKind::kFloat, false, false, "r32f"},
  };
  EXPECT_EQ(found->descriptors, expected);
}

TEST(Reflect, AVaryingMustMatchAndBothSidesAreNamed) {
  const Error type =
      errorOf(reflect(kPlainVertex, fragmentWith("layout(location = 0) in vec3 texel;\n", "texel, 1")));
  EXPECT_EQ(type.code, "source.interface");
  EXPECT_NE(type.message.find("vec3 \"texel\" at location 0"), std::string::npos) << type.message;
  EXPECT_NE(type.message.find("vec2 \"uv\" at location 0"), std::string::npos) << type.message;
  const Error place =
      errorOf(reflect(kPlainVertex, fragmentWith("layout(location = 5) in vec2 uv;\n", "uv, 1, 1")));
  EXPECT_EQ(place.code, "source.interface");
  EXPECT_NE(place.message.find("location 5"), std::string::npos) << place.message;
  EXPECT_NE(place.message.find("location 0"), std::string::npos) << place.message;
}

TEST(Reflect, AnUnusedFragmentInputNeedsNoPartner) {
  EXPECT_TRUE(reflect(kPlainVertex, fragmentWith("layout(location = 7) in vec3 unused;\n", "1")).ok());
}

TEST(Reflect, VaryingBlocksMatricesAndArraysMatchByLocation) {
  const std::string vertex = kHead +
                             "layout(location = 0) in vec3 position;\nlayout(location = 1) out Frame { mat3 "
                             "basis; vec2 uv[2]; } frame;\n"
                             "void main() { frame.basis = mat3(position.x); frame.uv[0] = frame.uv[1] = "
                             "position.xy; gl_Position = vec4(1); }\n";
  const std::string block = "layout(location = 1) in Frame { mat3 basis; vec2 uv[2]; } frame;\n";
  const Result<ShaderInterface> same = reflect(vertex, fragmentWith(block, "frame.basis[0], frame.uv[1].x"));
  EXPECT_TRUE(same.ok()) << formatError(same.error());
  EXPECT_TRUE(
      reflect(vertex, fragmentWith("layout(location = 5) in vec2 second_uv;\n", "second_uv, 1, 1")).ok());
  EXPECT_EQ(
      errorOf(reflect(vertex, fragmentWith("layout(location = 6) in vec2 beyond;\n", "beyond, 1, 1"))).code,
      "source.interface");
}

TEST(Reflect, TheStagesMustAgreeOnASharedBinding) {
  const std::string vertex = kHead +
                             "layout(location = 0) in vec3 position;\nlayout(binding = 0) uniform Scene { "
                             "mat4 view; vec4 tint; } scene;\n"
                             "void main() { gl_Position = scene.view * vec4(position, 1.0) + scene.tint; }\n";
  const Result<ShaderInterface> prefix = reflect(
      vertex, fragmentWith("layout(binding = 0) uniform Scene { mat4 view; } scene;\n", "scene.view[0]"));
  ASSERT_TRUE(prefix.ok()) << formatError(prefix.error());
  EXPECT_EQ(prefix->descriptors.at(0).members.size(), 2u);
  EXPECT_EQ(prefix->descriptors.at(0).size_bytes, 80u);
  const Error other = errorOf(reflect(
      vertex, fragmentWith("layout(binding = 0) uniform Scene { vec4 tint; } scene;\n", "scene.tint")));
  EXPECT_EQ(other.code, "source.interface");
  EXPECT_EQ(errorOf(reflect(vertex, fragmentWith("layout(binding = 0) uniform sampler2D albedo;\n",
                                                 "texture(albedo, vec2(0))")))
                .code,
            "source.interface");
  EXPECT_EQ(errorOf(reflect(vertex, fragmentWith("layout(binding = 1) uniform Scene { vec4 tint; } scene;\n",
                                                 "scene.tint")))
                .code,
            "source.interface")
      << "two blocks of one name cannot be bound by name";
}

TEST(Reflect, PushConstantsOfBothStagesBecomeOneList) {
  const std::string vertex =
      kHead +
      "layout(location = 0) in vec3 position;\nlayout(push_constant) uniform Object { mat4 model; } object;\n"
      "void main() { gl_Position = object.model * vec4(position, 1.0); }\n";
  const Result<ShaderInterface> apart = reflect(
      vertex, fragmentWith("layout(push_constant) uniform Paint { layout(offset = 64) vec4 tint; } paint;\n",
                           "paint.tint"));
  ASSERT_TRUE(apart.ok()) << formatError(apart.error());
  const std::vector<PushConstantRange> two = {{kStageVertex, 0, 64}, {kStageFragment, 64, 16}};
  EXPECT_EQ(apart->push_constants, two);
  ASSERT_EQ(apart->push_constant_members.size(), 2u);
  EXPECT_EQ(apart->push_constant_members[1].name, "tint");
  const Result<ShaderInterface> shared = reflect(
      vertex, fragmentWith("layout(push_constant) uniform Object { mat4 model; vec4 tint; } object;\n",
                           "object.tint + object.model[0]"));
  ASSERT_TRUE(shared.ok()) << formatError(shared.error());
  const std::vector<PushConstantRange> one = {{kStageVertex | kStageFragment, 0, 80}};
  EXPECT_EQ(shared->push_constants, one);
  EXPECT_EQ(
      errorOf(reflect(vertex, fragmentWith("layout(push_constant) uniform Paint { vec4 tint; } paint;\n",
                                           "paint.tint")))
          .code,
      "source.interface");
}

TEST(Reflect, SeesDepthDiscardAndSeveralOutputs) {
  const Result<ShaderInterface> found =
      reflect(kPlainVertex, kHead +
                                "layout(location = 0) in vec2 uv;\nlayout(location = 2) out uvec2 "
                                "id;\nlayout(location = 0) out vec4 color[2];\n"
                                "void main() { if (uv.x > 1.0) discard; color[0] = color[1] = vec4(1); id = "
                                "uvec2(3); gl_FragDepth = uv.y; }\n");
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  EXPECT_TRUE(found->writes_depth);
  EXPECT_TRUE(found->discards);
  const std::vector<FragmentOutput> expected = {{"color[0]", 0, ScalarKind::kFloat, 4},
                                                {"color[1]", 1, ScalarKind::kFloat, 4},
                                                {"id", 2, ScalarKind::kUint, 2}};
  EXPECT_EQ(found->outputs, expected);
  const Result<ShaderInterface> plain = reflect(kPlainVertex, fragmentWith("", "1"));
  ASSERT_TRUE(plain.ok());
  EXPECT_FALSE(plain->writes_depth || plain->discards);
}

TEST(Reflect, TellsTexelBuffersMultisampledAndComparingImages) {
  const auto found = reflect(kPlainVertex, fragmentWith("layout(binding = 0) uniform isamplerBuffer texels;\n"
                                                        "layout(binding = 1) uniform sampler2DMS samples;\n"
                                                        "layout(binding = 2) uniform sampler2DShadow shadow;\n",
                                                        "texelFetch(texels, 0) + texelFetch(samples, ivec2(0), 0) + texture(shadow, vec3(0))"));
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  ASSERT_EQ(found->descriptors.size(), 3u);
  EXPECT_EQ(found->descriptors[0].kind, DescriptorKind::kUniformTexelBuffer);
  EXPECT_EQ(found->descriptors[0].texel, ScalarKind::kInt);
  EXPECT_TRUE(found->descriptors[1].multisampled);
  EXPECT_TRUE(found->descriptors[2].compares);
}

TEST(Reflect, RefusesSubpassInputs) {
  EXPECT_EQ(errorOf(reflect(kPlainVertex, fragmentWith("layout(input_attachment_index = 0, binding = 0) uniform subpassInput last;\n",
                                                       "subpassLoad(last)")))
                .code,
            "shader.subpass_input");
}

TEST(Reflect, UnknownMembersCanBeSkipped) {
  const std::string fragment = fragmentWith("layout(binding = 0) buffer List { vec4 first; double wide; float items[]; } list;\n",
                                            "list.first + float(list.wide) + list.items[3]");
  const CompiledShader vertex_shader = compileText(kPlainVertex, "test.vert", {}).value(), fragment_shader = compileText(fragment, "test.frag", {}).value();
  const auto found = reflectInterface(vertex_shader.words, fragment_shader.words, {true});
  ASSERT_TRUE(found.ok()) << formatError(found.error());
  ASSERT_EQ(found->descriptors.size(), 1u);
  ASSERT_EQ(found->descriptors[0].members.size(), 2u);
  EXPECT_EQ(found->descriptors[0].members[0].name, "first");
  EXPECT_EQ(found->descriptors[0].members[1].name, "items");
  EXPECT_EQ(found->descriptors[0].members[1].array_length, 16u) << "an array without a size has some elements";
}

TEST(Reflect, RefusesWhatAnInterfaceCannotDescribe) {
  const std::string nonuniform = "#extension GL_EXT_nonuniform_qualifier : require\n";
  const std::string types = "#extension GL_EXT_shader_explicit_arithmetic_types : require\n";
  const std::vector<std::string> fragments = {
      fragmentWith(nonuniform + "layout(binding = 0) uniform sampler2D many[];\n",
                   "texture(many[int(gl_FragCoord.x)], vec2(0))"),
      fragmentWith("layout(binding = 0) buffer List { float items[]; } list;\n", "list.items[3]"),
      fragmentWith("layout(binding = 0) uniform Wide { double value; } wide;\n", "float(wide.value)"),
      fragmentWith(types + "layout(binding = 0) buffer Narrow { float16_t value; } narrow;\n",
                   "float(narrow.value)"),
      fragmentWith("struct S { vec4 v; };\nlayout(binding = 0) uniform Huge { S items[5000]; } huge;\n",
                   "huge.items[9].v"),
  };
  for (const std::string& fragment : fragments) {
    EXPECT_EQ(errorOf(reflect(kPlainVertex, fragment)).code, "source.unsupported") << fragment;
  }
  EXPECT_EQ(
      errorOf(reflect(kHead + "layout(location = 0) in mat4 turn;\nvoid main() { gl_Position = turn[0]; }\n",
                      fragmentWith("", "1")))
          .code,
      "source.unsupported");
}

TEST(Reflect, RefusesModulesOfTheWrongStage) {
  const std::vector<std::uint32_t> vertex = words(kPlainVertex, "a.vert");
  EXPECT_EQ(errorOf(reflectInterface(vertex, vertex)).code, "source.stage");
}

}  // namespace
}  // namespace reprise
