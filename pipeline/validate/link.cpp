// What serves for what.
#include "pipeline/validate/link.h"

#include <algorithm>

namespace barrido::scene::validation {
namespace {

constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

std::string name_of(ViewUsage usage) {
  constexpr const char* kNames[] = {"nothing",  "vertices",  "indices", "inverse bind matrices",
                                    "an image", "other data"};
  return kNames[static_cast<std::size_t>(usage)];
}

std::string name_of(AccessorUsage usage) {
  constexpr const char* kNames[] = {"nothing",         "a vertex attribute",
                                    "indices",         "inverse bind matrices",
                                    "animation input", "animation output"};
  return kNames[static_cast<std::size_t>(usage)];
}

}  // namespace

Link::Link(SchemaWalk& walk, const JsonText& checked, Budget& steps)
    : issues(walk.issues()),
      references(walk.references()),
      materials(walk.materials()),
      schema(walk),
      document(checked.document),
      attribute_names(checked.attribute_names),
      model(checked.document),
      budget(steps),
      view_usages(model.views.size()),
      accessor_usages(model.accessors.size()) {
  for (std::size_t i = 0; i < model.views.size(); ++i) {
    if (model.views[i].target == kArrayBuffer) view_usages[i] = ViewUsage::vertices;
    if (model.views[i].target == kElementArrayBuffer) view_usages[i] = ViewUsage::indices;
  }
}

void Link::use_view(std::size_t view, ViewUsage usage, const Place& place) {
  if (view == kNone) return;
  ViewUsage& before = view_usages[view];
  if (before == ViewUsage::none) {
    before = usage;
    if (usage == ViewUsage::vertices || usage == ViewUsage::indices)
      issues.add(kBufferViewTargetMissing, place);
  } else if (before != usage) {
    issues.add(kBufferViewTargetOverride, place, {name_of(before), name_of(usage)});
  }
}

void Link::use_accessor(std::size_t accessor, AccessorUsage usage, const Place& place) {
  AccessorUsage& before = accessor_usages[accessor];
  if (before == AccessorUsage::none) {
    before = usage;
  } else if (before != usage) {
    issues.add(kAccessorUsageOverride, place, {name_of(before), name_of(usage)});
  }
}

bool is_one_of(const Accessor& accessor, std::span<const Format> formats) {
  return std::any_of(formats.begin(), formats.end(), [&](const Format& format) {
    return accessor.type != nullptr && accessor.type->name == format.type &&
           accessor.component_type == format.component_type && accessor.normalized == format.normalized;
  });
}

std::string list_of(std::span<const Format> formats) {
  std::string text;
  for (const Format& format : formats) {
    text += (text.empty() ? "{" : " or {") + std::string(format.type) + ", " +
            (format.normalized ? "normalized " : "") + std::string(name_of_component(format.component_type)) +
            "}";
  }
  return text;
}

}  // namespace barrido::scene::validation
