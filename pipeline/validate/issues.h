// Where the findings of a validation go: each with its code, its place as a JSON pointer (RFC 6901) or a byte
// offset, and a sentence. Text of the file is made harmless before it is kept. Knows nothing of glTF.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/gltf/report.h"
#include "pipeline/validate/codes.h"
#include "pipeline/validate/codes_scene.h"

namespace barrido::scene::validation {

using gltf::Place;

struct Issue {
  std::string_view code;
  Severity severity = Severity::error;
  std::string pointer;                  ///< Where there is no offset.
  std::optional<std::uint64_t> offset;  ///< Bytes from the beginning of the file.
  std::string message;
};

class Issues {
 public:
  /// At most `max_kept` findings are kept; the others are only counted.
  explicit Issues(std::size_t max_kept) : max_kept_(max_kept) {}

  /// The root is "/", as the reference validator has it; RFC 6901 says "".
  void add(const Code& code, const Place& place, std::initializer_list<std::string> arguments = {});
  /// An empty pointer stands for the file.
  void add(const Code& code, std::string pointer, std::initializer_list<std::string> arguments = {});
  void add_at(std::uint64_t offset, const Code& code, std::initializer_list<std::string> arguments = {});

  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  bool truncated() const { return truncated_; }
  const std::vector<Issue>& list() const { return list_; }

 private:
  /// Counts the finding and tells whether it is to be kept.
  bool take(const Code& code);

  std::size_t max_kept_;
  std::array<std::size_t, 4> counts_{};
  std::vector<Issue> list_;
  bool truncated_ = false;
};

/// The text in quotation marks, on one line and not too long.
std::string in_quotes(std::string_view text);

}  // namespace barrido::scene::validation
