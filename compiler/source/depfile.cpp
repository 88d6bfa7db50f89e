#include "compiler/source/depfile.h"

#include <string_view>

#include "runtime/base/file.h"

namespace reprise {
namespace {

std::string escaped(std::string_view name) {
  std::string text;
  std::size_t backslashes = 0;
  for (char c : name) {
    if (c == ' ' || c == '\t') {
      // Backslashes before a space would otherwise be read as escapes of each other.
      text.append(backslashes, '\\');
      text += '\\';
    } else if (c == '#') {
      text += '\\';
    } else if (c == '$') {
      text += '$';
    }
    backslashes = c == '\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text;
}

Result<void> refuseLineBreaks(const std::string& name) {
  if (name.find_first_of("\n\r") == std::string::npos && !name.empty()) return {};
  return Error{
      ErrorKind::kInput,
      "depfile.name",
      "the name \"" + name + "\" is empty or holds a line break and cannot be written in a dependency file",
      {}};
}

}  // namespace

Result<std::string> depfileText(const std::string& target, const std::vector<std::string>& dependencies) {
  REPRISE_TRY(refuseLineBreaks(target));
  std::string text = escaped(target) + ":";
  for (const std::string& dependency : dependencies) {
    REPRISE_TRY(refuseLineBreaks(dependency));
    text += " \\\n  " + escaped(dependency);
  }
  return text + "\n";
}

Result<void> writeDepfile(const std::filesystem::path& file, const std::string& target,
                          const std::vector<std::string>& dependencies) {
  REPRISE_ASSIGN(const std::string text, depfileText(target, dependencies));
  return writeFile(file, text);
}

}  // namespace reprise
