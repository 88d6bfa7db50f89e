#include "profiler/measurements/sqlite_version.h"

#include <sqlite3.h>

namespace reprise {

std::string sqliteVersion() { return sqlite3_libversion(); }

}  // namespace reprise
