// The version of the database library, as it is linked.
#pragma once

#include <string>

namespace reprise {

std::string sqliteVersion();  // "3.40.1"

}  // namespace reprise
