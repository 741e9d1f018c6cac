// Findings into lists and sentences.
#include "pipeline/validate/issues.h"

namespace barrido::scene::validation {
namespace {

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

bool Issues::take(const Code& code) {
  ++counts_[static_cast<std::size_t>(code.severity)];
  truncated_ = truncated_ || list_.size() >= max_kept_;
  return list_.size() < max_kept_;
}

void Issues::add(const Code& code, const Place& place, std::initializer_list<std::string> arguments) {
  if (!take(code)) return;
  std::string pointer = place.pointer();
  if (pointer.empty()) pointer.push_back('/');
  list_.push_back({code.name, code.severity, std::move(pointer), {}, sentence(code.message, arguments)});
}

void Issues::add(const Code& code, std::string pointer, std::initializer_list<std::string> arguments) {
  if (!take(code)) return;
  list_.push_back({code.name, code.severity, std::move(pointer), {}, sentence(code.message, arguments)});
}

void Issues::add_at(std::uint64_t offset, const Code& code, std::initializer_list<std::string> arguments) {
  if (!take(code)) return;
  list_.push_back({code.name, code.severity, {}, offset, sentence(code.message, arguments)});
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxBytes = 80;
  return '"' + gltf::one_line(text, kMaxBytes) + '"';
}

}  // namespace barrido::scene::validation
