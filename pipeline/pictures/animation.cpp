#include "pipeline/pictures/animation.h"

#include <algorithm>
#include <cmath>

#include "pipeline/files/module_loader.h"
#include "pipeline/pictures/codecs.h"
#include "pipeline/pictures/gif_module/interface.h"
#include "pipeline/pictures/pack.h"
#include "pipeline/pictures/webp_module/interface.h"

namespace barrido::scene {
namespace {

/// GIF stores sizes in 16 bits, WebP in 14.
constexpr int kLongestSide = 16383;

/// One of the two formats; both give their reasons in a BarridoModuleError.
class Writer {
 public:
  explicit Writer(std::string name) : name_(std::move(name)) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  virtual ~Writer() = default;
  virtual void open(int width, int height) = 0;
  virtual void add(const AnimationFrame& frame, double begin_s, double end_s) = 0;
  virtual std::vector<std::uint8_t> finish(double end_s) = 0;

 protected:
  const std::string& name() const { return name_; }
  [[noreturn]] void fail(const BarridoModuleError& error) const { throw InputError(name_, "", error.text); }

 private:
  std::string name_;
};

class GifWriter final : public Writer {
 public:
  explicit GifWriter(const std::string& name) : Writer(name), functions_(functions_for(name)) {}
  ~GifWriter() override {
    if (writer_ != nullptr) functions_->close(writer_);
  }

  void open(int width, int height) override {
    BarridoModuleError error{};
    writer_ = functions_->open(width, height, &error);
    if (writer_ == nullptr) fail(error);
  }

  void add(const AnimationFrame& frame, double begin_s, double end_s) override {
    // Those who show shorter ones take them for mistakes.
    constexpr int kShortest = 2;
    const auto delay = static_cast<int>(std::lround(end_s * 100.0) - std::lround(begin_s * 100.0));
    const IndexedPicture& picture = frame.indexed;
    const BarridoGifFrame given{picture.indices.data(), picture.palette.data(), picture.transparent,
                                std::clamp(delay, kShortest, 65535)};
    BarridoModuleError error{};
    if (functions_->add(writer_, &given, &error) == 0) fail(error);
  }

  std::vector<std::uint8_t> finish(double) override {
    const std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    BarridoModuleError error{};
    if (functions_->finish(writer_, &bytes, &size, &error) == 0) fail(error);
    return {bytes, bytes + size};
  }

 private:
  static const BarridoGifFunctions* functions_for(const std::string& name) {
    static const Module module("barrido_gif.so", BARRIDO_GIF_ENTRY, BARRIDO_GIF_INTERFACE_VERSION);
    const auto* functions = module.functions<BarridoGifFunctions>();
    if (functions == nullptr) throw InputError(name, "", module.problem("writing GIF"));
    return functions;
  }

  const BarridoGifFunctions* functions_;
  BarridoGifWriter* writer_ = nullptr;
};

class WebpWriter final : public Writer {
 public:
  explicit WebpWriter(const std::string& name)
      : Writer(name), functions_(webp_functions(name, "writing WebP animations")) {}
  ~WebpWriter() override {
    if (writer_ != nullptr) functions_->close(writer_);
  }

  void open(int width, int height) override {
    BarridoModuleError error{};
    writer_ = functions_->open(width, height, &error);
    if (writer_ == nullptr) fail(error);
  }

  void add(const AnimationFrame& frame, double begin_s, double) override {
    BarridoModuleError error{};
    if (functions_->add(writer_, frame.rgba.data(), milliseconds(begin_s), &error) == 0) fail(error);
  }

  std::vector<std::uint8_t> finish(double end_s) override {
    const std::uint8_t* bytes = nullptr;
    std::size_t size = 0;
    BarridoModuleError error{};
    if (functions_->finish(writer_, milliseconds(end_s), &bytes, &size, &error) == 0) fail(error);
    return {bytes, bytes + size};
  }

 private:
  static int milliseconds(double seconds) {
    return static_cast<int>(std::lround(std::min(seconds * 1000.0, 2e9)));
  }

  const BarridoWebpFunctions* functions_;
  BarridoWebpWriter* writer_ = nullptr;
};

std::unique_ptr<Writer> make_writer(AnimationFormat format, const std::string& name) {
  if (format == AnimationFormat::gif) return std::make_unique<GifWriter>(name);
  return std::make_unique<WebpWriter>(name);
}

}  // namespace

std::optional<AnimationFormat> animation_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  if (extension == ".gif") return AnimationFormat::gif;
  if (extension == ".webp") return AnimationFormat::webp;
  return std::nullopt;
}

AnimationFrame prepare_frame(AnimationFormat format, const ImageView& image) {
  AnimationFrame frame{image.width, image.height, {}, {}};
  PixelBytes storage;
  const std::span<const std::uint8_t> pixels = bytes_of(image, storage);
  if (format == AnimationFormat::gif) {
    frame.indexed = index_colors(pixels);
  } else {
    frame.rgba.assign(pixels.begin(), pixels.end());
  }
  return frame;
}

struct AnimationEncoder::Implementation {
  std::string name;
  double frames_per_second;
  std::unique_ptr<Writer> writer;
  int width = 0, height = 0;
  int frames = 0;

  double begin_of(int frame) const { return frame / frames_per_second; }
};

AnimationEncoder::AnimationEncoder(AnimationFormat format, std::string name, double frames_per_second)
    : implementation_(new Implementation{name, frames_per_second, make_writer(format, name)}) {}
AnimationEncoder::~AnimationEncoder() = default;

void AnimationEncoder::add(const AnimationFrame& frame) {
  Implementation& self = *implementation_;
  if (self.frames == 0) {
    if (std::max(frame.width, frame.height) > kLongestSide) {
      throw InputError(self.name, "", "an animation has at most 16383 pixels a side");
    }
    self.width = frame.width;
    self.height = frame.height;
    self.writer->open(frame.width, frame.height);
  }
  if (frame.width != self.width || frame.height != self.height) {
    throw InputError(self.name, "", "the frames of an animation must have one size");
  }
  self.writer->add(frame, self.begin_of(self.frames), self.begin_of(self.frames + 1));
  ++self.frames;
}

std::vector<std::uint8_t> AnimationEncoder::finish() {
  return implementation_->writer->finish(implementation_->begin_of(implementation_->frames));
}

}  // namespace barrido::scene
