// What a URI means, what a buffer holds, what an image is.
#include "pipeline/validate/resources.h"

#include <algorithm>
#include <optional>

namespace barrido::scene::validation {
namespace {

/// The media type of a data URI, in lower case; text/plain where it names none (RFC 2397).
std::string media_type(std::string_view uri) {
  uri.remove_prefix(std::string_view("data:").size());
  std::string type(uri.substr(0, uri.find_first_of(";,")));
  std::transform(type.begin(), type.end(), type.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return type.empty() ? "text/plain" : type;
}

/// What stands before a colon in the first segment of a URI's path; nothing where there is none.
std::optional<std::string_view> scheme_of(std::string_view uri) {
  const std::size_t end = uri.find_first_of(":/?#");
  if (end == std::string_view::npos || uri[end] != ':') return {};
  return uri.substr(0, end);
}

/// RFC 3986, section 3.1.
bool is_scheme(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  });
}

/// Reports a URI that is broken or has a scheme, a host, an absolute path, a query or a fragment (RFC 3986,
/// section 4.2).
bool is_relative(Issues& issues, const std::string& uri, const Place& place) {
  const auto scheme = scheme_of(uri);
  if (scheme && !is_scheme(*scheme)) {
    issues.add(kInvalidUri, place, {in_quotes(*scheme) + " before the colon is no scheme"});
    return false;
  }
  if (!scheme && uri.find_first_of("?#") == std::string::npos && !uri.starts_with('/')) return true;
  issues.add(kNonRelativeUri, place, {in_quotes(uri)});
  return false;
}

/// Whether what stands before the comma of a data URI is a media type, parameters of the form name=value, and
/// at most one "base64", at the end (RFC 2397, section 3).
bool has_right_header(std::string_view uri) {
  std::string_view header = uri.substr(0, uri.find(','));
  header.remove_prefix(std::string_view("data:").size());
  if (header.ends_with(";base64")) header.remove_suffix(std::string_view(";base64").size());
  std::size_t semicolon = header.find(';');
  while (semicolon != std::string_view::npos) {
    header.remove_prefix(semicolon + 1);
    semicolon = header.find(';');
    const std::string_view parameter = header.substr(0, semicolon);
    if (parameter.find('=') == std::string_view::npos || parameter.starts_with('=')) return false;
  }
  return true;
}

bool is_power_of_two(std::uint32_t number) { return number != 0 && (number & (number - 1)) == 0; }

const std::string* uri_of(const Json& source) {
  const auto found = source.find("uri");
  return found == source.end() ? nullptr : &found->get_ref<const std::string&>();
}

}  // namespace

Resources::Resources(std::filesystem::path folder, const Chunks* chunks,
                     std::shared_ptr<const void> chunks_owner, std::uint64_t max_bytes)
    : folder_(std::move(folder)),
      chunks_(chunks),
      chunks_owner_(std::move(chunks_owner)),
      bytes_left_(max_bytes) {}

gltf::Content Resources::read_data_uri(Link& link, const std::string& uri, const Place& place) const {
  gltf::Content content = gltf::decode_data_uri(uri);
  if (content.problem.empty() && !has_right_header(uri)) content.problem = "a parameter is not name=value";
  if (!content.problem.empty()) {
    link.issues.add(kInvalidUri, place, {content.problem});
  } else if (chunks_ != nullptr) {
    link.issues.add(kDataUriGlb, place);
  }
  return content;
}

gltf::Content Resources::read_file(Link& link, const std::string& uri, const Place& place) {
  gltf::Content content;
  if (!is_relative(link.issues, uri, place)) {
    content.problem = "is not relative";
    return content;
  }
  const gltf::ResolvedPath resolved = gltf::resolve_uri(folder_, uri);
  content.problem = resolved.problem;
  if (content.problem.empty()) {
    if (const auto known = buffer_files_.find(resolved.path); known != buffer_files_.end()) {
      content.block = known->second;
      return content;
    }
    content = gltf::read_regular_file(resolved.path, bytes_left_);
  }
  if (!content.problem.empty()) link.issues.add(kIoError, place, {content.problem});
  return content;
}

void Resources::load_buffers(Link& link) {
  const Json& buffers = link.array("buffers");
  const Place root, buffers_place(root, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    if (buffers[i].is_object()) load_buffer(link, buffers[i], i, Place(buffers_place, i));
  }
}

void Resources::load_buffer(Link& link, const Json& source, std::size_t index, const Place& place) {
  Buffer& buffer = link.model.buffers[index];
  const Place uri_place(place, "uri");
  const std::string* uri = uri_of(source);
  gltf::Content content;
  std::span<const std::uint8_t> bytes;
  std::shared_ptr<const void> owner;
  const bool is_glb_buffer = uri == nullptr && chunks_ != nullptr && index == 0;
  if (uri != nullptr) {
    if (chunks_ != nullptr) link.issues.add(kUriGlb, uri_place);
    if (gltf::is_data_uri(*uri)) {
      content = read_data_uri(link, *uri, uri_place);
      const std::string type = media_type(*uri);
      if (content.problem.empty() && type != "application/octet-stream" &&
          type != "application/gltf-buffer") {
        link.issues.add(kBufferDataUriMimeTypeInvalid, uri_place, {in_quotes(type)});
        return;
      }
    } else if (!buffer.byte_length) {
      is_relative(link.issues, *uri, uri_place);
      return;
    } else {
      content = read_file(link, *uri, uri_place);
      if (!content.problem.empty()) return;
      const auto [file, is_new] =
          buffer_files_.try_emplace(gltf::resolve_uri(folder_, *uri).path, content.block);
      if (is_new) bytes_left_ -= std::min<std::uint64_t>(bytes_left_, content.block.size());
    }
    if (!content.problem.empty()) return;
    bytes = content.block.bytes();
    owner = content.block.owner();
  } else if (is_glb_buffer && buffer.byte_length) {
    if (!chunks_->binary) return link.issues.add(kBufferMissingGlbData, place);
    bytes = *chunks_->binary;
    owner = chunks_owner_;
  }
  if (owner == nullptr || !buffer.byte_length) return;
  if (bytes.size() < *buffer.byte_length) {
    return link.issues.add(kBufferByteLengthMismatch, place,
                           {std::to_string(bytes.size()), std::to_string(*buffer.byte_length)});
  }
  const std::uint64_t padded = (*buffer.byte_length + 3) / 4 * 4;
  if (is_glb_buffer && bytes.size() > padded) {
    link.issues.add(kBufferGlbChunkTooBig, place, {std::to_string(bytes.size() - padded)});
  }
  buffer.bytes = bytes;
  buffer.owner = std::move(owner);
}

