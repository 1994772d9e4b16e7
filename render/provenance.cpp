// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "provenance.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace planescope::draw {
namespace {

using Json = nlohmann::ordered_json;

Json layer_names(Layer layers) {
  static constexpr std::array<std::pair<const char*, Layer>, 5> kNames = {
      {{"scene", Layer::Scene},
       {"patches", Layer::Patches},
       {"segments", Layer::Segments},
       {"planes", Layer::Planes},
       {"graph", Layer::Graph}}};
  Json names = Json::array();
  for (const auto& [text, layer] : kNames)
    if (has(layers, layer)) names.push_back(text);
  return names;
}

Json drawing_json(const RenderOptions& options, Layer layers) {
  return {{"layers", layer_names(layers)},
          {"color_by", name(options.color_by)},
          {"palette", name(options.palette)},
          {"size", {options.size[0], options.size[1]}},
          {"supersample", options.supersample},
          {"background", {options.background[0], options.background[1], options.background[2]}},
          {"transparent", options.transparent},
          {"eye_dome_lighting", options.eye_dome_lighting},
          {"cull_front", options.cull_front},
          {"cutaway", options.cutaway},
          {"point_size", options.point_size},
          {"legend", options.annotation.legend},
          {"labels", options.annotation.labels},
          {"scale_bar", options.annotation.scale_bar},
          {"axes", options.annotation.axes}};
}

}  // namespace

const char* name(ColorBy by) {
  static constexpr std::array kNames = {"layers",    "segment", "plane", "patch", "normal",
                                        "curvature", "truth",   "rgb",   "height"};
  return kNames[static_cast<std::size_t>(by)];
}

const char* name(Palette palette) {
  static constexpr std::array kNames = {"standard", "vivid", "pastel", "grey"};
  return kNames[static_cast<std::size_t>(palette)];
}

Camera in_world(Camera camera, const SceneData& scene) {
  camera.position += scene.result.cloud.origin;
  camera.focal += scene.result.cloud.origin;
  return camera;
}

PngNotes provenance(const SceneData& scene, const RenderOptions& options, Layer layers,
                    const Camera& camera) {
  PngNotes notes;
  notes.dpi = options.dpi;
  const auto add = [&](const char* keyword, const std::string& text) {
    if (!text.empty()) notes.texts.emplace_back(keyword, text);
  };
  add("Title", options.annotation.title);
  add("Software", "planescope " PLANESCOPE_VERSION ", VTK " + vtk_version());
  const Result& result = scene.result;
  add("Source", result.input_name + (result.input_hash.empty() ? "" : " " + result.input_hash));
  add("planescope:options", result.options_hash);
  add("planescope:camera", camera_json(camera));
  add("planescope:drawing", drawing_json(options, layers).dump());
  return notes;
}

}  // namespace planescope::draw
