#include "cli/check/interpreter/interface.h"

#include <algorithm>
#include <cmath>

#include "cli/check/interpreter/memory.h"
#include "cli/check/interpreter/terms.h"

namespace reprise::interpreter {
namespace {

constexpr double kImageSize = 64.0;

// The place of one scalar of an interface.
struct Slot {
  std::uint32_t location = 0, component = 0, index = 0;
  std::uint32_t interpolation = 0;
};

// Calls leaf(scalar type, index of the scalar, slot) for every scalar of an interface variable.
class Locations {
 public:
  Locations(const Program& program, const Variable& variable) : program_(program), variable_(variable) {}

  template <typename Leaf>
  void walk(const Leaf& leaf) {
    const Decorations& own = variable_.decorations;
    Slot slot{own.location.value_or(0), own.component.value_or(0), own.index.value_or(0), own.interpolation};
    if (own.built_in) slot.location = kBuiltInLocation + *own.built_in;
    walkType(program_.types[variable_.type], slot, own.built_in.has_value(), leaf);
  }

 private:
  template <typename Leaf>
  void walkType(const Type& type, Slot& slot, bool built_in, const Leaf& leaf) {
    const Type& element = program_.types[type.element];
    switch (type.kind) {
      case Kind::kStruct: {
        for (const Member& member : type.members) {
          const Decorations& own = member.decorations;
          Slot inside = slot;
          if (own.location) inside.location = *own.location;
          inside.component = own.component.value_or(0);
          inside.interpolation |= own.interpolation;
          if (own.built_in) inside.location = kBuiltInLocation + *own.built_in;
          walkType(program_.types[member.type], inside, built_in || own.built_in.has_value(), leaf);
          if (!own.built_in) slot.location = inside.location;
        }
        return;
      }
      case Kind::kArray: case Kind::kMatrix: {
        const std::uint32_t component = slot.component;
        if (element.flat == 0) return;
        for (std::uint32_t i = 0; i < type.count; ++i) {
          walkType(element, slot, built_in, leaf);
          if (!built_in) slot.component = component;
        }
        return;
      }
      case Kind::kVector: case Kind::kInt: case Kind::kFloat: case Kind::kBool: return walkRow(type, slot, built_in, leaf);
      default: at_ += type.flat;
    }
  }

  // A scalar or a vector: one location, or two where 64-bit components need them. Built-in arrays go on by components.
  template <typename Leaf>
  void walkRow(const Type& type, Slot& slot, bool built_in, const Leaf& leaf) {
    const Type& scalar = program_.types[type.scalar];
    const std::uint32_t size = scalar.width == 64 ? 2 : 1;
    Slot at = slot;
    for (std::uint32_t i = 0; i < type.flat; ++i) {
      if (!built_in && at.component >= 4) at.component -= 4, ++at.location;
      leaf(scalar, at_++, at);
      at.component += size;
    }
    if (built_in) slot.component = at.component;
    else slot.location = at.location + 1;
  }

