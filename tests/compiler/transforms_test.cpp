// Bodies with the payload given and handed out, and the vertex shader that knows where it was.
#include <gtest/gtest.h>

#include <set>

#include "compiler/ir/inline_calls.h"
#include "compiler/ir/optimize.h"
#include "compiler/source/validate.h"
#include "compiler/strategies/frame_source.h"
#include "compiler/strategies/payload_bodies.h"
#include "compiler/transforms/clone_function.h"
#include "compiler/transforms/previous_position.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr std::uint32_t kSin = 13, kExp = 27;

constexpr const char* kLoopShader =
    "#version 450\n"
    "layout(location = 0) in vec4 p;\n"
    "layout(location = 1) in vec4 q;\n"
    "layout(location = 0) out vec4 color;\n"
    "void main() {\n"
    "  float sum = 0.0;\n"
    "  for (int i = 0; i < 48; ++i) sum += sin(p.x * float(i) + sum);\n"
    "  float vein = sum * 0.25 + p.y;\n"
    "  color = vec4(vein) * exp(q);\n"
    "}\n";

const Function& functionOf(const PayloadBodies& bodies, std::uint32_t function) {
  const Function* found = findFunction(bodies.module, function);
  REPRISE_CHECK(found != nullptr, function);
  return *found;
}

// Uses of a variable by an opcode, through access chains too.
int usesOf(const Function& function, std::uint32_t variable, spv::Op opcode) {
  std::set<std::uint32_t> pointers{variable};
  int count = 0;
  for (const Block& block : function.blocks)
    for (const Instruction& instruction : block.instructions) {
      if (instruction.opcode == spv::Op::OpAccessChain && pointers.count(instruction.word(0)) != 0) pointers.insert(instruction.result_id);
      count += instruction.opcode == opcode && pointers.count(instruction.word(0)) != 0;
    }
  return count;
}

int storesTo(const Function& function, std::uint32_t variable) { return usesOf(function, variable, spv::Op::OpStore); }
int loadsOf(const Function& function, std::uint32_t variable) { return usesOf(function, variable, spv::Op::OpLoad); }

TEST(Slice, TheHitBodyNoLongerComputesThePayload) {
  const auto shader = analysedWhole(kLoopShader);
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {true, true, true}).value();
  const Function& hit = functionOf(bodies, bodies.hit);
  EXPECT_EQ(countOf(hit, spv::Op::OpLoopMerge), 0);
  EXPECT_EQ(countOfExtended(hit, kSin), 0);
  EXPECT_EQ(countOfExtended(hit, kExp), 1) << "the tail stays";
  EXPECT_EQ(loadsOf(hit, bodies.payload_variable), 1);
  EXPECT_EQ(storesTo(hit, bodies.payload_variable), 0);
  const Result<void> valid = validateModule(writeModule(bodies.module));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
}

TEST(Slice, TheMissBodyHasEverythingAndHandsThePayloadOut) {
  const auto shader = analysedWhole(kLoopShader);
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {true, true, true}).value();
  const Function& miss = functionOf(bodies, bodies.miss);
  EXPECT_EQ(countOf(miss, spv::Op::OpLoopMerge), 1);
  EXPECT_EQ(countOfExtended(miss, kSin), 1);
  EXPECT_EQ(countOfExtended(miss, kExp), 1);
  EXPECT_EQ(storesTo(miss, bodies.payload_variable), 1);
  EXPECT_EQ(loadsOf(miss, bodies.payload_variable), 0);
}

TEST(Slice, TheMissBodyWithHiddenColoursComputesThePayloadAlone) {
  const auto shader = analysedWhole(kLoopShader);
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {false, true, false}).value();
  const Function& miss = functionOf(bodies, bodies.miss);
  EXPECT_EQ(countOfExtended(miss, kSin), 1);
  EXPECT_EQ(countOfExtended(miss, kExp), 0) << "only the hidden colour needs it";
  EXPECT_EQ(storesTo(miss, bodies.payload_variable), 1);
  EXPECT_EQ(bodies.hit, 0u);
}

constexpr const char* kDiscards =
    "#version 450\n"
    "layout(location = 0) in vec4 p;\n"
    "layout(location = 1) in vec4 q;\n"
    "layout(location = 0) out vec4 color;\n"
    "void main() {\n"
    "  BEFORE\n"
    "  float vein = sin(p.x) * cos(p.y);\n"
    "  AFTER\n"
    "  color = vec4(vein) * exp(q);\n"
    "}\n";

