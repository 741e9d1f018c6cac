// Tells when a file changes on disk, without asking again and again. Enters: a path; leaves: a call from
// another thread. Knows neither what is in the file nor who wants to know.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace barrido::view {

class FileWatch {
 public:
  /// `changed` is called, on a thread of the watch, after a file was written or replaced: `path` itself, and
  /// for a .gltf, whose pictures and buffers are files beside it, any file in its folder. Where the system
  /// cannot tell, it is never called.
  FileWatch(const std::string& path, std::function<void()> changed);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::view
