// Views within their buffers, accessors within their views.
#include "pipeline/validate/link.h"

namespace barrido::scene::validation {
namespace {

void link_view(Link& link, std::size_t index, const Place& place) {
  const BufferView& view = link.model.views[index];
  if (view.buffer == kNone || !link.model.buffers[view.buffer].byte_length) return;
  const std::uint64_t bytes = *link.model.buffers[view.buffer].byte_length;
  const bool begins_outside = view.offset >= bytes;
  if (!begins_outside && view.length <= bytes - view.offset) return;
  link.issues.add(kBufferViewTooLong, Place(place, begins_outside ? "byteOffset" : "byteLength"),
                  {std::to_string(view.buffer), std::to_string(bytes)});
}

/// Whether `length` bytes from `offset` on lie in the view, where the components begin at their multiples.
void check_range(Link& link, std::size_t view_index, std::uint64_t offset, std::uint64_t length,
                 std::size_t component, const Place& place) {
  const BufferView& view = link.model.views[view_index];
  const std::string bytes = std::to_string(component);
  if (offset % component != 0) {
    link.issues.add(kAccessorOffsetAlignment, Place(place, "byteOffset"), {std::to_string(offset), bytes});
  }
  if ((view.offset % component + offset % component) % component != 0) {
    link.issues.add(kAccessorTotalOffsetAlignment, place, {std::to_string(view.offset + offset), bytes});
  }
  const bool begins_outside = offset > view.length;
  if (!begins_outside && length <= view.length - offset) return;
  link.issues.add(kAccessorTooLong, begins_outside ? Place(place, "byteOffset") : place,
                  {std::to_string(length), std::to_string(offset), std::to_string(view_index),
                   std::to_string(view.length)});
}

/// stride × (count − 1) + element, or the largest number where that overflows.
std::uint64_t total_bytes(std::uint64_t stride, std::uint64_t count, std::uint64_t element) {
  if (count - 1 > (UINT64_MAX - element) / stride) return UINT64_MAX;
  return stride * (count - 1) + element;
}

void link_sparse_part(Link& link, std::size_t view, std::uint64_t offset, std::uint64_t element,
                      std::size_t component, std::uint64_t count, const Place& place) {
  if (view == kNone) return;
  const Place view_place(place, "bufferView");
  link.use_view(view, ViewUsage::other, view_place);
  if (link.model.views[view].stride != 0) link.issues.add(kBufferViewInvalidByteStride, view_place);
  if (component != 0) {
    check_range(link, view, offset, total_bytes(element, count, element), component, place);
  }
}

void link_accessor(Link& link, std::size_t index, const Place& place) {
  const Accessor& accessor = link.model.accessors[index];
  if (!accessor.is_complete()) return;
  const std::size_t component = component_bytes(accessor.component_type);
  if (accessor.view != kNone) {
    const std::uint64_t stride = link.model.stride_of(accessor);
    if (stride < accessor.element_bytes()) {
      link.issues.add(kAccessorSmallByteStride, place,
                      {std::to_string(stride), std::to_string(accessor.element_bytes())});
    }
    check_range(link, accessor.view, accessor.offset,
                total_bytes(stride, accessor.count, accessor.element_bytes()), component, place);
  }
  if (!accessor.sparse) return;
  const Sparse& sparse = *accessor.sparse;
  const Place sparse_place(place, "sparse");
  if (sparse.count > accessor.count) {
    link.issues.add(kAccessorSparseCountOutOfRange, Place(sparse_place, "count"),
                    {std::to_string(sparse.count), std::to_string(accessor.count)});
  }
  const std::size_t index_bytes = component_bytes(sparse.index_type);
  link_sparse_part(link, sparse.index_view, sparse.index_offset, index_bytes, index_bytes, sparse.count,
                   Place(sparse_place, "indices"));
  link_sparse_part(link, sparse.value_view, sparse.value_offset, component * accessor.components(), component,
                   sparse.count, Place(sparse_place, "values"));
}

}  // namespace

void link_accessors(Link& link) {
  const Place root, views_place(root, "bufferViews"), accessors_place(root, "accessors");
  for (std::size_t i = 0; i < link.model.views.size(); ++i) link_view(link, i, Place(views_place, i));
  for (std::size_t i = 0; i < link.model.accessors.size(); ++i)
    link_accessor(link, i, Place(accessors_place, i));
}

void link_images(Link& link) {
  const Json& images = link.array("images");
  const Place root, images_place(root, "images");
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (!images[i].is_object()) continue;
    const std::size_t view = index_of(images[i], "bufferView", link.model.views.size());
    if (view == kNone) continue;
    const Place place(images_place, i), view_place(place, "bufferView");
    link.use_view(view, ViewUsage::image, view_place);
    if (link.model.views[view].stride != 0) link.issues.add(kImageBufferViewWithByteStride, view_place);
  }
}

}  // namespace barrido::scene::validation
