// The shading modes as a list in help texts, made as the program is compiled.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "pipeline/shading_modes.h"

namespace barrido::cli {

struct ModeList {
  std::array<char, 256> text{};
  std::size_t size = 0;

  /// `before`, the modes' names (or their words for people) with commas between, `after`.
  constexpr ModeList(std::string_view before, bool for_people, std::string_view after) {
    add(before);
    for (const pipeline::ShadingMode& mode : pipeline::kShadingModes) {
      if (&mode != pipeline::kShadingModes.data()) add(", ");
      add(for_people ? std::string_view(mode.words) : mode.name);
    }
    add(after);
  }
  constexpr void add(std::string_view more) {
    for (const char c : more) text.at(size++) = c;
  }
  constexpr operator std::string_view() const { return {text.data(), size}; }
};

}  // namespace barrido::cli
