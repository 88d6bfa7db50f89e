// A person-like figure, made up: capsules about the bones of a skeleton of 13 joints, one skinned mesh of 1.8 metres, with a cycle of a
// walk as its only animation ("walk", one second, two steps; the figure stays where it is and looks along +z).
//
// Vertices near a joint are skinned to both bones. The base colour is white, so that each figure can have a colour of its own.
#pragma once

#include "profiler/gltf/gltf_scene.h"

namespace reprise {

// segments: around each capsule, at least 3.
GltfScene makeFigure(int segments);

}  // namespace reprise
