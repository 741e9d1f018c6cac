#include "viewer/barrido/call_limits.h"

#include <algorithm>
#include <thread>

#include "viewer/barrido/process_guard.h"
#include "viewer/barrido/text_format.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

/// Beside what the sizes of files and frames allow: what the loader allows any file (352 MiB), and the
/// program itself with what drawing makes of that; and the stacks of its threads.
constexpr std::uint64_t kProgramBytes = 464 * kMiB;
constexpr std::uint64_t kThreadBytes = 9 * kMiB;

// A frame of the default size within some 13 s of the processor, where 0.1 s are usual.
constexpr double kFrameSeconds = 4.0;
constexpr double kSecondsAPixel = 1e-5;
constexpr double kSecondsAByte = 1e-6;

/// The loader ends by itself, with a better message; only where it does not look at the clock this comes
/// first.
constexpr double kGraceSeconds = 0.5;

}  // namespace

std::uint64_t parse_memory(std::string_view text) {
  constexpr double kMost = 1e6;
  constexpr std::string_view kUnits = "KMG";
  const std::size_t unit = text.empty() ? std::string_view::npos : kUnits.find(text.back());
  const std::string expected = "expected a size with K, M or G, as 512M, at least 16M";
  if (unit == std::string_view::npos) throw ValueError(expected);
  double bytes = 0.0;
  try {
    bytes = parse_number(text.substr(0, text.size() - 1), 0.0, kMost * static_cast<double>(kMiB));
  } catch (const ValueError&) {
    throw ValueError(expected);
  }
  for (std::size_t i = 0; i <= unit; ++i) bytes *= 1024.0;
  if (bytes < static_cast<double>(16 * kMiB)) throw ValueError(expected);
  return static_cast<std::uint64_t>(std::min(bytes, 1e18));
}

std::string memory_text(const std::uint64_t& bytes) {
  return shortest_double(static_cast<double>(bytes) / 1024.0) + "K";
}

double parse_seconds(std::string_view text) { return parse_number(text, 0.1, 1e6); }

CallLimits::CallLimits(const LimitOptions& options) : options_(options) {
  if (options_.max_seconds)
    start_clock(ClockKind::wall, *options_.max_seconds, "the time of --max-seconds is up");
  limit_memory();
}

CallLimits::~CallLimits() { stop_clock(); }

void CallLimits::limit_memory() const {
  if (options_.max_memory) return limit_data(*options_.max_memory);
  const std::uint64_t threads = std::max(std::thread::hardware_concurrency(), 1u) * kThreadBytes;
  // Twice what the loader allows itself: drawing makes more of what was read.
  limit_data(kProgramBytes + threads + frame_bytes_ + 2 * (kept_bytes_ + opened_bytes_));
}

void CallLimits::expect_frames(std::uint64_t bytes) {
  frame_bytes_ = std::max(frame_bytes_, bytes);
  limit_memory();
}

std::shared_ptr<scene::Budget> CallLimits::open(const std::string& path, bool keeps) {
  constexpr double kNever = 1e9;
  scene::BudgetLimits limits{options_.max_memory, std::nullopt};
  if (options_.max_seconds) {
    limits.max_seconds = kNever;  // The clock of the call runs.
    rename_clock(path + ": not read within the seconds of --max-seconds");
  }
  const auto budget = std::make_shared<scene::Budget>(limits);
  const std::string late = path + ": takes too long to read (--max-seconds allows more)";
  if (!options_.max_seconds)
    start_clock(ClockKind::processor, budget->allowed_seconds() + kGraceSeconds, late);
  const std::uint64_t before = keeps ? kept_bytes_ : 0;
  budget->on_growth([this, keeps, before, late](const scene::Budget& grown) {
    (keeps ? kept_bytes_ : opened_bytes_) = before + grown.earned_memory();
    limit_memory();
    if (!options_.max_seconds)
      start_clock(ClockKind::processor, grown.allowed_seconds() + kGraceSeconds, late);
  });
  return budget;
}

void CallLimits::draw(const std::string& label, double pixels) {
  if (options_.max_seconds) return rename_clock(label + ": not drawn within the seconds of --max-seconds");
  const double seconds = kFrameSeconds + kSecondsAPixel * pixels +
                         kSecondsAByte / 64.0 * static_cast<double>(kept_bytes_ + opened_bytes_);
  start_clock(ClockKind::processor, seconds, label + ": takes too long to draw (--max-seconds allows more)");
}

void CallLimits::rest() {
  if (options_.max_seconds) return rename_clock("the time of --max-seconds is up");
  stop_clock();
}

}  // namespace barrido::cli
