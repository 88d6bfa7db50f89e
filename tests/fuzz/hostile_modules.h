// Valid fragment modules of at most 1 MiB that are made to cost whoever reads them as much as possible.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace reprise {

inline constexpr std::size_t kMostFileBytes = 1u << 20;

struct HostileModule {
  std::string name;                                            // of a test: letters and digits
  std::function<std::vector<std::uint32_t>(std::size_t)> make;  // of a size: instructions, nesting, whatever the module has many of
  std::size_t size = 0;                                        // the largest that fits into the file, or that the validator takes
};

const std::vector<HostileModule>& hostileModules();

// A fragment shader of about `instructions` instructions as real ones are: arithmetic of varyings in a chain, with names.
std::vector<std::uint32_t> longShader(std::size_t instructions);

}  // namespace reprise
