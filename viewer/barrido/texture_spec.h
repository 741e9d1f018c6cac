// Textures and mappings on the command line: "marble:octaves=6:scale=0.5" and "sphere:from=normal" become
// choices of the scene and the other way round. What is written reads back as the same bits.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "pipeline/scene/texture_choice.h"

namespace barrido::cli {

/// NAME[:KEY=VALUE]… with the procedures stripes, checker, noise, wood and marble.
///
///  scale        size of a stripe, cell, ring or layer > 0, in the model's units (surface: of u and v);
///               an eighth of the scene (of the picture)
///  axis         X,Y,Z of stripes, rings and layers; 0,1,0
///  space        object (the pattern sticks to it), world, or surface ((u, v) of the mapping or the file)
///  dark, light  R,G,B[,A] in 0..1, linear: the two colours
///  octaves      1..16. Noise, wood and marble.
///  gain         of each octave, 0.01..1; 0.5. Noise, wood and marble.
///  turbulence   how far rings and layers are moved, −100..100. Wood and marble.
///  threshold    −1..1: light above it, dark below. Noise.
/// @return nothing where the text names no procedure: then it is the path of a picture.
/// @throws ValueError naming the key, and where the text looks like a name but is none.
std::optional<scene::SolidTexture> parse_solid(std::string_view spec);

/// As parse_solid reads it.
std::string solid_text(const scene::SolidTexture& solid);

/// SURFACE[:KEY=VALUE]… with the surfaces planar, cylinder, sphere and box.
///
///  from     what leads to the surface: surface (its normal), centre, normal (of the object), reflection
///  at       fragments, or vertices
///  axis     X,Y,Z from pole to pole, or across the plane; 0,1,0
///  centre   X,Y,Z in object space; the middle of the object
///  size     side, height or diameter > 0, in the object's units; the object's
///  repeats  U,V, neither 0; 1,1
///  offset   U,V; 0,0
/// @throws ValueError naming the key.
scene::MappingChoice parse_mapping(std::string_view spec);

/// As parse_mapping reads it.
std::string mapping_text(const scene::MappingChoice& mapping);

}  // namespace barrido::cli
