// Values of options that are more than one field: how each is read into the options and written again. For
// the table of options alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/render_options.h"

namespace barrido::cli {

/// The texts of an option: none, or one for each time it is given.
using Texts = std::vector<std::string>;

// All readers throw ValueError saying what is allowed.
void read_resolution(RenderOptions& options, std::string_view text);
Texts resolution_text(const RenderOptions& options);
void read_stats(RenderOptions& options, std::string_view text);
Texts stats_text(const RenderOptions& options);
void read_material(RenderOptions& options, std::string_view text);
Texts material_texts(const RenderOptions& options);
void read_fog(RenderOptions& options, std::string_view text);
Texts fog_texts(const RenderOptions& options);
void read_environment(RenderOptions& options, std::string_view text);
Texts environment_texts(const RenderOptions& options);
void read_light(RenderOptions& options, std::string_view text);
Texts light_texts(const RenderOptions& options);
void read_lights_off(RenderOptions& options, std::string_view text);
Texts lights_off_texts(const RenderOptions& options);
void read_no_lights(RenderOptions& options, std::string_view text);
Texts no_lights_texts(const RenderOptions& options);
void read_cameras(RenderOptions& options, std::string_view text);
Texts camera_texts(const RenderOptions& options);
void read_up(RenderOptions& options, std::string_view text);
Texts up_text(const RenderOptions& options);
void read_frames(RenderOptions& options, std::string_view text);
Texts frames_texts(const RenderOptions& options);
void read_background(RenderOptions& options, std::string_view text);
Texts background_texts(const RenderOptions& options);
void read_simd(RenderOptions& options, std::string_view text);
Texts simd_text(const RenderOptions& options);
void read_max_memory(RenderOptions& options, std::string_view text);
Texts max_memory_texts(const RenderOptions& options);

}  // namespace barrido::cli
