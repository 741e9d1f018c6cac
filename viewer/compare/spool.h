// Text that is collected on disk until it is known what stands before it: a report's pictures may be larger
// than memory.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace barrido::compare {

/// A file without a name: it goes away with the object, whatever happens.
class Spool {
 public:
  /// Takes its space in `folder`. @throws scene::InputError naming it.
  explicit Spool(const std::filesystem::path& folder);

  /// @throws scene::InputError, as when the disk is full.
  void append(std::string_view text);
  /// Writes all that was collected. @throws scene::InputError.
  void copy_to(std::FILE* out);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path folder_;
  std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace barrido::compare
