// The reference interpreter: modules whose results are known, and the laws of its hashes.
#include "cli/check/interpreter/interpret.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <set>

#include "compiler/source/compile.h"

namespace reprise {
namespace {

using Ending = Interpretation::Ending;

std::vector<std::uint32_t> wordsOf(const std::string& text, const std::string& name = "test.frag") {
  const Result<CompiledShader> shader = compileText(text, name, {});
  REPRISE_CHECK(shader.ok(), formatError(shader.error()));
  return shader->words;
}

// A shader with one varying and one output, whose main() is given.
std::vector<std::uint32_t> mainOf(const std::string& body, const std::string& before = "") {
  return wordsOf("#version 450\nlayout(location = 0) in vec4 p;\nlayout(location = 0) out vec4 color;\n" + before + "void main() {\n" + body + "\n}\n");
}

Interpretation run(const std::vector<std::uint32_t>& words, const InterpreterInputs& inputs = {}) {
  const Result<Interpretation> result = interpretFragment(words, "main", inputs);
  REPRISE_CHECK(result.ok(), formatError(result.error()));
  return *result;
}

std::vector<float> floatsOf(const Interpretation& result) {
  std::vector<float> values;
  for (const OutputWord& word : result.outputs) values.push_back(std::bit_cast<float>(word.bits));
  return values;
}

// The four components of the output.
std::vector<float> colorOf(const std::string& body, const std::string& before = "") { return floatsOf(run(mainOf(body, before))); }

std::uint64_t hashOf(const std::string& body, const std::string& before = "") { return run(mainOf(body, before)).outputs.at(0).hash; }

using Color = std::vector<float>;

TEST(Interpreter, FollowsLoopsWithBreakAndContinue) {
  EXPECT_EQ(colorOf("int sum = 0; for (int i = 0; i < 10; ++i) { if (i == 2) continue; if (i == 5) break; sum += i; } color = vec4(sum);"), Color(4, 8.0f));
  EXPECT_EQ(colorOf("int n = 0; do { n += 3; } while (n < 10); while (n > 4) n -= 4; color = vec4(n);"), Color(4, 4.0f));
  EXPECT_EQ(colorOf("int n = 0; for (int i = 0; i < 3; ++i) for (int k = 0; k <= i; ++k) { if (k == 2) break; n += 10 * i + k; } color = vec4(n);"),
            Color(4, 62.0f));
}

TEST(Interpreter, SwitchesFallThrough) {
  const std::string body = "int n = 0; for (int i = 0; i < 5; ++i) switch (i) { case 0: n += 1; case 1: n += 10; break; case 3: n += 100; default: n += 1000; } color = vec4(n);";
  EXPECT_EQ(colorOf(body), Color(4, 3121.0f));
}

TEST(Interpreter, CallsFunctions) {
  EXPECT_EQ(colorOf("float a = 3.0, b = 0.0; change(a, b); change(a, b); color = vec4(a, b, early(2), early(-2));",
                    "void change(inout float a, out float b) { float local; local = a + 1.0; b = local; a = local * 2.0; }\n"
                    "float early(int n) { for (int i = 0; i < 9; ++i) { if (i == n) return float(10 + i); } if (n < 0) return -1.0; return 0.0; }\n"),
            (Color{18.0f, 9.0f, 12.0f, -1.0f}));
}

TEST(Interpreter, TakesDynamicIndices) {
  EXPECT_EQ(colorOf("float a[4]; for (int i = 0; i < 4; ++i) a[i] = float(i * i); vec4 v = vec4(a[0], a[1], a[2], a[3]); int k = 2; v[k] += 0.5;\n"
                    "color = vec4(v[k], a[k + 1], table[k].b[1], table[1].a);",
                    "struct Row { float a; vec2 b; };\nconst Row table[3] = Row[](Row(1.0, vec2(2.0, 3.0)), Row(4.0, vec2(5.0, 6.0)), Row(7.0, vec2(8.0, 9.0)));\n"),
            (Color{4.5f, 9.0f, 9.0f, 4.0f}));
}

TEST(Interpreter, PrivateVariablesLastAndLocalsDoNot) {
  EXPECT_EQ(colorOf("count(); count(); color = vec4(total, count(), 0.0, 0.0);",
                    "float total = 5.0;\nfloat count() { float here = 0.0; here += 1.0; total += here; return here; }\n"),
            (Color{7.0f, 1.0f, 0.0f, 0.0f}));
}

TEST(Interpreter, MultipliesMatrices) {
  EXPECT_EQ(colorOf("mat2 a = mat2(1.0, 2.0, 3.0, 4.0); mat2x3 b = mat2x3(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);\n"
                    "vec2 v = a * vec2(10.0, 1.0); vec2 w = vec2(10.0, 1.0) * a; vec3 u = b * v; color = vec4(v.y, w.x, u.z, (b * a)[1].x + determinant(a));"),
            (Color{24.0f, 12.0f, 183.0f, 17.0f}));
  EXPECT_EQ(colorOf("mat3 a = inverse(mat3(2.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 8.0, 0.0)); color = vec4(a[0].x, a[1].z, a[2].y, transpose(mat2x3(1, 2, 3, 4, 5, 6))[2].y);"),
            (Color{0.5f, 0.125f, 0.25f, 6.0f}));
}

TEST(Interpreter, KnowsIntegersAndBits) {
  EXPECT_EQ(colorOf("int a = -7; uint u = 0x80000001u; color = vec4(a / 2, a % 4, a >> 1, findMSB(u));"), (Color{-3.0f, 1.0f, -4.0f, 31.0f}));
  EXPECT_EQ(colorOf("uint carry, high, low; uint sum = uaddCarry(0xffffffffu, 3u, carry); umulExtended(0xffffffffu, 4u, high, low);\n"
                    "color = vec4(sum, carry, high, low == 0xfffffffcu ? 1 : 0);"), (Color{2.0f, 1.0f, 3.0f, 1.0f}));
  EXPECT_EQ(colorOf("int h, l; imulExtended(-2, 3, h, l); color = vec4(h, l, bitfieldExtract(0xf0, 4, 4), bitfieldInsert(0, -1, 1, 2));"), (Color{-1.0f, -6.0f, -1.0f, 6.0f}));
  EXPECT_EQ(colorOf("color = vec4(bitCount(7), bitfieldReverse(1u) == 0x80000000u ? 1 : 0, findLSB(8), findMSB(-1));"), (Color{3.0f, 1.0f, 3.0f, -1.0f}));
}

TEST(Interpreter, KnowsTheExtendedInstructions) {
  EXPECT_EQ(colorOf("float w; float f = modf(2.75, w); int e; float s = frexp(12.0, e); color = vec4(f, w, s, ldexp(s, e));"), (Color{0.75f, 2.0f, 0.75f, 12.0f}));
  EXPECT_EQ(colorOf("vec4 u = unpackUnorm4x8(packUnorm4x8(vec4(0.0, 1.0, 0.2, 2.0))); vec2 h = unpackHalf2x16(packHalf2x16(vec2(1.5, -0.25))); color = vec4(u.y, u.w, h);"),
            (Color{1.0f, 1.0f, 1.5f, -0.25f}));
  EXPECT_EQ(colorOf("color = vec4(length(vec2(3.0, 4.0)), cross(vec3(1, 0, 0), vec3(0, 1, 0)).z, mod(-1.0, 4.0), smoothstep(0.0, 2.0, 1.0));"), (Color{5.0f, 1.0f, 3.0f, 0.5f}));
  EXPECT_EQ(colorOf("color = vec4(isnan(sqrt(-1.0 - abs(p.x))) ? 1.0 : 0.0, isinf(1.0 / (p.x - p.x)) ? 1.0 : 0.0, sign(-3.0), fract(2.25));"), (Color{1.0f, 1.0f, -1.0f, 0.25f}));
}

TEST(Interpreter, KnowsOtherWidths) {
  const std::string before = "#extension GL_EXT_shader_explicit_arithmetic_types : require\n";
  EXPECT_EQ(colorOf("double d = 1.0 / 3.0; int64_t big = 1l << 40; float16_t h = float16_t(2049.0); color = vec4(float(d * 3.0), float(big >> 38), float(h), float(int16_t(70000)));", before),
            (Color{1.0f, 4.0f, 2048.0f, 4464.0f}));
}

TEST(Interpreter, TellsHowItEnds) {
  EXPECT_EQ(run(mainOf("color = p; if (p.x > -9.0) discard;")).ending, Ending::kDiscarded);
  EXPECT_EQ(run(mainOf("gone(); color = p;", "void gone() { for (int i = 0; i < 3; ++i) if (i == 2) discard; }\n")).ending, Ending::kDiscarded);
  EXPECT_EQ(run(mainOf("demote; color = p;", "#extension GL_EXT_demote_to_helper_invocation : require\n")).ending, Ending::kDiscarded);
  InterpreterInputs inputs;
  inputs.most_steps = 1000;
  EXPECT_EQ(run(mainOf("float s = 0.0; while (p.x > -9.0) s += 1.0; color = vec4(s);"), inputs).ending, Ending::kEndless);
}

// Two phis that take each other's value.
TEST(Interpreter, PhisAreReadAtOnce) {
  const std::vector<std::uint32_t> words = wordsOf(R"(
OpCapability Shader
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %main "main" %out
OpExecutionMode %main OriginUpperLeft
OpDecorate %out Location 0
%void = OpTypeVoid
%fn = OpTypeFunction %void
%bool = OpTypeBool
%int = OpTypeInt 32 1
%v2 = OpTypeVector %int 2
%ptr = OpTypePointer Output %v2
%out = OpVariable %ptr Output
%c0 = OpConstant %int 0
%c1 = OpConstant %int 1
%c3 = OpConstant %int 3
%main = OpFunction %void None %fn
%entry = OpLabel
OpBranch %head
%head = OpLabel
%a = OpPhi %int %c0 %entry %b %again
%b = OpPhi %int %c1 %entry %a %again
%i = OpPhi %int %c0 %entry %next %again
%more = OpSLessThan %bool %i %c3
OpLoopMerge %end %again None
OpBranchConditional %more %again %end
%again = OpLabel
%next = OpIAdd %int %i %c1
OpBranch %head
%end = OpLabel
%both = OpCompositeConstruct %v2 %a %b
OpStore %out %both
OpReturn
OpFunctionEnd
)", "swap.frag.spvasm");
  const Interpretation result = run(words);
  ASSERT_EQ(result.outputs.size(), 2u);
  EXPECT_EQ(result.outputs[0].bits, 1u);
  EXPECT_EQ(result.outputs[1].bits, 0u);
  EXPECT_FALSE(result.outputs[0].is_float);
}

// As glslangValidator -gV writes them: debug information is instructions, inside functions and outside.
TEST(Interpreter, PassesOverDebugInformation) {
  const std::vector<std::uint32_t> words = wordsOf(R"(
OpCapability Shader
OpExtension "SPV_KHR_non_semantic_info"
%debug = OpExtInstImport "NonSemantic.Shader.DebugInfo.100"
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %main "main" %out
OpExecutionMode %main OriginUpperLeft
%file = OpString "a.frag"
OpDecorate %out Location 3
%void = OpTypeVoid
%fn = OpTypeFunction %void
%uint = OpTypeInt 32 0
%ptr = OpTypePointer Output %uint
%out = OpVariable %ptr Output
%c7 = OpConstant %uint 7
%source = OpExtInst %void %debug DebugSource %file
%main = OpFunction %void None %fn
%entry = OpLabel
%line = OpExtInst %void %debug DebugLine %source %c7 %c7 %c7 %c7
OpLine %file 7 1
OpStore %out %c7
OpNoLine
OpReturn
OpFunctionEnd
)", "debug.frag.spvasm");
  const Interpretation result = run(words);
  ASSERT_EQ(result.outputs.size(), 1u);
  EXPECT_EQ(result.outputs[0].bits, 7u);
  EXPECT_EQ(result.outputs[0].location, 3u);
}

constexpr const char* kBlock =
    "layout(set = 1, binding = 2, std140) uniform Block { float head; vec3 place; float list[2]; layout(row_major) mat2x3 turn; } block;\n"
    "layout(set = 1, binding = 3, std430) buffer Data { uint count; float tail[]; } data;\n";

TEST(Interpreter, ReadsBlocksAsTheyLie) {
  InterpreterInputs inputs;
  std::vector<float> values(64);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
  inputs.blocks[{1, 2}] = std::vector<std::byte>(bytes, bytes + 256);
  inputs.blocks[{1, 3}] = std::vector<std::byte>(bytes, bytes + 40);
  // Three rows of two floats from 16 on, as the matrix is row major.
  EXPECT_EQ(floatsOf(run(mainOf("int k = 1; color = vec4(block.place.y, block.list[k], block.turn[1][2], data.tail[k]);", kBlock), inputs)),
            (Color{5.0f, 12.0f, 25.0f, 2.0f}));
  EXPECT_EQ(floatsOf(run(mainOf("mat2x3 whole = block.turn; color = vec4(whole[0][1], data.tail.length(), block.turn[0].z, block.head);", kBlock), inputs)),
            (Color{20.0f, 9.0f, 24.0f, 0.0f}));
}

TEST(Interpreter, SeesWhatItWroteToABuffer) {
  const Interpretation result = run(mainOf("data.tail[1] = 3.0; float a = data.tail[1]; data.tail[1] = 4.0; color = vec4(a, data.tail[1], 0.0, 0.0);", kBlock));
  EXPECT_EQ(floatsOf(result), (Color{3.0f, 4.0f, 0.0f, 0.0f}));
  EXPECT_NE(result.side_effects, 0u);
  EXPECT_EQ(run(mainOf("color = vec4(data.tail[1]);", kBlock)).side_effects, 0u);
  EXPECT_NE(run(mainOf("data.tail[1] = 4.0; data.tail[1] = 3.0; color = p;", kBlock)).side_effects, result.side_effects);
}

TEST(Interpreter, MadeUpIntegersTakeAllValuesAndPairs) {
  const std::vector<std::uint32_t> words = wordsOf("#version 450\nlayout(binding = 0) uniform B { ivec4 n; } b; layout(location = 0) out ivec4 n; void main() { n = b.n; }");
  std::set<std::uint32_t> values;
  std::array<std::set<std::pair<std::uint32_t, std::uint32_t>>, 6> pairs;
  for (std::uint32_t seed = 0; seed < 16; ++seed) {
    InterpreterInputs inputs;
    inputs.seed = seed;
    const std::vector<OutputWord> out = run(words, inputs).outputs;
    if (seed < 4) values.insert(out[0].bits);
    for (std::size_t i = 0, pair = 0; i < 4; ++i)
      for (std::size_t k = i + 1; k < 4; ++k) pairs[pair++].insert({out[i].bits, out[k].bits});
  }
  EXPECT_EQ(values, (std::set<std::uint32_t>{0, 1, 2, 3}));
  for (const auto& seen : pairs) EXPECT_EQ(seen.size(), 16u);
}

TEST(Interpreter, VaryingsAreSmoothAndDiffer) {
  InterpreterInputs inputs;
  const std::vector<std::uint32_t> words = mainOf("color = p;");
  const Color first = floatsOf(run(words, inputs));
  inputs.frag_x += 1.0f;
  const Color second = floatsOf(run(words, inputs));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(first[i], second[i], 0.06);
  EXPECT_NE(first, second);
  EXPECT_NE(first[0], first[1]);
}

// A test of a texture goes either way, so that what lies behind it is seen.
TEST(Interpreter, TexturesDifferFromPointToPoint) {
  const std::vector<std::uint32_t> words = mainOf("if (texture(map, vec2(0.5)).x < 0.5) discard; color = dFdx(p);", "layout(binding = 0) uniform sampler2D map;\n");
  std::set<Ending> endings;
  std::set<std::uint32_t> values;
  InterpreterInputs inputs;
  for (; inputs.frag_x < 32.0f; inputs.frag_x += 1.0f) {
    const Interpretation result = run(words, inputs);
    endings.insert(result.ending);
    if (!result.outputs.empty()) values.insert(result.outputs[0].bits);
  }
  EXPECT_EQ(endings.size(), 2u);
  EXPECT_GT(values.size(), 4u);
}

TEST(Interpreter, TellsWhatIsUndefined) {
  const Interpretation result = run(mainOf("float never; color = vec4(p.x, never, 0.0, 0.0);"));
  EXPECT_TRUE(result.reads_undefined);
  EXPECT_FALSE(result.undefined_behaviour);
  EXPECT_FALSE(result.outputs.at(0).undefined);
  EXPECT_TRUE(result.outputs.at(1).undefined);
  EXPECT_TRUE(run(mainOf("bool never; color = never ? p : vec4(0.0); if (never) color += p;")).undefined_behaviour);
  EXPECT_FALSE(run(mainOf("float never; if (p.x < -9.0) color = vec4(never); else color = p;")).reads_undefined);
  InterpreterInputs inputs;
  inputs.undefined_fill = 0x3f800000;
  EXPECT_EQ(floatsOf(run(mainOf("float never; color = vec4(never);"), inputs))[0], 1.0f);
  EXPECT_TRUE(run(mainOf("int zero = 0; color = vec4(3 / zero);")).reads_undefined);
  EXPECT_TRUE(run(mainOf("float a[2]; a[0] = a[1] = 1.0; int i = 1; color = vec4(a[i * 2]);")).undefined_behaviour);
}

TEST(InterpreterHashes, TellComputationsApart) {
  EXPECT_EQ(hashOf("float a = p.x * p.y; float b = p.x * p.y; color = vec4(a + b);"), hashOf("float a = p.x * p.y; color = vec4(a + a);"));
  EXPECT_NE(hashOf("color = vec4(p.x * 0.5);"), hashOf("color = vec4(p.x * 0.25);"));
  EXPECT_NE(hashOf("color = vec4((p.x + p.y) + p.z);"), hashOf("color = vec4(p.x + (p.y + p.z));"));
  EXPECT_NE(hashOf("color = vec4(p.x - p.y);"), hashOf("color = vec4(p.y - p.x);"));
  EXPECT_NE(hashOf("color = vec4(p.x);"), hashOf("color = vec4(p.y);"));
  EXPECT_NE(hashOf("color = vec4(dFdx(p.x));"), hashOf("color = vec4(dFdy(p.x));"));
  EXPECT_NE(hashOf("color = vec4(fma(p.x, p.y, p.z));"), hashOf("color = vec4(p.x * p.y + p.z);"));
}

TEST(InterpreterHashes, DoNotSeeHowValuesTravel) {
  const std::uint64_t plain = hashOf("color = vec4(sin(p.x * 2.0));");
  EXPECT_EQ(hashOf("float a[3]; int i = 1; a[i] = p.x; vec2 v = vec2(0.0, a[1]); v = v.yx; color = vec4(sin(twice(v.x)));", "float twice(float a) { return a * 2.0; }\n"), plain);
  EXPECT_EQ(hashOf("float r = 0.0; for (int i = 1; i < 4; ++i) if (i == 2) r = sin(p.x * float(i)); color = vec4(r);"), plain);
  EXPECT_EQ(hashOf("float r = p.x > -99.0 ? p.x : p.y; color = sin(vec4(r, p.yzw) * 2.0);"), plain);
}

TEST(InterpreterHashes, IntegersRememberTheFloatsThatMadeThem) {
  const std::string other = "color = vec4(uintBitsToFloat((floatBitsToUint(p.y * 0.0 + 1.0) ^ 5u) & 0x3fffffffu));";
  const std::string one = "color = vec4(uintBitsToFloat((floatBitsToUint(p.x * 0.0 + 1.0) ^ 5u) & 0x3fffffffu));";
  EXPECT_EQ(colorOf(one), colorOf(other));
  EXPECT_NE(hashOf(one), hashOf(other));
}

TEST(InterpreterHashes, TexturesAreTheirBindingsAndOperands) {
  const std::string maps = "layout(set = 0, binding = 0) uniform sampler2D a;\nlayout(set = 0, binding = 1) uniform sampler2D b;\n"
                           "layout(set = 0, binding = 2) uniform sampler2D c[2];\nlayout(set = 1, binding = 0) uniform texture2D t;\nlayout(set = 1, binding = 1) uniform sampler s;\n";
  const std::uint64_t plain = hashOf("color = texture(a, p.xy);", maps);
  EXPECT_EQ(hashOf("vec4 seen = textureLod(b, p.xy, 0.0); color = seen.w > 99.0 ? seen : texture(a, p.xy);", maps), plain);
  for (const char* other : {"texture(b, p.xy)", "texture(a, p.yx)", "texture(a, p.xy, 1.0)", "texture(c[1], p.xy)", "texture(sampler2D(t, s), p.xy)", "texelFetch(a, ivec2(0), 0)"})
    EXPECT_NE(hashOf("color = " + std::string(other) + ";", maps), plain) << other;
}

struct Compared {
  std::optional<ComputationDifference> difference;
  CompareCounts counts;
};

Compared compared(const std::string& given, const std::string& prepared, const std::string& before = "", const CompareOptions& options = {}) {
  Compared out;
  auto difference = compareComputations(mainOf(given, before), mainOf(prepared, before), "main", options, &out.counts);
  REPRISE_CHECK(difference.ok(), formatError(difference.error()));
  out.difference = *difference;
  return out;
}

TEST(CompareComputations, NamesWhatDiffersAndWhere) {
  EXPECT_FALSE(compared("color = p;", "vec4 c = p; color = c;").difference);
  const auto different = compared("color = vec4(p.xyz, p.w * 2.0);", "color = vec4(p.xyz, p.w + p.w);").difference;
  ASSERT_TRUE(different);
  EXPECT_NE(different->expected.find("output 0.3"), std::string::npos) << different->expected;
  EXPECT_NE(different->expected, different->found);
  // Only where the varying is large, which some seed shows.
  EXPECT_TRUE(compared("color = p.x > 1.5 ? p : p.yxzw;", "color = p.yxzw;").difference);
  EXPECT_EQ(compared("if (p.x > -99.0) discard; color = p;", "color = p;").difference->expected, "it discards");
}

// A bound from a block is 0, 1, 2 and 3 in turn, so that a loop's second time round is seen.
TEST(CompareComputations, TriesSmallIntegers) {
  const std::string block = "layout(binding = 0) uniform B { int turns; } b;\n";
  EXPECT_TRUE(compared("float s = 0.0; for (int i = 0; i < b.turns; ++i) s += p[i]; color = vec4(s);", "float s = 0.0; for (int i = 0; i < min(b.turns, 2); ++i) s += p[i]; color = vec4(s);", block).difference);
}

TEST(CompareComputations, TriesMoreSeedsForBlocksThatWereNotReached) {
  const std::string block = "layout(binding = 0) uniform B { int a, b; } b;\n";
  const std::string given = "color = p; if (b.a == 3 && b.b == 1) color = p * 2.0;";
  const Compared hidden = compared(given, "color = p;", block);
  EXPECT_TRUE(hidden.difference);
  EXPECT_EQ(hidden.counts.unreached, 0);
  const Compared never = compared("color = p; if (p.x > 99.0) color = p * 2.0;", "color = p;");
  EXPECT_FALSE(never.difference);
  EXPECT_EQ(never.counts.unreached, 1);
  EXPECT_EQ(never.counts.blocks, 3);
  EXPECT_EQ(never.counts.returned, 256);
}

TEST(CompareComputations, LeavesOutWhatTheGivenModuleLeavesOpen) {
  EXPECT_FALSE(compared("float never; color = vec4(p.xyz, never);", "color = vec4(p.xyz, 7.0);").difference);
  EXPECT_TRUE(compared("color = vec4(p.xyz, 0.0);", "float never; color = vec4(p.xyz, never);").difference) << "0 is what undefined values are here";
  const Compared open = compared("bool never; color = vec4(0.0); if (never) color = p;", "color = p;");
  EXPECT_FALSE(open.difference);
  EXPECT_GE(open.counts.undefined, 64);
  CompareOptions options;
  options.most_steps = 10000;
  const Compared endless = compared("float s = 0.0; while (p.x > -99.0) s += 1.0; color = vec4(s);", "color = p;", "", options);
  EXPECT_FALSE(endless.difference);
  EXPECT_GE(endless.counts.endless, 64);
  EXPECT_EQ(compared("color = p;", "float s = 0.0; while (p.x > -99.0) s += 1.0; color = vec4(s);").difference->found, "it does not end");
}

TEST(CompareComputations, EndsWithItsBudget) {
  CompareOptions options;
  options.most_steps_together = 20000;
  const Compared some = compared("float s = 0.0; for (int i = 0; i < 100; ++i) s += p.x; color = vec4(s);", "float s = 0.0; for (int i = 0; i < 100; ++i) s += p.x; color = vec4(s);", "", options);
  EXPECT_GT(some.counts.returned, 4);
  EXPECT_LT(some.counts.returned, 64);
}

TEST(CompareComputations, SeesWritesThatAreLostOrMoved) {
  EXPECT_TRUE(compared("data.tail[1] = p.x; color = p;", "color = p;", kBlock).difference);
  EXPECT_TRUE(compared("data.tail[1] = p.x; data.tail[2] = p.y; color = p;", "data.tail[2] = p.y; data.tail[1] = p.x; color = p;", kBlock).difference);
  EXPECT_FALSE(compared("data.tail[1] = p.x; color = vec4(data.tail[1]);", "float x = p.x; data.tail[1] = x; color = vec4(x);", kBlock).difference);
}

TEST(Interpreter, RefusesWhatItDoesNotKnow) {
  const auto words = mainOf("color = subgroupAdd(p);", "#extension GL_KHR_shader_subgroup_arithmetic : require\n");
  const Result<Interpretation> result = interpretFragment(words, "", {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, "interpreter.unsupported");
  EXPECT_EQ(result.error().kind, ErrorKind::kRefused);
  EXPECT_NE(result.error().message.find("subgroup"), std::string::npos);
  EXPECT_EQ(interpretFragment(words, "other", {}).error().code, "interpreter.invalid");
  EXPECT_EQ(interpretFragment({}, "", {}).error().code, "interpreter.invalid");
}

// Words changed and cut at random end as an error or as a result, never worse.
TEST(Interpreter, HoldsOutAgainstBrokenModules) {
  const std::vector<std::uint32_t> whole = mainOf(
      "float a[4]; for (int i = 0; i < 4; ++i) a[i] = block.list[i & 1] * data.tail[i]; mat2 m = mat2(a[0], a[1], a[2], a[3]); color = vec4(m * p.xy, f(a), modf(p.z, a[1]));",
      std::string(kBlock) + "float f(float a[4]) { switch (int(a[0])) { case 0: return a[1]; default: return a[2]; } }\n");
  std::uint64_t state = 7;
  int errors = 0;
  for (int round = 0; round < 4000; ++round) {
    std::vector<std::uint32_t> words = whole;
    for (int change = 0; change < 3; ++change) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      std::uint32_t& word = words[(state >> 33) % words.size()];
      switch ((state >> 20) & 3) {
        case 0: word = static_cast<std::uint32_t>(state >> 40) % words[3]; break;
        case 1: word ^= 1u << ((state >> 24) & 31); break;
        case 2: word = words[(state >> 45) % words.size()]; break;
        default: word = static_cast<std::uint32_t>(state >> 24); break;
      }
    }
    if (round % 8 == 0) words.resize((state >> 30) % words.size());
    InterpreterInputs inputs;
    inputs.most_steps = 5000;
    errors += interpretFragment(words, "", inputs).ok() ? 0 : 1;
  }
  EXPECT_GT(errors, 1000);
  EXPECT_LT(errors, 4000);
}

}  // namespace
}  // namespace reprise
