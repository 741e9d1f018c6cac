#include "pipeline/files/budget.h"

#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_gettime is POSIX's

#include <algorithm>
#include <array>

#include "pipeline/files/error.h"

namespace barrido::scene {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
constexpr std::uint64_t kFreeBytes = 352 * kMiB;

// A glTF node of a few letters becomes a kilobyte; what models hold in earnest (numbers, names) grows
// tenfold.
constexpr std::uint64_t kBytesOfModel = 64;
// A JPEG file of 4096² pixels may have one megabyte; with its mip levels it takes 150.
constexpr std::uint64_t kBytesOfPicture = 160;

constexpr double kFreeSeconds = 4.0;
constexpr double kBytesASecond = 1e6;

using Time = std::chrono::steady_clock::time_point;

/// The clock of the wall where the user says how long to wait; else that of the processor, so that no file is
/// refused because the machine is busy with other things.
Time now(const BudgetLimits& limits) {
  if (limits.max_seconds) return std::chrono::steady_clock::now();
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return Time(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
}

}  // namespace

Budget::Budget(const BudgetLimits& limits) : limits_(limits), start_(now(limits)) {}

std::uint64_t Budget::default_memory() const { return std::max(kFreeBytes, earned_); }

double Budget::default_seconds() const {
  return kFreeSeconds + static_cast<double>(file_bytes_) / kBytesASecond;
}

void Budget::add_file(std::uint64_t bytes, Kind kind, const std::string& file) {
  {
    const std::lock_guard lock(mutex_);
    file_bytes_ += bytes;
    earned_ += bytes * (kind == Kind::model ? kBytesOfModel : kBytesOfPicture);
    if (on_growth_) on_growth_(*this);
  }
  take(bytes, file, {});
}

void Budget::take(std::uint64_t bytes, const std::string& file, const std::string& place) {
  check_time(file, place);
  const std::lock_guard lock(mutex_);
  const std::uint64_t left = allowed_memory() - std::min(taken_, allowed_memory());
  if (bytes > left) {
    throw LimitError(file, place,
                     "needs more than the " + shown_bytes(allowed_memory()) +
                         " of memory that it may take (--max-memory allows more)");
  }
  taken_ += bytes;
}

std::uint64_t Budget::memory_left() const {
  const std::lock_guard lock(mutex_);
  return allowed_memory() - std::min(taken_, allowed_memory());
}

bool Budget::is_late() const {
  const std::chrono::duration<double> spent = now(limits_) - start_;
  const std::lock_guard lock(mutex_);
  return spent.count() > allowed_seconds();
}

void Budget::check_time(const std::string& file, const std::string& place) const {
  if (is_late()) throw LimitError(file, place, "takes too long to read (--max-seconds allows more)");
}

std::string shown_bytes(std::uint64_t bytes) {
  constexpr std::array<const char*, 4> kUnits{"bytes", "KiB", "MiB", "GiB"};
  std::size_t unit = 0;
  std::uint64_t tenths = bytes * 10;
  if (bytes > UINT64_MAX / 10) tenths = UINT64_MAX;
  while (unit + 1 < kUnits.size() && tenths >= 10240) {
    tenths = tenths / 1024;
    ++unit;
  }
  std::string text = std::to_string(tenths / 10);
  if (tenths % 10 != 0 && unit > 0) text += '.' + std::to_string(tenths % 10);
  return text + ' ' + kUnits[unit];
}

}  // namespace barrido::scene
