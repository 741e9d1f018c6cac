#include "viewer/barrido/info_validate.h"

#include <array>
#include <map>

#include <nlohmann/json.hpp>

#include "viewer/barrido/standard_streams.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

using Json = nlohmann::ordered_json;
using scene::validation::Issue;
using scene::validation::Issues;
using scene::validation::Severity;

constexpr std::array<const char*, 4> kSeverityNames = {"error", "warning", "information", "hint"};

std::string place_of(const Issue& issue) {
  if (issue.offset) return "byte " + std::to_string(*issue.offset);
  return issue.pointer.empty() ? "the file" : issue.pointer;
}

std::string counts_text(const Issues& issues) {
  std::string text = counted(issues.count(Severity::error), "error", "errors") + ", " +
                     counted(issues.count(Severity::warning), "warning", "warnings");
  const std::size_t others = issues.count(Severity::information) + issues.count(Severity::hint);
  if (others > 0) text += ", " + counted(others, "remark", "remarks");
  return text;
}

Json issue_json(const Issue& issue) {
  Json json{{"code", issue.code}, {"message", issue.message}, {"severity", static_cast<int>(issue.severity)}};
  if (issue.offset) {
    json["offset"] = *issue.offset;
  } else {
    json["pointer"] = issue.pointer;
  }
  return json;
}

Json info_of(const scene::ValidationInfo& info) {
  Json json{{"version", info.version}};
  if (!info.min_version.empty()) json["minVersion"] = info.min_version;
  if (!info.generator.empty()) json["generator"] = info.generator;
  if (!info.extensions_used.empty()) json["extensionsUsed"] = info.extensions_used;
  if (!info.extensions_required.empty()) json["extensionsRequired"] = info.extensions_required;
  json["animationCount"] = info.animations;
  json["materialCount"] = info.materials;
  json["hasMorphTargets"] = info.has_morph_targets;
  json["hasSkins"] = info.has_skins;
  json["hasTextures"] = info.has_textures;
  json["hasDefaultScene"] = info.has_default_scene;
  json["drawCallCount"] = info.draw_calls;
  json["totalVertexCount"] = info.vertices;
  json["totalTriangleCount"] = info.triangles;
  json["maxUVs"] = info.max_uvs;
  json["maxInfluences"] = info.max_influences;
  json["maxAttributes"] = info.max_attributes;
  return json;
}

}  // namespace

std::string validation_text(const scene::ValidationReport& report, const DrawingVerdict& verdict) {
  std::string text = on_one_line(report.file) + ": " + counts_text(report.issues) + "\n";
  // The same fault of many numbers is one line, at the place of the first.
  std::map<std::pair<std::string_view, std::string>, std::size_t> repeats;
  for (const Issue& issue : report.issues.list()) ++repeats[{issue.code, place_of(issue)}];
  for (const Severity severity :
       {Severity::error, Severity::warning, Severity::information, Severity::hint}) {
    for (const Issue& issue : report.issues.list()) {
      if (issue.severity != severity) continue;
      std::size_t& count = repeats[{issue.code, place_of(issue)}];
      if (count == 0) continue;
      text += "  " + left(kSeverityNames[static_cast<std::size_t>(severity)], 13) + std::string(issue.code) +
              " " + on_one_line(place_of(issue) + ": " + issue.message);
      if (count > 1) text += " (and " + grouped(count - 1) + " more)";
      text += "\n";
      count = 0;
    }
  }
  if (report.issues.truncated()) text += "  ... more findings are counted above and not shown\n";
  return text + (verdict.drawn ? "barrido render draws it\n"
                               : "barrido render refuses it: " + on_one_line(verdict.reason) + "\n");
}

std::string validation_json(const scene::ValidationReport& report, const DrawingVerdict& verdict) {
  Json messages = Json::array();
  for (const Issue& issue : report.issues.list()) messages.push_back(issue_json(issue));
  Json json{{"uri", report.file},
            {"mimeType", report.is_glb ? "model/gltf-binary" : "model/gltf+json"},
            {"validatorVersion", "barrido " BARRIDO_VERSION}};
  json["issues"] = {{"numErrors", report.issues.count(Severity::error)},
                    {"numWarnings", report.issues.count(Severity::warning)},
                    {"numInfos", report.issues.count(Severity::information)},
                    {"numHints", report.issues.count(Severity::hint)},
                    {"messages", std::move(messages)},
                    {"truncated", report.issues.truncated()}};
  if (report.info) json["info"] = info_of(*report.info);
  json["render"] = {{"drawn", verdict.drawn}};
  if (!verdict.drawn) json["render"]["reason"] = verdict.reason;
  // Names in a file need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace barrido::cli
