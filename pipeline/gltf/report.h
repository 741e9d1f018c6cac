// Where the problems of one import go: errors end it as InputError, warnings are collected; and words for
// what comes from the file. Knows nothing of glTF.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace barrido::scene::gltf {

/// `text` fit for a message of one line: control characters become '?', and what is longer than `max_bytes`
/// is cut at a whole UTF-8 character and ends in "...".
std::string one_line(std::string_view text, std::size_t max_bytes = 160);

/// A number as the file might have written it: "3", "0.1", "NaN".
std::string shown(double value);

/// "accessors[3]"
std::string element(std::string_view array, std::size_t index);

/// Where a walk through a document is, as a chain up to the root: made into text only when something is
/// wrong. A place must not outlive its parents.
class Place {
 public:
  Place() = default;
  Place(const Place& parent, std::string_view name) : parent_(&parent), name_(name) {}
  Place(const Place& parent, std::size_t index) : parent_(&parent), index_(index) {}

  /// "meshes[0].primitives[1].mode"; empty for the root.
  std::string text() const;
  /// "/meshes/0/primitives/1/mode" (RFC 6901); empty for the root.
  std::string pointer() const;

 private:
  static constexpr std::size_t kNoIndex = SIZE_MAX;
  const Place* parent_ = nullptr;
  std::string_view name_;
  std::size_t index_ = kNoIndex;
};

class Report {
 public:
  /// `file`: the model's path as the user gave it.
  explicit Report(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  /// @throws InputError always: "file: place: reason".
  [[noreturn]] void fail(const std::string& place, const std::string& reason) const;

  /// Keeps one line for the user; the same line is kept once, and of many different ones the first.
  void warn(const std::string& line);

  std::vector<std::string> take_warnings() { return std::move(warnings_); }

 private:
  std::string file_;
  std::vector<std::string> warnings_;
};

}  // namespace barrido::scene::gltf
