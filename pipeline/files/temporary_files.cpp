#include "pipeline/files/temporary_files.h"

#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

namespace barrido::scene {
namespace {

enum class State : int { free, being_created, live };

/// A handler of a signal may neither lock nor allocate: names stand in fixed memory, each behind a flag.
struct Slot {
  std::atomic<State> state{State::free};
  std::array<char, PATH_MAX> path{};
};

/// More than frames are ever written at a time. Whoever finds none free goes without: its file is then
/// removed by its destructor only.
constexpr std::size_t kSlots = 64;
constexpr std::size_t kNoSlot = kSlots;
std::array<Slot, kSlots> slots;
static_assert(std::atomic<State>::is_always_lock_free);

/// Set for good once the files are being removed.
std::atomic<bool> ending{false};

/// As long as nobody would wait for a disk that does not answer.
constexpr int kMostWaits_ms = 1000;
/// A folder that somebody still writes into is tried again.
constexpr int kMostRounds = 10;

/// No signal interrupts this thread meanwhile: its handler would wait for what this thread has begun.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~WithoutSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
  sigset_t before_{};
};

std::size_t take_slot() {
  for (std::size_t i = 0; i < kSlots; ++i) {
    State expected = State::free;
    if (slots[i].state.compare_exchange_strong(expected, State::being_created)) return i;
  }
  return kNoSlot;
}

void forget(std::size_t slot) {
  if (slot != kNoSlot) slots[slot].state = State::free;
}

/// The slot, or none where the path does not fit.
std::size_t remember(std::size_t slot, const std::string& path) {
  if (slot == kNoSlot) return kNoSlot;
  if (path.size() >= PATH_MAX) {
    forget(slot);
    return kNoSlot;
  }
  std::memcpy(slots[slot].path.data(), path.c_str(), path.size() + 1);
  slots[slot].state = State::live;
  return slot;
}

/// Whoever creates a file takes a slot and then asks whether the end has come: either it sees that, and never
/// goes on, or the end sees its slot and waits for it.
std::size_t take_slot_unless_ending() {
  const std::size_t slot = take_slot();
  if (ending) forget(slot);
  while (ending) ::poll(nullptr, 0, 1);
  return slot;
}

void wait_for_creation() {
  for (const Slot& slot : slots) {
    for (int wait = 0; slot.state == State::being_created && wait < kMostWaits_ms; ++wait)
      ::poll(nullptr, 0, 1);
  }
}

/// Whether a folder is left because something has been put into it since.
bool remove_once() {
  for (const Slot& slot : slots) {
    if (slot.state == State::live) ::unlink(slot.path.data());
  }
  bool again = false;
  for (const Slot& slot : slots) {
    if (slot.state == State::live && ::rmdir(slot.path.data()) != 0) again |= errno == ENOTEMPTY;
  }
  return again;
}

}  // namespace

TemporaryPath::TemporaryPath(std::filesystem::path path) : TemporaryPath([&] { return std::move(path); }) {}

TemporaryPath::TemporaryPath(const std::function<std::filesystem::path()>& create) : slot_(kNoSlot) {
  const WithoutSignals without_signals;
  const std::size_t slot = take_slot_unless_ending();
  try {
    path_ = create();
    slot_ = remember(slot, path_.string());
  } catch (...) {
    forget(slot);
    throw;
  }
}

TemporaryPath::~TemporaryPath() {
  if (path_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  forget(slot_);
}

void TemporaryPath::keep() {
  forget(std::exchange(slot_, kNoSlot));
  path_.clear();
}

void remove_temporary_files() noexcept {
  ending = true;
  wait_for_creation();
  for (int round = 0; round < kMostRounds && remove_once(); ++round) continue;
}

}  // namespace barrido::scene