  const Program& program_;
  const Variable& variable_;
  std::uint32_t at_ = 0;
};

// A wave over the image with a length, a direction and a phase that follow from the key.
double smooth(const Machine& m, std::uint64_t key) {
  const std::uint64_t seeded = mixed(termOf(Term::kMadeUp, m.inputs.seed), key);
  const double across = 12.0 * unitFrom(mixed(seeded, 1)) - 6.0, down = 12.0 * unitFrom(mixed(seeded, 2)) - 6.0;
  const double phase = 6.2831853 * unitFrom(mixed(seeded, 3));
  const double wave = std::sin(across * m.inputs.frag_x / kImageSize + down * m.inputs.frag_y / kImageSize + phase);
  return 0.5 + 0.49999 * wave;
}

// Integers stay the same over tiles of the image, as they do over triangles.
std::uint32_t overTiles(const Machine& m, std::uint64_t key, const Slot& slot) {
  const auto tile = [](float place) { return static_cast<std::uint64_t>(std::clamp(place, 0.0f, 65535.0f) / 16.0f); };
  return madeUpInt(m, mixed(mixed(key, tile(m.inputs.frag_x)), tile(m.inputs.frag_y)), slot.location + slot.component);
}

Scalar builtInOf(const Machine& m, const Type& scalar, const Slot& slot) {
  const std::uint64_t key = mixed(termOf(Term::kBuiltIn, slot.location - kBuiltInLocation), slot.component);
  const bool is_float = scalar.kind == Kind::kFloat;
  const auto number = [&](double value) { return Scalar{bitsOfFloat(value, scalar.width), key, false}; };
  switch (static_cast<spv::BuiltIn>(slot.location - kBuiltInLocation)) {
    case spv::BuiltIn::FragCoord:
      if (slot.component == 0) return number(m.inputs.frag_x);
      if (slot.component == 1) return number(m.inputs.frag_y);
      return number(smooth(m, key) + (slot.component == 3 ? 0.5 : 0.0) * 0.999);
    case spv::BuiltIn::FrontFacing: return {overTiles(m, key, slot) != 0 ? 1u : 0u, 0, false};
    case spv::BuiltIn::PointCoord: return number(smooth(m, key));
    case spv::BuiltIn::SamplePosition: return number(0.5);
    case spv::BuiltIn::SampleMask: return {maskOf(scalar.width), 0, false};
    case spv::BuiltIn::SampleId: case spv::BuiltIn::HelperInvocation: return {};
    default: break;
  }
  return is_float ? number(inRangeOfSeed(m.inputs.seed, smooth(m, key))) : Scalar{overTiles(m, key, slot) & maskOf(scalar.width), 0, false};
}

Scalar varyingOf(const Machine& m, const Type& scalar, const Slot& slot) {
  const std::uint64_t place = mixed(termOf(Term::kVarying, slot.location), slot.component);
  if (scalar.kind != Kind::kFloat) return {overTiles(m, place, slot) & maskOf(scalar.width), 0, false};
  return {bitsOfFloat(inRangeOfSeed(m.inputs.seed, smooth(m, place)), scalar.width), mixed(place, slot.interpolation), false};
}

bool isBuffer(spv::StorageClass storage) {
  return storage == spv::StorageClass::Uniform || storage == spv::StorageClass::StorageBuffer ||
         storage == spv::StorageClass::PushConstant || storage == spv::StorageClass::UniformConstant;
}

void addWords(const Scalar& value, const Type& scalar, const Slot& slot, std::vector<OutputWord>& words) {
  OutputWord word;
  word.location = slot.location + (slot.index != 0 ? kSecondIndexLocation : 0);
  word.component = slot.component;
  word.is_float = scalar.kind == Kind::kFloat;
  word.bits = static_cast<std::uint32_t>(value.bits);
  word.hash = computationOf(value, scalar);
  word.undefined = value.undefined;
  words.push_back(word);
  if (scalar.width != 64) return;
  ++word.component;
  word.bits = static_cast<std::uint32_t>(value.bits >> 32);
  words.push_back(word);
}

}  // namespace

void setUpMemory(Machine& m) {
  if (m.program.variables.size() > kMostVariables) return m.fail(unsupported("more than " + std::to_string(kMostVariables) + " variables"));
  m.memory.assign(m.program.memory, {});
  for (std::uint32_t number = 0; number < m.program.variables.size() && !m.failure; ++number) {
    const Variable& variable = m.program.variables[number];
    const Type& type = m.program.types[variable.type];
    Pointer pointer;
    if (isBuffer(variable.storage)) {
      pointer.kind = PointerKind::kDescriptor, pointer.variable = number;
    } else {
      pointer.offset = variable.place;
      Scalar* place = m.memory.data() + variable.place;
      if (variable.storage == spv::StorageClass::Input)
        Locations(m.program, variable).walk([&](const Type& scalar, std::uint32_t at, const Slot& slot) {
          place[at] = slot.location >= kBuiltInLocation ? builtInOf(m, scalar, slot) : varyingOf(m, scalar, slot);
        });
      else if (variable.initializer != 0) std::copy_n(m.read(variable.initializer, type.flat), type.flat, place);
      else m.fillUndefined(type, place);
    }
    m.constants[m.program.ids[variable.id].slot] = pack(pointer);
  }
}

std::vector<OutputWord> outputsOf(const Machine& m) {
  std::vector<OutputWord> words;
  for (const Variable& variable : m.program.variables) {
    const auto& interface = m.program.interface;
    if (variable.storage != spv::StorageClass::Output || std::find(interface.begin(), interface.end(), variable.id) == interface.end()) continue;
    Locations(m.program, variable).walk([&](const Type& scalar, std::uint32_t at, const Slot& slot) {
      addWords(m.memory[variable.place + at], scalar, slot, words);
    });
  }
  std::sort(words.begin(), words.end(), [](const OutputWord& a, const OutputWord& b) {
    return std::pair(a.location, a.component) < std::pair(b.location, b.component);
  });
  return words;
}

}  // namespace reprise::interpreter
