#include "viewer/compare/spool.h"

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "pipeline/files/error.h"

namespace barrido::compare {
namespace {

[[noreturn]] void fail(const std::filesystem::path& folder) {
  throw scene::InputError(folder.string(), "",
                          "cannot be written: " + std::generic_category().message(errno));
}

}  // namespace

Spool::Spool(const std::filesystem::path& folder) : folder_(folder) {
  std::string name = (folder / ".barrido-XXXXXX").string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) fail(folder);
  ::unlink(name.c_str());
  file_.reset(::fdopen(descriptor, "w+b"));
  if (!file_) {
    ::close(descriptor);
    fail(folder);
  }
}

void Spool::append(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail(folder_);
}

void Spool::copy_to(std::FILE* out) {
  if (std::fflush(file_.get()) != 0) fail(folder_);
  std::rewind(file_.get());
  std::vector<char> block(std::size_t{1} << 20);
  while (true) {
    const std::size_t got = std::fread(block.data(), 1, block.size(), file_.get());
    if (got > 0 && std::fwrite(block.data(), 1, got, out) != got) fail(folder_);
    if (got < block.size()) break;
  }
  if (std::ferror(file_.get()) != 0) fail(folder_);
}

}  // namespace barrido::compare
