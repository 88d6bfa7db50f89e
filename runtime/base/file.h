// Files, whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"

namespace reprise {

// The bytes of a file. Errors: file.missing, file.unreadable (kInput); a directory is unreadable.
Result<std::string> readFile(const std::filesystem::path& path);

// Writes to a temporary name in the same directory, flushes to disk and renames, so that a reader sees the old content or
// the new one. Missing parent directories are made. Errors: file.unwritable (kMachine) with the system's reason; nothing is
// left behind.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

// SPIR-V words of a file as they lie on disk (host order). Errors: as readFile; spirv.size if not a multiple of four bytes.
Result<std::vector<std::uint32_t>> readWords(const std::filesystem::path& path);

std::string_view bytesOf(std::span<const std::uint32_t> words);

}  // namespace reprise
