#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "profiler/gltf/gltf_parts.h"
#include "profiler/gltf/read_gltf.h"

namespace reprise {
namespace {

constexpr std::size_t kMostValues = kMostGltfVertices * 16;

template <typename T>
double load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

double component(const unsigned char* at, int type, bool normalized) {
  const auto signedPart = [&](double value, double most) { return normalized ? std::max(value / most, -1.0) : value; };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return signedPart(load<std::int8_t>(at), 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return signedPart(load<std::uint8_t>(at), 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return signedPart(load<std::int16_t>(at), 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return signedPart(load<std::uint16_t>(at), 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return load<std::uint32_t>(at);
    default: return load<float>(at);
  }
}

std::size_t componentBytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return 4;
    default: return 0;
  }
}

std::size_t componentsOf(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR: return 1;
    case TINYGLTF_TYPE_VEC2: return 2;
    case TINYGLTF_TYPE_VEC3: return 3;
    case TINYGLTF_TYPE_VEC4: return 4;
    case TINYGLTF_TYPE_MAT4: return 16;
    default: return 0;
  }
}

// `count` elements of `bytes` each, from `offset` on.
struct Span {
  std::size_t offset, count, bytes;
};

Result<ByteRange> elements(const tinygltf::Model& model, int view, const Span& span, const std::string& where) {
  REPRISE_ASSIGN(ByteRange range, viewBytes(model, view, where));
  if (range.stride == 0) range.stride = span.bytes;
  const bool fits = span.offset <= range.size && range.stride >= span.bytes && span.count > 0 &&
                    span.bytes <= range.size - span.offset &&
                    (span.count - 1) <= (range.size - span.offset - span.bytes) / range.stride;
  if (!fits)
    return gltfError("accessor", where,
                     std::to_string(span.count) + " elements of " + std::to_string(span.bytes) + " bytes from byte " +
                         std::to_string(span.offset) + " on do not lie in bufferViews[" + std::to_string(view) + "], which has " +
                         std::to_string(range.size) + " bytes");
  range.data += span.offset;
  return range;
}

Result<void> applySparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor, const std::string& where,
                         std::vector<double>& values) {
  const auto& sparse = accessor.sparse;
  const std::size_t width = componentsOf(accessor.type), bytes = componentBytes(accessor.componentType);
  const std::size_t index_bytes = componentBytes(sparse.indices.componentType);
  if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > accessor.count || index_bytes == 0 ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
    return gltfError("accessor", where + ".sparse", "its count, offsets or types make no sense");
  const auto count = static_cast<std::size_t>(sparse.count);
  REPRISE_ASSIGN(const ByteRange indices, elements(model, sparse.indices.bufferView,
                                                   {static_cast<std::size_t>(sparse.indices.byteOffset), count, index_bytes}, where + ".sparse.indices"));
  REPRISE_ASSIGN(const ByteRange replaced, elements(model, sparse.values.bufferView,
                                                    {static_cast<std::size_t>(sparse.values.byteOffset), count, width * bytes}, where + ".sparse.values"));
  for (std::size_t i = 0; i < count; ++i) {
    const double index = component(indices.data + i * indices.stride, sparse.indices.componentType, false);
    if (!(index >= 0 && index < static_cast<double>(accessor.count)))
      return gltfError("index", where + ".sparse.indices", "an index is beyond the accessor's count of " + std::to_string(accessor.count));
    for (std::size_t c = 0; c < width; ++c)
      values[static_cast<std::size_t>(index) * width + c] =
          component(replaced.data + i * replaced.stride + c * bytes, accessor.componentType, accessor.normalized);
  }
  return {};
}

Result<std::vector<double>> readNumbers(const tinygltf::Model& model, int index, std::size_t components, const std::string& where) {
  REPRISE_TRY(expectIndex(index, model.accessors.size(), where));
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  const std::string place = where + " (" + elementPath("accessors", static_cast<std::size_t>(index)) + ")";
  const std::size_t width = componentsOf(accessor.type), bytes = componentBytes(accessor.componentType);
  if (width == 0 || bytes == 0 || (components != 0 && width != components))
    return gltfError("accessor", place, "it has " + std::to_string(width) + " components of " + std::to_string(bytes) + " bytes, expected " +
                                            std::to_string(components) + " components of a known type");
  if (accessor.count < 1 || accessor.count > kMostValues / width)
    return gltfError("limit", place, "it has " + std::to_string(accessor.count) + " elements, expected 1 to " + std::to_string(kMostValues / width));
  std::vector<double> values;
  if (accessor.bufferView >= 0) {
    REPRISE_ASSIGN(const ByteRange range, elements(model, accessor.bufferView, {accessor.byteOffset, accessor.count, width * bytes}, place));
    values.reserve(accessor.count * width);
    for (std::size_t i = 0; i < accessor.count; ++i)
      for (std::size_t c = 0; c < width; ++c)
        values.push_back(component(range.data + i * range.stride + c * bytes, accessor.componentType, accessor.normalized));
  } else {
    // Zeros, of which no byte lies in the file: they must not cost more memory than a file of its size could.
    if (accessor.count > kMostGltfVertices)
      return gltfError("limit", place, "it has " + std::to_string(accessor.count) + " elements without a buffer view");
    values.resize(accessor.count * width);
  }
  if (accessor.sparse.isSparse) REPRISE_TRY(applySparse(model, accessor, place, values));
  return values;
}

}  // namespace

