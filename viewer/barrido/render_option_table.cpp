#include "viewer/barrido/render_option_table.h"

#include <array>

#include "viewer/barrido/light_spec.h"
#include "viewer/barrido/material_spec.h"
#include "viewer/barrido/render_values.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using Options = RenderOptions;
using Text = std::string_view;

constexpr auto kFlag = OptionKind::flag;
constexpr auto kValue = OptionKind::value;

constexpr RenderOption kOutput[] = {
    {{"Output", "--output", "-o", kValue, "OUT",
      "File to write: png, jpg, tif, exr, hdr and more by its extension; - is standard output (PNG). May "
      "hold "
      "{model} {shading} {camera} {frame} {frame:04} {view}; {{ is a brace. Folders that are missing are "
      "made. May "
      "be "
      "left out with --hash or --stats."},
     [](Options& o, Text text) { o.output = text; }},
    {{"Output", "--resolution", "", kValue, "W,H", "Size in pixels, each in 1..16384. Default 1280,720."},
     set_resolution},
    {{"Output", "--view", "", kValue, "LIST",
      "In place of the picture, in false colour with a legend, what it costs and is made of: overdraw, "
      "layers, "
      "illuminations, texels, mip-level, mip-colors, triangles, depth, normals or mach-bands; several with "
      "commas between (picture is the picture itself), or all; a frame for each."},
     set_views},
    {{"Output", "--sheet", "", kFlag, "", "All frames of the call in one picture, each with its name."},
     [](Options& o, Text) { o.sheet = true; }},
    {{"Output", "--compression", "", kValue, "N", "Of PNG, 0 (none) to 9 (smallest). Default 1."},
     [](Options& o, Text text) { o.png_compression = parse_whole(text, 0, 9); }},
    {{"Output", "--hash", "", kFlag, "",
      "Print the SHA-256 of each frame's pixels (8-bit RGBA, top row first) and its name, a line a frame; on "
      "standard error where standard output holds the picture."},
     [](Options& o, Text) { o.hash = true; }},
    {{"Output", "--stats", "", OptionKind::optional_value, "text|json",
      "Print times, and what each shading mode did: illuminations, interpolations, additions and powers per "
      "frame, polygon and scanline. Default text."},
     set_stats},
    {{"Output", "--quiet", "", kFlag, "", "No warnings and no progress; errors are still told."},
     [](Options& o, Text) { o.quiet = true; }},
};

constexpr RenderOption kShading[] = {
    {{"Shading", "--shading", "", kValue, "LIST",
      "flat, gouraud, cheap-phong, phong, several with commas between, or all; a frame for each. Default "
      "phong."},
     set_shadings},
    {{"Shading", "--flat-at", "", kValue, "PLACE",
      "Where flat polygons are lit: centroid (default) or provoking (vertex, as OpenGL)."},
     set_flat_at},
    {{"Shading", "--cheap-phong-power", "", kValue, "PLACE",
      "Where cheap Phong raises to the power: pixel (default) or vertex."},
     set_cheap_phong_power},
    {{"Shading", "--lighting", "", kValue, "MODEL", "Highlights: phong (R.V) or blinn (N.H, default)."},
     set_lighting},
    {{"Shading", "--color-interpolation", "", kValue, "WAY",
      "perspective (default), or screen: linear on the screen, as textbook Gouraud."},
     set_color_interpolation},
    {{"Shading", "--crease-angle", "", kValue, "DEG",
      "Give models without normals smooth ones; edges sharper than DEG (0..180) stay visible. Without this "
      "option such models are faceted, as glTF says."},
     [](Options& o, Text text) { o.settings.crease_angle_deg = parse_degrees(text, 0.0, 180.0); }},
    {{"Shading", "--cull", "", kValue, "FACES", "none, back or front. Default: as the materials say."},
     set_cull},
    {{"Shading", "--wireframe", "", kFlag, "", "Draw edges only."},
     [](Options& o, Text) { o.settings.wireframe = true; }},
    {{"Shading", "--edges", "", kFlag, "", "Draw edges over the surfaces."},
     [](Options& o, Text) { o.settings.overlays.edges = true; }},
    {{"Shading", "--normals", "", kFlag, "", "Draw the vertices' normals as lines."},
     [](Options& o, Text) { o.settings.overlays.normals = true; }},
    {{"Shading", "--material", "", kValue, "SPEC",
      "Properties in place of those of every material, KEY=VALUE with colons between. Keys: color=R,G,B "
      "metallic=M roughness=R, and the formula's own: ambient=R,G,B diffuse=R,G,B specular=R,G,B "
      "emission=R,G,B shininess=N. Colours are linear."},
     [](Options& o, Text text) { o.settings.material = parse_material(text); }},
    {{"Shading", "--fog", "", kValue, "SPEC",
      "linear:START,END[:R,G,B], exp:DENSITY[:R,G,B] or exp2:DENSITY[:R,G,B], by distance from the eye; the "
      "colour is given as it is to be seen. Default: the colour of --background, or dark grey."},
     [](Options& o, Text text) { o.fog = parse_fog(text); }},
};

