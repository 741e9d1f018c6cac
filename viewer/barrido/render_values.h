// Values of options that have a form of their own, or are more than one field: how each is read and written
// again. For the table of options alone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/render_options.h"

namespace barrido::cli {

/// The texts of an option: none, or one for each time it is given.
using Texts = std::vector<std::string>;

// All that read throw ValueError saying what is allowed.
void read_resolution(RenderOptions& options, std::string_view text);
Texts resolution_text(const RenderOptions& options);
void read_stats(RenderOptions& options, std::string_view text);
Texts stats_text(const RenderOptions& options);
void read_environment(RenderOptions& options, std::string_view text);
Texts environment_texts(const RenderOptions& options);
void read_texture(RenderOptions& options, std::string_view text);
Texts texture_texts(const RenderOptions& options);
void read_mapping(RenderOptions& options, std::string_view text);
Texts mapping_texts(const RenderOptions& options);
void read_displacement(RenderOptions& options, std::string_view text);
Texts displacement_texts(const RenderOptions& options);
void read_light(RenderOptions& options, std::string_view text);
Texts light_texts(const RenderOptions& options);
void read_lights_off(RenderOptions& options, std::string_view text);
Texts lights_off_texts(const RenderOptions& options);
void read_no_lights(RenderOptions& options, std::string_view text);
Texts no_lights_texts(const RenderOptions& options);
void read_cameras(RenderOptions& options, std::string_view text);
Texts camera_texts(const RenderOptions& options);
void read_background(RenderOptions& options, std::string_view text);
Texts background_texts(const RenderOptions& options);

glm::vec3 parse_up(std::string_view text);
FrameRange parse_frames(std::string_view text);
std::string frames_text(const FrameRange& frames);
raster::SimdTarget parse_simd(std::string_view text);
std::string simd_text(const raster::SimdTarget& target);
scene::Shutter parse_shutter(std::string_view text);
std::string shutter_text(const scene::Shutter& shutter);
scene::PixelPlace parse_pixel_place(std::string_view text);
std::string pixel_place_text(const scene::PixelPlace& place);
// Texts stand for themselves.
std::string stored(std::string_view text);
std::string copied(const std::string& text);

}  // namespace barrido::cli
