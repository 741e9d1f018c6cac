#include "viewer/compare/same_footing.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "pipeline/pictures/transfer.h"

namespace barrido::compare {
namespace {

/// Calls `change` with each pixel's four values.
template <class Change>
void change_pixels(scene::StoredPicture& picture, Change change) {
  constexpr std::size_t kGrain = 1 << 14;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, picture.rgba.size() / 4, kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) change(&picture.rgba[i * 4]);
                    });
}

void make_linear(scene::StoredPicture& picture) {
  change_pixels(picture, [](float* rgba) {
    for (int c = 0; c < 3; ++c) rgba[c] = scene::linear_from_srgb(rgba[c]);
  });
  picture.is_linear = true;
}

void associate(scene::StoredPicture& picture) {
  change_pixels(picture, [](float* rgba) {
    for (int c = 0; c < 3; ++c) rgba[c] *= rgba[3];
  });
  picture.is_associated = true;
}

bool has_alpha(const scene::StoredPicture& picture) { return picture.channels % 2 == 0; }

}  // namespace

void put_on_same_footing(scene::StoredPicture& a, scene::StoredPicture& b) {
  if (a.is_linear && !b.is_linear) make_linear(b);
  if (b.is_linear && !a.is_linear) make_linear(a);
  if (a.is_associated && !b.is_associated && has_alpha(b)) associate(b);
  if (b.is_associated && !a.is_associated && has_alpha(a)) associate(a);
}

}  // namespace barrido::compare
