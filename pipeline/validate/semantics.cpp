// Names are cut at underscores and numbers are read by hand: "TEXCOORD_01" is not TEXCOORD_1.
#include "pipeline/validate/semantics.h"

#include <algorithm>
#include <array>
#include <optional>

namespace barrido::scene::validation {
namespace {

constexpr std::array<std::string_view, 4> kNumbered = {"COLOR", "JOINTS", "TEXCOORD", "WEIGHTS"};
enum Numbered : std::size_t { kColor, kJoints, kTexcoord, kWeights };

struct SemanticNumber {
  std::size_t semantic;  ///< In kNumbered.
  std::size_t number;
};

std::optional<SemanticNumber> numbered_semantic(std::string_view name) {
  constexpr std::size_t kMaxDigits = 9;
  const std::size_t underscore = name.find('_');
  if (underscore == std::string_view::npos) return {};
  const auto found = std::find(kNumbered.begin(), kNumbered.end(), name.substr(0, underscore));
  const std::string_view digits = name.substr(underscore + 1);
  if (found == kNumbered.end() || digits.empty() || digits.size() > kMaxDigits) return {};
  if (digits.size() > 1 && digits[0] == '0') return {};
  std::size_t number = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return {};
    number = 10 * number + static_cast<std::size_t>(c - '0');
  }
  return SemanticNumber{static_cast<std::size_t>(found - kNumbered.begin()), number};
}

bool is_plain_semantic(std::string_view name) {
  return name == "POSITION" || name == "NORMAL" || name == "TANGENT";
}

struct Sets {
  std::array<std::size_t, kNumbered.size()> count{};
  std::array<std::size_t, kNumbered.size()> expected{};
};

Sets count_sets(const Json& attributes) {
  Sets sets;
  for (const auto& [name, unused] : attributes.items()) {
    const auto numbered = numbered_semantic(name);
    if (!numbered) continue;
    ++sets.count[numbered->semantic];
    std::size_t& expected = sets.expected[numbered->semantic];
    expected = std::max(expected, numbered->number + 1);
  }
  return sets;
}

std::size_t continuous(const Sets& sets, std::size_t semantic) {
  return sets.count[semantic] == sets.expected[semantic] ? sets.count[semantic] : 0;
}

}  // namespace

std::string_view semantic_of(std::string_view name) { return name.substr(0, name.find('_')); }

void check_attribute_names(Issues& issues, const Json& attributes, const Place& place) {
  for (const auto& [name, unused] : attributes.items()) {
    if (name.starts_with('_') || is_plain_semantic(name) || numbered_semantic(name)) continue;
    issues.add(kMeshPrimitiveInvalidAttribute, Place(place, name));
  }
  if (!attributes.contains("POSITION")) issues.add(kMeshPrimitiveNoPosition, place);
  if (attributes.contains("TANGENT") && !attributes.contains("NORMAL")) {
    issues.add(kMeshPrimitiveTangentWithoutNormal, Place(place, "TANGENT"));
  }
  const Sets sets = count_sets(attributes);
  for (std::size_t i = 0; i < kNumbered.size(); ++i) {
    if (sets.count[i] == sets.expected[i]) continue;
    issues.add(kMeshPrimitiveIndexedSemanticContinuity, place,
               {std::string(kNumbered[i]), std::to_string(sets.expected[i]), std::to_string(sets.count[i])});
  }
  const std::size_t joints = continuous(sets, kJoints), weights = continuous(sets, kWeights);
  if (joints != weights) {
    issues.add(kMeshPrimitiveJointsWeightsMismatch, place, {std::to_string(joints), std::to_string(weights)});
  }
}

void check_target_names(Issues& issues, const Json& target, const Place& place) {
  for (const auto& [name, unused] : target.items()) {
    if (name.starts_with('_') || is_plain_semantic(name)) continue;
    const auto numbered = numbered_semantic(name);
    if (numbered && (numbered->semantic == kColor || numbered->semantic == kTexcoord)) continue;
    issues.add(kMeshPrimitiveInvalidAttribute, Place(place, name));
  }
}

AttributeSets count_attribute_sets(const Json& attributes) {
  const Sets sets = count_sets(attributes);
  const std::size_t joints = continuous(sets, kJoints);
  return {continuous(sets, kColor), joints == continuous(sets, kWeights) ? joints : 0,
          continuous(sets, kTexcoord)};
}

std::size_t count_of(const Json& object, const char* array) {
  const auto found = object.find(array);
  return found == object.end() ? 0 : found->size();
}

}  // namespace barrido::scene::validation
