#include "viewer/barrido/help.h"

#include <algorithm>

#include "viewer/barrido/call_limits.h"
#include "viewer/barrido/diff_options.h"
#include "viewer/barrido/inspect_options.h"
#include "viewer/barrido/lab_options.h"
#include "viewer/barrido/render_options.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

constexpr std::size_t kWidth = 99;

constexpr OptionSyntax kInfoSyntax[] = {
    {"Options", "--json", "", OptionKind::flag, "", "As JSON, for programs."},
    {"Options", "--validate", "", OptionKind::flag, "",
     "Check the file against glTF 2.0 instead, in the terms of the Khronos glTF validator."},
    {"Options", "--max-memory", "", OptionKind::value, "SIZE", kMaxMemoryHelp},
    {"Options", "--max-seconds", "", OptionKind::value, "N", kMaxSecondsHelp},
    {"Options", "--help", "-h", OptionKind::flag, "", "This text."},
};

constexpr const char* kGeneralHelp =
    R"(barrido draws 3D models into pictures on the processor, by scanlines, as fixed-function OpenGL did.

Usage:
  barrido render FILE... -o OUT [OPTIONS]    draw glTF models (.gltf, .glb)
  barrido inspect FILE --pixel X,Y [OPTIONS] why a pixel has its colour, number by number
  barrido info FILE [--json]                 what a model holds, and how well it will be drawn
  barrido info --validate FILE [--json]      what is wrong with a model
  barrido lab sampling FILE [OPTIONS]        how fast errors fall with the number of samples
  barrido diff A B [OPTIONS]                 whether two pictures, or two folders, are the same
  barrido COMMAND --help                     the options of a command, with examples
  barrido --version

Exit status: 0 fine, 1 pictures differ, 2 error.
)";

constexpr const char* kRenderUsage =
    R"(Usage: barrido render FILE... -o OUT [OPTIONS]

Draws each glTF model (.gltf, .glb) and writes one picture a frame. A frame is made for every FILE,
camera, shading mode and moment asked for. A FILE is loaded once, whatever the number of frames.
)";

constexpr const char* kRenderNotes = R"(
Colours: --background and --fog take colours as they are to be seen; lights are linear.
Exit status: 0 fine, 2 error; no picture is left half-written.

Examples:
  barrido render teapot.glb -o teapot.png
  barrido render teapot.glb -o sheet.png --sheet --shading all --resolution 640,480
  barrido render a.glb b.glb -o "out/{model}-{shading}.jpg" --shading flat,phong
  barrido render car.glb -o "turn/{frame:03}.png" --turntable 120 --environment studio.hdr
  barrido render fox.glb -o "run/{frame:04}.png" --frames 0:59 --fps 30
  barrido render room.glb -o room.png --light key --light point:pos=0,2,0:attenuation=1,0,0.1
  barrido render teapot.glb -o - --background 1,1,1 | display -
  barrido render teapot.glb --shading all --hash --stats
)";

constexpr const char* kInspectUsage =
    R"(Usage: barrido inspect FILE --pixel X,Y [OPTIONS]

Tells why a pixel of the frame that `barrido render FILE` draws with the same options has its
colour: every triangle that covers it and which of them is seen, the illumination formula with its
numbers, texels and their weights, fog, blending, and the steps to 8 bits. What it adds up is the
pixel, bit for bit.
)";

constexpr const char* kInspectNotes = R"(
Exit status: 0 fine, 2 error.

Examples:
  barrido inspect teapot.glb --pixel 640,360
  barrido inspect teapot.glb --pixel 320,240 --resolution 640,480 --shading gouraud --json
)";

constexpr const char* kLabUsage =
    R"(Usage: barrido lab sampling FILE [-o PLOT.svg] [OPTIONS]

Draws the frame that `barrido render FILE` draws with the same options, of 320 x 180 pixels unless
--resolution says otherwise, with 1 to 256 uniform and jittered samples a pixel and with adaptive
ones, and tells how far each is from the frame of 1024 samples: as JSON, and with -o as a plot.
)";

constexpr const char* kLabNotes = R"(
Errors are roots of mean squares of linear light. Slopes are of the mean square over the number of
samples, both as logarithms: of smooth things -2, of edges -1.5, of random places -1.
Exit status: 0 fine, 2 error.

