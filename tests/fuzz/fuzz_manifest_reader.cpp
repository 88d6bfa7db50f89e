// libFuzzer target: any text as the manifest of a package, sealed with the right hash if it is JSON, and as the parts of one.
// What is read must come back from writing and reading again.
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/base/file.h"
#include "runtime/base/hash.h"
#include "runtime/package/json_values.h"
#include "runtime/package/package.h"
#include "tests/fuzz/fuzz_folder.h"

namespace {

using nlohmann::json;

// The text as the body of a manifest whose hashes fit, so that mutations get behind them; the text itself if it is no body.
std::string sealed(const std::string& text, const std::string& module_hash) {
  try {
    json body = reprise::parseJson(text);
    for (const char* recipe : {"original", "variant"})
      if (body.is_object() && body.contains(recipe) && body[recipe].is_object() && body[recipe].contains("modules"))
        for (json& entry : body[recipe]["modules"])
          if (entry.is_object()) entry["hash"] = module_hash;
    const std::string hash = reprise::contentHash(reprise::jsonText(body));
    return reprise::jsonText(json{{"hash", hash}, {"package", std::move(body)}});
  } catch (const std::exception&) {
    return text;
  }
}

template <typename Part>
void expectRoundTrip(const std::string& text, reprise::Result<Part> (*read)(const std::string&),
                     std::string (*write)(const Part&)) {
  const reprise::Result<Part> part = read(text);
  if (!part.ok()) return;
  const std::string written = write(*part);
  const reprise::Result<Part> again = read(written);
  REPRISE_CHECK(again.ok(), again.error().message);
  REPRISE_CHECK(write(*again) == written, written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const reprise::FuzzFolder folder;
  constexpr std::uint32_t kModule[] = {0x07230203, 0x10300, 0, 1, 0};
  static const std::string module_hash = reprise::contentHash(reprise::bytesOf(kModule));
  for (const char* name : {"vertex.spv", "fragment.spv", "original_vertex.spv", "a.spv"})
    if (!std::filesystem::exists(folder.path() / name)) folder.write(name, reprise::bytesOf(kModule));
  const std::string text(reinterpret_cast<const char*>(data), size);
  expectRoundTrip(text, reprise::recipeFromJson, reprise::recipeToJson);
  expectRoundTrip(text, reprise::interfaceFromJson, reprise::interfaceToJson);
  folder.write("manifest.json", sealed(text, module_hash));
  const reprise::Result<reprise::Package> package = reprise::readPackage(folder.path());
  if (package.ok()) return 0;
  REPRISE_CHECK(!package.error().code.empty() && !package.error().message.empty(), text);
  return 0;
}
