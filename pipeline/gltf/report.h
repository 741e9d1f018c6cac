// Where the problems of one import go: errors end it as InputError, warnings are collected. Knows nothing of
// glTF.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace barrido::scene::gltf {

/// `text` fit for a message of one line: control characters become '?', and what is longer than `max_bytes`
/// is cut at a whole UTF-8 character and ends in "...".
std::string one_line(std::string_view text, std::size_t max_bytes = 160);

/// "accessors[3]"
std::string element(std::string_view array, std::size_t index);

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
