// Picture files from strangers: the decoders may refuse them with InputError and nothing else. What they give
// is encoded as PNG and decoded again, which must lose nothing.
#include "pipeline/pictures/codecs.h"
#include "pipeline/pictures/format.h"
#include "pipeline/pictures/header_check.h"
#include "targets.h"

namespace barrido::fuzz {
namespace {

constexpr scene::ImageLimits kLimits{4096, 1 << 18};

/// Colours under alpha 0 and all.
void check_round_trip(const scene::Image& image) {
  const scene::ImageView view{image.width, image.height, image.rgba, {}};
  const std::vector<std::uint8_t> png = scene::encode_png(view);
  const scene::Image again = scene::decode_png(png, "again", kLimits);
  require(again.width == image.width && again.height == image.height && again.rgba == image.rgba,
          "PNG lost something");
}

template <class Decode>
void expect_input_error(Decode decode) {
  try {
    decode();
  } catch (const scene::InputError& error) {
    require(std::string_view(error.what()).starts_with("picture"), std::string("no name: ") + error.what());
  }
}

/// The other reader of PNG must see the same picture; of at most 8 bits a channel (IHDR, byte 24) exactly.
void check_precise(Bytes bytes) {
  const scene::Samples16 samples = scene::decode_png_16(bytes, "picture", kLimits);
  const auto pixels = static_cast<std::size_t>(samples.width) * static_cast<std::size_t>(samples.height);
  require(samples.rgba.size() == pixels * 4, "samples are missing");
  require(samples.channels >= 1 && samples.channels <= 4, "no such number of channels");
  const scene::Image image = scene::decode_png(bytes, "picture", kLimits);
  require(image.rgba.size() == samples.rgba.size(), "the readers disagree on the size");
  if (bytes[24] == 16) return;
  for (std::size_t i = 0; i < samples.rgba.size(); ++i) {
    require(samples.rgba[i] == image.rgba[i] * 257, "the readers disagree on a pixel");
  }
}

}  // namespace

void run_image(Bytes bytes) {
  expect_input_error([&] { check_round_trip(scene::decode_image(bytes, "picture", kLimits)); });
  if (scene::is_png(bytes)) expect_input_error([&] { check_precise(bytes); });
  if (const scene::FormatTraits* format = scene::format_by_content(bytes, "picture.tga")) {
    expect_input_error([&] { scene::check_header(bytes, *format, "picture", kLimits); });
  }
}

}  // namespace barrido::fuzz
