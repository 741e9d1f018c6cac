// Internal to story_text(): the parts of the text. Each adds whole lines.
#pragma once

#include <string>

#include "pipeline/inspect/pixel_story.h"

namespace barrido::inspect {

/// Lines that begin further to the right from level to level.
class Lines {
 public:
  void add(int level, const std::string& line) {
    text_ += std::string(2 * static_cast<std::size_t>(level), ' ') + line + "\n";
  }
  void blank() { text_ += "\n"; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// "triangle 12 of mesh 0 'teapot'[0], node 3 'pot', material 1 'glaze'".
std::string source_words(const FragmentStory& fragment);

/// One evaluation of the model, as the formula and with numbers. `first`: not told before for this surface,
/// so that formula and material are of interest.
void tell_illumination(const IlluminationStory& story, pipeline::SpecularModel model, bool first,
                       Lines& lines);

/// Where the fragment's colour comes from: corners, span, illumination, textures, fog.
void tell_shading(const PixelStory& pixel, const FragmentStory& fragment, Lines& lines);

/// Tests, blending and the frame.
void tell_fate(const FragmentStory& fragment, Lines& lines);

}  // namespace barrido::inspect
