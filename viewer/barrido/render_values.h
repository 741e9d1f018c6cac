// Values of single options of `barrido render`: each function reads the text of one option into the options.
#pragma once

#include <string_view>

#include "viewer/barrido/render_options.h"

namespace barrido::cli {

/// All throw ValueError saying what is allowed.
void set_resolution(RenderOptions& options, std::string_view text);
void set_shadings(RenderOptions& options, std::string_view text);
void set_views(RenderOptions& options, std::string_view text);
void set_stats(RenderOptions& options, std::string_view text);
void set_environment(RenderOptions& options, std::string_view text);
void set_background(RenderOptions& options, std::string_view text);
void set_ambient(RenderOptions& options, std::string_view text);
void set_cameras(RenderOptions& options, std::string_view text);
void set_up(RenderOptions& options, std::string_view text);
void set_camera_up(RenderOptions& options, std::string_view text);
void set_orthographic_height(RenderOptions& options, std::string_view text);
void set_lights_off(RenderOptions& options, std::string_view text);
void set_frames(RenderOptions& options, std::string_view text);
void set_simd(RenderOptions& options, std::string_view text);
void set_flat_at(RenderOptions& options, std::string_view text);
void set_cheap_phong_power(RenderOptions& options, std::string_view text);
void set_lighting(RenderOptions& options, std::string_view text);
void set_color_interpolation(RenderOptions& options, std::string_view text);
void set_texture_interpolation(RenderOptions& options, std::string_view text);
void set_min_filter(RenderOptions& options, std::string_view text);
void set_mag_filter(RenderOptions& options, std::string_view text);
void set_cull(RenderOptions& options, std::string_view text);
void set_color_management(RenderOptions& options, std::string_view text);
void set_tone_map(RenderOptions& options, std::string_view text);
void set_visibility_first(RenderOptions& options, std::string_view text);

/// X,Y,Z of any finite size.
glm::vec3 parse_point(std::string_view text);
/// Degrees in [least, most].
float parse_degrees(std::string_view text, double least, double most);

}  // namespace barrido::cli
