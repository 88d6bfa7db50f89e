#include "compiler/source/include_resolver.h"

#include <algorithm>
#include <utility>

#include "runtime/base/file.h"

namespace reprise {
namespace {

std::filesystem::path directoryOf(const std::string& file) {
  return file == "-" ? std::filesystem::path() : std::filesystem::path(file).parent_path();
}

std::string shown(const std::filesystem::path& directory) {
  return directory.empty() ? "\".\"" : "\"" + directory.string() + "\"";
}

}  // namespace

IncludeResolver::IncludeResolver(std::string main_path, std::vector<std::filesystem::path> include_dirs)
    : main_path_(std::move(main_path)), include_dirs_(std::move(include_dirs)) {}

const SourceFile* IncludeResolver::openBeside(const std::string& name, const std::string& includer) {
  return open((directoryOf(includer) / name).lexically_normal());
}

const SourceFile* IncludeResolver::openFromDirectories(const std::string& name, const std::string& includer) {
  for (const std::filesystem::path& directory : include_dirs_) {
    if (const SourceFile* file = open((directory / name).lexically_normal())) return file;
  }
  if (failure_) return nullptr;
  std::string searched = "beside the including file in " + shown(directoryOf(includer)) + " for quoted names";
  for (const std::filesystem::path& directory : include_dirs_) searched += ", " + shown(directory);
  failure_ = Error{ErrorKind::kInput,
                   "source.include",
                   "the included file \"" + name + "\" was not found; searched " + searched +
                       "; add its directory with -I or correct the name",
                   {includer, 0, 0}};
  return nullptr;
}

const SourceFile* IncludeResolver::open(const std::filesystem::path& path) {
  if (failure_) return nullptr;
  const std::string name = path.string();
  auto known =
      std::find_if(files_.begin(), files_.end(), [&](const SourceFile& file) { return file.path == name; });
  if (known == files_.end()) {
    std::error_code unknown;
    // A folder may bear the name of a file that lies elsewhere.
    if (!std::filesystem::exists(path, unknown) || std::filesystem::is_directory(path, unknown)) return nullptr;
    Result<std::string> text = readFile(path, kMostShaderBytes);
    if (!text) {
      failure_ = text.error();
      return nullptr;
    }
    files_.push_back({name, std::move(*text)});
    known = std::prev(files_.end());
  }
  included_bytes_ += known->text.size() + 1;
  open_paths_.push_back(name);
  if (open_paths_.size() > kMaxIncludeDepth || included_bytes_ > kMaxIncludeBytes) {
    failCycle(name);
    open_paths_.pop_back();
    return nullptr;
  }
  return &*known;
}

void IncludeResolver::close() {
  REPRISE_CHECK(!open_paths_.empty(), main_path_);
  open_paths_.pop_back();
}

void IncludeResolver::failCycle(const std::string& path) {
  // The innermost files of the nest show the cycle; the outermost may only lead to it.
  std::string chain;
  const std::size_t shown_files = std::min<std::size_t>(open_paths_.size(), 4);
  for (std::size_t i = open_paths_.size() - shown_files; i < open_paths_.size(); ++i) {
    chain += (chain.empty() ? "" : " includes ") + open_paths_[i];
  }
  const std::string includer = open_paths_.size() > 1 ? open_paths_[open_paths_.size() - 2] : main_path_;
  failure_ = Error{ErrorKind::kInput,
                   "source.include",
                   "including \"" + path + "\" does not end: more than " + std::to_string(kMaxIncludeDepth) +
                       " nested includes or " + std::to_string(kMaxIncludeBytes >> 20) +
                       " MiB of included text (... " + chain + "); break the cycle or add include guards",
                   {includer, 0, 0}};
}

}  // namespace reprise