std::string discardingShader(const std::string& before, const std::string& after) {
  std::string text = kDiscards;
  text.replace(text.find("BEFORE"), 6, before);
  text.replace(text.find("AFTER"), 5, after);
  return text;
}

TEST(Slice, KeepsDiscardBeforeThePayload) {
  const auto shader = analysedWhole(discardingShader("if (fract(q.x * 4.0) < 0.5) discard;", ""));
  for (const bool hit : {true, false}) {
    const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {hit, !hit, false}).value();
    EXPECT_EQ(countOf(functionOf(bodies, hit ? bodies.hit : bodies.miss), spv::Op::OpKill), 1) << (hit ? "hit" : "miss");
    EXPECT_TRUE(validateModule(writeModule(bodies.module)).ok());
  }
}

TEST(Slice, KeepsDiscardAfterThePayloadAndWhatDecidesIt) {
  const auto shader = analysedWhole(discardingShader("", "if (vein > q.x) discard;"));
  const PayloadBodies hidden = makeBodies(shader->shader, shader->named("vein").values, {true, true, false}).value();
  EXPECT_EQ(countOf(functionOf(hidden, hidden.hit), spv::Op::OpKill), 1);
  EXPECT_EQ(countOf(functionOf(hidden, hidden.miss), spv::Op::OpKill), 1);
  EXPECT_EQ(countOfExtended(functionOf(hidden, hidden.hit), kSin), 0);
}

TEST(Slice, KeepsDiscardThatNeedsAPartOfThePayloadsComputation) {
  const auto shader = analysedWhole(discardingShader("float shared_wave = sin(p.x);\n  if (shared_wave > q.x) discard;", ""));
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {true, false, true}).value();
  const Function& hit = functionOf(bodies, bodies.hit);
  EXPECT_EQ(countOf(hit, spv::Op::OpKill), 1);
  EXPECT_GE(countOfExtended(hit, kSin), 1) << "the discard still needs it";
}

TEST(Slice, EveryPayloadWidthMakesValidBodies) {
  for (const char* type : {"float", "vec2", "vec3", "vec4"}) {
    const auto shader = analysedWhole(std::string("#version 450\nlayout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\n"
                                                  "void main() {\n  ") + type + " vein = " + type + "(1.5) * sin(" + type +
                                      "(p" + (std::string(type) == "float" ? ".x" : "") + "));\n  color = vec4(dot(vein, vein)) * exp(p);\n}\n");
    const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {true, true, true}).value();
    const Result<void> valid = validateModule(writeModule(bodies.module));
    EXPECT_TRUE(valid.ok()) << type << ": " << valid.error().message;
    EXPECT_EQ(countOfExtended(functionOf(bodies, bodies.hit), kSin), 0) << type;
  }
}

struct Conversions {
  const char* type;     // of the payload
  const char* value;    // how it is computed
  const char* use;      // what the colour takes from it
  spv::Op pack, unpack; // in the miss body and in the hit body
};

TEST(Slice, OtherTypesThanFloatsAreConvertedOnTheirWay) {
  using spv::Op;
  const Conversions all[] = {
      {"int", "int(sin(p.x) * 99.0) * 7", "float(vein)", Op::OpBitcast, Op::OpBitcast},
      {"ivec4", "ivec4(sin(p) * 99.0) * 7", "vec4(vein)", Op::OpBitcast, Op::OpBitcast},
      {"bool", "sin(p.x) > 0.5", "(vein ? 1.0 : 2.0)", Op::OpSelect, Op::OpINotEqual},
      {"bvec3", "greaterThan(sin(p.xyz), p.yzw)", "vec4(vein, 1.0)", Op::OpSelect, Op::OpINotEqual},
      {"bvec4", "greaterThan(sin(p), p.yzwx)", "vec4(vein)", Op::OpSelect, Op::OpINotEqual},
      {"float16_t", "float16_t(sin(p.x)) * float16_t(3.0)", "exp(vein)", Op::OpFConvert, Op::OpFConvert},
      {"f16vec3", "f16vec3(sin(p.xyz)) * float16_t(3.0)", "exp(vein.x)", Op::OpFConvert, Op::OpFConvert}};
  for (const Conversions& one : all) {
    SCOPED_TRACE(one.type);
    const std::string head = "#version 450\n#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n"
                             "layout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\n";
    const auto shader = analysedWhole(head + "void main() {\n  " + one.type + " vein = " + one.value + ";\n  color = " +
                                      one.use + " * exp(p);\n}\n");
    const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {true, true, true}).value();
    const Result<void> valid = validateModule(writeModule(bodies.module));
    EXPECT_TRUE(valid.ok()) << valid.error().message;
    const Function &hit = functionOf(bodies, bodies.hit), &miss = functionOf(bodies, bodies.miss);
    const Function& original = *findFunction(shader->shader.module, shader->shader.entry_function);
    EXPECT_EQ(countOfExtended(hit, kSin), 0);
    EXPECT_EQ(countOf(miss, one.pack), countOf(original, one.pack) + 1);
    EXPECT_GE(countOf(hit, one.unpack), 1);
    EXPECT_EQ(storesTo(miss, bodies.payload_variable), shader->named("vein").channels);
  }
}

