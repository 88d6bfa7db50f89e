#include "compiler/analysis/places.h"

#include <cctype>

#include "compiler/analysis/analyse.h"

namespace reprise {
namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

int columnOf(std::string_view line, const std::string& name) {
  const auto isWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (!name.empty())
    for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at + 1)) {
      const bool begins = at == 0 || !isWord(line[at - 1]);
      const std::size_t end = at + name.size();
      if (begins && (end >= line.size() || !isWord(line[end]))) return static_cast<int>(at) + 1;
    }
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string_view::npos ? 0 : static_cast<int>(first) + 1;
}

}  // namespace

PlaceFinder::PlaceFinder(const PreparedShader& shader, const std::vector<SourceFile>& sources) : shader_(shader) {
  for (const Instruction& source : shader.module.debug_sources)
    if (source.opcode == spv::Op::OpString) files_[source.result_id] = stringOf(source.operands[0]);
  for (const SourceFile& source : sources) lines_of_file_[source.path] = linesOf(source.text);
}

Place PlaceFinder::placeOf(const Instruction& instruction) const {
  const auto named = shader_.named.find(instruction.result_id);
  const LineMark& line = named != shader_.named.end() ? named->second.line : instruction.line;
  Place place;
  if (const auto file = files_.find(line.file); file != files_.end()) place.file = file->second;
  place.line = static_cast<int>(line.line);
  place.column = static_cast<int>(line.column);
  const auto lines = lines_of_file_.find(place.file);
  if (place.column == 0 && line.line > 0 && lines != lines_of_file_.end() && line.line <= lines->second.size())
    place.column = columnOf(lines->second[line.line - 1], named != shader_.named.end() ? named->second.name : "");
  return place;
}

Place placeOf(const PreparedShader& shader, const Instruction& instruction, const std::vector<SourceFile>& sources) {
  return PlaceFinder(shader, sources).placeOf(instruction);
}

}  // namespace reprise
