#include "cli/package_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

#include "runtime/package/embedded.h"

namespace reprise {
namespace {

constexpr std::size_t kBytesInLine = 24;

void appendBytes(std::string& text, std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i % kBytesInLine == 0) text += "\n   ";
    fmt::format_to(std::back_inserter(text), " {},", static_cast<unsigned>(static_cast<unsigned char>(bytes[i])));
  }
}

}  // namespace

bool isHeaderName(const std::string& name) {
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

Result<std::string> packageHeader(const Package& package, const std::string& name) {
  const std::vector<PackageFile> files = packageFiles(package);
  std::string text = "// Made by reprise emit: a package for reprise::readEmbeddedPackage.\n#pragma once\n\n"
                     "#include \"runtime/package/embedded.h\"\n\nnamespace reprise_packages {\nnamespace " + name + "_bytes {\n";
  for (std::size_t i = 0; i < files.size(); ++i) {
    text += fmt::format("\ninline constexpr unsigned char file{}[] = {{", i);
    appendBytes(text, files[i].bytes);
    text += "\n};\n";
  }
  text += fmt::format("\n}}  // namespace {}_bytes\n\ninline constexpr reprise::EmbeddedFile {}[] = {{\n", name, name);
  for (std::size_t i = 0; i < files.size(); ++i)
    text += fmt::format("    {{\"{}\", {}_bytes::file{}, sizeof {}_bytes::file{}}},\n", files[i].name, name, i, name, i);
  return text + "};\n\n}  // namespace reprise_packages\n";
}

}  // namespace reprise
