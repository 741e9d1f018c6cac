#include "pipeline/scene/triangles.h"

namespace barrido::scene {

bool is_surface(pipeline::PrimitiveMode mode) {
  return mode == pipeline::PrimitiveMode::triangles || mode == pipeline::PrimitiveMode::triangle_strip ||
         mode == pipeline::PrimitiveMode::triangle_fan;
}

std::vector<std::uint32_t> triangle_list(pipeline::PrimitiveMode mode, std::span<const std::uint32_t> indices,
                                         std::uint32_t vertex_count) {
  std::vector<std::uint32_t> list;
  const std::size_t count = indices.empty() ? vertex_count : indices.size();
  if (!is_surface(mode) || count < 3) return list;
  const auto vertex = [&](std::size_t i) {
    return indices.empty() ? static_cast<std::uint32_t>(i) : indices[i];
  };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    list.insert(list.end(), {vertex(a), vertex(b), vertex(c)});
  };
  if (mode == pipeline::PrimitiveMode::triangles) {
    list.reserve(count);
    for (std::size_t i = 0; i + 2 < count; i += 3) add(i, i + 1, i + 2);
    return list;
  }
  list.reserve((count - 2) * 3);
  for (std::size_t i = 0; i + 2 < count; ++i) {
    if (mode == pipeline::PrimitiveMode::triangle_fan) {
      add(0, i + 1, i + 2);
    } else {
      // Every other triangle of a strip is turned over so that all face the same way.
      add(i + i % 2, i + 1 - i % 2, i + 2);
    }
  }
  return list;
}

namespace {

/// How many of `count` vertices in order make whole points, lines and triangles.
std::size_t whole_count(pipeline::PrimitiveMode mode, std::size_t count) {
  switch (mode) {
    case pipeline::PrimitiveMode::points:
      return count;
    case pipeline::PrimitiveMode::lines:
      return count / 2 * 2;
    case pipeline::PrimitiveMode::line_loop:
    case pipeline::PrimitiveMode::line_strip:
      return count >= 2 ? count : 0;
    case pipeline::PrimitiveMode::triangles:
      return count / 3 * 3;
    default:
      return count >= 3 ? count : 0;
  }
}

}  // namespace

std::vector<bool> drawn_vertices(pipeline::PrimitiveMode mode, std::span<const std::uint32_t> indices,
                                 std::uint32_t vertex_count) {
  const std::size_t whole = whole_count(mode, indices.empty() ? vertex_count : indices.size());
  if (indices.empty() && whole == vertex_count) return {};
  std::vector<bool> drawn(vertex_count, false);
  std::size_t missing = vertex_count;
  for (std::size_t i = 0; i < whole; ++i) {
    const std::size_t vertex = indices.empty() ? i : indices[i];
    if (drawn[vertex]) continue;
    drawn[vertex] = true;
    if (--missing == 0) return {};
  }
  return drawn;
}

}  // namespace barrido::scene
