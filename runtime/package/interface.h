// What a pair of shaders expects from the application: vertex inputs, descriptors, push constants, outputs. Reflected from
// the user's SPIR-V by the compiler, stored in the package, read by the profiler and by applications.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace reprise {

enum class ScalarKind { kFloat, kInt, kUint };

// One member of a uniform block or push-constant range, flattened: nested structs appear as "outer.inner", arrays of
// scalars, vectors and matrices keep array_length. Offsets and strides are in bytes from the start of the block.
struct BlockMember {
  std::string name;
  ScalarKind scalar = ScalarKind::kFloat;
  int rows = 1;               // components of the vector, or rows of the matrix: 1..4
  int columns = 1;            // 1 unless a matrix: 2..4
  std::uint32_t offset = 0;
  std::uint32_t matrix_stride = 0;  // column stride (row stride if row_major), 0 unless a matrix
  bool row_major = false;
  std::uint32_t array_length = 0;   // 0: no array
  std::uint32_t array_stride = 0;
  bool operator==(const BlockMember&) const = default;
};

enum class DescriptorKind {
  kUniformBlock, kStorageBlock, kCombinedImageSampler, kSampledImage, kSampler, kStorageImage, kUniformTexelBuffer, kStorageTexelBuffer
};
enum class ImageDimension { kNone, k1D, k2D, k3D, kCube, k1DArray, k2DArray, kCubeArray };

// Stage bits, with the values of VkShaderStageFlagBits.
inline constexpr std::uint32_t kStageVertex = 0x1;
inline constexpr std::uint32_t kStageFragment = 0x10;

struct Descriptor {
  std::string name;  // the block's or variable's name in the source
  std::uint32_t set = 0;
  std::uint32_t binding = 0;
  std::uint32_t count = 1;
  DescriptorKind kind = DescriptorKind::kUniformBlock;
  ImageDimension dimension = ImageDimension::kNone;
  std::uint32_t stages = 0;
  std::uint32_t size_bytes = 0;      // of a block
  std::vector<BlockMember> members;  // of a block
  ScalarKind texel = ScalarKind::kFloat;  // of an image
  bool compares = false;             // depth comparison
  bool multisampled = false;
  std::string storage_format;        // of a storage image, as in GLSL: "rgba32f"; "" where the shader names none
  bool operator==(const Descriptor&) const = default;
};

struct PushConstantRange {
  std::uint32_t stages = 0;
  std::uint32_t offset = 0;
  std::uint32_t size_bytes = 0;
  bool operator==(const PushConstantRange&) const = default;
};

struct VertexInput {
  std::string name;
  std::uint32_t location = 0;
  ScalarKind scalar = ScalarKind::kFloat;
  int components = 4;
  bool operator==(const VertexInput&) const = default;
};

struct FragmentOutput {
  std::string name;
  std::uint32_t location = 0;
  ScalarKind scalar = ScalarKind::kFloat;
  int components = 4;
  bool operator==(const FragmentOutput&) const = default;
};

struct ShaderInterface {
  std::vector<VertexInput> vertex_inputs;
  std::vector<FragmentOutput> outputs;      // colour outputs, by location
  std::vector<Descriptor> descriptors;      // by set, then binding; both stages merged
  std::string push_constant_name;           // of the block, empty: none
  std::vector<PushConstantRange> push_constants;
  std::vector<BlockMember> push_constant_members;
  bool writes_depth = false;                // FragDepth
  bool discards = false;
  bool operator==(const ShaderInterface&) const = default;
};

}  // namespace reprise
