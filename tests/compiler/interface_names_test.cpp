// Names for stripped modules and for those of dxc and slangc, and two stages that share them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "compiler/ir/module.h"
#include "compiler/source/interface_names.h"
#include "compiler/source/reflect.h"
#include "compiler/source/stage_interface.h"
#include "compiler/source/validate.h"
#include "runtime/base/file.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

const std::filesystem::path kMarble = REPRISE_SOURCE_DIR "/shaders/marble";
const std::string kTraps = REPRISE_SOURCE_DIR "/tests/check/traps/";

CompiledShader stripped(const CompiledShader& shader) {
  Module module = readModule(shader.words).value();
  module.names.clear();
  return compileText(bytesOf(writeModule(module)), nameOf(shader.stage) + std::string(".spv"), {}).value();
}

CompiledShader trapShader(const std::string& file) {
  CompileOptions options;
  options.stage = ShaderStage::kFragment;  // its only entry point, whatever it is called
  return compile(kTraps + file, options).value();
}

void forgetNames(std::vector<BlockMember>& members) {
  for (BlockMember& member : members) member.name.clear();
}

ShaderInterface withoutNames(ShaderInterface interface) {
  for (Descriptor& descriptor : interface.descriptors) {
    descriptor.name.clear();
    forgetNames(descriptor.members);
  }
  forgetNames(interface.push_constant_members);
  interface.push_constant_name.clear();
  for (VertexInput& input : interface.vertex_inputs) input.name.clear();
  for (FragmentOutput& output : interface.outputs) output.name.clear();
  return interface;
}

class StrippedMarble : public testing::Test {
 protected:
  const CompiledShader vertex_ = compile(kMarble / "marble.vert", {}).value(), fragment_ = compile(kMarble / "marble.frag", {}).value();
  const ShaderInterface named_ = readProgram(vertex_, fragment_).value().interface;
};

TEST_F(StrippedMarble, HasTheSameInterfaceButForNames) {
  const ShaderProgram program = readProgram(stripped(vertex_), stripped(fragment_)).value();
  EXPECT_EQ(withoutNames(program.interface), withoutNames(named_));
  ASSERT_EQ(program.interface.descriptors.size(), 1u);
  EXPECT_EQ(program.interface.descriptors[0].name, "block_0_0");
  EXPECT_EQ(program.interface.descriptors[0].members.at(1).name, "member1");
  EXPECT_EQ(program.interface.push_constant_name, "push_constants");
  EXPECT_EQ(program.interface.vertex_inputs.at(0).name, "input_0");
  EXPECT_EQ(program.interface.outputs.at(0).name, "output_0");
}

TEST_F(StrippedMarble, TellsWhatItsValuesDependOnByTheSameNames) {
  const ShaderProgram program = readProgram(stripped(vertex_), stripped(fragment_)).value();
  for (const InputSource& input : program.analysis.inputs) {
    const std::string expected = input.kind == InputKind::kVarying ? "varying_" : input.kind == InputKind::kUniform ? "block_0_0.member" : "";
    EXPECT_EQ(input.name.rfind(expected, 0), 0u) << input.name;
  }
  EXPECT_FALSE(program.analysis.inputs.empty());
}

TEST_F(StrippedMarble, TakesTheNamesOfTheOtherStage) {
  for (const ShaderProgram& program : {readProgram(stripped(vertex_), fragment_).value(), readProgram(vertex_, stripped(fragment_)).value()}) {
    EXPECT_EQ(program.interface.descriptors, named_.descriptors);
    EXPECT_TRUE(std::any_of(program.analysis.inputs.begin(), program.analysis.inputs.end(),
                            [](const InputSource& input) { return input.name == "Scene.camera_position"; }));
  }
}

TEST(InterfaceNames, ThatAreThereStay) {
  const CompiledShader shader = compile(kMarble / "marble.frag", {}).value();
  EXPECT_EQ(withInterfaceNames(shader.words), shader.words);
}

TEST(InterfaceNames, JoinBlocksOfOneLayoutAndKeepOthersApart) {
  const std::string vertex = "#version 450\nlayout(location = 0) in vec3 position;\n"
                             "layout(set = 0, binding = 0) uniform PerFrame { mat4 turn; vec4 light; } frame;\n"
                             "void main() { gl_Position = frame.turn * vec4(position, 1.0) + frame.light; }\n";
  const auto fragmentWith = [](const std::string& members, const std::string& value) {
    return "#version 450\nlayout(location = 0) out vec4 color;\nlayout(set = 0, binding = 0) uniform Global {" + members + "} g;\n"
           "void main() { color = " + value + "; }\n";
  };
  const Result<ShaderProgram> joined = readProgram(compiled(vertex, "a.vert"), compiled(fragmentWith("mat4 m; vec4 l; vec4 more;", "g.l + g.more"), "a.frag"));
  ASSERT_TRUE(joined.ok()) << joined.error().message;
  ASSERT_EQ(joined->interface.descriptors.size(), 1u);
  const Descriptor& block = joined->interface.descriptors[0];
  EXPECT_EQ(block.name, "PerFrame");
  ASSERT_EQ(block.members.size(), 3u);
  EXPECT_EQ(block.members[1].name, "light");
  EXPECT_EQ(block.members[2].name, "more");
  const Result<ShaderProgram> apart = readProgram(compiled(vertex, "a.vert"), compiled(fragmentWith("vec4 l; vec4 m;", "g.l + g.m"), "a.frag"));
  ASSERT_FALSE(apart.ok());
  EXPECT_EQ(apart.error().code, "source.interface");
  EXPECT_NE(apart.error().message.find("\"PerFrame\""), std::string::npos) << apart.error().message;
  EXPECT_NE(apart.error().message.find("\"Global\""), std::string::npos) << apart.error().message;
}

