// Random structured shaders: what they are made of, that preparation leaves their meaning alone, and that a preparation that does not is told.
#include <gtest/gtest.h>

#include "tests/fuzz/prepared_difference.h"
#include "tests/fuzz/reduce_shader.h"

namespace reprise {
namespace {

constexpr std::uint64_t kModules = 200;
// Within so many modules the oracle is to find a fault of ssa-rewrite in Debian's SPIRV-Tools 2023.1.
constexpr std::uint64_t kModulesToConvict = 500;

std::uint64_t hashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char one : text) hash = (hash ^ static_cast<unsigned char>(one)) * 0x100000001b3ull;
  return hash;
}

int countWith(const std::string& what) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= kModules; ++seed) count += randomShader(seed).find(what) != std::string::npos ? 1 : 0;
  return count;
}

TEST(RandomShader, IsTheSameForTheSameSeed) {
  EXPECT_EQ(randomShader(7), randomShader(7));
  EXPECT_NE(randomShader(7), randomShader(8));
  std::uint64_t hash = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) hash = hash * 31 + hashOf(randomShader(seed));
  // Of every compiler and machine. It changes with the generator, and with it the seeds that docs/building.md names.
  EXPECT_EQ(hash, 0x48a8ef6e35f364f1u);
}

TEST(RandomShader, HasEveryConstruct) {
  for (const char* what : {"for (int ", "while (true)", "for (;;)", "} while (", "switch (", "default:", "break;", "continue;", " else ", "discard",
                           "inout ", "out ", "const ", "struct ", "texture(", "memory.list[", "scene.", "draw.", "&&", "||", " ? ", "ids"})
    EXPECT_GE(countWith(what), 10) << what;
}

TEST(RandomShader, SmallerOptionsGiveSmallerShaders) {
  RandomShaderOptions small;
  small.functions = 0;
  small.statements = 2;
  small.depth = 1;
  std::size_t size = 0, small_size = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    size += randomShader(seed).size();
    small_size += randomShader(seed, small).size();
    EXPECT_TRUE(moduleOf(seed, randomShader(seed, small)).has_value()) << seed;
  }
  EXPECT_LT(small_size, size / 2);
}

TEST(StructuredShaders, ArePreparedWithoutADifference) {
  int refused = 0, untold = 0, undefined = 0;
  for (std::uint64_t seed = 1; seed <= kModules; ++seed) {
    const RandomModule module = randomModule(seed);
    const Judgement judgement = judgePreparation(module.words, Promotion::kOurs);
    EXPECT_FALSE(judgement.finding()) << "seed " << seed << " (" << module.form << "): " << judgement.what;
    refused += judgement.verdict == Judgement::Verdict::kRefused ? 1 : 0;
    untold += judgement.verdict == Judgement::Verdict::kUntold ? 1 : 0;
    undefined += judgement.undefined > 0 ? 1 : 0;
  }
  // Else what does not differ would mean little.
  EXPECT_LE(refused, 4);
  EXPECT_LE(untold, 4);
  EXPECT_LE(undefined, 4);
}

TEST(StructuredShaders, ConvictSsaRewrite) {
  bool differs = false;
  for (std::uint64_t seed = 1; seed <= kModulesToConvict && !differs; ++seed)
    differs = judgePreparation(randomModule(seed).words, Promotion::kSpirvTools).verdict == Judgement::Verdict::kDifferent;
  EXPECT_TRUE(differs);
}

TEST(ReduceShader, KeepsWhatShowsAndNothingElse) {
  const std::string text = "a\nif (x) {\n  b\n  if (y) {\n    c\n  }\n  d\n}\ne\n";
  const auto contains = [](const std::string& line) { return [line](const std::string& shorter) { return shorter.find(line) != std::string::npos; }; };
  EXPECT_EQ(reduceShader(text, contains("c")), "    c\n");
  EXPECT_EQ(reduceShader(text, contains("if (y)")), "  if (y) {\n");
}

}  // namespace
}  // namespace reprise
