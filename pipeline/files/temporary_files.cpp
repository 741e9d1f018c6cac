#include "pipeline/files/temporary_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <string>
#include <utility>

namespace barrido::scene {
namespace {

enum class State : int { free, being_changed, live };

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

std::size_t remember(const std::string& path) {
  if (path.size() >= PATH_MAX) return kNoSlot;
  for (std::size_t i = 0; i < kSlots; ++i) {
    State expected = State::free;
    if (!slots[i].state.compare_exchange_strong(expected, State::being_changed)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].state = State::live;
    return i;
  }
  return kNoSlot;
}

void forget(std::size_t slot) {
  if (slot != kNoSlot) slots[slot].state = State::free;
}

}  // namespace

TemporaryPath::TemporaryPath(std::filesystem::path path)
    : path_(std::move(path)), slot_(remember(path_.string())) {}

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
  for (const Slot& slot : slots) {
    if (slot.state == State::live) ::unlink(slot.path.data());
  }
  for (const Slot& slot : slots) {
    if (slot.state == State::live) ::rmdir(slot.path.data());
  }
}

}  // namespace barrido::scene
