#include "compiler/strategies/kept_inputs.h"

#include <fmt/format.h>

#include <unordered_map>
#include <unordered_set>

namespace reprise {
namespace {

using spv::Op;
using spv::StorageClass;

constexpr std::size_t kWordsPerTarget = 4;

Error refusedInput(const Module& module, std::uint32_t variable, const std::string& why) {
  const std::string name = nameOf(module, variable);
  return {ErrorKind::kRefused, "repair.input", "the input '" + (name.empty() ? fmt::format("%{}", variable) : name) + "' " + why +
                                                   ", which a repair cannot take up again", {}};
}

bool isInput(const Instruction& global) {
  return global.opcode == Op::OpVariable && static_cast<StorageClass>(global.word(0)) == StorageClass::Input;
}

// Inputs that functions refer to, and those of them that something else than a load or an access chain does.
struct Uses {
  std::unordered_set<std::uint32_t> read, unusual;
};

Uses usesOf(const Module& module) {
  std::unordered_set<std::uint32_t> inputs;
  for (const Instruction& global : module.globals)
    if (isInput(global)) inputs.insert(global.result_id);
  Uses uses;
  for (const Function& function : module.functions) {
    std::unordered_map<std::uint32_t, std::uint32_t> input_of;  // of pointers into inputs
    for (const Block& block : function.blocks)
      for (const Instruction& instruction : block.instructions)
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          if (!instruction.operands[i].is_id) continue;
          const std::uint32_t id = instruction.operands[i].words[0];
          const auto pointer = input_of.find(id);
          const std::uint32_t input = inputs.count(id) != 0 ? id : pointer != input_of.end() ? pointer->second : 0;
          if (input == 0) continue;
          uses.read.insert(input);
          const bool steps = i == 0 && (instruction.opcode == Op::OpAccessChain || instruction.opcode == Op::OpInBoundsAccessChain);
          if (steps) input_of[instruction.result_id] = input;
          if (!steps && instruction.opcode != Op::OpLoad) uses.unusual.insert(input);
        }
  }
  return uses;
}

bool isDecorated(const Module& module, std::uint32_t id, spv::Decoration decoration) { return decorationOf(module, id, decoration).has_value(); }

// "" where values of the type are not kept.
std::string glslType(const Module& module, std::uint32_t type_id, KeptInput& input) {
  const Instruction* type = findGlobal(module, type_id);
  if (type->opcode == Op::OpTypeMatrix) {
    input.columns = static_cast<int>(type->word(1));
    type = findGlobal(module, type->word(0));
  }
  if (type->opcode == Op::OpTypeVector) {
    input.rows = static_cast<int>(type->word(1));
    type = findGlobal(module, type->word(0));
  }
  const bool floats = type->opcode == Op::OpTypeFloat;
  if ((!floats && type->opcode != Op::OpTypeInt) || type->word(0) != 32) return "";
  input.scalar = floats ? KeptScalar::kFloat : type->word(1) != 0 ? KeptScalar::kInt : KeptScalar::kUint;
  if (input.columns > 1) return fmt::format("mat{}x{}", input.columns, input.rows);
  const char* scalars[] = {"float", "int", "uint"};
  const char* vectors[] = {"vec", "ivec", "uvec"};
  const auto kind = static_cast<std::size_t>(input.scalar);
  return input.rows == 1 ? scalars[kind] : vectors[kind] + std::to_string(input.rows);
}

std::string layoutOf(const Module& module, std::uint32_t variable) {
  std::string text = fmt::format("layout(location = {}", decorationOf(module, variable, spv::Decoration::Location).value_or(0));
  if (const auto component = decorationOf(module, variable, spv::Decoration::Component)) text += fmt::format(", component = {}", *component);
  text += ") ";
  if (isDecorated(module, variable, spv::Decoration::Flat)) text += "flat ";
  if (isDecorated(module, variable, spv::Decoration::NoPerspective)) text += "noperspective ";
  if (isDecorated(module, variable, spv::Decoration::Centroid)) text += "centroid ";
  return text + "in ";
}

// Each component of an input as an expression behind its variable's name: "", ".x", "[1].y".
std::vector<std::string> componentsOf(const KeptInput& input) {
  std::vector<std::string> components;
  for (int column = 0; column < input.columns; ++column)
    for (int row = 0; row < input.rows; ++row)
      components.push_back((input.columns > 1 ? fmt::format("[{}]", column) : std::string()) +
                           (input.rows > 1 ? fmt::format(".{}", "xyzw"[row]) : std::string()));
  return components;
}

std::string wordOf(KeptScalar scalar, const std::string& value) {
  return (scalar == KeptScalar::kFloat ? "floatBitsToUint(" : "uint(") + value + ")";
}

std::string valueOf(KeptScalar scalar, const std::string& word) {
  return (scalar == KeptScalar::kFloat ? "uintBitsToFloat(" : scalar == KeptScalar::kInt ? "int(" : "uint(") + word + ")";
}

std::string wordAt(std::size_t word) { return fmt::format("words[{}].{}", word / kWordsPerTarget, "xyzw"[word % kWordsPerTarget]); }

// The words in their order, as the pass that keeps them computes them.
std::vector<std::string> keptExpressions(const KeptInputs& kept) {
  std::vector<std::string> words{"max(floatBitsToUint(gl_FragCoord.w), 1u)"};
  if (kept.keeps_depth) words.push_back("floatBitsToUint(gl_FragCoord.z)");
  for (std::size_t i = 0; i < kept.inputs.size(); ++i)
    for (const std::string& component : componentsOf(kept.inputs[i]))
      words.push_back(wordOf(kept.inputs[i].scalar, fmt::format("reprise_given_{}{}", i, component)));
  if (kept.front_facing != 0) words.push_back("uint(gl_FrontFacing)");
  return words;
}

std::string keepText(const KeptInputs& kept) {
  const std::vector<std::string> words = keptExpressions(kept);
  std::string text;
  for (std::size_t first = 0; first < words.size(); first += kWordsPerTarget) {
    text += fmt::format("reprise_kept[{}] = uvec4(", first / kWordsPerTarget);
    for (std::size_t i = first; i < first + kWordsPerTarget; ++i) text += (i == first ? "" : ", ") + (i < words.size() ? words[i] : "0u");
    text += "); ";
  }
  return text;
}

std::string takeText(const KeptInputs& kept) {
  std::size_t word = 1;
  const std::string depth = kept.keeps_depth ? valueOf(KeptScalar::kFloat, wordAt(word++)) : "0.0";
  std::string text = fmt::format("reprise_frag_coord = vec4(gl_FragCoord.xy, {}, {}); ", depth, valueOf(KeptScalar::kFloat, wordAt(0)));
  for (std::size_t i = 0; i < kept.inputs.size(); ++i) {
    std::string values;
    for (std::size_t component = 0; component < componentsOf(kept.inputs[i]).size(); ++component)
      values += (component == 0 ? "" : ", ") + valueOf(kept.inputs[i].scalar, wordAt(word++));
    text += fmt::format("reprise_input_{} = {}({}); ", i, kept.inputs[i].type, values);
  }
  if (kept.front_facing != 0) text += "reprise_front_facing = " + wordAt(word) + " != 0u; ";
  return text;
}

// True if the built-in is dealt with.
bool takeBuiltIn(spv::BuiltIn built_in, std::uint32_t variable, KeptInputs& kept) {
  switch (built_in) {
    case spv::BuiltIn::FragCoord: kept.frag_coord = variable; return true;
    case spv::BuiltIn::FrontFacing: kept.front_facing = variable; return true;
    case spv::BuiltIn::HelperInvocation: return true;  // false of every fragment that is seen, here and there
    default: return false;
  }
}

}  // namespace

