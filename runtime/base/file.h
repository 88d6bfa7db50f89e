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

// What a file of a kind may have at most.
inline constexpr std::size_t kMostTextBytes = std::size_t{64} << 20;    // TOML, JSON, CSV
inline constexpr std::size_t kMostShaderBytes = std::size_t{16} << 20;  // GLSL, HLSL
inline constexpr std::size_t kMostSpirvBytes = std::size_t{64} << 20;   // as binary or as assembler text
inline constexpr std::size_t kMostImageBytes = std::size_t{512} << 20;
inline constexpr std::size_t kMostFrameBytes = std::size_t{2} << 30;    // texels of a rendered frame, as they lie in memory

// The bytes of a regular file, or of standard input where the path is /dev/stdin. Reads no more than most_bytes and one, even of a file
// that grows, and waits for no pipe but standard input. Errors (kInput): file.missing, file.unreadable, file.not_regular (a folder,
// a device, a pipe), file.too_large.
Result<std::string> readFile(const std::filesystem::path& path, std::size_t most_bytes = kMostTextBytes);

// Standard input to its end; `name` stands for it in messages. Errors: file.unreadable, file.too_large.
Result<std::string> readStandardInput(const std::filesystem::path& name, std::size_t most_bytes);

// As file.too_large has it.
Error tooLarge(const std::filesystem::path& path, std::size_t bytes, std::size_t most_bytes);

// Writes to a temporary name in the same directory, flushes to disk and renames, so that a reader sees the old content or
// the new one. Missing parent directories are made. Errors: file.unwritable (kMachine) with the system's reason; nothing is
// left behind.
Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes);

// Words of a file as they lie on disk (host order). Errors: as readFile; spirv.size if not a multiple of four bytes.
Result<std::vector<std::uint32_t>> readWords(const std::filesystem::path& path, std::size_t most_bytes = kMostSpirvBytes);

std::string_view bytesOf(std::span<const std::uint32_t> words);

}  // namespace reprise
