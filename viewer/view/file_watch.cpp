#include "viewer/view/file_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <thread>

namespace barrido::view {
namespace {

/// Whether the events in `bytes` concern a file with this name, or any file when the name is empty.
bool concerns(std::string_view bytes, const std::string& name) {
  while (bytes.size() >= sizeof(inotify_event)) {
    inotify_event event{};
    std::copy_n(bytes.data(), sizeof event, reinterpret_cast<char*>(&event));
    const std::string_view file(bytes.data() + sizeof event);
    if (name.empty() || file == name) return true;
    bytes.remove_prefix(std::min(bytes.size(), sizeof event + event.len));
  }
  return false;
}

}  // namespace

struct FileWatch::Implementation {
  int events = -1;
  int stop = -1;
  std::string name;
  std::function<void()> changed;
  std::thread thread;

  void run() const {
    alignas(inotify_event) std::array<char, 8192> buffer{};
    for (;;) {
      std::array<pollfd, 2> waiting{{{events, POLLIN, 0}, {stop, POLLIN, 0}}};
      if (poll(waiting.data(), waiting.size(), -1) < 0) continue;
      if (waiting[1].revents != 0) return;
      const ssize_t count = read(events, buffer.data(), buffer.size());
      if (count <= 0) return;
      if (concerns({buffer.data(), static_cast<std::size_t>(count)}, name)) changed();
    }
  }
};

FileWatch::FileWatch(const std::string& path, std::function<void()> changed)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  const std::filesystem::path file(path);
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  self.name = file.extension() == ".gltf" ? "" : file.filename().string();
  self.changed = std::move(changed);
  self.events = inotify_init1(IN_CLOEXEC);
  self.stop = eventfd(0, EFD_CLOEXEC);
  if (self.events < 0 || self.stop < 0) return;
  if (inotify_add_watch(self.events, folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO) < 0) return;
  self.thread = std::thread([&self] { self.run(); });
}

FileWatch::~FileWatch() {
  Implementation& self = *implementation_;
  if (self.thread.joinable()) {
    const std::uint64_t one = 1;
    const ssize_t written = write(self.stop, &one, sizeof one);
    if (written == sizeof one)
      self.thread.join();
    else
      self.thread.detach();
  }
  if (self.events >= 0) close(self.events);
  if (self.stop >= 0) close(self.stop);
}

}  // namespace barrido::view
