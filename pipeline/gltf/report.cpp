// Messages of the glTF importer. Text that comes from the file is made harmless before it is shown.
#include "pipeline/gltf/report.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "pipeline/files/error.h"

namespace barrido::scene::gltf {
namespace {

/// RFC 6901, section 3: '~' is written ~0, '/' is written ~1.
std::string escaped(std::string_view name) {
  constexpr std::size_t kMaxBytes = 200;
  std::string text;
  for (const char c : one_line(name, kMaxBytes)) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

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

std::string shown(double value) {
  constexpr double kMaxExact = 9007199254740992.0;
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-infinity" : "infinity";
  if (std::floor(value) == value && std::abs(value) <= kMaxExact) {
    return std::to_string(static_cast<std::int64_t>(value));
  }
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general);
  return {text, end.ptr};
}

std::string element(std::string_view array, std::size_t index) {
  return std::string(array) + '[' + std::to_string(index) + ']';
}

std::string Place::text() const {
  if (parent_ == nullptr) return {};
  const std::string above = parent_->text();
  if (index_ != kNoIndex) return above + '[' + std::to_string(index_) + ']';
  return (above.empty() ? above : above + '.') + one_line(name_, 80);
}

std::string Place::pointer() const {
  if (parent_ == nullptr) return {};
  return parent_->pointer() + '/' + (index_ != kNoIndex ? std::to_string(index_) : escaped(name_));
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
