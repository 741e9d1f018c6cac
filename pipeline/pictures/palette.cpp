#include "pipeline/pictures/palette.h"

#include <algorithm>
#include <unordered_map>

namespace barrido::scene {
namespace {

constexpr std::size_t kMostColors = 256;
constexpr int kAlphaSeen = 128;

/// Colours that are one to begin with.
struct Bin {
  std::array<std::uint8_t, 3> place{};  ///< 5, 6 and 5 bits
  std::uint32_t count = 0;
  std::array<std::uint64_t, 3> sum{};
  std::uint8_t index = 0;
};

constexpr std::array<int, 3> kBits{5, 6, 5};

std::size_t bin_of(const std::uint8_t* rgba) {
  return (std::size_t{rgba[0]} >> 3) << 11 | (std::size_t{rgba[1]} >> 2) << 5 | std::size_t{rgba[2]} >> 3;
}

/// A range of the bins' list.
struct Box {
  std::size_t begin = 0, end = 0;
  std::uint64_t count = 0;
  int axis = 0;              ///< The longest.
  std::uint32_t length = 0;  ///< Of it, in 1/256 of the range of colours.
};

using Bins = std::vector<Bin*>;

Box make_box(const Bins& bins, std::size_t begin, std::size_t end) {
  Box box{begin, end};
  std::array<std::uint8_t, 3> least{255, 255, 255}, most{};
  for (std::size_t i = begin; i < end; ++i) {
    box.count += bins[i]->count;
    for (std::size_t c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], bins[i]->place[c]);
      most[c] = std::max(most[c], bins[i]->place[c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const auto length = static_cast<std::uint32_t>(most[c] - least[c]) << (8 - kBits[c]);
    if (length <= box.length) continue;
    box.length = length;
    box.axis = static_cast<int>(c);
  }
  return box;
}

/// Along the longest axis, so that both halves have as many pixels, as far as can be.
std::size_t median_of(Bins& bins, const Box& box) {
  const auto axis = static_cast<std::size_t>(box.axis);
  const auto at = [&](std::size_t i) { return bins.begin() + static_cast<std::ptrdiff_t>(i); };
  std::sort(at(box.begin), at(box.end), [axis](const Bin* a, const Bin* b) {
    return a->place[axis] != b->place[axis] ? a->place[axis] < b->place[axis] : a->place < b->place;
  });
  std::uint64_t count = 0;
  for (std::size_t i = box.begin; i + 1 < box.end; ++i) {
    count += bins[i]->count;
    if (2 * count >= box.count) return i + 1;
  }
  return box.end - 1;
}

/// Many pixels in a long box are worth most.
std::uint64_t worth(const Box& box) { return box.end - box.begin > 1 ? box.count * box.length : 0; }

std::vector<Box> cut(Bins& bins, std::size_t most) {
  std::vector<Box> boxes{make_box(bins, 0, bins.size())};
  while (boxes.size() < most) {
    const auto widest = std::max_element(boxes.begin(), boxes.end(),
                                         [](const Box& a, const Box& b) { return worth(a) < worth(b); });
    if (worth(*widest) == 0) break;
    const Box whole = *widest;
    const std::size_t middle = median_of(bins, whole);
    *widest = make_box(bins, whole.begin, middle);
    boxes.push_back(make_box(bins, middle, whole.end));
  }
  return boxes;
}

void index_by_boxes(std::span<const std::uint8_t> rgba, std::size_t most, IndexedPicture& picture) {
  std::vector<Bin> all(std::size_t{1} << 16);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    if (rgba[i + 3] < kAlphaSeen) continue;
    Bin& bin = all[bin_of(&rgba[i])];
    ++bin.count;
    for (std::size_t c = 0; c < 3; ++c) bin.sum[c] += rgba[i + c];
  }
  Bins bins;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].count == 0) continue;
    all[i].place = {static_cast<std::uint8_t>(i >> 11), static_cast<std::uint8_t>(i >> 5 & 63),
                    static_cast<std::uint8_t>(i & 31)};
    bins.push_back(&all[i]);
  }
  const std::vector<Box> boxes = cut(bins, most);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    std::array<std::uint64_t, 3> sum{};
    for (std::size_t i = boxes[b].begin; i < boxes[b].end; ++i) {
      bins[i]->index = static_cast<std::uint8_t>(b);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += bins[i]->sum[c];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      picture.palette[3 * b + c] = static_cast<std::uint8_t>((sum[c] + boxes[b].count / 2) / boxes[b].count);
    }
  }
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const bool seen = rgba[i + 3] >= kAlphaSeen;
    picture.indices[i / 4] =
        seen ? all[bin_of(&rgba[i])].index : static_cast<std::uint8_t>(picture.transparent);
  }
}

/// @return false when there are more colours.
bool index_exactly(std::span<const std::uint8_t> rgba, std::size_t most, IndexedPicture& picture) {
  std::unordered_map<std::uint32_t, std::uint8_t> index_of;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    if (rgba[i + 3] < kAlphaSeen) {
      picture.indices[i / 4] = static_cast<std::uint8_t>(picture.transparent);
      continue;
    }
    const std::uint32_t color = std::uint32_t{rgba[i]} << 16 | std::uint32_t{rgba[i + 1]} << 8 | rgba[i + 2];
    const auto [slot, is_new] = index_of.try_emplace(color, static_cast<std::uint8_t>(index_of.size()));
    if (is_new && index_of.size() > most) return false;
    if (is_new) std::copy_n(&rgba[i], 3, &picture.palette[3 * std::size_t{slot->second}]);
    picture.indices[i / 4] = slot->second;
  }
  return true;
}

}  // namespace

IndexedPicture index_colors(std::span<const std::uint8_t> rgba) {
  IndexedPicture picture;
  picture.indices.resize(rgba.size() / 4);
  std::size_t most = kMostColors;
  for (std::size_t i = 3; i < rgba.size(); i += 4) {
    if (rgba[i] >= kAlphaSeen) continue;
    picture.transparent = static_cast<int>(--most);
    break;
  }
  if (index_exactly(rgba, most, picture)) return picture;
  picture.palette = {};
  index_by_boxes(rgba, most, picture);
  return picture;
}

}  // namespace barrido::scene
