// From a path to a checked document. tinygltf is given the JSON without its "buffers" and "images": so it
// opens no file, decodes no URI and copies no buffer; bytes are read here and viewed in place (a GLB's binary
// chunk stays where the file was read to).
#include "pipeline/gltf/document.h"

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/gltf/accessor.h"
#include "pipeline/gltf/check.h"
#include "pipeline/gltf/compressed_views.h"
#include "pipeline/gltf/draco_primitives.h"
#include "pipeline/gltf/forgive.h"
#include "pipeline/gltf/json_values.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

/// The reason in a parser's message, without the library's own label.
std::string parse_problem(const std::string& what) {
  const std::size_t label_end = what.starts_with("[json.exception.") ? what.find("] ") : std::string::npos;
  std::string problem = label_end == std::string::npos ? what : what.substr(label_end + 2);
  problem.erase(problem.find_last_not_of(" \r\n.") + 1);
  return one_line(problem, 200);
}

/// What the text will become: it is parsed twice, and written once in between; every object is then one of
/// tinygltf's and of the scene's, which are large, however empty.
void take_for_json(const Report& report, const JsonShape& shape, std::size_t text_bytes, Budget& budget) {
  constexpr std::uint64_t kOfAValue = 64, kOfAnObject = 1536;
  budget.take(3 * text_bytes + kOfAValue * shape.values + kOfAnObject * shape.objects, report.file(), "JSON");
}

/// Whether arrays of glTF 2.0 are objects with names in them, as all are in glTF 1.0, where files need no
/// asset.
bool looks_like_version_1(const json& document) {
  for (const char* name : {"accessors", "buffers", "bufferViews", "materials", "meshes", "nodes", "scenes"}) {
    const auto found = document.find(name);
    if (found != document.end() && found->is_object()) return true;
  }
  return false;
}

/// "2.0" … "2.9": a version is readable when its major number is 2 and its minVersion is at most 2.0 (glTF
/// 2.0, section 3.2). Looked at before anything else: of another version, other things are missing.
void check_version(const Report& report, const json& document) {
  if (!document.is_object()) return;
  const auto asset = document.find("asset");
  const auto text = [&](const char* name) {
    if (asset == document.end() || !asset->is_object()) return std::string();
    const auto found = asset->find(name);
    return found != asset->end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const std::string version = text("version");
  if (!version.empty() && !version.starts_with("2.")) {
    report.fail("asset.version", "glTF " + one_line(version, 20) + " is not supported; only 2.x is");
  }
  if (version.empty() && looks_like_version_1(document)) {
    report.fail("", "looks like glTF 1.0, which is not supported; only 2.x is");
  }
  const std::string least = text("minVersion");
  if (!least.empty() && least != "2.0") {
    report.fail("asset.minVersion", "glTF " + one_line(least, 20) + " is not supported");
  }
}

/// What an object's type asks for beside it (glTF 2.0, section 5.12; KHR_lights_punctual).
void check_kinds(const Report& report, const json& document) {
  const auto check = [&](const json& array, const std::string& place, const char* kind) {
    for (std::size_t i = 0; i < array.size(); ++i) {
      if (array[i]["type"] == kind && !array[i].contains(kind)) {
        report.fail(element(place, i) + '.' + kind, "is missing");
      }
    }
  };
  if (const auto cameras = document.find("cameras"); cameras != document.end()) {
    check(*cameras, "cameras", "perspective");
    check(*cameras, "cameras", "orthographic");
  }
  static const json::json_pointer kLights("/extensions/KHR_lights_punctual/lights");
  if (document.contains(kLights)) check(document[kLights], "extensions.KHR_lights_punctual.lights", "spot");
}

std::unique_ptr<json> parse_json(Report& report, std::string_view text, const ImportOptions& options) {
  const JsonShape shape = check_json_depth(report, text, options.max_json_depth);
  take_for_json(report, shape, text.size(), *options.budget);
  try {
    auto document = std::make_unique<json>(json::parse(text.begin(), text.end()));
    check_version(report, *document);
    forgive_small_sins(report, *document);
    check_document(report, *document);
    check_kinds(report, *document);
    constexpr std::uint64_t kOfAMaterial = 2560;  // More than of any other object
    const auto materials = document->find("materials");
    if (materials != document->end()) {
      options.budget->take(kOfAMaterial * materials->size(), report.file(), "materials");
    }
    return document;
  } catch (const json::exception& error) {
    report.fail("JSON", parse_problem(error.what()));
  }
}

/// The file's name as it is shown; a data URI's contents are of no use to a reader.
std::string shown_uri(const std::string& uri) {
  return is_data_uri(uri) ? std::string("data URI") : one_line(uri, 80);
}

Content read_uri(const std::filesystem::path& folder, const std::string& uri, const ImportOptions& options,
                 Budget::Kind kind) {
  if (is_data_uri(uri)) return decode_data_uri(uri);  // Smaller than the text, which has been put down.
  if (options.from_standard_input) return {{}, "a model from standard input has no folder to read it from"};
  const ResolvedPath resolved = resolve_uri(folder, uri);
  if (!resolved.problem.empty()) return {{}, resolved.problem};
  return read_regular_file(resolved.path, options.max_file_bytes, options.budget.get(), kind);
}

/// Which buffers have views. A compressed view's own buffer is only for those who cannot decode it.
std::vector<bool> viewed_buffers(const json& document, std::size_t count) {
  std::vector<bool> viewed(count);
  const auto views = document.find("bufferViews");
  if (views == document.end()) return viewed;
  for (const json& view : *views) {
    const json* compression = compression_of(view);
    const auto buffer = whole_number(compression != nullptr ? *compression : view, "buffer");
    if (buffer && *buffer < count) viewed[static_cast<std::size_t>(*buffer)] = true;
  }
  return viewed;
}

/// tinygltf refuses accessors of indices without a buffer view, which are zeros (glTF 2.0, section 5.1.1):
/// they get one more view, of nothing, until it has read them. Returns whether there is one.
bool give_views_to_indices(json& document) {
  json* views = nullptr;
  const auto meshes = document.find("meshes");
  if (meshes == document.end()) return false;
  for (const json& mesh : *meshes) {
    for (const json& primitive : mesh["primitives"]) {
      const auto indices = primitive.find("indices");
      if (indices == primitive.end()) continue;
      json& accessor = document["accessors"][indices->get<std::size_t>()];
      if (accessor.contains("bufferView")) continue;
      if (views == nullptr) {
        views = &document["bufferViews"];
        views->push_back({{"buffer", 0}, {"byteLength", 1}});
      }
      accessor["bufferView"] = views->size() - 1;
    }
  }
  return views != nullptr;
}

}  // namespace

