// The models of a scenario: [[model]] tables, the files that they name, and the objects that come of them.
#pragma once

#include <filesystem>

#include "profiler/scenario/table_reader.h"

namespace reprise {

// After the objects, whose names the models must not bear.
void readModels(TableReader& root, const std::filesystem::path& directory, Scenario& scenario);

// Reads the files, each once, and appends an object for every primitive that is drawn: "name.0", "name.1", ... in the order of the file.
// Errors (kInput): those of readGltf; scenario.value (no such animation).
Result<void> loadModels(Scenario& scenario);

// What the model plays; null: the pose at rest.
const GltfAnimation* animationOf(const ModelSpec& model);

}  // namespace reprise
