// Surfaces as discs in a texture, in two levels, for shaders that gather from them (Bunnell, "Dynamic Ambient Occlusion and Indirect
// Lighting", GPU Gems 2, chapter 14, 2005: surface elements with a position, a normal and an area, in a hierarchy).
//
// A row per object, pairs of texels (RGBA32F):
//   pair 0            the object: (centre, area), (0, 0, 0, radius of a sphere about the centre that holds all its vertices)
//   pair 1 + u + v*discs_u  a patch of its surface: (centre, area), (unit normal, 0)
// Patch (u, v) has the triangles whose middle has texture coordinates in [u, u+1)/discs_u x [v, v+1)/discs_v. Centres and normals are means
// weighted by area. A patch without triangles has area 0 at the origin.
#pragma once

#include "profiler/scenario/scenario.h"
#include "profiler/scene/texture.h"

namespace reprise {

// spec.kind is kDiscs. Width 2 + 2 * discs_u * discs_v, height: the number of objects. Where spec.object_space is false, positions are
// those of the world at time 0 by the scenario's own motions. Errors (kInput): texture.objects, an object that the scenario does not have.
Result<TextureImage> buildDiscTexture(const Scenario& scenario, const TextureSpec& spec);

}  // namespace reprise