Error gltfError(const std::string& code, const std::string& where, const std::string& message) {
  return {ErrorKind::kInput, "gltf." + code, where + ": " + message, {}};
}

std::string elementPath(const std::string& where, std::size_t index) { return where + "[" + std::to_string(index) + "]"; }

Result<void> expectIndex(int index, std::size_t size, const std::string& where) {
  if (index >= 0 && static_cast<std::size_t>(index) < size) return {};
  return gltfError("index", where, "the index is " + std::to_string(index) + ", and there are " + std::to_string(size));
}

Result<ByteRange> viewBytes(const tinygltf::Model& model, int view, const std::string& where) {
  REPRISE_TRY(expectIndex(view, model.bufferViews.size(), where + ".bufferView"));
  const tinygltf::BufferView& found = model.bufferViews[static_cast<std::size_t>(view)];
  const std::string place = elementPath("bufferViews", static_cast<std::size_t>(view));
  REPRISE_TRY(expectIndex(found.buffer, model.buffers.size(), place + ".buffer"));
  const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(found.buffer)].data;
  if (found.byteOffset > data.size() || found.byteLength > data.size() - found.byteOffset)
    return gltfError("accessor", place, "it ends at byte " + std::to_string(found.byteOffset) + " + " + std::to_string(found.byteLength) +
                                            " of a buffer of " + std::to_string(data.size()));
  return ByteRange{data.data() + found.byteOffset, found.byteLength, found.byteStride};
}

Result<AccessorFloats> readAccessor(const tinygltf::Model& model, int accessor, std::size_t components, const std::string& where) {
  REPRISE_ASSIGN(const std::vector<double> numbers, readNumbers(model, accessor, components, where));
  AccessorFloats result;
  result.components = componentsOf(model.accessors[static_cast<std::size_t>(accessor)].type);
  result.values.reserve(numbers.size());
  for (const double number : numbers) {
    if (!std::isfinite(number))
      return gltfError("value", where, "number " + std::to_string(result.values.size()) + " is not finite");
    result.values.push_back(static_cast<float>(number));
  }
  return result;
}

Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int accessor, const std::string& where) {
  REPRISE_ASSIGN(const std::vector<double> numbers, readNumbers(model, accessor, 1, where));
  std::vector<std::uint32_t> indices;
  indices.reserve(numbers.size());
  for (const double number : numbers) {
    if (!(number >= 0 && number <= 4294967295.0)) return gltfError("accessor", where, "it holds a number that is no index");
    indices.push_back(static_cast<std::uint32_t>(number));
  }
  return indices;
}

}  // namespace reprise
