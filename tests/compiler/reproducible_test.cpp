// Undefined values made zero, and arithmetic that no driver may rearrange.
#include <gtest/gtest.h>

#include "compiler/ir/reproducible.h"
#include "compiler/source/validate.h"
#include "tests/compiler/analysed_shader.h"

namespace reprise {
namespace {

constexpr const char* kUndefined = R"(
               OpCapability Shader
               OpMemoryModel Logical GLSL450
               OpEntryPoint Fragment %main "main" %color %place
               OpExecutionMode %main OriginUpperLeft
               OpDecorate %color Location 0
               OpDecorate %place Location 0
       %void = OpTypeVoid
   %function = OpTypeFunction %void
      %float = OpTypeFloat 32
       %vec4 = OpTypeVector %float 4
     %output = OpTypePointer Output %vec4
      %input = OpTypePointer Input %vec4
      %local = OpTypePointer Function %vec4
      %color = OpVariable %output Output
      %place = OpVariable %input Input
       %main = OpFunction %void None %function
      %start = OpLabel
   %variable = OpVariable %local Function
      %undef = OpUndef %vec4
       %read = OpLoad %vec4 %place
     %loaded = OpLoad %vec4 %variable
        %sum = OpFAdd %vec4 %undef %loaded
   %shuffled = OpVectorShuffle %vec4 %sum %read 0 4 0xffffffff 5
               OpStore %color %shuffled
               OpReturn
               OpFunctionEnd
)";

Module assembled(const char* text) { return readModule(assemble(text).value()).value(); }

std::string textOf(const Module& module) {
  const std::vector<std::uint32_t> words = writeModule(module);
  EXPECT_TRUE(validateModule(words).ok()) << disassemble(words);
  return disassemble(words);
}

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(DefinedValues, NothingUndefinedIsLeft) {
  const std::string text = textOf(withDefinedValues(assembled(kUndefined)));
  EXPECT_EQ(countOf(text, "OpUndef"), 0) << text;
  EXPECT_EQ(countOf(text, "4294967295"), 0) << text;
  EXPECT_EQ(countOf(text, "OpConstantNull"), 1) << text;
  // The output before its first store, and the payload proper.
  EXPECT_EQ(countOf(text, "OpStore"), 2) << text;
  EXPECT_NE(text.find("OpCopyObject"), std::string::npos) << text;
}

TEST(WithoutContraction, DecoratesEveryFloatOperationOnce) {
  const Module strict = withoutContraction(assembled(kUndefined));
  EXPECT_EQ(countOf(textOf(strict), "NoContraction"), 1);
  EXPECT_EQ(countOf(textOf(withoutContraction(strict)), "NoContraction"), 1);
}

}  // namespace
}  // namespace reprise
