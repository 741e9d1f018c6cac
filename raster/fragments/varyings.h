// What vertices hand to fragments: a list of varyings by meaning. Who needs a quantity asks the list where it
// stands; who adds one adds a meaning.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace barrido::raster {

/// Texture units of a draw: those of the texture environment and those whose pictures are maps that other
/// stages read (TextureRole).
inline constexpr int kMaxTextureUnits = 8;
inline constexpr int kMaxLights = 64;
/// Largest number of varyings a vertex carries: cheap Phong's two dot products a light, and 48 others.
inline constexpr int kMaxVaryings = 2 * kMaxLights + 48;

inline constexpr int kAbsent = -1;

/// In the order in which they are recorded.
enum class Meaning : std::uint8_t {
  color,         ///< 4: primary colour; absent where the primitive has one of its own.
  specular,      ///< 3: secondary colour, added after texturing; absent likewise, or where none is added.
  normal,        ///< 3: eye space.
  tangents,      ///< 6: how the eye-space place changes with the two coordinates of a map, P_u and P_v.
  eye_position,  ///< 3: eye space.
  dots,          ///< 2 a light: N·L and R·V (or its power); cheap Phong.
  texcoord,      ///< 2 or 3, one entry a texture unit.
  fog,           ///< 1: eye-space z, or any value whose magnitude is the fog distance.
  visibility,    ///< 1 a light: the share of it that arrives. Made by a stage, not interpolated.
  occlusion,     ///< 1: the share of ambient light that arrives. Made by a stage.
};
inline constexpr std::size_t kMeaningCount = 10;

using Meanings = std::uint32_t;  ///< A set of them.
constexpr Meanings set_of(Meaning meaning) { return 1u << static_cast<unsigned>(meaning); }
template <class... More>
constexpr Meanings set_of(Meaning meaning, More... more) {
  return set_of(meaning) | set_of(more...);
}

struct Varying {
  Meaning meaning = Meaning::color;
  int floats = 0;
  int unit = 0;  ///< Texture unit; of coordinates only.
};

/// Where each varying stands after depth and 1/w of a vertex record, in floats. The first `affine_count` are
/// linear on the screen; the others are stored divided by w and are perspective-correct: f = Σ(b f/w) /
/// Σ(b/w) (OpenGL 1.3, eq. 3.6).
class VaryingList {
 public:
  int count = 0;         ///< Interpolated varyings in all, at most kMaxVaryings.
  int affine_count = 0;  ///< How many of them, from the first, are linear on the screen.

  /// First float of an entry, or kAbsent.
  int at(Meaning meaning, int unit = 0) const { return slot(meaning, unit).offset; }
  bool has(Meaning meaning, int unit = 0) const { return at(meaning, unit) != kAbsent; }
  int floats(Meaning meaning, int unit = 0) const { return slot(meaning, unit).floats; }

  /// Places an entry behind all others.
  void add(const Varying& varying) {
    place(varying);
    count = end_;
  }
  /// Places an entry that a stage fills, behind all that is interpolated.
  void add_computed(const Varying& varying) { place(varying); }

 private:
  struct Slot {
    std::int16_t offset = kAbsent;
    std::int16_t floats = 0;
  };
  static constexpr std::size_t kSlots = kMeaningCount + kMaxTextureUnits - 1;

  /// Units' coordinates have slots of their own, behind those of all meanings.
  static std::size_t index(Meaning meaning, int unit) {
    const auto m = static_cast<std::size_t>(meaning);
    return unit == 0 ? m : kMeaningCount - 1 + static_cast<std::size_t>(unit);
  }
  const Slot& slot(Meaning meaning, int unit) const { return slots_[index(meaning, unit)]; }
  void place(const Varying& varying) {
    slots_[index(varying.meaning, varying.unit)] = {static_cast<std::int16_t>(end_),
                                                    static_cast<std::int16_t>(varying.floats)};
    end_ += varying.floats;
  }

  std::array<Slot, kSlots> slots_{};
  int end_ = 0;
};

}  // namespace barrido::raster
