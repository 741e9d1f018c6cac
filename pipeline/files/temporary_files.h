// The files that exist only until they are finished and renamed: the process knows them all, so that one that
// is told to end can remove them first.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

namespace barrido::scene {

/// A file or folder that is removed with the object, with all that a folder holds, unless told to stay.
class TemporaryPath {
 public:
  /// What stands there, or will.
  explicit TemporaryPath(std::filesystem::path path);
  /// What `create` makes, and returns the name of: at no moment does it exist without being known. Passes on
  /// what `create` throws.
  explicit TemporaryPath(const std::function<std::filesystem::path()>& create);
  TemporaryPath(const TemporaryPath&) = delete;
  TemporaryPath& operator=(const TemporaryPath&) = delete;
  ~TemporaryPath();

  const std::filesystem::path& path() const { return path_; }
  /// It has been renamed, or is wanted after all.
  void keep();

 private:
  std::filesystem::path path_;
  std::size_t slot_;
};

/// Removes the files, and then the empty folders, of all TemporaryPaths, and lets no more be created; for a
/// process that is about to end. May be called by the handler of a signal.
void remove_temporary_files() noexcept;

}  // namespace barrido::scene
