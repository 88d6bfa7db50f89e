#include "profiler/scenario/texture_file.h"

#include "runtime/base/file.h"

namespace reprise {

Result<std::string> readTextureFile(const TextureSpec& spec) {
  Result<std::string> bytes = readFile(spec.path, kMostImageBytes);
  if (bytes.ok()) return bytes;
  Error error = bytes.error();
  if (error.code == "file.missing") error.code = "texture.missing";
  error.message = "texture '" + spec.name + "': " + error.message;
  error.place = spec.file_place;
  return error;
}

}  // namespace reprise