Result<KeptInputs> keptInputs(const Module& module, bool orthographic) {
  const Uses uses = usesOf(module);
  KeptInputs kept;
  for (const Instruction& global : module.globals) {
    if (!isInput(global) || uses.read.count(global.result_id) == 0) continue;
    const std::uint32_t variable = global.result_id;
    if (uses.unusual.count(variable) != 0) return refusedInput(module, variable, "is used in another way than by loading it");
    if (const auto built_in = decorationOf(module, variable, spv::Decoration::BuiltIn)) {
      if (!takeBuiltIn(static_cast<spv::BuiltIn>(*built_in), variable, kept)) return refusedInput(module, variable, "is a built-in");
      continue;
    }
    KeptInput input;
    input.variable = variable;
    input.type = glslType(module, findGlobal(module, global.type_id)->word(1), input);
    if (input.type.empty()) return refusedInput(module, variable, "is an array, a structure or not of 32 bits");
    input.layout = layoutOf(module, variable);
    kept.inputs.push_back(std::move(input));
  }
  kept.keeps_depth = orthographic || kept.frag_coord != 0;
  return kept;
}

std::size_t keptWords(const KeptInputs& kept) { return keptExpressions(kept).size(); }

std::vector<ResourceFormat> keptFormats(const KeptInputs& kept) {
  const std::size_t words = keptWords(kept);
  std::vector<ResourceFormat> formats((words + kWordsPerTarget - 1) / kWordsPerTarget, ResourceFormat::kRgba32Uint);
  if (words % kWordsPerTarget == 1) formats.back() = ResourceFormat::kR32Uint;
  if (words % kWordsPerTarget == 2) formats.back() = ResourceFormat::kRg32Uint;
  return formats;
}

std::string keptTarget(std::size_t target) { return target == 0 ? "kept" : "kept" + std::to_string(target); }

std::map<std::string, std::string> keptMacros(const KeptInputs& kept) {
  std::string given, taken;
  for (std::size_t i = 0; i < kept.inputs.size(); ++i) {
    given += fmt::format("{}{} reprise_given_{}; ", kept.inputs[i].layout, kept.inputs[i].type, i);
    taken += fmt::format("{} reprise_input_{}; ", kept.inputs[i].type, i);
  }
  return {{"KEPT_TARGETS", std::to_string(keptFormats(kept).size())},
          {"KEPT_GIVEN", given},
          {"KEEP", keepText(kept)},
          {"KEPT_TAKEN", taken},
          {"TAKE", takeText(kept)}};
}

void bindGivenInputs(const KeptInputs& kept, const Module& body, FrameBindings& bindings) {
  for (std::size_t i = 0; i < kept.inputs.size(); ++i)
    if (findGlobal(body, kept.inputs[i].variable) != nullptr) bindings.shared[fmt::format("reprise_given_{}", i)] = kept.inputs[i].variable;
}

void bindTakenInputs(const KeptInputs& kept, const Module& body, FrameBindings& bindings) {
  const auto bind = [&](const std::string& name, std::uint32_t variable) {
    if (variable != 0 && findGlobal(body, variable) != nullptr) bindings.variables[name] = variable;
  };
  for (std::size_t i = 0; i < kept.inputs.size(); ++i) bind(fmt::format("reprise_input_{}", i), kept.inputs[i].variable);
  bind("reprise_frag_coord", kept.frag_coord);
  bind("reprise_front_facing", kept.front_facing);
}

}  // namespace reprise
