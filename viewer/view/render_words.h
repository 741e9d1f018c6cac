// The command line that gives a picture again: options in, words of `barrido render` out. Parsing the words
// gives the same options, bit for bit. Knows no window.
#pragma once

#include <string>
#include <vector>

#include "pipeline/scene/render_scene.h"
#include "viewer/barrido/render_options.h"

namespace barrido::view {

/// "point:pos=1,2,3:intensity=2", as cli::parse_light reads it. Angles are the degrees that give the light's
/// radians, or the nearest there are.
std::string light_text(const scene::UserLight& light);

/// "linear:2,10:0.5,0.6,0.7", as cli::parse_fog reads it.
std::string fog_text(const cli::FogChoice& fog);

/// "roughness=0.3:diffuse=1,0,0", as cli::parse_material reads it; empty when nothing is overridden.
std::string material_text(const scene::MaterialOverride& material);

/// Options that describe the picture, where they differ from the defaults, in the order of the help; the size
/// always. No file names, nothing about output and execution.
std::vector<std::string> words_of(const cli::RenderOptions& options);

/// One line for a POSIX shell: words with other than harmless letters are quoted.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace barrido::view