void Resources::check_images(Link& link) {
  const Json& images = link.array("images");
  const Place root, images_place(root, "images");
  image_types_.resize(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (images[i].is_object()) check_image(link, images[i], i, Place(images_place, i));
  }
}

void Resources::check_image(Link& link, const Json& source, std::size_t index, const Place& place) {
  const Place uri_place(place, "uri");
  const std::string* uri = uri_of(source);
  if (uri != nullptr && chunks_ != nullptr) link.issues.add(kUriGlb, uri_place);
  ImageProbe probe;
  if (uri != nullptr && gltf::is_data_uri(*uri)) {
    const gltf::Content content = read_data_uri(link, *uri, uri_place);
    if (!content.problem.empty()) return;
    if (detect_mime_type(content.block.bytes()) != media_type(*uri)) {
      return link.issues.add(kInvalidUri, uri_place, {"the data are not " + in_quotes(media_type(*uri))});
    }
    probe = probe_image(content.block.bytes());
  } else if (source.contains("extensions") && !source["extensions"].empty()) {
    return;  // An extension may give the URI another meaning.
  } else if (uri != nullptr) {
    const gltf::ResolvedPath resolved = gltf::resolve_uri(folder_, *uri);
    const auto known = image_files_.find(resolved.path);
    if (resolved.problem.empty() && known != image_files_.end()) {
      probe = known->second;
    } else {
      const gltf::Content content = read_file(link, *uri, uri_place);
      if (!content.problem.empty()) return;
      probe = probe_image(content.block.bytes());
      image_files_.emplace(resolved.path, probe);
    }
  } else {
    const std::size_t view = index_of(source, "bufferView", link.model.views.size());
    if (view == kNone) return;
    const auto bytes = link.model.bytes_of(view, 0, link.model.views[view].length);
    if (bytes.empty()) return;
    probe = probe_image(bytes);
  }
  image_types_[index] = probe.state == ImageProbe::State::fine ? probe.mime_type : std::string_view();
  check_probe(link, source, probe, place);
}

void Resources::check_probe(Link& link, const Json& source, const ImageProbe& probe, const Place& place) {
  if (probe.state == ImageProbe::State::unrecognized) return link.issues.add(kImageUnrecognizedFormat, place);
  if (probe.state == ImageProbe::State::cut_off) return link.issues.add(kImageUnexpectedEos, place);
  if (probe.state == ImageProbe::State::broken)
    return link.issues.add(kImageDataInvalid, place, {probe.problem});
  if (probe.mime_type == "image/webp" && !link.schema.has_extension("EXT_texture_webp")) {
    link.issues.add(kImageNonEnabledMimeType, place, {std::string(probe.mime_type)});
  }
  const std::string declared = source.value("mimeType", std::string(probe.mime_type));
  if (declared != probe.mime_type) {
    link.issues.add(kImageMimeTypeInvalid, Place(place, source.contains("uri") ? "uri" : "bufferView"),
                    {std::string(probe.mime_type), in_quotes(declared)});
  }
  if (!is_power_of_two(probe.width) || !is_power_of_two(probe.height)) {
    link.issues.add(kImageNpotDimensions, place, {std::to_string(probe.width), std::to_string(probe.height)});
  }
}

void Resources::check_textures(Link& link) {
  const Json &textures = link.array("textures"), &images = link.array("images");
  const Place root, textures_place(root, "textures");
  const auto check_source = [&](const Json& object, bool webp, const Place& place) {
    const std::size_t image = index_of(object, "source", images.size());
    if (image == kNone || !images[image].is_object()) return;
    const std::string type = images[image].value("mimeType", std::string(image_types_[image]));
    const bool right = webp ? type == "image/webp" : type == "image/png" || type == "image/jpeg";
    if (type.empty() || right) return;
    link.issues.add(kTextureInvalidImageMimeType, Place(place, "source"),
                    {in_quotes(type), webp ? "image/webp" : "image/jpeg or image/png"});
  };
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (!textures[i].is_object()) continue;
    const Place place(textures_place, i), extensions_place(place, "extensions");
    check_source(textures[i], false, place);
    const Json& extensions = textures[i].contains("extensions") ? textures[i]["extensions"] : textures[i];
    if (!link.schema.has_extension("EXT_texture_webp") || !extensions.contains("EXT_texture_webp")) continue;
    check_source(extensions["EXT_texture_webp"], true, Place(extensions_place, "EXT_texture_webp"));
  }
}

}  // namespace barrido::scene::validation
