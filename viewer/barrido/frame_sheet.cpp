#include "viewer/barrido/frame_sheet.h"

#include "pipeline/pictures/image_io.h"
#include "viewer/barrido/frame_pipeline.h"
#include "viewer/barrido/standard_streams.h"
#include "viewer/sheet/sheet.h"

namespace barrido::cli {
namespace {

constexpr std::size_t kMaxPixels = std::size_t{1} << 28;  // Of compose_sheet; a sheet is no smaller.
constexpr std::size_t kMaxColumns = 12;

}  // namespace

void FrameSheet::add(const std::string& label, raster::Framebuffer&& framebuffer) {
  pixels_ += framebuffer.color8().size();
  if (pixels_ > kMaxPixels) {
    throw scene::InputError("--sheet", label, "the frames are too many or too large for one picture");
  }
  entries_.push_back({label, std::move(framebuffer)});
}

void FrameSheet::write(const std::string& name, int columns, int png_compression) const {
  std::vector<sheet::SheetPicture> pictures;
  for (const Entry& entry : entries_) {
    const scene::ImageView view = view_of(entry.framebuffer);
    pictures.push_back({view.width, view.height, view.rgba8, entry.label});
  }
  sheet::SheetOptions options;
  options.columns = columns;
  const scene::Image sheet = sheet::compose_sheet(pictures, options);
  const scene::ImageView view{sheet.width, sheet.height, sheet.rgba, {}};
  scene::WriteOptions write;
  write.png_compression = png_compression;
  if (name == "-") {
    write_standard_output(scene::encode_png(view, write));
  } else {
    scene::write_image(name, view, write);
  }
}

int sheet_columns(std::size_t frames, std::size_t inner) {
  const bool is_grid = inner > 1 && frames > inner && inner <= kMaxColumns;
  return is_grid ? static_cast<int>(inner) : 0;
}

}  // namespace barrido::cli
