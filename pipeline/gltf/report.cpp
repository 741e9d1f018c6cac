// Messages of the glTF importer. Text that comes from the file is made harmless before it is shown.
#include "pipeline/gltf/report.h"

#include <algorithm>

#include "pipeline/files/error.h"

namespace barrido::scene::gltf {

std::string one_line(std::string_view text, std::size_t max_bytes) {
  const bool cut = text.size() > max_bytes;
  if (cut) {
    std::size_t end = max_bytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
    text = text.substr(0, end);
  }
  std::string line(text);
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  if (cut) line += "...";
  return line;
}

std::string element(std::string_view array, std::size_t index) {
  return std::string(array) + '[' + std::to_string(index) + ']';
}

void Report::fail(const std::string& place, const std::string& reason) const {
  throw InputError(file_, place, reason);
}

void Report::warn(const std::string& line) {
  constexpr std::size_t kMost = 64;  // Nobody reads more; and each new line is compared with all.
  if (warnings_.size() > kMost) return;
  if (std::find(warnings_.begin(), warnings_.end(), line) != warnings_.end()) return;
  warnings_.push_back(warnings_.size() < kMost ? line : "there are more warnings; these are the first");
}

}  // namespace barrido::scene::gltf