Document::Document(Report& report, const std::filesystem::path& path, const ImportOptions& options)
    : folder_(path.parent_path()), options_(options) {
  const Content file = options.from_standard_input
                           ? read_standard_input(options.max_file_bytes, options.budget.get())
                           : read_regular_file(path, options.max_file_bytes, options.budget.get());
  if (!file.problem.empty()) report.fail("", file.problem);
  const Container container = split_container(report, file.block.bytes());
  json_ = parse_json(report, container.json, options);
  load_buffers(report, container, file.block);
  parse_model(report);
  view_problems_ = check_views(*this);
  decoded_views_ = decode_compressed_views(report, *this, view_problems_);
  accessor_problems_ = check_accessors(*this, options.max_vertices);
  decoded_accessors_ = decode_draco_primitives(report, *this, accessor_problems_);
}

Document::~Document() = default;

void Document::load_buffers(Report& report, const Container& container, const ByteBlock& file) {
  const auto buffers = json_->find("buffers");
  if (buffers == json_->end()) return;
  buffers_.reserve(buffers->size());
  const std::vector<bool> is_viewed = viewed_buffers(*json_, buffers->size());
  for (std::size_t i = 0; i < buffers->size(); ++i) {
    const json& source = (*buffers)[i];
    std::string place = element("buffers", i);
    Buffer buffer;
    const auto uri = source.find("uri");
    if (uri != source.end()) {
      const auto& text = uri->get_ref<const std::string&>();
      place += " (" + shown_uri(text) + ")";
      Content content = read_uri(folder_, text, options_, Budget::Kind::model);
      if (!content.problem.empty()) {
        if (is_viewed[i]) report.fail(place, content.problem);
        report.warn(place + ": " + content.problem + "; nothing uses it");
        content.block = {};
      }
      buffer.bytes = content.block.bytes();
      buffer.owner = content.block.owner();
    } else if (i == 0 && container.binary_chunk) {
      buffer.bytes = *container.binary_chunk;
      buffer.owner = file.owner();
    }
    buffer.byte_length = source["byteLength"].get<std::uint64_t>();
    if (buffer.owner != nullptr && buffer.byte_length > buffer.bytes.size()) {
      report.fail(place, "byteLength is " + std::to_string(buffer.byte_length) + ", but there are only " +
                             std::to_string(buffer.bytes.size()) + " bytes");
    }
    if (buffer.owner != nullptr) {
      buffer.bytes = buffer.bytes.first(static_cast<std::size_t>(buffer.byte_length));
    }
    buffers_.push_back(std::move(buffer));
  }
  json_->erase("buffers");
}

