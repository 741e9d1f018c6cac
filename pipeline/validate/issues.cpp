// Findings into lists and sentences.
#include "pipeline/validate/issues.h"

#include <charconv>
#include <cmath>

#include "pipeline/gltf/report.h"

namespace barrido::scene::validation {
namespace {

constexpr std::size_t kMaxNameBytes = 200;

/// RFC 6901, section 3: '~' is written ~0, '/' is written ~1.
std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : gltf::one_line(name, kMaxNameBytes)) {
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

std::string sentence(std::string_view form, std::initializer_list<std::string> arguments) {
  std::string text;
  const std::string* argument = arguments.begin();
  while (!form.empty()) {
    const std::size_t gap = form.find("{}");
    text += form.substr(0, gap);
    if (gap == std::string_view::npos) break;
    if (argument != arguments.end()) text += *argument++;
    form.remove_prefix(gap + 2);
  }
  return text;
}

}  // namespace

std::string Place::pointer() const {
  if (parent_ == nullptr) return {};
  return parent_->pointer() + '/' + (index_ != kNoIndex ? std::to_string(index_) : escaped(name_));
}

bool Issues::take(const Code& code) {
  ++counts_[static_cast<std::size_t>(code.severity)];
  truncated_ = truncated_ || list_.size() >= max_kept_;
  return list_.size() < max_kept_;
}

void Issues::add(const Code& code, const Place& place, std::initializer_list<std::string> arguments) {
  if (!take(code)) return;
  list_.push_back({code.name, code.severity, place.pointer(), {}, sentence(code.message, arguments)});
}

void Issues::add(const Code& code, std::string pointer, std::initializer_list<std::string> arguments) {
  if (!take(code)) return;
  list_.push_back({code.name, code.severity, std::move(pointer), {}, sentence(code.message, arguments)});
}

void Issues::add_at(std::uint64_t offset, const Code& code, std::initializer_list<std::string> arguments) {
  if (!take(code)) return;
  list_.push_back({code.name, code.severity, {}, offset, sentence(code.message, arguments)});
}

std::string shown(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-infinity" : "infinity";
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxBytes = 80;
  return '"' + gltf::one_line(text, kMaxBytes) + '"';
}

}  // namespace barrido::scene::validation
