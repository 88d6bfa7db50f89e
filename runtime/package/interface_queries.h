// What is often asked of an interface.
#pragma once

#include <optional>
#include <vector>

#include "runtime/package/interface.h"

namespace reprise {

// The first byte behind a member.
inline std::uint32_t endOf(const BlockMember& member) {
  const int vectors = member.row_major ? member.rows : member.columns;
  const std::uint32_t one = member.columns == 1 ? 4u * static_cast<std::uint32_t>(member.rows)
                                                : member.matrix_stride * static_cast<std::uint32_t>(vectors);
  return member.offset + (member.array_length == 0 ? one : member.array_stride * member.array_length);
}

// The length of the shortest array of descriptors; nullopt where there is none.
inline std::optional<std::uint32_t> shortestDescriptorArray(const std::vector<Descriptor>& descriptors) {
  std::optional<std::uint32_t> shortest;
  for (const Descriptor& descriptor : descriptors)
    if (descriptor.count > 1 && (!shortest || descriptor.count < *shortest)) shortest = descriptor.count;
  return shortest;
}

}  // namespace reprise