TEST(Slice, UnsignedIntegersTravelAsTheyAre) {
  const auto shader = analysedWhole("#version 450\nlayout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\n"
                                    "void main() {\n  uvec2 vein = uvec2(sin(p.xy) * 99.0) * 7u;\n"
                                    "  color = vec4(vein, 0.0, 1.0) * exp(p);\n}\n");
  const PayloadBodies bodies = makeBodies(shader->shader, shader->named("vein").values, {true, true, true}).value();
  EXPECT_TRUE(validateModule(writeModule(bodies.module)).ok());
  EXPECT_EQ(countOf(functionOf(bodies, bodies.hit), spv::Op::OpBitcast), 0);
  EXPECT_EQ(countOf(functionOf(bodies, bodies.miss), spv::Op::OpBitcast), 0);
}

TEST(Clone, HasTheSameCodeUnderOtherIds) {
  const Module module = inlineCalls(moduleOf(kLoopShader)).value();
  const std::uint32_t original = module.entry_points.front().word(1);
  const ClonedFunction cloned = cloneFunction(module, original);
  const Function& before = *findFunction(cloned.module, original);
  const Function& copy = *findFunction(cloned.module, cloned.function);
  ASSERT_EQ(copy.blocks.size(), before.blocks.size());
  for (std::size_t block = 0; block < copy.blocks.size(); ++block) {
    ASSERT_EQ(copy.blocks[block].instructions.size(), before.blocks[block].instructions.size());
    EXPECT_NE(copy.blocks[block].label, before.blocks[block].label);
    for (std::size_t i = 0; i < copy.blocks[block].instructions.size(); ++i)
      EXPECT_EQ(copy.blocks[block].instructions[i].opcode, before.blocks[block].instructions[i].opcode);
  }
  EXPECT_TRUE(validateModule(writeModule(cloned.module)).ok());
}

struct VertexText {
  std::string globals, position;
  std::string extra = "";
};

Result<PreviousPosition> previousOf(const VertexText& text) {
  const Module vertex = inlineCalls(moduleOf("#version 450\n" + text.globals +
                                             "layout(location = 0) in vec3 position;\nlayout(location = 0) out vec3 place;\n"
                                             "void main() {\n  place = position;\n  " + text.extra + "\n  gl_Position = " + text.position +
                                             ";\n}\n", "test.vert")).value();
  const Module frame = compileFrame("previous_position.vert", ShaderStage::kVertex,
                                    {{"REPRISE_SET", "3"}, {"PREVIOUS_LOCATION", "1"}, {"ORTHOGRAPHIC", "0"}});
  return addPreviousPosition(vertex, {3, 1, &frame});
}

