// nlohmann's parser does the syntax and UTF-8; it takes no number above the largest double, though, where
// glTF's validator goes on and says which property is out of range. Such numbers are written anew before it
// sees them.
#include "pipeline/validate/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "pipeline/files/error.h"
#include "pipeline/gltf/container.h"

namespace barrido::scene::validation {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::string_view kLargest = "1.7976931348623157e308";

bool is_number_character(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == 'e' || c == 'E' || c == '+' || c == '-';
}

/// Whether the number is above the largest double; from_chars alone does not tell this from one near 0.
bool overflows(std::string_view number) {
  constexpr std::size_t kManyDigits = 300;
  const std::size_t exponent = number.find_first_of("eE");
  if (exponent == std::string_view::npos && std::min(number.find('.'), number.size()) < kManyDigits)
    return false;
  if (exponent != std::string_view::npos && number.substr(exponent + 1).starts_with('-')) return false;
  double value = 0;
  return std::from_chars(number.data(), number.data() + number.size(), value).ec ==
         std::errc::result_out_of_range;
}

/// The text with the largest double in place of every number above it; empty where there is none.
std::string with_finite_numbers(std::string_view text) {
  std::string result;
  std::size_t copied = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (in_string || !is_number_character(c)) {
      if (in_string && c == '\\') ++i;  // Whatever is escaped, it does not end the string.
      if (c == '"') in_string = !in_string;
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_number_character(text[end])) ++end;
    if (overflows(text.substr(i, end - i))) {
      result += text.substr(copied, i - copied);
      if (c == '-') result += '-';
      result += kLargest;
      copied = end;
    }
    i = end;
  }
  if (copied != 0) result += text.substr(copied);
  return result;
}

/// How many values there may be at most: each but the first follows a comma or opens what holds it.
std::size_t count_values(std::string_view text) {
  std::size_t count = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == ',' || c == '[' || c == '{')) {
      ++count;
    }
  }
  return count;
}

/// Looks for names that come twice in an object, and keeps the order of attributes: told value after value,
/// it builds nothing else.
class NameWatch : public nlohmann::json_sax<Json> {
 public:
  NameWatch(Issues& issues, NamesInOrder& attribute_names)
      : issues_(issues), attribute_names_(attribute_names) {}

  bool null() override { return count_item(); }
  bool boolean(bool) override { return count_item(); }
  bool number_integer(std::int64_t) override { return count_item(); }
  bool number_unsigned(std::uint64_t) override { return count_item(); }
  bool number_float(double, const std::string&) override { return count_item(); }
  bool string(std::string&) override { return count_item(); }
  bool binary(Json::binary_t&) override { return count_item(); }
  bool start_object(std::size_t) override { return open(true); }
  bool start_array(std::size_t) override { return open(false); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    Level& level = levels_.back();
    level.name = name;
    if (!level.names.insert(name).second) {
      issues_.add(kDuplicateElements, pointer(levels_.size()), {in_quotes(name)});
    } else if (holds_attributes()) {
      attribute_names_[pointer(levels_.size() - 1)].push_back(name);
    }
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

 private:
  struct Level {
    bool is_object;
    std::set<std::string> names;
    std::string name;
    std::size_t items;
  };

  bool count_item() {
    if (!levels_.empty()) ++levels_.back().items;
    return true;
  }
  bool open(bool is_object) {
    count_item();
    levels_.push_back({is_object, {}, {}, 0});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  bool holds_attributes() const {
    const std::size_t depth = levels_.size();
    return (depth > 1 && levels_[depth - 2].name == "attributes") ||
           (depth > 2 && levels_[depth - 3].name == "targets");
  }

  std::string pointer(std::size_t depth) const { return pointer_of(depth, Place()); }
  std::string pointer_of(std::size_t depth, const Place& place, std::size_t at = 0) const {
    if (at == depth) return place.pointer();
    const Level& level = levels_[at];
    return pointer_of(depth, level.is_object ? Place(place, level.name) : Place(place, level.items - 1),
                      at + 1);
  }

  Issues& issues_;
  NamesInOrder& attribute_names_;
  std::vector<Level> levels_;
};

/// The reason in the library's message, without its label.
std::string parse_problem(std::string what) {
  if (what.starts_with("[json.exception.")) what.erase(0, std::min(what.find("] ") + 2, what.size()));
  return in_quotes(what);
}

/// Twice over the text: the library's way to watch while it builds looks through every array again for each
/// object in it.
JsonText parse(Issues& issues, std::string_view text) {
  JsonText result{Json::parse(text.begin(), text.end()), {}};
  NameWatch watch(issues, result.attribute_names);
  Json::sax_parse(text.begin(), text.end(), &watch);
  return result;
}

}  // namespace

std::optional<JsonText> parse_json_text(Issues& issues, std::string_view text, int max_depth,
                                        std::size_t max_values) {
  if (text.starts_with(kByteOrderMark)) {
    issues.add(kInvalidJson, "", {"it begins with a byte order mark"});
    text.remove_prefix(kByteOrderMark.size());
  }
  if (count_values(text) > max_values) {
    issues.add(kInvalidJson, "", {"more than " + std::to_string(max_values) + " values are not read"});
    return {};
  }
  try {
    gltf::check_json_depth(gltf::Report("JSON"), text, max_depth);
    const std::string rewritten = with_finite_numbers(text);
    return parse(issues, rewritten.empty() ? text : rewritten);
  } catch (const Json::exception& error) {
    issues.add(kInvalidJson, "", {parse_problem(error.what())});
  } catch (const InputError& error) {
    issues.add(kInvalidJson, "", {error.what()});
  }
  return {};
}

bool is_infinite(double value) { return std::abs(value) >= std::numeric_limits<double>::max(); }

}  // namespace barrido::scene::validation