std::vector<std::string> descriptorNames(const std::string& trap) {
  const CompiledShader shader = trapShader(trap);
  ReflectOptions lenient;
  lenient.skip_unknown_members = true;
  std::vector<std::string> names;
  const StageInterface stage = reflectStage(shader.words, ShaderStage::kFragment, lenient).value();
  for (const Descriptor& descriptor : stage.descriptors) names.push_back(descriptor.name);
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

TEST(InterfaceNames, OfDxcAndSlangAreThoseOfTheSource) {
  EXPECT_EQ(descriptorNames("dxc_style.spvasm"), (Names{"Scene", "lamps", "linear_sampler", "picture"}));
  EXPECT_EQ(descriptorNames("slang_style.spvasm"), (Names{"Scene", "StructuredBuffer", "linear_sampler", "picture"}));
}

TEST(InterfaceNames, TellBlocksOfOneTypeApart) {
  EXPECT_EQ(descriptorNames("stripped.spvasm"), (Names{"block_0_1", "block_1_0", "block_1_1", "texture_0_2"}));
}

TEST(InterfaceNames, OfVertexInputsAreThoseOfMeshes) {
  CompiledShader shader = compiled("#version 450\nlayout(location = 0) in vec3 a;\nlayout(location = 1) in vec2 b;\nlayout(location = 2) in vec3 c;\n"
                                   "void main() { gl_Position = vec4(a.xy + b, a.z, c.x); }\n", "a.vert");
  Module module = readModule(shader.words).value();
  for (Instruction& name : module.names) {
    const std::string text = stringOf(name.operands.back());
    if (text == "a") name.operands.back() = stringOperand("in.var.POSITION");
    if (text == "b") name.operands.back() = stringOperand("in.var.TEXCOORD0");
    if (text == "c") name.operands.back() = stringOperand("input.normal");
  }
  const StageInterface stage = reflectStage(withInterfaceNames(writeModule(module)), ShaderStage::kVertex).value();
  ASSERT_EQ(stage.vertex_inputs.size(), 3u);
  EXPECT_EQ(stage.vertex_inputs[0].name, "position");
  EXPECT_EQ(stage.vertex_inputs[1].name, "uv");
  EXPECT_EQ(stage.vertex_inputs[2].name, "normal");
}

TEST(Slang, IsReadThoughTheValidatorDoesNotKnowTheLanguage) {
  std::vector<std::uint32_t> words = trapShader("slang_style.spvasm").words;
  for (std::size_t at = 5; at < words.size(); at += words[at] >> 16)
    if ((words[at] & 0xffffu) == 3) words[at + 1] = 11;  // OpSource Slang
  const Result<CompiledShader> shader = compileText(bytesOf(words), "a.spv", {});
  ASSERT_TRUE(shader.ok()) << shader.error().message;
  EXPECT_TRUE(readModule(shader->words).ok());
}

TEST(Registers, ThatCollideAreToldWithBothNames) {
  const CompiledShader shader = trapShader("dxc_registers_collide.spvasm");
  const CompiledShader vertex = compiled("#version 450\nlayout(location = 0) out vec3 place;\nlayout(location = 1) out vec2 uv;\n"
                                         "void main() { place = vec3(0); uv = vec2(0); gl_Position = vec4(0); }\n", "a.vert");
  ReflectOptions lenient;
  lenient.skip_unknown_members = true;
  const Result<ShaderInterface> found = reflectInterface(vertex.words, shader.words, lenient);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().code, "source.binding");
  for (const char* text : {"\"Scene\"", "\"picture\"", "set 0 binding 0", "-fvk-t-shift"})
    EXPECT_NE(found.error().message.find(text), std::string::npos) << found.error().message;
}

TEST(Registers, OfTwoBlocksThatCollideAreToldToo) {
  const CompiledShader vertex = compiled("#version 450\nvoid main() { gl_Position = vec4(0); }\n", "a.vert");
  const CompiledShader fragment = compiled("#version 450\nlayout(location = 0) out vec4 color;\n"
                                           "layout(binding = 1) uniform First { vec4 a; } first;\nlayout(binding = 1) uniform Second { vec4 a; } second;\n"
                                           "void main() { color = first.a + second.a; }\n", "a.frag");
  const Result<ShaderInterface> found = reflectInterface(vertex.words, fragment.words);
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().code, "source.binding");
  EXPECT_NE(found.error().message.find("\"First\""), std::string::npos) << found.error().message;
  EXPECT_NE(found.error().message.find("\"Second\""), std::string::npos) << found.error().message;
}

}  // namespace
}  // namespace reprise
