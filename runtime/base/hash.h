// Content hashes: XXH3 with 128 bits, as 32 lower-case hexadecimal digits. They identify content and reveal damage; they
// are no defence against somebody who forges them.
#pragma once

#include <string>
#include <string_view>

namespace reprise {

std::string contentHash(std::string_view bytes);

}  // namespace reprise
