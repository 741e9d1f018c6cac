#include "pipeline/files/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

#include "pipeline/files/descriptor.h"
#include "pipeline/files/error.h"
#include "pipeline/files/temporary_files.h"

namespace barrido::scene {
namespace {

namespace fs = std::filesystem;

InputError cannot_write(const fs::path& path, int error_number) {
  return {path.string(), "", "cannot be written: " + std::generic_category().message(error_number)};
}

/// A new empty file in `folder`; hidden, so that a pattern such as *.png does not find it.
fs::path create_temporary(const fs::path& folder, const fs::path& target) {
  static std::atomic<unsigned> count{0};
  while (true) {
    fs::path path =
        folder / (".barrido-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".part");
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.is_open()) return path;
    if (errno != EEXIST) throw cannot_write(target, errno);
  }
}

void write_bytes(const fs::path& file_path, std::span<const std::uint8_t> bytes, const fs::path& target) {
  Descriptor file(::open(file_path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (!file.is_open()) throw cannot_write(target, errno);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), std::min(bytes.size(), std::size_t{1} << 30));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw cannot_write(target, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (!file.close()) throw cannot_write(target, errno);
}

/// What takes a file's place becomes as accessible as that was.
void take_over_access(const fs::path& target, const fs::path& successor, const fs::path& path) {
  struct stat facts {};
  if (::stat(target.c_str(), &facts) != 0) return;
  // Only the superuser may give files away; a failure leaves the file with who wrote it.
  if (::chown(successor.c_str(), facts.st_uid, facts.st_gid) != 0) errno = 0;
  if (::chmod(successor.c_str(), facts.st_mode & 07777) != 0) throw cannot_write(path, errno);
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (path.empty() || !path.has_filename()) throw cannot_write(path, path.empty() ? ENOENT : EISDIR);
  if (fs::is_directory(status)) throw cannot_write(path, EISDIR);
  // A device such as /dev/null must be written to, not replaced.
  if (fs::exists(status) && !fs::is_regular_file(status)) return write(path);

  // A symbolic link stays one: the file it means is replaced.
  fs::path target = fs::exists(status) ? fs::canonical(path, error) : path;
  if (error) target = path;
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) throw cannot_write(path, errno);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  TemporaryPath temporary([&] { return create_temporary(folder, path); });
  write(temporary.path());
  if (fs::exists(status)) take_over_access(target, temporary.path(), path);
  if (::rename(temporary.path().c_str(), target.c_str()) != 0) throw cannot_write(path, errno);
  temporary.keep();
}

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  write_atomically(path, [&](const fs::path& file_path) { write_bytes(file_path, bytes, path); });
}

}  // namespace barrido::scene
