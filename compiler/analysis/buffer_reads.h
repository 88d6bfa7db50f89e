// Which instructions read memory that a device may keep from lanes whose results go nowhere: storage buffers, of old and new spelling, and
// memory behind pointers. Uniform blocks, push constants and images are read alike in all lanes.
#pragma once

#include <vector>

#include "compiler/analysis/value_graph.h"

namespace reprise {

// By node.
std::vector<bool> readsOfBuffers(const Module& module, const ValueGraph& graph);

}  // namespace reprise