TEST(PreviousPosition, ListsTheBlocksAndPushConstantsThatThePositionReads) {
  const auto previous = previousOf({
      "layout(set = 1, binding = 2) uniform Scene { mat4 view_projection; vec4 sun; } scene;\n"
      "layout(push_constant) uniform Object { mat4 model; vec4 tint; } object;\n",
      "scene.view_projection * object.model * vec4(position, 1.0)"});
  ASSERT_TRUE(previous.ok()) << formatError(previous.error());
  const Result<void> valid = validateModule(writeModule(previous->module));
  EXPECT_TRUE(valid.ok()) << valid.error().message;
  ASSERT_EQ(previous->inputs.size(), 2u);
  for (const PreviousInput& input : previous->inputs) {
    EXPECT_EQ(input.size_bytes, 80u) << input.name;
    if (input.source == PreviousSource::kPushConstants) {
      EXPECT_EQ(input.name, "Object");
      continue;
    }
    EXPECT_EQ(input.name, "Scene");
    EXPECT_EQ(input.set, 1u);
    EXPECT_EQ(input.binding, 2u);
    EXPECT_GE(input.reprise_binding, 16u);
  }
  EXPECT_NE(previous->inputs[0].source, previous->inputs[1].source);
  EXPECT_EQ(previous->module.entry_points.size(), 1u);
}

TEST(PreviousPosition, ABlockThatOnlyVaryingsReadIsNoInput) {
  const auto previous = previousOf({"layout(set = 0, binding = 0) uniform Scene { mat4 view_projection; } scene;\n"
                                    "layout(set = 0, binding = 1) uniform Look { vec4 tint; } look;\n",
                                    "scene.view_projection * vec4(position, 1.0)", "place = look.tint.xyz;"});
  ASSERT_TRUE(previous.ok()) << formatError(previous.error());
  ASSERT_EQ(previous->inputs.size(), 1u);
  EXPECT_EQ(previous->inputs[0].name, "Scene");
}

TEST(PreviousPosition, TwoBlocksGetBindingsOfTheirOwn) {
  const auto previous = previousOf({"layout(set = 0, binding = 0) uniform Camera { mat4 view; } camera;\n"
                                    "layout(set = 0, binding = 1) uniform Bones { mat4 bones[8]; } skin;\n",
                                    "camera.view * skin.bones[gl_VertexIndex & 7] * vec4(position, 1.0)"});
  ASSERT_TRUE(previous.ok()) << formatError(previous.error());
  ASSERT_EQ(previous->inputs.size(), 2u);
  EXPECT_NE(previous->inputs[0].reprise_binding, previous->inputs[1].reprise_binding);
  EXPECT_TRUE(validateModule(writeModule(previous->module)).ok());
}

TEST(PreviousPosition, APositionFromABufferOrATextureIsRefused) {
  for (const VertexText& text :
       {VertexText{"layout(set = 0, binding = 0) readonly buffer Instances { mat4 model[]; } instances;\n",
                   "instances.model[gl_InstanceIndex] * vec4(position, 1.0)"},
        VertexText{"layout(set = 0, binding = 0) uniform sampler2D heights;\n",
                   "vec4(position + textureLod(heights, position.xy, 0.0).rgb, 1.0)"}}) {
    const auto previous = previousOf(text);
    ASSERT_FALSE(previous.ok());
    EXPECT_EQ(previous.error().code, "vertex.input");
    EXPECT_EQ(previous.error().kind, ErrorKind::kRefused);
  }
}

TEST(PreviousPosition, ABufferThatOnlyVaryingsReadIsAllowed) {
  const auto previous = previousOf({"layout(set = 0, binding = 0) readonly buffer Colors { vec4 tint[]; } colors;\n",
                                    "vec4(position, 1.0)", "place = colors.tint[gl_VertexIndex].xyz;"});
  ASSERT_TRUE(previous.ok()) << formatError(previous.error());
  EXPECT_TRUE(previous->inputs.empty());
  EXPECT_TRUE(validateModule(writeModule(previous->module)).ok());
}

TEST(PreviousPosition, AShaderWithoutAPositionIsRefused) {
  const Module vertex = moduleOf("#version 450\nlayout(location = 0) out vec3 place;\nvoid main() { place = vec3(1.0); }\n", "test.vert");
  const Module frame = compileFrame("previous_position.vert", ShaderStage::kVertex,
                                    {{"REPRISE_SET", "0"}, {"PREVIOUS_LOCATION", "1"}, {"ORTHOGRAPHIC", "0"}});
  const Module stripped = stripForShipping(inlineCalls(vertex).value()).value();
  const auto previous = addPreviousPosition(removeDeadCode(stripped).value(), {0, 1, &frame});
  ASSERT_FALSE(previous.ok());
  EXPECT_EQ(previous.error().code, "vertex.no_position");
}

}  // namespace
}  // namespace reprise