Examples:
  barrido lab sampling teapot.glb -o teapot.svg
  barrido lab sampling ground.glb --pixel-filter gaussian --resolution 160,90
)";

constexpr const char* kInfoUsage = R"(Usage: barrido info FILE [--json] [--validate]

Tells what a glTF model (.gltf, .glb) holds: scenes, meshes, triangles, materials, textures,
cameras, lights, animations, bounds; and which of its features are drawn exactly, approximated or
ignored.
)";

constexpr const char* kInfoNotes = R"(
With --validate every fault has a code, a place (a JSON pointer or a byte) and a sentence; with
--json as well, the report has the form of the Khronos validator's. The last line tells whether
`barrido render` draws the file: it forgives what does no harm.
Exit status: 0 fine (warnings are printed), 2 error: of the file, when it is validated.
)";

constexpr const char* kDiffUsage =
    R"(Usage: barrido diff A B [OPTIONS]

Compares two pictures, or all pictures in two folders by their relative names: A is what is
expected, B what came out. A picture that only one folder has is a difference. Thresholds and
figures are those of OpenImageIO's idiff; its spellings (-fail, -hardfail ...) are understood.
)";

constexpr const char* kDiffNotes = R"(
Values are compared as the files store them: PNG, JPEG and TIFF of bytes or 16-bit numbers as 0..1,
EXR and HDR as floats. A picture of the first kind that meets one of the second is taken to linear
light. A missing alpha is opaque, grey is as much red, green and blue. Pictures of different sizes
always differ; what one of them lacks counts as 0. Positions are (x, y) from the upper left corner.
Exit status: 0 same (warnings are printed), 1 different, 2 error.

Examples:
  barrido diff expected.png actual.png
  barrido diff golden out --html report --junit report.xml
  barrido diff a.png b.png --fail 0.004 --failpercent 1 --hardfail 0.1
  barrido diff golden out --bless
  barrido diff a.exr b.exr --failflip 0.01 -o difference.exr
)";

std::string names_column(const OptionSyntax& option) {
  std::string names = option.short_name.empty() ? "      " : "  " + std::string(option.short_name) + ", ";
  names += option.name;
  if (option.form.empty()) return names;
  const std::string form(option.form);
  return names + (option.kind == OptionKind::optional_value ? "[=" + form + "]" : " " + form);
}

/// Adds `words` behind what `text` ends with, breaking lines at blanks; further lines begin at `indent`.
void append_wrapped(std::string& text, std::size_t column, std::string_view words, std::size_t indent) {
  bool first_of_line = true;
  while (!words.empty()) {
    const std::size_t length = std::min(words.find(' '), words.size());
    const std::string word(words.substr(0, length));
    words.remove_prefix(std::min(length + 1, words.size()));
    if (!first_of_line && column + 1 + word.size() > kWidth) {
      text += "\n" + std::string(indent, ' ');
      column = indent;
      first_of_line = true;
    }
    text += (first_of_line ? "" : " ") + word;
    column += word.size() + (first_of_line ? 0 : 1);
    first_of_line = false;
  }
  text += "\n";
}

}  // namespace

std::string version_text() { return "barrido " BARRIDO_VERSION "\n"; }

std::string general_help() { return kGeneralHelp; }

std::string options_help(std::span<const OptionSyntax> syntax) {
  std::size_t widest = 0;
  for (const OptionSyntax& option : syntax) widest = std::max(widest, names_column(option).size());
  const std::size_t indent = widest + 2;
  std::string text;
  std::string_view section;
  for (const OptionSyntax& option : syntax) {
    if (option.section != section) text += "\n" + std::string(option.section) + ":\n";
    section = option.section;
    text += left(names_column(option), indent);
    append_wrapped(text, indent, option.help, indent);
  }
  return text;
}

std::string render_help() { return kRenderUsage + options_help(render_syntax()) + kRenderNotes; }

std::string diff_help() { return kDiffUsage + options_help(diff_syntax()) + kDiffNotes; }

std::string lab_help() { return kLabUsage + options_help(lab_syntax()) + kLabNotes; }

std::string inspect_help() { return kInspectUsage + options_help(inspect_syntax()) + kInspectNotes; }

std::string info_help() { return kInfoUsage + options_help(info_syntax()) + kInfoNotes; }

std::span<const OptionSyntax> info_syntax() { return kInfoSyntax; }

}  // namespace barrido::cli
