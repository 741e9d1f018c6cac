// The names of attributes: which there are, how they are numbered (glTF 2.0, section 3.7.2.1).
#pragma once

#include <cstddef>
#include <string_view>

#include "pipeline/validate/issues.h"
#include "pipeline/validate/json_text.h"

namespace barrido::scene::validation {

/// "TEXCOORD" of "TEXCOORD_1"; the name itself where there is no underscore.
std::string_view semantic_of(std::string_view name);

/// How many sets of numbered attributes a primitive has. 0 where they are not numbered as they must be.
struct AttributeSets {
  std::size_t colors = 0;
  std::size_t joints = 0;  ///< 0 as well unless there are as many of weights.
  std::size_t texcoords = 0;
};

void check_attribute_names(Issues& issues, const Json& attributes, const Place& place);
void check_target_names(Issues& issues, const Json& target, const Place& place);
AttributeSets count_attribute_sets(const Json& attributes);

/// Elements of an array of the object; 0 where there is none.
std::size_t count_of(const Json& object, const char* array);

}  // namespace barrido::scene::validation
