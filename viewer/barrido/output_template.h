// Names of the pictures: a template with placeholders in braces becomes one name a frame.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/values.h"

namespace barrido::cli {

/// What the placeholders stand for.
struct FrameName {
  std::string model;    ///< File name without folder and extension.
  std::string shading;  ///< "cheap-phong"
  std::string camera;   ///< Index, or "auto" where none was chosen.
  int frame = 0;
  std::string view;         ///< "overdraw", or "picture" where it is none.
  std::string folder{"."};  ///< Of the model, as it was given: below any folder, "up" in place of "..".
};

/// "out/{model}-{shading}-{camera}-{frame:04}.png". {{ and }} are braces; {frame:04} is the number with
/// leading zeros to four places (1 to 9).
class OutputTemplate {
 public:
  /// @throws ValueError for an empty template, unknown placeholders and lonely braces.
  explicit OutputTemplate(std::string_view text);

  /// Whether the placeholder ("model", "folder", "shading", "camera", "frame", "view") occurs.
  bool has(std::string_view placeholder) const;
  bool is_standard_output() const;
  std::string expand(const FrameName& name) const;

 private:
  struct Piece {
    std::string_view placeholder;  ///< Empty: `text` as it stands.
    std::string text;
    int width = 0;  ///< Leading zeros to so many places.
  };
  void add_text(char letter);
  void add_placeholder(std::string_view inside);

  std::vector<Piece> pieces_;
};

}  // namespace barrido::cli
