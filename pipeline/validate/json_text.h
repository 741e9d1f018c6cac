// The text of a glTF file into a JSON document, with what glTF asks of the text itself: UTF-8 without a byte
// order mark, names used once in an object, syntax. Knows nothing of what the document means.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/validate/issues.h"

namespace barrido::scene::validation {

using Json = nlohmann::json;

/// Names of an object in the order of the text, by the object's JSON pointer.
using NamesInOrder = std::map<std::string, std::vector<std::string>>;

struct JsonText {
  Json document;                 ///< Objects sorted by name.
  NamesInOrder attribute_names;  ///< Of primitives and their morph targets.
};

/// Numbers too large for a double are ±the largest double afterwards (see is_infinite). Nothing when the text
/// is no JSON, nests deeper than `max_depth`, or has more than `max_values` values, each of which takes
/// memory.
std::optional<JsonText> parse_json_text(Issues& issues, std::string_view text, int max_depth,
                                        std::size_t max_values);

/// Whether the file wrote a number too large for a double.
bool is_infinite(double value);

}  // namespace barrido::scene::validation
