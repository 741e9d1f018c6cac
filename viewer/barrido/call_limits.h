// The limits of one call: from --max-memory and --max-seconds, or from what the sizes of its files and frames
// justify. docs/limits.md describes them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/files/budget.h"

namespace barrido::cli {

struct LimitOptions {
  std::optional<std::uint64_t> max_memory;  ///< Bytes
  std::optional<double> max_seconds;        ///< Of the whole call
};

/// "512M", "1.5G", "300000K": a number with K, M or G for 1024, 1024² or 1024³, at least 16M. @throws
/// ValueError.
std::uint64_t parse_memory(std::string_view text);
/// As parse_memory reads it, to the byte: "1024K".
std::string memory_text(const std::uint64_t& bytes);
/// A number in 0.1..1000000. @throws ValueError.
double parse_seconds(std::string_view text);

inline constexpr std::string_view kMaxMemoryHelp =
    "Take no more memory than SIZE, as 512M or 4G. Default: as the sizes of files and frames justify; "
    "docs/limits.md tells how much.";
inline constexpr std::string_view kMaxSecondsHelp =
    "End after N seconds. Default: none for the call, but one for each file and frame, as their sizes "
    "justify.";

/// The clock of the call starts with the object and stops with it. One at a time in a process.
class CallLimits {
 public:
  explicit CallLimits(const LimitOptions& options);
  ~CallLimits();
  CallLimits(const CallLimits&) = delete;
  CallLimits& operator=(const CallLimits&) = delete;

  /// So much memory will be needed for frames, whose sizes the user chose.
  void expect_frames(std::uint64_t bytes);

  /// A file is about to be opened: what it may take. `keeps`: it stays open beside those that follow.
  std::shared_ptr<scene::Budget> open(const std::string& path, bool keeps = false);

  /// A frame of so many pixels is about to be drawn.
  void draw(const std::string& label, double pixels);

  /// What comes now takes no longer than the user wants.
  void rest();

 private:
  void limit_memory() const;

  LimitOptions options_;
  std::uint64_t frame_bytes_ = 0;
  std::uint64_t kept_bytes_ = 0;    ///< Earned by files that stay open.
  std::uint64_t opened_bytes_ = 0;  ///< Earned by the file opened last.
};

}  // namespace barrido::cli
