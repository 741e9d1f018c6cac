#include "tests/osmesa/report.h"

#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace barrido::crosscheck {
namespace {

void write_png(const std::filesystem::path& file, const Picture& picture) {
  std::vector<std::uint8_t> rgb;
  for (const auto& c : picture.color) rgb.insert(rgb.end(), c.begin(), c.begin() + 3);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(file.string() + ": " + image.message);
  }
}

std::string number(double value, const char* format = "%.1f") {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Pixels that differ by 1, 2, 3–7, 8–31 and more.
std::string histogram(const ClassFigures& figures) {
  constexpr std::size_t kBegin[] = {1, 2, 3, 8, 32, 256};
  std::string text;
  for (std::size_t i = 0; i < 5; ++i) {
    std::uint64_t sum = 0;
    for (std::size_t d = kBegin[i]; d < kBegin[i + 1]; ++d) sum += figures.histogram[d];
    text += (i == 0 ? "" : " / ") + std::to_string(sum);
  }
  return text;
}

std::string row(const Feature& feature, const Figures& f) {
  const ClassFigures& interior = f.of(PixelClass::interior);
  const ClassFigures& edge = f.of(PixelClass::edge);
  const ClassFigures& tie = f.of(PixelClass::tie);
  std::string text = std::string("| ") + feature.name + " | " + std::to_string(f.pairs);
  text += " | " + std::to_string(interior.worst) + " | " + number(per_million(interior.different, f.pixels));
  text += " | " + histogram(interior) + " | " + std::to_string(f.second_looks);
  text += " | " + std::to_string(edge.worst) + " | " + number(per_million(edge.excessive, f.pixels), "%.2f");
  text += " | " + number(100.0 * static_cast<double>(tie.pixels) /
                             static_cast<double>(std::max<std::uint64_t>(f.pixels, 1)),
                         "%.2f");
  text += " | " + number(per_million(tie.excessive, f.pixels), "%.2f");
  text += " | " + number(std::max(f.worst_depth, 0.0) * 0x1p24) + " | ";
  const std::string failure = feature_failure(f, feature.gate);
  if (!feature.gate.held) return text + "reported only |\n";
  return text + (failure.empty() && interior.excessive == 0 ? "held" : "broken") + " |\n";
}

}  // namespace

void write_pictures(const std::filesystem::path& folder, const std::string& name, const Picture& expected,
                    const Picture& actual) {
  std::filesystem::create_directories(folder);
  Picture difference = expected;
  for (std::size_t i = 0; i < difference.color.size(); ++i) {
    int alpha = std::abs(static_cast<int>(expected.color[i][3]) - static_cast<int>(actual.color[i][3]));
    for (std::size_t c = 0; c < 3; ++c) {
      const int d = std::abs(static_cast<int>(expected.color[i][c]) - static_cast<int>(actual.color[i][c]));
      difference.color[i][c] = static_cast<std::uint8_t>(std::min(255, 16 * std::max(d, alpha)));
    }
  }
  write_png(folder / (name + "-expected.png"), expected);
  write_png(folder / (name + "-actual.png"), actual);
  write_png(folder / (name + "-difference.png"), difference);
}

std::string slug(const std::string& feature) {
  std::string text;
  for (const char c : feature) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain) {
      text += c;
    } else if (!text.empty() && text.back() != '-') {
      text += '-';
    }
  }
  return text;
}

void write_table(const std::filesystem::path& file, const std::vector<Feature>& features,
                 const std::vector<Figures>& figures, const std::string& reference,
                 const std::string& command) {
  std::ofstream out(file);
  std::uint64_t pairs = 0;
  for (const Figures& f : figures) pairs += f.pairs;
  const bool softpipe = reference.find("softpipe") != std::string::npos;
  out << "# Cross-check with OpenGL" << (softpipe ? ": softpipe" : "") << "\n\n"
      << "Written by `" << (softpipe ? "GALLIUM_DRIVER=softpipe " : "") << command << "`; do not edit. "
      << pairs << " scenes from seeds, each drawn by Barrido and by\n"
      << reference << ".\n\n"
      << "Pixels are classified from the projected geometry in double precision: *edge* is within one pixel "
         "of an edge,\n"
      << "*tie* is near a discrete decision (a texel's edge for nearest filters, a choice of level or face, "
         "surfaces that\n"
      << "cross, the terminator of per-pixel lighting), *interior* is the rest. Differences are the largest "
         "of a pixel's\n"
      << "channels in 1/255; the histogram counts interior pixels that differ by 1 / 2 / 3–7 / 8–31 / more. "
         "ppm are parts\n"
      << "per million of all pixels: in the interior of those that differ at all, elsewhere of those that "
         "differ by more\n"
      << "than the interior may. Depth is the largest difference in the interior in units of 2⁻²⁴, beyond "
         "what snapping\n"
      << "positions to 1/256 pixel explains. Where filters lie between levels a pixel is also allowed 0.07 "
         "(and what the level\n"
      << "of detail varies over the group of pixels that it is computed for) times the difference of the two "
         "levels.\n\n"
      << "A pixel that differs by more is looked at again: OpenGL draws the scene with 16 "
         "bits a "
         "channel, so that\n"
      << "its blending and filters do not round to 8 bits, and where a colour is a filtered texel and "
         "nothing else "
         "it is computed\n"
      << "in double precision. Barrido must be within the same gate of one of these. *Second looks* counts "
         "such "
         "pixels; they are\n"
      << "still counted as differing in the columns before.\n\n"
      << "Left out, because this OpenGL differs from the specification or the specification leaves the "
         "choice: a sum with\n"
      << "the secondary colour above 1 under fog (not clamped there; OpenGL 1.3, section 3.9); the "
         "change-over between the\n"
      << "filters at level of detail 1/2 (always 0 there; section 3.8.9); 0 to the power of 0 in highlights; "
         "the diagonal along\n"
      << "which quads with more than a plane of colours are cut; outlined polygons that the view volume cuts "
         "(it "
         "does not close\n"
      << "them there; section 2.11), and the corners that cutting quads and polygons into triangles makes in "
         "them. Its unit of\n"
      << "polygon offset is 2⁻²³ (Barrido's 2⁻²⁴), which is allowed for. Lines may differ at their ends "
         "(section 3.4.1).\n\n"
      << (softpipe ? "softpipe is a second opinion with gates of its own: it has 4 sub-pixel bits where "
                     "Barrido and llvmpipe have "
                     "8, so up to\n1000 ppm may differ at edges. Reported and not held are levels of detail, "
                     "points "
                     "and lines, which it draws by coarser\nrules, and everything mixed, where it blends "
                     "over sums above "
                     "1 that it did not clamp. Interiors are held to the same\ngates.\n\n"
                   : "")
      << "| feature | pairs | interior, worst | interior ppm | histogram | second looks | edge, worst | edge "
         "ppm | "
         "ties, % | tie ppm "
         "| depth | gate |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (figures[i].pairs > 0) out << row(features[i], figures[i]);
  }
  out.flush();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace barrido::crosscheck
