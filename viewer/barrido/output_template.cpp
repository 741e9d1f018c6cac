#include "viewer/barrido/output_template.h"

#include <algorithm>
#include <array>

namespace barrido::cli {
namespace {

constexpr std::array<std::string_view, 6> kPlaceholders{"model",  "folder", "shading",
                                                        "camera", "frame",  "view"};

std::string padded(int number, int width) {
  std::string digits = std::to_string(number);
  const auto places = static_cast<std::size_t>(width);
  if (digits.size() < places) digits.insert(0, places - digits.size(), '0');
  return digits;
}

/// The N of "frame:0N", 1 to 9; 0 when `inside` is something else.
int padding_of(std::string_view inside) {
  constexpr std::string_view kPrefix = "frame:0";
  const bool fits = inside.size() == kPrefix.size() + 1 && inside.substr(0, kPrefix.size()) == kPrefix;
  const char digit = fits ? inside.back() : '0';
  return digit >= '1' && digit <= '9' ? digit - '0' : 0;
}

}  // namespace

OutputTemplate::OutputTemplate(std::string_view text) {
  if (text.empty()) throw ValueError("expected a file name, or - for standard output");
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    const bool doubled = i + 1 < text.size() && text[i + 1] == letter;
    if (letter != '{' && letter != '}') {
      add_text(letter);
    } else if (doubled) {
      add_text(letter);
      ++i;
    } else {
      const std::size_t close = letter == '{' ? text.find('}', i) : std::string_view::npos;
      if (close == std::string_view::npos) throw ValueError("a lonely brace; write {{ or }} for a brace");
      add_placeholder(text.substr(i + 1, close - i - 1));
      i = close;
    }
  }
}

void OutputTemplate::add_text(char letter) {
  if (pieces_.empty() || !pieces_.back().placeholder.empty()) pieces_.push_back({});
  pieces_.back().text += letter;
}

void OutputTemplate::add_placeholder(std::string_view inside) {
  if (const int width = padding_of(inside); width > 0) {
    pieces_.push_back({"frame", "", width});
    return;
  }
  for (const std::string_view name : kPlaceholders) {
    if (inside != name) continue;
    pieces_.push_back({name, "", 0});
    return;
  }
  throw ValueError("unknown placeholder {" + std::string(inside) +
                   "}: expected {model}, {folder}, {shading}, {camera}, {frame}, {frame:04} or {view}");
}

bool OutputTemplate::has(std::string_view placeholder) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [placeholder](const Piece& piece) { return piece.placeholder == placeholder; });
}

bool OutputTemplate::is_standard_output() const {
  return pieces_.size() == 1 && pieces_[0].placeholder.empty() && pieces_[0].text == "-";
}

std::string OutputTemplate::expand(const FrameName& name) const {
  std::string expanded;
  for (const Piece& piece : pieces_) {
    if (piece.placeholder.empty()) expanded += piece.text;
    if (piece.placeholder == "model") expanded += name.model;
    if (piece.placeholder == "shading") expanded += name.shading;
    if (piece.placeholder == "camera") expanded += name.camera;
    if (piece.placeholder == "view") expanded += name.view;
    if (piece.placeholder == "folder") expanded += name.folder;
    if (piece.placeholder == "frame") expanded += padded(name.frame, piece.width);
  }
  return expanded;
}

}  // namespace barrido::cli
