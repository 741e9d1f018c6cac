#include "viewer/view/key_table.h"

#include "viewer/barrido/mode_list.h"
#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/text_format.h"
#include "viewer/view/commands.h"

namespace barrido::view {
namespace {

void ask(Viewer& viewer, Request request) { viewer.requests.push_back(request); }

template <int number>
void toggle_light_number(Viewer& viewer) {
  toggle_light(viewer.active(), number - 1);
}

void toggle_difference(Viewer& viewer) {
  if (!viewer.display.split) viewer.set_split(true);
  viewer.display.difference = !viewer.display.difference;
}

constexpr KeyAction step(std::string_view option, float by = 1.0f) { return {nullptr, option, by}; }

constexpr KeyBinding kMouse[] = {
    {"Mouse", Key::none, 0, "Left drag", "orbit"},
    {"Mouse", Key::none, 0, "Shift+left, middle", "pan"},
    {"Mouse", Key::none, 0, "Wheel, right drag", "zoom"},
    {"Mouse", Key::none, 0, "Ctrl+left drag", "roll"},
    {"Mouse", Key::none, 0, "Click", "split view: keys change this side; inspector: hold the pixel"},
    {"Mouse", Key::none, 0, "Drop", "open models; a picture or a folder becomes the environment"},
};

constexpr KeyBinding kCamera[] = {
    {"Camera", Key::enter, kPlain, "Enter", "reset", [](Viewer& v) { v.reset_camera(); }},
    {"Camera", key_of('1'), kPlain, "1", "front", [](Viewer& v) { v.look_from(StandardView::front); }},
    {"Camera", key_of('3'), kPlain, "3", "right", [](Viewer& v) { v.look_from(StandardView::right); }},
    {"Camera", key_of('7'), kPlain, "7", "top", [](Viewer& v) { v.look_from(StandardView::top); }},
    {"Camera", key_of('9'), kPlain, "9", "isometric",
     [](Viewer& v) { v.look_from(StandardView::isometric); }},
    {"Camera", key_of('5'), kPlain, "5", "orthographic or perspective",
     [](Viewer& v) { v.toggle_orthographic(); }},
};

constexpr cli::ModeList kNextMode("next: ", true, "");

constexpr KeyBinding kShading[] = {
    {"Shading", key_of('S'), kPlain, "S", kNextMode, step("--shading")},
    {"Shading", key_of('S'), kShift, "Shift+S", "previous", step("--shading", -1)},
    {"Shading", key_of('B'), kPlain, "B", "highlights: N·H (Blinn) or R·V (Phong)", step("--lighting")},
    {"Shading", key_of('O'), kPlain, "O", "colours: perspective or linear on the screen",
     step("--color-interpolation")},
    {"Shading", key_of('K'), kPlain, "K", "culling: the materials', none, back, front", step("--cull")},
    {"Shading", key_of('E'), kPlain, "E", "edges over the surfaces", step("--edges")},
    {"Shading", key_of('W'), kPlain, "W", "wireframe", step("--wireframe")},
    {"Shading", key_of('N'), kPlain, "N", "normals", step("--normals")},
    {"Shading", key_of('A'), kPlain, "A", "antialiasing: 1, 4, 9, 16, 64 samples, 16 jittered, adaptive",
     [](Viewer& v) { step_antialiasing(v, 1); }},
    {"Shading", key_of('G'), kPlain, "G", "fog: none, linear, exp, exp2", step_fog},
};

constexpr KeyBinding kTextures[] = {
    {"Textures", key_of('T'), kPlain, "T", "textures on or off", step("--no-textures")},
    {"Textures", key_of('I'), kPlain, "I", "interpolation: perspective or affine",
     step("--texture-interpolation")},
    {"Textures", key_of('F'), kPlain, "F", "next filter for minification, the file's first",
     step("--min-filter")},
    {"Textures", key_of('F'), kShift, "Shift+F", "previous", step("--min-filter", -1)},
    {"Textures", key_of('M'), kPlain, "M", "next filter for magnification", step("--mag-filter")},
    {"Textures", key_of('R'), kPlain, "R", "reflections: none, of the scene, of the environment's picture",
     step_environment},
    {"Textures", key_of('U'), kPlain, "U", "the environment's picture as background",
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
    {"Light", key_of('X'), kPlain, "X", "markers where the lights are", step("--light-markers")},
    {"Light", key_of('L'), kPlain, "L", "brighter by half a stop", step("--exposure", 0.5f)},
    {"Light", key_of('L'), kShift, "Shift+L", "darker", step("--exposure", -0.5f)},
    {"Light", key_of('J'), kPlain, "J", "tone map: clamp or Reinhard", step("--tone-map")},
    {"Light", key_of('Y'), kPlain, "Y", "colours managed (sRGB) or as they are stored",
     step("--color-management")},
};

constexpr KeyBinding kCompare[] = {
    {"Compare", key_of('D'), kPlain, "D", "split view: drag the divider",
     [](Viewer& v) { v.set_split(!v.display.split); }},
    {"Compare", key_of('D'), kShift, "Shift+D", "heat map of the two sides' difference", toggle_difference},
    {"Compare", key_of('Q'), kPlain, "Q", "split view of the same draws: Barrido | OSMesa, an OpenGL",
     [](Viewer& v) { v.set_osmesa(!v.display.osmesa); }},
    {"Compare", key_of('V'), kPlain, "V", "next view: overdraw, texels, mip levels, depth, Mach bands ...",
     step("--view")},
    {"Compare", key_of('V'), kShift, "Shift+V", "previous", step("--view", -1)},
    {"Compare", key_of('P'), kPlain, "P", "inspector: why the pixel at the pointer looks as it does",
     [](Viewer& v) { v.display.inspector = !v.display.inspector; }},
    {"Compare", key_of('A'), kShift, "Shift+A", "keys change the other side",
     [](Viewer& v) {
       if (v.display.split) v.set_active_side(1 - v.active_side());
     }},
};

constexpr KeyBinding kFiles[] = {
    {"Files", Key::right, kPlain, "Right", "next file", [](Viewer& v) { v.step_file(1); }},
    {"Files", Key::left, kPlain, "Left", "previous file", [](Viewer& v) { v.step_file(-1); }},
    {"Files", Key::up, kPlain, "Up", "read the file again", [](Viewer& v) { v.reload(); }},
    {"Files", Key::space, kPlain, "Space", "play or stop the animation",
     [](Viewer& v) { v.toggle_playing(); }},
    {"Files", Key::f12, kPlain, "F12", "write the picture",
     [](Viewer& v) { ask(v, Request::write_picture); }},
    {"Files", key_of('C'), kPlain, "C", "copy the command line that draws this picture",
     [](Viewer& v) { ask(v, Request::copy_command_line); }},
    {"Files", key_of('S'), kControl, "Ctrl+S", "save the settings",
     [](Viewer& v) { ask(v, Request::save_settings); }},
    {"Files", key_of('O'), kControl, "Ctrl+O", "load them again",
     [](Viewer& v) { ask(v, Request::load_settings); }},
};

constexpr KeyBinding kWindow[] = {
    {"Window", key_of('H'), kPlain, "H", "this help", [](Viewer& v) { v.display.help = !v.display.help; }},
    {"Window", Key::tab, kPlain, "Tab", "panel", [](Viewer& v) { v.display.panel = !v.display.panel; }},
    {"Window", key_of('Z'), kPlain, "Z", "frame time and counters",
     [](Viewer& v) { v.display.counters = !v.display.counters; }},
    {"Window", Key::escape, kPlain, "Esc", "close the help, or quit",
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

void KeyAction::operator()(Viewer& viewer) const {
  if (run != nullptr) {
    run(viewer);
  } else {
    cli::step_option(viewer.active(), option, step);
  }
}

std::span<const KeyBinding> key_table() { return kTable; }

bool press(Viewer& viewer, Key key, unsigned modifiers) {
  for (const KeyBinding& binding : kTable) {
    if (!binding.action || binding.key != key || binding.modifiers != modifiers) continue;
    const std::size_t asked = viewer.requests.size();
    binding.action(viewer);
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