constexpr RenderOption kTextures[] = {
    {{"Textures", "--no-textures", "", kFlag, "", "Draw as if no material had a texture."},
     [](Options& o, Text) { o.settings.textures = false; }},
    {{"Textures", "--texture-interpolation", "", kValue, "WAY",
      "perspective (default), or affine: linear on the screen, which shows the error."},
     set_texture_interpolation},
    {{"Textures", "--min-filter", "", kValue, "NAME",
      "nearest, linear, nearest-mipmap-nearest, linear-mipmap-nearest, nearest-mipmap-linear or "
      "linear-mipmap-linear. Default: the file's."},
     set_min_filter},
    {{"Textures", "--mag-filter", "", kValue, "NAME", "nearest or linear. Default: the file's."},
     set_mag_filter},
    {{"Textures", "--environment", "", kValue, "PATH",
      "Surroundings for reflections: a folder of six faces (px nx py ny pz nz), a cross (4:3 or 3:4) or a "
      "latitude-longitude picture (2:1), of low or high range; dynamic draws them from each object's "
      "centre."},
     set_environment},
};

constexpr RenderOption kLights[] = {
    {{"Lights", "--light", "", OptionKind::repeatable, "SPEC",
      "A light in place of the file's; may be repeated. TYPE[:KEY=VALUE]... with the types key, fill, back "
      "(of "
      "the three-light set-up; they move with the camera), directional, point, spot. Keys: color=R,G,B "
      "intensity=I (below 0 takes light away) dir=X,Y,Z pos=X,Y,Z attenuation=KC,KL,KQ range=D "
      "cone=INNER,OUTER cutoff=DEG exponent=N space=world|camera. Colours are linear."},
     [](Options& o, Text text) { o.settings.lights.push_back(parse_light(text)); }},
    {{"Lights", "--ambient", "", kValue, "R,G,B", "Ambient light, linear. Default: the file's, or a little."},
     set_ambient},
    {{"Lights", "--light-off", "", kValue, "LIST",
      "Leave out these of the frame's lights: numbers from 1, with commas between."},
     set_lights_off},
    {{"Lights", "--light-markers", "", kFlag, "", "Draw where the lights are."},
     [](Options& o, Text) { o.settings.overlays.light_markers = true; }},
    {{"Lights", "--no-lights", "", kFlag, "", "Leave out all lights but the ambient."},
     [](Options& o, Text) { o.settings.no_lights = true; }},
};

