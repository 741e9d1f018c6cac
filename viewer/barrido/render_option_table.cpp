#include "viewer/barrido/render_option_table.h"

#include <array>
#include <stdexcept>

#include "viewer/barrido/map_spec.h"
#include "viewer/barrido/mode_list.h"
#include "viewer/barrido/render_option_rows.h"
#include "viewer/barrido/render_values.h"

namespace barrido::cli {
namespace {

constexpr RenderOption kOutputOptions[] = {
    with_short("-o", option("--output", "OUT", kOutput,
                            "File to write: png, jpg, tif, exr, hdr and more by its extension; - is standard "
                            "output (PNG). --turntable and --frames make gif and webp an animation. May hold "
                            "{model} {folder} {shading} {camera} {frame} {frame:04} {view}; {{ "
                            "is a brace. Folders that are missing are made. May be left out with --hash or "
                            "--stats.",
                            parsed<&Options::output, stored, copied>())),
    option("--resolution", "W,H", kPicture, "Size in pixels, each in 1..16384. Default 1280,720.",
           always_written(custom<read_resolution, resolution_text>()), no_editor("the window has its size")),
    option(
        "--view", "LIST", kDrawing,
        "In place of the picture, in false colour with a legend, what it costs and is made of: overdraw, "
        "layers, illuminations, texels, mip-level, mip-colors, texel-density, coordinates, triangles, depth, "
        "normals, mach-bands, samples or slivers; "
        "several with commas between (picture is the picture itself), or all; a frame for each.",
        choices<&Options::views, 1>(), kViewEditor),
    option("--sheet", "", kOutput, "All frames of the call in one picture, each with its name.",
           flag<&Options::sheet>()),
    option(
        "--raw", "", kOutput,
        "With -o -: all frames one after the other as bare pixels (8-bit RGBA, top row first), for programs "
        "that make films.",
        flag<&Options::raw>()),
    option("--compression", "N", kOutput, "Of PNG, 0 (none) to 9 (smallest). Default 1.",
           number<&Options::png_compression>(0, 9)),
    option("--hash", "", kOutput,
           "Print the SHA-256 of each frame's pixels (8-bit RGBA, top row first) and its name, a line a "
           "frame; on standard error where standard output holds the picture.",
           flag<&Options::hash>()),
    option("--stats", "text|json", kOutput,
           "Print times, and what each shading mode did: illuminations, interpolations, additions and powers "
           "per frame, polygon and scanline. Default text.",
           custom<read_stats, stats_text>(OptionKind::optional_value)),
    option("--quiet", "", kCall, "No warnings and no progress; errors are still told.",
           flag<&Options::quiet>()),
};

constexpr ModeList kShadingHelp("", false,
                                ", several with commas between, or all; a frame for each. Default phong.");

constexpr RenderOption kShadingOptions[] = {
    option("--shading", "LIST", kPicture, kShadingHelp, choices<&Options::shadings>(), widget("shading")),
    option("--flat-at", "PLACE", kPicture,
           "Where flat polygons are lit: centroid (default) or provoking (vertex, as OpenGL).",
           choice<&Settings::flat_at>(), widget("flat, lit at")),
    option("--cheap-phong-power", "PLACE", kPicture,
           "Where cheap Phong raises to the power: pixel (default) or vertex.",
           choice<&Settings::cheap_phong_power>(), widget("cheap, power at")),
    option("--lighting", "MODEL", kPicture, "Highlights: phong (R.V) or blinn (N.H, default).",
           choice<&Settings::lighting>(), widget("highlights")),
    option("--color-interpolation", "WAY", kPicture,
           "perspective (default), or screen: linear on the screen, as textbook Gouraud.",
           choice<&Settings::color_interpolation>(), widget("colours")),
    option("--crease-angle", "DEG", kPicture,
           "Give models without normals smooth ones; edges sharper than DEG (0..180) stay visible. Without "
           "this option such models are faceted, as glTF says.",
           number<&Settings::crease_angle_deg>(0, 180),
           slider("smooth normals", {0, 180}, "%.0f deg", 40.0f)),
    option("--cull", "FACES", kPicture, "none, back or front. Default: as the materials say.",
           choice<&Settings::cull, 3>(), list("culling", "the materials'")),
    option("--transparency", "WAY", kPicture,
           "Order of transparent surfaces: sorted (triangles by the distance of their middles) or exact (by "
           "depth "
           "in each pixel, also where surfaces pass through each other; up to 64 layers). Default sorted.",
           choice<&Settings::transparency>(), widget("transparency")),
    option("--wireframe", "", kPicture, "Draw edges only.", flag<&Settings::wireframe>(),
           widget("wireframe")),
    option("--edges", "", kPicture, "Draw edges over the surfaces.", flag<&Overlays::edges>(),
           beside("edges")),
    option("--normals", "", kPicture, "Draw the vertices' normals as lines.", flag<&Overlays::normals>(),
           beside("normals")),
    option("--material", "SPEC", kPicture,
           "Properties in place of those of every material, KEY=VALUE with colons between. Keys: color=R,G,B "
           "metallic=M roughness=R, and the formula's own: ambient=R,G,B diffuse=R,G,B specular=R,G,B "
           "emission=R,G,B shininess=N. Colours are linear.",
           parsed<&Settings::material, parse_material, material_text>(), by_hand("Material")),
    option(
        "--displacement", "PATH", kPicture,
        "Move all surfaces along their normals, before anything else is done with them, by the heights of "
        "a picture (its red), of a procedure as --texture has them, or constant. Default: as the materials "
        "say.",
        custom<read_displacement, displacement_texts>(), no_editor("the call names its picture")),
    option("--displacement-scale", "S", kPicture,
           "How far a height of 1 moves, in the model's units; below 0 inwards. Default: the materials', or "
           "0.1.",
           number<&UserDisplacement::scale>(-1e6, 1e6), slider("displacement", {-1, 1}, "%.3f", 0.1f)),
    option("--displacement-bias", "B", kPicture,
           "How far a height of 0 moves. Default: the materials', or 0.",
           number<&UserDisplacement::bias>(-1e6, 1e6), slider("from", {-1, 1}, "%.3f", 0.0f)),
    option("--displacement-pieces", "N", kPicture,
           "Pieces that each edge is cut into, 1..256. Default: the materials', or as long as a texel.",
           number<&UserDisplacement::pieces>(1, scene::kMaxDisplacedPieces),
           slider("pieces", {1, 64}, "%.0f", 8.0f)),
    option("--fog", "SPEC", kPicture,
           "linear:START,END[:R,G,B], exp:DENSITY[:R,G,B] or exp2:DENSITY[:R,G,B], by distance from the eye; "
           "the colour is given as it is to be seen. Default: the colour of --background, or dark grey.",
           parsed<&Options::fog, parse_fog, fog_text>(), by_hand("Fog")),
};

constexpr RenderOption kTextureOptions[] = {
    option("--no-textures", "", kPicture, "Draw as if no material had a texture.",
           flag<&Settings::textures, false>(), kTexturesEditor),
    option("--texture", "SPEC", kPicture,
           "In place of every material's picture: PATH of a picture, or a procedure NAME[:KEY=VALUE]... with "
           "the names stripes, checker, noise, wood, marble. Keys: scale=S (size of a stripe, cell, ring or "
           "layer) axis=X,Y,Z space=object|world|surface dark=R,G,B[,A] light=R,G,B[,A] octaves=1..16 gain=G "
           "turbulence=T threshold=T. Colours are linear.",
           custom<read_texture, texture_texts>(), by_hand("Textures")),
    option("--mapping", "SPEC", kPicture,
           "Coordinates from an intermediate surface, SURFACE[:KEY=VALUE]... with planar, cylinder, sphere, "
           "box. Keys: from=surface|centre|normal|reflection (what leads to it) at=fragments|vertices "
           "axis=X,Y,Z centre=X,Y,Z size=S repeats=U,V offset=U,V.",
           custom<read_mapping, mapping_texts>(), by_hand("Textures")),
    option("--tiles", "WAY", kPicture,
           "What happens to each repetition of a picture, by a hash of its number: none (default), rotate "
           "(quarter turns), shift or both.",
           choice<&scene::TextureChoice::tiles>(), list("tiles", "the materials'")),
    option("--mapping-lines", "", kPicture,
           "Draw the intermediate surface of a mapping, its seam and poles in red.",
           flag<&Overlays::mapping>(), widget("mapping's surface")),
    option("--texture-interpolation", "WAY", kPicture,
           "perspective (default), or affine: linear on the screen, which shows the error.",
           choice<&Settings::texture_interpolation>(), widget("interpolation")),
    option("--min-filter", "NAME", kPicture,
           "nearest, linear, nearest-mipmap-nearest, linear-mipmap-nearest, nearest-mipmap-linear, "
           "linear-mipmap-linear, footprint (the mean of all texels under a pixel, Catmull's) or corners (of "
           "those under its corners, Crow's). Default: the file's.",
           choice<&Settings::min_filter>(), list("smaller", "the file's")),
    option("--mag-filter", "NAME", kPicture, "nearest or linear. Default: the file's.",
           choice<&Settings::mag_filter>(), list("larger", "the file's")),
    option("--no-maps", "", kPicture,
           "Draw without the maps that change normals, ambient light, opacity or highlights.",
           flag<&MapOverride::drawn, false>(), kMapsEditor),
    option(
        "--bump", "PATH[:KEY=VALUE]...", kPicture,
        "Tilt the normals of all surfaces by the slopes of a picture's heights, in Phong shading. Keys: "
        "height=H of white over black, default 0.05; form=invariant (default: H in repeats of the picture, "
        "the same at every size of the object) or blinn (H in the model's units); repeat=U,V.",
        parsed<&MapOverride::bump, parse_bump, bump_text>(), kMapPath),
    option("--transparency-map", "PATH[:repeat=U,V]", kPicture,
           "Opacity of all surfaces by a picture's red: black lets all through, white is opaque.",
           parsed<&MapOverride::transparency, parse_map, map_text>(), kMapPath),
    option("--specularity-map", "PATH[:repeat=U,V]", kPicture,
           "Multiply the highlights of all surfaces by a picture.",
           parsed<&MapOverride::specularity, parse_map, map_text>(), kMapPath),
    option("--anisotropy", "N", kPicture,
           "Where a pixel is longer than wide on a texture, up to N samples along it, 1..16, of smaller mip "
           "levels: less blur in the distance. Default 1.",
           number<&Settings::max_anisotropy>(1, raster::kMaxAnisotropy),
           slider("anisotropy", {1, raster::kMaxAnisotropy}, "%.0f")),
    option("--environment", "PATH", kPicture,
           "Surroundings for reflections: a folder of six faces (px nx py ny pz nz), a cross (4:3 or 3:4) or "
           "a latitude-longitude picture (2:1), of low or high range; dynamic draws them from each object's "
           "centre.",
           custom<read_environment, environment_texts>(), by_hand("Environment")),
};

constexpr RenderOption kLightOptions[] = {
    option("--light", "SPEC", kPicture,
           "A light in place of the file's; may be repeated. TYPE[:KEY=VALUE]... with the types key, fill, "
           "back (of the three-light set-up; they move with the camera), directional, point, spot. Keys: "
           "color=R,G,B intensity=I (below 0 takes light away) dir=X,Y,Z pos=X,Y,Z attenuation=KC,KL,KQ "
           "range=D cone=INNER,OUTER cutoff=DEG exponent=N space=world|camera. Colours are linear.",
           custom<read_light, light_texts>(OptionKind::repeatable), by_hand("Lights")),
    option("--ambient", "R,G,B", kPicture, "Ambient light, linear. Default: the file's, or a little.",
           vector<&Settings::ambient>({0.0, 1e6}), by_hand("Lights")),
    option("--light-off", "LIST", kPicture,
           "Leave out these of the frame's lights: numbers from 1, with commas between.",
           custom<read_lights_off, lights_off_texts>(), by_hand("Lights")),
    option("--light-markers", "", kPicture, "Draw where the lights are.", flag<&Overlays::light_markers>(),
           widget("markers")),
    option("--no-lights", "", kPicture, "Leave out all lights but the ambient.",
           custom<read_no_lights, no_lights_texts>(OptionKind::flag), by_hand("Lights")),
};

constexpr RenderOption kCameraOptions[] = {
    option("--camera-index", "LIST", kPicture,
           "Cameras of the file, from 0, several with commas between, or all; a frame for each. none frames "
           "the model. Default: the first; a file without cameras is framed.",
           custom<read_cameras, camera_texts>(), by_hand("Camera")),
    option(
        "--camera-position", "X,Y,Z", kPicture,
        "Where the eye is, in place of the file's camera; of one that --camera-index names, the view angle "
        "and the near and far plane stay.",
        parsed<&Camera::position, parse_place, shortest>(), by_hand("Camera")),
    option("--camera-focal-point", "X,Y,Z", kPicture, "What the eye looks at. Default: the model's middle.",
           parsed<&Camera::focal_point, parse_place, shortest>(), by_hand("Camera")),
    option("--camera-view-angle", "DEG", kPicture, "Vertical field of view, 1..170.",
           number<&Camera::view_angle_deg>(1, 170), by_hand("Camera")),
    option("--camera-up", "X,Y,Z", kPicture,
           "The direction that is up in the picture, to roll the camera. Default: as --up, or the file's.",
           parsed<&Camera::view_up, parse_direction, shortest>(), no_editor("the mouse rolls the camera")),
    option("--orthographic-height", "H", kPicture,
           "Parallel rays; the picture is H of the model's units high.",
           number<&Camera::orthographic_height>(1e-18, kAnyNumber), by_hand("Camera")),
    option("--up", "AXIS", kPicture, "+X, -X, +Y, -Y, +Z, -Z or a direction X,Y,Z. Default +Y.",
           parsed<&Camera::up, parse_up, shortest>(), no_editor("a fact of the model")),
    option("--azimuth", "DEG", kPicture, "Turn about the focal point to the right, -360..360.",
           number<&Camera::azimuth_deg>(-360, 360), no_editor("the mouse moves the eye")),
    option("--elevation", "DEG", kPicture, "Turn about the focal point upwards, -90..90.",
           number<&Camera::elevation_deg>(-90, 90), no_editor("the mouse moves the eye")),
    option("--turntable", "N", kOutput, "N frames once round the model; {frame} is 0..N-1.",
           number<&Options::turntable>(1, 100'000)),
    option("--scene", "N", kPicture, "Scene of the file, from 0. Default: the file's default.",
           number<&Settings::scene_index>(0, 1'000'000), no_editor("few files have several")),
    option("--variant", "NAME", kPicture, "Variant of the materials (KHR_materials_variants).",
           parsed<&Settings::variant, stored, copied>(), no_editor("few files have any")),
};

constexpr RenderOption kAnimationOptions[] = {
    option("--time", "T", kPicture, "The moment T, in seconds, of the animation.",
           number<&Options::time_s>(0, 1e6), by_hand("Animation")),
    option("--frames", "A:B", kOutput, "Frames A to B, both included; frame n is the moment n/FPS.",
           parsed<&Options::frames, parse_frames, frames_text>()),
    option("--fps", "FPS", kOutput,
           "Frames a second for --frames and --shutter, and of animations that are written, 0.001..1000. "
           "Default 30.",
           number<&Options::frames_per_second>(0.001, 1000)),
    option("--animation", "N", kPicture, "Which animation of the file, from 0. Default 0.",
           number<&Options::animation>(0, 1'000'000), by_hand("Animation")),
};

constexpr RenderOption kSampleOptions[] = {
    option("--samples", "N", kPicture,
           "Samples a pixel, 1..4096; 4, 9, 16 ... are grids of 2 x 2, 3 x 3, 4 x 4 ... Default 1, at the "
           "pixel's centre.",
           number<&Samples::count>(1, 4096), slider("samples", {1, 64}, "%.0f")),
    option("--sampling", "WAY", kPicture,
           "Where they lie: uniform (default), the middles of a grid's cells, the same in every pixel; "
           "jittered, one random place in each cell, others in every pixel; or adaptive, the corners of each "
           "pixel, and more where they differ, whatever --samples says.",
           choice<&Samples::sampling>(), widget("sampling")),
    option("--adaptive-threshold", "T", kPicture,
           "Adaptive: pixels are cut into quarters where a channel, as it is shown, differs by more than T, "
           "0..1. Default 0.1.",
           number<&Samples::adaptive_threshold>(0, 1), slider("threshold", {0, 0.5}, "%.2f")),
    option("--adaptive-depth", "N", kPicture,
           "Adaptive: how often a pixel is cut at most, 1..4: 9, 25, 81 or 289 samples. Default 2.",
           number<&Samples::adaptive_depth>(1, 4), slider("depth", {1, 4}, "%.0f")),
    option("--adaptive-corners-only", "", kPicture,
           "Adaptive: lose what lies between the corners of a pixel, as the textbook's rule does.",
           flag<&Samples::corners_only>(), widget("corners only")),
    option("--pixel-filter", "NAME[:radius=R]", kPicture,
           "What the samples are weighted with: box (default), triangle, cone, gaussian or mitchell; R is "
           "the half width in pixels, 0.01..8. Default 0.5, 1, 1, 1.5, 2.",
           parsed<&Samples::filter, parse_pixel_filter, pixel_filter_text>(), by_hand("Samples")),
    option("--filter-what", "WHAT", kPicture,
           "What is averaged: light (default), or display: colours as they are shown, which leaves edges of "
           "bright things jagged.",
           choice<&Samples::order>(), widget("averages")),
    option("--seed", "S", kPicture, "Of all random numbers, 0..1000000000. Default 0.",
           number<&Samples::seed>(0, 1'000'000'000), slider("seed", {0, 100}, "%.0f")),
    option("--shutter", "OPEN,CLOSE", kPicture,
           "Motion blur: samples are spread over this time, in frames after the frame's own (see --fps); "
           "0,0.5 is a film camera's. Also of a turntable's turn.",
           parsed<&Samples::shutter, parse_shutter, shutter_text>(), by_hand("Samples")),
    option("--lens-radius", "R", kPicture,
           "Depth of field: the lens has this radius, in the model's units. Default: a pinhole.",
           number<&Samples::lens_radius>(0, kAnyNumber), by_hand("Samples")),
    option("--f-stop", "N", kPicture,
           "The same by the f-number of a lens before a picture 24 mm high, in a model whose unit is the "
           "metre, 0.01..1000.",
           number<&Samples::f_stop>(0.01, 1000), by_hand("Samples")),
    option("--focus-distance", "D", kPicture,
           "What is so far away along the line of sight is sharp. Default: the focal point.",
           number<&Samples::focus_distance>(1e-18, kAnyNumber), by_hand("Samples")),
    option("--focus-pixel", "X,Y", kPicture,
           "What is seen at this pixel is sharp, counted from the upper left one.",
           parsed<&Samples::focus_pixel, parse_pixel_place, pixel_place_text>(), by_hand("Samples")),
};

constexpr RenderOption kColourOptions[] = {
    option("--background", "R,G,B[,A]", kPicture,
           "Colour behind all, 0..1, as it is to be seen (0.5 is half of 255, whatever the exposure); or "
           "environment. Default: the file's, or dark grey.",
           custom<read_background, background_texts>(), by_hand("Colour")),
    option("--color-management", "WAY", kPicture,
           "srgb (default): light is linear, pictures are encoded; none: texels and results as they are, as "
           "OpenGL 1.x.",
           choice<&Settings::color_management>(), widget("colours")),
    option("--exposure", "EV", kPicture, "Brighten by 2^EV, -32..32. Default 0.",
           number<&Settings::exposure_ev>(-32, 32), slider("exposure", {-8, 8}, "%.2f EV")),
    option("--tone-map", "MAP", kPicture, "Values over the maximum: clamp (default) or reinhard.",
           choice<&Settings::tone_map>(), widget("tone map")),
};

constexpr RenderOption kExecutionOptions[] = {
    option("--threads", "N", kCall, "Use N threads, 1..1024. Default: all. Never changes a pixel.",
           number<&Options::threads>(1, 1024)),
    option("--simd", "SET", kCall,
           "Instructions: auto (default), scalar, sse4, avx2, avx512 or neon. Never changes a pixel.",
           parsed<&Options::simd, parse_simd, simd_text>()),
    option("--visibility-first", "on|off", kDrawing,
           "Find what is visible before shading (default on). Never changes a pixel.",
           choice<&Settings::visibility_first>(), no_editor("never changes a pixel")),
    option("--max-memory", "SIZE", kCall, kMaxMemoryHelp,
           parsed<&LimitOptions::max_memory, parse_memory, memory_text>()),
    option("--max-seconds", "N", kCall, kMaxSecondsHelp, number<&LimitOptions::max_seconds>(0.1, 1e6)),
    option("--settings", "FILE", kCall,
           "Options from a JSON file, as barrido-view saves it; those of the command line win.",
           parsed<&Options::settings_path, stored, copied>()),
    with_short("-h", option("--help", "", kCall, "This text.", flag<&Options::help>())),
};

struct Section {
  std::string_view name;
  std::span<const RenderOption> rows;
};

constexpr Section kSections[] = {
    {"Output", kOutputOptions},  {"Shading", kShadingOptions}, {"Textures", kTextureOptions},
    {"Lights", kLightOptions},   {"Camera", kCameraOptions},   {"Animation", kAnimationOptions},
    {"Samples", kSampleOptions}, {"Colour", kColourOptions},   {"Execution", kExecutionOptions},
};

constexpr std::size_t kCount = [] {
  std::size_t count = 0;
  for (const Section& section : kSections) count += section.rows.size();
  return count;
}();

constexpr auto kTable = [] {
  std::array<RenderOption, kCount> table{};
  std::size_t next = 0;
  for (const Section& section : kSections) {
    for (RenderOption row : section.rows) {
      row.syntax.section = section.name;
      table[next++] = row;
    }
  }
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

const RenderOption& render_option(std::string_view name) {
  for (const RenderOption& row : kTable) {
    if (row.syntax.name == name) return row;
  }
  throw std::out_of_range("no option " + std::string(name));
}

}  // namespace barrido::cli
