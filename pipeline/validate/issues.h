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

#include "pipeline/validate/codes.h"
#include "pipeline/validate/codes_scene.h"

namespace barrido::scene::validation {

/// Where a walk is, as a chain up to the root: made into text only when something is wrong.
class Place {
 public:
  Place() = default;
  Place(const Place& parent, std::string_view name) : parent_(&parent), name_(name) {}
  Place(const Place& parent, std::size_t index) : parent_(&parent), index_(index) {}

  /// "/meshes/0/primitives/1"; empty for the root.
  std::string pointer() const;

 private:
  static constexpr std::size_t kNoIndex = SIZE_MAX;
  const Place* parent_ = nullptr;
  std::string_view name_;
  std::size_t index_ = kNoIndex;
};

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

  void add(const Code& code, const Place& place, std::initializer_list<std::string> arguments = {});
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

/// A number as the file might have written it: "3", "0.1", "NaN".
std::string shown(double value);
/// The text in quotation marks, on one line and not too long.
std::string in_quotes(std::string_view text);

}  // namespace barrido::scene::validation