constexpr RenderOption kCamera[] = {
    {{"Camera", "--camera-index", "", kValue, "LIST",
      "Cameras of the file, from 0, several with commas between, or all; a frame for each. none frames the "
      "model. Default: the first; a file without cameras is framed."},
     set_cameras},
    {{"Camera", "--camera-position", "", kValue, "X,Y,Z",
      "Where the eye is, in place of the file's camera; of one that --camera-index names, the view angle and "
      "the near and far plane stay."},
     [](Options& o, Text text) { o.settings.camera.position = parse_point(text); }},
    {{"Camera", "--camera-focal-point", "", kValue, "X,Y,Z",
      "What the eye looks at. Default: the model's middle."},
     [](Options& o, Text text) { o.settings.camera.focal_point = parse_point(text); }},
    {{"Camera", "--camera-view-angle", "", kValue, "DEG", "Vertical field of view, 1..170."},
     [](Options& o, Text text) { o.settings.camera.view_angle_deg = parse_degrees(text, 1.0, 170.0); }},
    {{"Camera", "--camera-up", "", kValue, "X,Y,Z",
      "The direction that is up in the picture, to roll the camera. Default: as --up, or the file's."},
     set_camera_up},
    {{"Camera", "--orthographic-height", "", kValue, "H",
      "Parallel rays; the picture is H of the model's units high."},
     set_orthographic_height},
    {{"Camera", "--up", "", kValue, "AXIS", "+X, -X, +Y, -Y, +Z, -Z or a direction X,Y,Z. Default +Y."},
     set_up},
    {{"Camera", "--azimuth", "", kValue, "DEG", "Turn about the focal point to the right, -360..360."},
     [](Options& o, Text text) { o.settings.camera.azimuth_deg = parse_degrees(text, -360.0, 360.0); }},
    {{"Camera", "--elevation", "", kValue, "DEG", "Turn about the focal point upwards, -90..90."},
     [](Options& o, Text text) { o.settings.camera.elevation_deg = parse_degrees(text, -90.0, 90.0); }},
    {{"Camera", "--turntable", "", kValue, "N", "N frames once round the model; {frame} is 0..N-1."},
     [](Options& o, Text text) { o.turntable = parse_whole(text, 1, 100'000); }},
    {{"Camera", "--scene", "", kValue, "N", "Scene of the file, from 0. Default: the file's default."},
     [](Options& o, Text text) { o.settings.scene_index = parse_whole(text, 0, 1'000'000); }},
};

constexpr RenderOption kAnimation[] = {
    {{"Animation", "--time", "", kValue, "T", "The moment T, in seconds, of the animation."},
     [](Options& o, Text text) { o.time_s = parse_number(text, 0.0, 1e6); }},
    {{"Animation", "--frames", "", kValue, "A:B",
      "Frames A to B, both included; frame n is the moment n/FPS."},
     set_frames},
    {{"Animation", "--fps", "", kValue, "FPS", "Frames a second for --frames, 0.001..1000. Default 30."},
     [](Options& o, Text text) { o.frames_per_second = parse_number(text, 0.001, 1000.0); }},
    {{"Animation", "--animation", "", kValue, "N", "Which animation of the file, from 0. Default 0."},
     [](Options& o, Text text) { o.animation = parse_whole(text, 0, 1'000'000); }},
};

constexpr RenderOption kColour[] = {
    {{"Colour", "--background", "", kValue, "R,G,B[,A]",
      "Colour behind all, 0..1, as it is to be seen (0.5 is half of 255, whatever the exposure); or "
      "environment. "
      "Default: the file's, or dark grey."},
     set_background},
    {{"Colour", "--color-management", "", kValue, "WAY",
      "srgb (default): light is linear, pictures are encoded; none: texels and results as they are, as "
      "OpenGL "
      "1.x."},
     set_color_management},
    {{"Colour", "--exposure", "", kValue, "EV", "Brighten by 2^EV, -32..32. Default 0."},
     [](Options& o, Text text) {
       o.settings.exposure_ev = static_cast<float>(parse_number(text, -32.0, 32.0));
     }},
    {{"Colour", "--tone-map", "", kValue, "MAP", "Values over the maximum: clamp (default) or reinhard."},
     set_tone_map},
};

constexpr RenderOption kExecution[] = {
    {{"Execution", "--threads", "", kValue, "N",
      "Use N threads, 1..1024. Default: all. Never changes a pixel."},
     [](Options& o, Text text) { o.threads = parse_whole(text, 1, 1024); }},
    {{"Execution", "--simd", "", kValue, "SET",
      "Instructions: auto (default), scalar, sse4, avx2, avx512 or neon. Never changes a pixel."},
     set_simd},
    {{"Execution", "--visibility-first", "", kValue, "on|off",
      "Find what is visible before shading (default on). Never changes a pixel."},
     set_visibility_first},
    {{"Execution", "--max-memory", "", kValue, "SIZE", kMaxMemoryHelp},
     [](Options& o, Text text) { o.limits.max_memory = parse_memory(text); }},
    {{"Execution", "--max-seconds", "", kValue, "N", kMaxSecondsHelp},
     [](Options& o, Text text) { o.limits.max_seconds = parse_seconds(text); }},
    {{"Execution", "--settings", "", kValue, "FILE",
      "Options from a JSON file, as barrido-view saves it; those of the command line win."},
     [](Options& o, Text text) { o.settings_path = text; }},
    {{"Execution", "--help", "-h", kFlag, "", "This text."}, [](Options& o, Text) { o.help = true; }},
};

constexpr std::size_t kCount = std::size(kOutput) + std::size(kShading) + std::size(kTextures) +
                               std::size(kLights) + std::size(kCamera) + std::size(kAnimation) +
                               std::size(kColour) + std::size(kExecution);

constexpr auto kTable = [] {
  std::array<RenderOption, kCount> table{};
  std::size_t next = 0;
  const auto append = [&](std::span<const RenderOption> section) {
    for (const RenderOption& option : section) table[next++] = option;
  };
  append(kOutput);
  append(kShading);
  append(kTextures);
  append(kLights);
  append(kCamera);
  append(kAnimation);
  append(kColour);
  append(kExecution);
  return table;
}();

constexpr auto kSyntax = [] {
  std::array<OptionSyntax, kCount> syntax{};
  for (std::size_t i = 0; i < kCount; ++i) syntax[i] = kTable[i].syntax;
  return syntax;
}();

}  // namespace

std::span<const RenderOption> render_option_table() { return kTable; }

std::span<const OptionSyntax> render_syntax() { return kSyntax; }

}  // namespace barrido::cli
