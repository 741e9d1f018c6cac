#include "pipeline/pictures/environment_texels.h"

#include "pipeline/pictures/transfer.h"

namespace barrido::scene {

TexelEncoder::TexelEncoder(float scale, bool srgb)
    : scale_(scale), table_(static_cast<std::size_t>(kMaxIndex) + 1) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    const float value = static_cast<float>(i) / kMaxIndex;
    table_[i] = srgb ? srgb8_from_linear(value) : byte_from_fraction(value);
  }
}

std::uint8_t TexelEncoder::alpha(float value) { return byte_from_fraction(value); }

TexelReader::TexelReader(const Picture& picture, bool linearise)
    : width_(picture_width(picture)), height_(picture_height(picture)) {
  if (const auto* image = std::get_if<Image>(&picture)) {
    bytes_ = image->rgba.data();
  } else {
    floats_ = std::get<FloatImage>(picture).rgba.data();
  }
  for (std::size_t i = 0; i < color_.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    color_[i] = linearise ? linear_from_srgb8(byte) : static_cast<float>(byte) / 255.0f;
  }
}

}  // namespace barrido::scene
