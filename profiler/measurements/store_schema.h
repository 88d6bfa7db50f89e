// The tables of the store and their version.
#pragma once

#include "profiler/measurements/database.h"
#include "runtime/base/result.h"

namespace reprise {

// PRAGMA user_version. Grows when an older Reprise would misread the file; there is no older version to upgrade from yet.
inline constexpr int kStoreVersion = 3;
// PRAGMA application_id: "Rprs".
inline constexpr int kStoreApplicationId = 0x52707273;

// Makes the tables in an empty file; in another one checks that it is a whole store of this version.
// Errors: store.unwritable, store.corrupt (kMachine), store.version (kInput).
Result<void> prepareSchema(Database* database);

}  // namespace reprise
