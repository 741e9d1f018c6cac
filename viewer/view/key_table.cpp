#include "viewer/view/key_table.h"

#include "viewer/barrido/text_format.h"
#include "viewer/view/commands.h"

namespace barrido::view {
namespace {

scene::RenderSettings& settings(Viewer& viewer) { return viewer.active().settings; }

void ask(Viewer& viewer, Request request) { viewer.requests.push_back(request); }

template <class Value>
void swap_between(Value& value, Value one, Value other) {
  value = value == one ? other : one;
}

template <int number>
void toggle_light_number(Viewer& viewer) {
  toggle_light(viewer.active(), number - 1);
}

void toggle_difference(Viewer& viewer) {
  if (!viewer.display.split) viewer.set_split(true);
  viewer.display.difference = !viewer.display.difference;
}

constexpr unsigned kNoModifier = kPlain;

constexpr KeyBinding kMouse[] = {
    {"Mouse", Key::none, 0, "Left drag", "orbit"},
    {"Mouse", Key::none, 0, "Shift+left, middle", "pan"},
    {"Mouse", Key::none, 0, "Wheel, right drag", "zoom"},
    {"Mouse", Key::none, 0, "Ctrl+left drag", "roll"},
    {"Mouse", Key::none, 0, "Click", "split view: keys change this side; inspector: hold the pixel"},
    {"Mouse", Key::none, 0, "Drop", "open models; a picture or a folder becomes the environment"},
};

constexpr KeyBinding kCamera[] = {
    {"Camera", Key::enter, kNoModifier, "Enter", "reset", [](Viewer& v) { v.reset_camera(); }},
    {"Camera", key_of('1'), kNoModifier, "1", "front", [](Viewer& v) { v.look_from(StandardView::front); }},
    {"Camera", key_of('3'), kNoModifier, "3", "right", [](Viewer& v) { v.look_from(StandardView::right); }},
    {"Camera", key_of('7'), kNoModifier, "7", "top", [](Viewer& v) { v.look_from(StandardView::top); }},
    {"Camera", key_of('9'), kNoModifier, "9", "isometric",
     [](Viewer& v) { v.look_from(StandardView::isometric); }},
    {"Camera", key_of('5'), kNoModifier, "5", "orthographic or perspective",
     [](Viewer& v) { v.toggle_orthographic(); }},
};

constexpr KeyBinding kShading[] = {
    {"Shading", key_of('S'), kNoModifier, "S", "next: flat, Gouraud, cheap Phong, Phong",
     [](Viewer& v) { step_shading(v.active(), 1); }},
    {"Shading", key_of('S'), kShift, "Shift+S", "previous", [](Viewer& v) { step_shading(v.active(), -1); }},
    {"Shading", key_of('B'), kNoModifier, "B", "highlights: N·H (Blinn) or R·V (Phong)",
     [](Viewer& v) {
       swap_between(settings(v).lighting, pipeline::SpecularModel::blinn, pipeline::SpecularModel::phong);
     }},
    {"Shading", key_of('O'), kNoModifier, "O", "colours: perspective or linear on the screen",
     [](Viewer& v) {
       swap_between(settings(v).color_interpolation, pipeline::ColorInterpolation::perspective,
                    pipeline::ColorInterpolation::screen);
     }},
    {"Shading", key_of('K'), kNoModifier, "K", "culling: the materials', none, back, front",
     [](Viewer& v) { step_culling(v.active()); }},
    {"Shading", key_of('E'), kNoModifier, "E", "edges over the surfaces",
     [](Viewer& v) { settings(v).overlays.edges = !settings(v).overlays.edges; }},
    {"Shading", key_of('W'), kNoModifier, "W", "wireframe",
     [](Viewer& v) { settings(v).wireframe = !settings(v).wireframe; }},
    {"Shading", key_of('N'), kNoModifier, "N", "normals",
     [](Viewer& v) { settings(v).overlays.normals = !settings(v).overlays.normals; }},
    {"Shading", key_of('G'), kNoModifier, "G", "fog: none, linear, exp, exp2", step_fog},
};

constexpr KeyBinding kTextures[] = {
    {"Textures", key_of('T'), kNoModifier, "T", "textures on or off",
     [](Viewer& v) { settings(v).textures = !settings(v).textures; }},
    {"Textures", key_of('I'), kNoModifier, "I", "interpolation: perspective or affine",
     [](Viewer& v) {
       swap_between(settings(v).texture_interpolation, pipeline::TextureInterpolation::perspective,
                    pipeline::TextureInterpolation::affine);
     }},
    {"Textures", key_of('F'), kNoModifier, "F", "next filter for minification, the file's first",
     [](Viewer& v) { step_min_filter(v.active(), 1); }},
    {"Textures", key_of('F'), kShift, "Shift+F", "previous",
     [](Viewer& v) { step_min_filter(v.active(), -1); }},
    {"Textures", key_of('M'), kNoModifier, "M", "next filter for magnification",
     [](Viewer& v) { step_mag_filter(v.active(), 1); }},
    {"Textures", key_of('R'), kNoModifier, "R",
     "reflections: none, of the scene, of the environment's picture", step_environment},
    {"Textures", key_of('U'), kNoModifier, "U", "the environment's picture as background",
     toggle_environment_background},
};

constexpr KeyBinding kLight[] = {
    {"Light", key_of('1'), kControl, "Ctrl+1...8", "switch that light on or off", toggle_light_number<1>},
    {"", key_of('2'), kControl, "", "", toggle_light_number<2>},
    {"", key_of('3'), kControl, "", "", toggle_light_number<3>},
    {"", key_of('4'), kControl, "", "", toggle_light_number<4>},
    {"", key_of('5'), kControl, "", "", toggle_light_number<5>},
    {"", key_of('6'), kControl, "", "", toggle_light_number<6>},
    {"", key_of('7'), kControl, "", "", toggle_light_number<7>},
    {"", key_of('8'), kControl, "", "", toggle_light_number<8>},
    {"Light", key_of('X'), kNoModifier, "X", "markers where the lights are",
     [](Viewer& v) { settings(v).overlays.light_markers = !settings(v).overlays.light_markers; }},
    {"Light", key_of('L'), kNoModifier, "L", "brighter by half a stop",
     [](Viewer& v) { change_exposure(v.active(), 0.5f); }},
    {"Light", key_of('L'), kShift, "Shift+L", "darker",
     [](Viewer& v) { change_exposure(v.active(), -0.5f); }},
    {"Light", key_of('J'), kNoModifier, "J", "tone map: clamp or Reinhard",
     [](Viewer& v) {
       swap_between(settings(v).tone_map, raster::ToneMap::clamp, raster::ToneMap::reinhard);
     }},
    {"Light", key_of('Y'), kNoModifier, "Y", "colours managed (sRGB) or as they are stored",
     [](Viewer& v) {
       swap_between(settings(v).color_management, scene::ColorManagement::srgb, scene::ColorManagement::none);
     }},
};

constexpr KeyBinding kCompare[] = {
    {"Compare", key_of('D'), kNoModifier, "D", "split view: drag the divider",
     [](Viewer& v) { v.set_split(!v.display.split); }},
    {"Compare", key_of('D'), kShift, "Shift+D", "heat map of the two sides' difference", toggle_difference},
    {"Compare", key_of('Q'), kNoModifier, "Q", "split view of the same draws: Barrido | OSMesa, an OpenGL",
     [](Viewer& v) { v.set_osmesa(!v.display.osmesa); }},
    {"Compare", key_of('V'), kNoModifier, "V",
     "next view: overdraw, texels, mip levels, depth, Mach bands ...",
     [](Viewer& v) { step_view(v.active(), 1); }},
    {"Compare", key_of('V'), kShift, "Shift+V", "previous", [](Viewer& v) { step_view(v.active(), -1); }},
    {"Compare", key_of('P'), kNoModifier, "P", "inspector: why the pixel at the pointer looks as it does",
     [](Viewer& v) { v.display.inspector = !v.display.inspector; }},
    {"Compare", key_of('A'), kNoModifier, "A", "keys change the other side",
     [](Viewer& v) {
       if (v.display.split) v.set_active_side(1 - v.active_side());
     }},
};

constexpr KeyBinding kFiles[] = {
    {"Files", Key::right, kNoModifier, "Right", "next file", [](Viewer& v) { v.step_file(1); }},
    {"Files", Key::left, kNoModifier, "Left", "previous file", [](Viewer& v) { v.step_file(-1); }},
    {"Files", Key::up, kNoModifier, "Up", "read the file again", [](Viewer& v) { v.reload(); }},
    {"Files", Key::space, kNoModifier, "Space", "play or stop the animation",
     [](Viewer& v) { v.toggle_playing(); }},
    {"Files", Key::f12, kNoModifier, "F12", "write the picture",
     [](Viewer& v) { ask(v, Request::write_picture); }},
    {"Files", key_of('C'), kNoModifier, "C", "copy the command line that draws this picture",
     [](Viewer& v) { ask(v, Request::copy_command_line); }},
    {"Files", key_of('S'), kControl, "Ctrl+S", "save the settings",
     [](Viewer& v) { ask(v, Request::save_settings); }},
    {"Files", key_of('O'), kControl, "Ctrl+O", "load them again",
     [](Viewer& v) { ask(v, Request::load_settings); }},
};

constexpr KeyBinding kWindow[] = {
    {"Window", key_of('H'), kNoModifier, "H", "this help",
     [](Viewer& v) { v.display.help = !v.display.help; }},
    {"Window", Key::tab, kNoModifier, "Tab", "panel", [](Viewer& v) { v.display.panel = !v.display.panel; }},
    {"Window", key_of('Z'), kNoModifier, "Z", "frame time and counters",
     [](Viewer& v) { v.display.counters = !v.display.counters; }},
    {"Window", Key::escape, kNoModifier, "Esc", "close the help, or quit",
     [](Viewer& v) {
       if (v.display.help) {
         v.display.help = false;
       } else {
         ask(v, Request::quit);
       }
     }},
};

constexpr std::size_t kCount = std::size(kMouse) + std::size(kCamera) + std::size(kShading) +
                               std::size(kTextures) + std::size(kLight) + std::size(kCompare) +
                               std::size(kFiles) + std::size(kWindow);

constexpr auto kTable = [] {
  std::array<KeyBinding, kCount> table{};
  std::size_t next = 0;
  const auto append = [&](std::span<const KeyBinding> section) {
    for (const KeyBinding& binding : section) table[next++] = binding;
  };
  append(kMouse);
  append(kCamera);
  append(kShading);
  append(kTextures);
  append(kLight);
  append(kCompare);
  append(kFiles);
  append(kWindow);
  return table;
}();

/// Whether the key changes what is around the picture and not the picture.
bool leaves_picture(const KeyBinding& binding) { return binding.section == "Window"; }

}  // namespace

std::span<const KeyBinding> key_table() { return kTable; }

bool press(Viewer& viewer, Key key, unsigned modifiers) {
  for (const KeyBinding& binding : kTable) {
    if (binding.run == nullptr || binding.key != key || binding.modifiers != modifiers) continue;
    const std::size_t asked = viewer.requests.size();
    binding.run(viewer);
    if (!leaves_picture(binding) && viewer.requests.size() == asked) viewer.changed = true;
    return true;
  }
  return false;
}

std::string keys_help() {
  std::string text;
  std::string_view section;
  for (const KeyBinding& binding : kTable) {
    if (binding.name.empty()) continue;
    if (binding.section != section) text += "\n" + std::string(binding.section) + ":\n";
    section = binding.section;
    text += "  " + cli::left(std::string(binding.name), 20) + std::string(binding.help) + "\n";
  }
  return text;
}

}  // namespace barrido::view