void Document::parse_model(const Report& report) {
  json images;
  if (const auto found = json_->find("images"); found != json_->end()) images.swap(*found);
  json_->erase("images");
  const bool has_padding_view = give_views_to_indices(*json_);
  const std::string text = json_->dump();
  if (!images.is_null()) (*json_)["images"].swap(images);
  if (text.size() > std::numeric_limits<unsigned int>::max()) report.fail("JSON", "is larger than 4 GB");

  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({nullptr, nullptr, nullptr, nullptr, nullptr});
  std::string errors, warnings;
  const bool parsed = loader.LoadASCIIFromString(&model_, &errors, &warnings, text.data(),
                                                 static_cast<unsigned int>(text.size()), {});
  if (!parsed) report.fail("", parse_problem(errors.empty() ? std::string("cannot be parsed") : errors));
  if (has_padding_view) take_views_from_indices();
}

void Document::take_views_from_indices() {
  const int padding_view = static_cast<int>(model_.bufferViews.size()) - 1;
  for (tinygltf::Accessor& accessor : model_.accessors) {
    if (accessor.bufferView == padding_view) accessor.bufferView = -1;
  }
  model_.bufferViews.pop_back();
  json_->at("bufferViews").erase(json_->at("bufferViews").size() - 1);
  for (json& accessor : json_->at("accessors")) {
    if (accessor.value("bufferView", -1) == padding_view) accessor.erase("bufferView");
  }
}

void Document::warn_of_unused(Report& report) const {
  for (const auto* problems : {&view_problems_, &accessor_problems_}) {
    for (const std::optional<Problem>& problem : *problems) {
      if (problem) report.warn(problem->place + ": " + problem->reason + "; nothing that is drawn uses it");
    }
  }
}

bool Document::has_bytes(int buffer_view) const { return view_owner(buffer_view) != nullptr; }

std::shared_ptr<const void> Document::view_owner(int buffer_view) const {
  const auto decoded = decoded_views_.find(buffer_view);
  if (decoded != decoded_views_.end()) return decoded->second.owner();
  return buffer(model_.bufferViews[static_cast<std::size_t>(buffer_view)].buffer).owner;
}

std::span<const std::uint8_t> Document::view_bytes(int buffer_view) const {
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(buffer_view)];
  const auto decoded = decoded_views_.find(buffer_view);
  if (decoded != decoded_views_.end()) return decoded->second.bytes().first(view.byteLength);
  return buffer(view.buffer).bytes.subspan(view.byteOffset, view.byteLength);
}

const DecodedAccessor* Document::decoded_accessor(int accessor) const {
  const auto found = decoded_accessors_.find(accessor);
  return found == decoded_accessors_.end() ? nullptr : &found->second;
}

std::size_t Document::image_count() const {
  const auto images = json_->find("images");
  return images == json_->end() ? 0 : images->size();
}

EncodedImage Document::read_image(std::size_t index) const {
  const json& source = json_->at("images")[index];
  EncodedImage image;
  image.name = source.value("name", std::string());
  const auto uri = source.find("uri");
  const auto view = source.find("bufferView");
  if (uri != source.end()) {
    const auto& text = uri->get_ref<const std::string&>();
    if (!is_data_uri(text)) image.name = text;
    Content content = read_uri(folder_, text, options_, Budget::Kind::picture);
    image.problem = content.problem;
    image.bytes = content.block.bytes();
    image.owner = content.block.owner();
  } else if (view != source.end() && view_problem(view->get<int>())) {
    const Problem& problem = *view_problem(view->get<int>());
    image.problem = problem.place + ": " + problem.reason;
  } else if (view != source.end() && has_bytes(view->get<int>())) {
    const int buffer_view = view->get<int>();
    image.bytes = view_bytes(buffer_view);
    image.owner = view_owner(buffer_view);
  } else {
    image.problem = view != source.end() ? "its buffer has no bytes" : "has neither a uri nor a bufferView";
  }
  image.name = image.name.empty() ? element("images", index) : one_line(image.name, 80);
  return image;
}

}  // namespace barrido::scene::gltf
