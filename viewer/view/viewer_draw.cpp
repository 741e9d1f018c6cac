// What the viewer shows: pictures of one side or both, OSMesa's, and the story of a pixel.
#include <algorithm>
#include <exception>
#include <utility>

#include "raster/fragments/primitive.h"
#include "viewer/sheet/view_legend.h"
#include "viewer/view/viewer.h"

namespace barrido::view {
namespace {

constexpr std::uint32_t kDarkGrey = 0xff333333u;

void add(Costs& sum, const DrawnFrame& frame) {
  sum.draw_ms += frame.draw_ms;
  sum.triangles += frame.counts.primitives_in;
  sum.fragments += frame.counts.raster.fragments_shaded;
  sum.illuminations += frame.counts.illuminations_vertex + frame.counts.illuminations_fragment;
  sum.powers += frame.counts.powers;
}

}  // namespace

int Viewer::legend_height() const {
  const bool view = display.split ? has_view(kLeft) || has_view(kRight) : has_view(active_side_);
  return view ? sheet::legend_height(width()) : 0;
}

void Viewer::set_size(int width, int height) {
  const int w = std::clamp(width, 1, raster::kMaxFrameSide);
  const int old_width = this->width(), old_height = this->height();
  for (cli::RenderOptions& options : sides_) options.settings.width = w;
  const int h = std::clamp(height - legend_height(), 1, raster::kMaxFrameSide);
  for (cli::RenderOptions& options : sides_) options.settings.height = h;
  changed = changed || w != old_width || h != old_height;
}

Picture Viewer::blank(int coarseness) const {
  const int w = std::max(1, width() / coarseness);
  const int legend = legend_height() > 0 ? sheet::legend_height(w) : 0;
  const int h = std::max(1, height() / coarseness) + legend;
  return {w, h,
          std::vector<std::uint32_t>(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), kDarkGrey)};
}

cli::RenderOptions Viewer::coarse(int side, int coarseness) const {
  cli::RenderOptions options = sides_[static_cast<std::size_t>(side)];
  options.settings.width = std::max(1, options.settings.width / coarseness);
  options.settings.height = std::max(1, options.settings.height / coarseness);
  return options;
}

void Viewer::stand_on_nothing(Picture& picture) const {
  if (legend_height() == 0) return;
  picture.height += sheet::legend_height(picture.width);
  picture.rgba.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height),
                      kDarkGrey);
}

Picture Viewer::draw_osmesa(int coarseness) {
  osmesa_cannot_.clear();
  osmesa_picture_ = {};
  if (!model_) return blank(coarseness);
  try {
    OsmesaFrame frame = model_->draw_by(osmesa_, coarse(kLeft, coarseness));
    costs_.osmesa_ms = frame.draw_ms;
    osmesa_cannot_ = std::move(frame.picture.cannot);
    Picture picture{frame.width, frame.height, std::move(frame.picture.rgba)};
    if (coarseness == 1) osmesa_picture_ = picture;
    stand_on_nothing(picture);
    return picture;
  } catch (const std::exception& error) {
    message = std::string("no picture by OSMesa: ") + error.what();
    return blank(coarseness);
  }
}

Picture Viewer::draw_side(int side, int coarseness) {
  if (!model_) return blank(coarseness);
  try {
    const DrawnFrame frame = model_->draw(coarse(side, coarseness));
    add(costs_, frame);
    const auto& colors = frame.framebuffer.color8();
    Picture picture{frame.framebuffer.width(), frame.framebuffer.height(), {colors.begin(), colors.end()}};
    if (display.split && !has_view(side)) stand_on_nothing(picture);
    return picture;
  } catch (const std::exception& error) {
    message = error.what();
    return blank(coarseness);
  }
}

std::string Viewer::osmesa_story(int x, int y) const {
  if (!display.osmesa || x >= osmesa_picture_.width || y >= osmesa_picture_.height) return "";
  const std::uint32_t rgba =
      osmesa_picture_.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(osmesa_picture_.width) +
                           static_cast<std::size_t>(x)];
  return "OSMesa's colour here: " + std::to_string(rgba & 255) + ' ' + std::to_string(rgba >> 8 & 255) + ' ' +
         std::to_string(rgba >> 16 & 255) + "\n";
}

void Viewer::inspect(int x, int y) {
  inspected_.reset();
  if (!model_ || x < 0 || y < 0 || x >= width() || y >= height()) return;
  int side = active_side_;
  if (display.split && !display.difference && !display.osmesa) {
    side = x < divider_column(width(), display.divider) ? kLeft : kRight;
  }
  try {
    const inspect::PixelStory story = model_->inspect(sides_[static_cast<std::size_t>(side)], x, y);
    inspected_ = {x, y, side, story.rgba8, osmesa_story(x, y) + inspect::story_text(story)};
  } catch (const std::exception& error) {
    inspected_ = {x, y, side, {}, error.what()};
  }
}

const Picture& Viewer::draw(int coarseness) {
  costs_ = {};
  difference_.reset();
  changed = false;
  if (!display.split) {
    picture_ = draw_side(active_side_, coarseness);
    return picture_;
  }
  if (display.osmesa) sides_[kRight] = sides_[kLeft];
  const Picture left = draw_side(kLeft, coarseness);
  const Picture right = display.osmesa ? draw_osmesa(coarseness) : draw_side(kRight, coarseness);
  // A view of structure beside OSMesa's picture is no comparison.
  if (!display.osmesa || !has_view(kLeft)) difference_ = difference_of(left, right);
  picture_ = display.difference && difference_ ? heat_map(left, right, *difference_)
                                               : side_by_side(left, right, display.divider);
  return picture_;
}

}  // namespace barrido::view
