// What opening files may cost: an account of memory, kept before memory is taken, and a clock. Larger files
// may cost more, since who sends much may mean much; a little file that asks for gigabytes is refused. Safe
// to use from several threads.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace barrido::scene {

struct BudgetLimits {
  std::optional<std::uint64_t> max_memory;  ///< Bytes. Empty: as Budget::default_memory says.
  std::optional<double> max_seconds;        ///< Empty: as Budget::default_seconds says.
};

class Budget {
 public:
  /// Of a file that holds a model or its buffers, and of one that holds a picture: pictures are packed
  /// tighter.
  enum class Kind : std::uint8_t { model, picture };

  /// The clock starts now.
  explicit Budget(const BudgetLimits& limits = {});

  /// Called, with the mutex held, whenever a file has made the budget larger.
  void on_growth(std::function<void(const Budget&)> call) { on_growth_ = std::move(call); }

  /// A file of so many bytes is about to be read: it counts as memory taken, and as a reason to allow more.
  /// @throws InputError as take.
  void add_file(std::uint64_t bytes, Kind kind, const std::string& file);

  /// Memory that is about to be taken. @throws InputError naming `file` and `place` where it, or the time, is
  /// not allowed.
  void take(std::uint64_t bytes, const std::string& file, const std::string& place);

  /// Bytes that may still be taken.
  std::uint64_t memory_left() const;

  /// Whether the time is up.
  bool is_late() const;
  /// @throws InputError when the time is up.
  void check_time(const std::string& file, const std::string& place) const;

  /// Bytes that files of this size may take: 352 MiB, or 64 for each byte of a model and 160 for each of a
  /// picture where that is more.
  std::uint64_t allowed_memory() const { return limits_.max_memory.value_or(default_memory()); }
  /// Bytes that the size of the files alone would allow.
  std::uint64_t earned_memory() const { return earned_; }
  /// 4 of the processor, and 1 more for each million bytes.
  double allowed_seconds() const { return limits_.max_seconds.value_or(default_seconds()); }

 private:
  std::uint64_t default_memory() const;
  double default_seconds() const;

  using Clock = std::chrono::steady_clock;
  BudgetLimits limits_;
  Clock::time_point start_ = Clock::now();
  mutable std::mutex mutex_;
  std::uint64_t taken_ = 0;
  std::uint64_t earned_ = 0;
  std::uint64_t file_bytes_ = 0;
  std::function<void(const Budget&)> on_growth_;
};

/// "288 MiB", "1.5 GiB": at most one digit behind the point.
std::string shown_bytes(std::uint64_t bytes);

}  // namespace barrido::scene
