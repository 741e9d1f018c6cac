#include "pipeline/scene/blended_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/scene/triangles.h"

namespace barrido::scene {
namespace {

/// What a piece costs, in vertices, beside those it transforms; and what all may cost for one vertex of the
/// draws.
constexpr std::uint64_t kCostOfPiece = 200, kFreeCost = 4'000'000, kCostAVertex = 8;

struct Item {
  float distance = 0.0f;
  std::uint32_t slice = 0;  ///< Of equal slices; falling distance.
  std::uint32_t draw = 0;
  std::uint32_t triangle = 0;
};

/// Corner indices of each draw's triangles; none for points and lines.
using TriangleLists = std::vector<std::vector<std::uint32_t>>;

float middle_distance(const BlendedDraw& draw, const std::uint32_t* corners) {
  const pipeline::Attribute& positions = draw.geometry->position;
  const auto position = [&](std::uint32_t vertex) {
    const float* p = positions.data + std::size_t{vertex} * static_cast<std::size_t>(positions.stride);
    return glm::vec3(p[0], p[1], p[2]);
  };
  const glm::vec3 sum = position(corners[0]) + position(corners[1]) + position(corners[2]);
  return draw.distance(sum / 3.0f);
}

std::vector<Item> items_of(std::span<const BlendedDraw> draws, const TriangleLists& lists) {
  std::vector<Item> items;
  for (std::uint32_t d = 0; d < draws.size(); ++d) {
    const std::vector<std::uint32_t>& list = lists[d];
    if (list.empty()) items.push_back({draws[d].distance(draws[d].center), 0, d, 0});
    for (std::uint32_t t = 0; 3 * std::size_t{t} < list.size(); ++t) {
      items.push_back({middle_distance(draws[d], &list[3 * std::size_t{t}]), 0, d, t});
    }
  }
  return items;
}

/// Cuts the way from the nearest to the farthest item into equal slices.
void cut(std::vector<Item>& items, std::uint32_t slices) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
  for (const Item& item : items) {
    if (!std::isfinite(item.distance)) continue;
    nearest = std::min(nearest, item.distance);
    farthest = std::max(farthest, item.distance);
  }
  for (Item& item : items) {
    const float place = (farthest - item.distance) / (farthest - nearest) * static_cast<float>(slices);
    item.slice = place > 0.0f ? std::min(static_cast<std::uint32_t>(place), slices - 1) : 0;
  }
}

/// Every item by its distance; or by its slice, in that by its draw.
void sort(std::vector<Item>& items, bool sliced) {
  std::stable_sort(items.begin(), items.end(), [sliced](const Item& a, const Item& b) {
    if (sliced && a.slice != b.slice) return a.slice < b.slice;
    if (sliced && a.draw != b.draw) return a.draw < b.draw;
    return a.distance > b.distance;
  });
}

std::uint64_t cost_of(const std::vector<Item>& items, const TriangleLists& lists) {
  std::uint64_t cost = 0;
  for (std::size_t i = 0; i < items.size();) {
    const std::uint32_t draw = items[i].draw;
    std::uint32_t low = UINT32_MAX, high = 0;
    for (; i < items.size() && items[i].draw == draw; ++i) {
      if (lists[draw].empty()) continue;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = lists[draw][3 * std::size_t{items[i].triangle} + corner];
        low = std::min(low, vertex);
        high = std::max(high, vertex);
      }
    }
    cost += kCostOfPiece + (low <= high ? high - low + 1 : 0);
  }
  return cost;
}

std::vector<BlendedPiece> pieces_of(const std::vector<Item>& items, const TriangleLists& lists) {
  std::vector<BlendedPiece> pieces;
  for (const Item& item : items) {
    if (pieces.empty() || pieces.back().draw != item.draw) pieces.push_back({item.draw, {}});
    const std::vector<std::uint32_t>& list = lists[item.draw];
    if (list.empty()) continue;
    const std::uint32_t* corners = &list[3 * std::size_t{item.triangle}];
    pieces.back().indices.insert(pieces.back().indices.end(), corners, corners + 3);
  }
  return pieces;
}

}  // namespace

BlendedOrder order_blended(std::span<const BlendedDraw> draws) {
  TriangleLists lists;
  std::uint64_t vertices = 0;
  for (const BlendedDraw& draw : draws) {
    const pipeline::Geometry& geometry = *draw.geometry;
    lists.push_back(triangle_list(geometry.mode, geometry.indices, geometry.vertex_count));
    vertices += geometry.vertex_count;
  }
  std::vector<Item> items = items_of(draws, lists);
  sort(items, false);
  BlendedOrder order;
  const std::uint64_t allowed = kFreeCost + kCostAVertex * vertices;
  for (std::uint32_t slices = 1024; slices > 0 && cost_of(items, lists) > allowed; slices /= 4) {
    order.slices = static_cast<int>(slices);
    cut(items, slices);
    sort(items, true);
  }
  order.pieces = pieces_of(items, lists);
  return order;
}

}  // namespace barrido::scene
