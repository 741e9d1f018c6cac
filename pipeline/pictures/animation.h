// Pictures that move, GIF and WebP. Enters: frames, one after the other; leaves: the bytes of one file. Both
// encoders are in modules that are loaded on first need. Must not know: scenes, times of animations.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/palette.h"

namespace barrido::scene {

/// gif: at most 256 colours a frame, without dithering, and alpha all or nothing. webp: without loss.
enum class AnimationFormat : std::uint8_t { gif, webp };

/// By extension (".GIF" is one); none where it names neither.
std::optional<AnimationFormat> animation_format(const std::filesystem::path& path);

/// A frame made ready: what takes time and needs no other frame.
struct AnimationFrame {
  int width = 0;
  int height = 0;
  IndexedPicture indexed;  ///< gif
  PixelBytes rgba;         ///< webp
};

/// May be called on several threads at once.
AnimationFrame prepare_frame(AnimationFormat format, const ImageView& image);

/// One animation in memory, repeated for ever.
class AnimationEncoder {
 public:
  /// Sizes are those of the first frame. `name` is for messages. @throws InputError when there is no module.
  AnimationEncoder(AnimationFormat format, std::string name, double frames_per_second);
  ~AnimationEncoder();

  /// Frame n is seen from n/FPS on; GIF counts hundredths of a second, and shows none shorter than 2.
  /// @throws InputError, also when the sizes differ.
  void add(const AnimationFrame& frame);

  /// The file; the encoder is of no more use. @throws InputError.
  std::vector<std::uint8_t> finish();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::scene
