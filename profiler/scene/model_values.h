// What models give to uniforms: joints, weights, factors of the material, lights.
#pragma once

#include <vector>

#include "profiler/scene/frame_state.h"

namespace reprise {

// The numbers of a source, as many as the scene has; a member that is longer keeps zeros.
//   joint_matrices      by joint, bind pose to the model's space (model takes that to the world)
//   joint_count         0: not skinned
//   morph_weights       of the targets that are kept
//   base_color_factor   the material's times the model's colour
//   metallic_roughness  metallic, roughness, normal scale, occlusion strength
//   emissive_factor, alpha_cutoff (0: opaque)
//   light_position      by light: the world's position, w = 1; of directional lights the direction towards them, w = 0
//   light_color         times intensity; w: range, 0 without end
//   light_direction     where a spot light looks, and w: the cosine of its outer cone; of others w = -2
//   light_count
std::vector<float> modelValues(Semantic semantic, const Scenario& scenario, const FrameState& state, std::size_t object);

}  // namespace reprise
