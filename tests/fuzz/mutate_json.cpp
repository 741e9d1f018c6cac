#include <algorithm>
#include <random>
#include <vector>

#include <nlohmann/json.hpp>

#include "mutators.h"
#include "viewer/compare/text_encoding.h"

namespace barrido::fuzz {
namespace {

using nlohmann::json;
using Random = std::minstd_rand;

/// nlohmann's destructor and dump recurse; deeper documents are left to plain mutation.
constexpr int kMaxDepth = 100;
constexpr std::string_view kBase64Mark = ";base64,";

std::size_t below(Random& random, std::size_t count) { return random() % count; }

int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  for (const char c : text) {
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if (c == ']' || c == '}') --depth;
  }
  return deepest;
}

void collect(json& value, std::vector<json*>& all) {
  all.push_back(&value);
  if (!value.is_structured()) return;
  for (auto& child : value) collect(child, all);
}

std::string mutate_bytes(std::string bytes) {
  const std::size_t size = bytes.size();
  bytes.resize(size + 64);
  bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
  return bytes;
}

std::string decode_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

/// The bytes behind a data URI, or the characters.
std::string mutate_string(const std::string& text) {
  const std::size_t mark = text.find(kBase64Mark);
  if (mark == std::string::npos) return mutate_bytes(text);
  const std::string bytes =
      mutate_bytes(decode_base64(std::string_view(text).substr(mark + kBase64Mark.size())));
  return text.substr(0, mark + kBase64Mark.size()) +
         compare::base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

json mutate_number(const json& number, Random& random) {
  const std::vector<json> edges{-1,    0,   1,    2,     255,        256,        65535,
                                65536, 1e9, 2e9,  -1e38, 4294967295, 2147483648, 1e300,
                                0.5,   1.5, 1e-9, 5123,  5125,       5126,       4611686018427387904};
  if (below(random, 2) == 0) return edges[below(random, edges.size())];
  const double value = number.is_number() ? number.get<double>() : 0.0;
  switch (below(random, 4)) {
    case 0:
      return value + 1;
    case 1:
      return value - 1;
    case 2:
      return static_cast<int>(below(random, 8));
    default:
      return -value;
  }
}

void change_child(json& parent, const std::vector<json*>& all, Random& random) {
  const json& other = *all[below(random, all.size())];
  const bool remove = below(random, 2) == 0;
  if (parent.is_array()) {
    const std::size_t place = below(random, parent.size() + 1);
    if (remove && place < parent.size()) {
      parent.erase(place);
    } else {
      parent.push_back(parent.empty() || below(random, 2) == 0 ? json(other)
                                                               : json(parent[place % parent.size()]));
    }
    return;
  }
  if (remove && !parent.empty()) {
    parent.erase(std::next(parent.begin(), static_cast<std::ptrdiff_t>(below(random, parent.size()))));
  } else if (other.is_object() && !other.empty()) {
    const auto member = std::next(other.begin(), static_cast<std::ptrdiff_t>(below(random, other.size())));
    const std::string key = member.key();
    json value = member.value();
    parent[key] = std::move(value);
  } else {
    parent[mutate_bytes("KHR_")] = json(other);
  }
}

void change_once(json& document, Random& random) {
  std::vector<json*> all;
  collect(document, all);
  json& chosen = *all[below(random, all.size())];
  if (below(random, 8) == 0) {
    const json other = *all[below(random, all.size())];
    chosen = other;
  } else if (chosen.is_structured()) {
    change_child(chosen, all, random);
  } else if (chosen.is_string()) {
    chosen = mutate_string(chosen.get<std::string>());
  } else {
    chosen = mutate_number(chosen, random);
  }
}

}  // namespace

std::string mutate_json_text(const std::string& text, unsigned seed) {
  if (depth_of(text) > kMaxDepth) return text;
  json document = json::parse(text, nullptr, false);
  if (document.is_discarded()) return text;
  Random random(seed);
  for (std::size_t changes = 1 + below(random, 3); changes > 0; --changes) change_once(document, random);
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::size_t mutate_gltf(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string changed = seed % 8 == 0 ? text : mutate_json_text(text, seed);
  if (changed == text || changed.size() > capacity) return LLVMFuzzerMutate(data, size, capacity);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}

}  // namespace barrido::fuzz
