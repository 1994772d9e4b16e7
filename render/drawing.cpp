// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderStepsPass.h>

#include "depth_shading.hpp"
#include "fit_points.hpp"
#include "planescope/error.hpp"
#include "sensor_noise.hpp"

namespace planescope::draw {
namespace {

constexpr std::size_t kDepthSample = 200'000;
// [pixel] Here all buffers together take about 5 GB.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

vtkSmartPointer<vtkRenderer> make_renderer(Window& window, int layer) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetLayer(layer);
  window.vtk()->AddRenderer(renderer);
  return renderer;
}

void place(vtkRenderer& renderer, const Camera& camera, const double* clipping_range) {
  vtkCamera& active = *renderer.GetActiveCamera();
  active.SetPosition(camera.position.data());
  active.SetFocalPoint(camera.focal.data());
  active.SetViewUp(camera.up.data());
  active.SetViewAngle(camera.view_angle);
  active.SetClippingRange(clipping_range[0], clipping_range[1]);
}

/// Nearest and farthest depth of what is drawn before the camera, with room to spare: both
/// renderers share it, and with it the depth buffer.
std::array<double, 2> depth_range(const PointCloud& cloud, const Camera& camera) {
  const std::size_t step = 1 + cloud.size() / kDepthSample;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 1e-3;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    if (!is_finite(cloud.positions[i])) continue;
    const double depth =
        (cloud.positions[i].cast<double>() - camera.position).dot(camera.forward());
    if (depth > 0) nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  return {std::clamp(0.8 * nearest, 1e-3 * farthest, 0.99 * farthest), 1.5 * farthest};
}

Actors add_all(vtkRenderer& renderer, Actors actors) {
  for (const auto& actor : actors) renderer.AddActor(actor);
  return actors;
}

}  // namespace

void validate(const RenderOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error(Error::Kind::Usage, what); };
  for (const int side : options.size) {
    if (side < 16 || side > 16384)
      refuse("picture size " + std::to_string(options.size[0]) + "x" +
             std::to_string(options.size[1]) + ": each side must be 16 to 16384 pixels");
  }
  if (std::int64_t{options.size[0]} * options.size[1] > kMostPixels)
    refuse("picture size " + std::to_string(options.size[0]) + "x" +
           std::to_string(options.size[1]) +
           ": at most 67108864 pixels in all (8192x8192); ask for less");
  if (options.supersample < 1 || options.supersample > 4)
    refuse("supersample " + std::to_string(options.supersample) + ": must be 1 to 4");
  for (const double channel : options.background)
    if (!(channel >= 0 && channel <= 1)) refuse("background: each channel must be 0 to 1");
  if (!(options.point_size >= 0 && options.point_size <= 100))
    refuse("point size " + std::to_string(options.point_size) + ": must be 0 to 100 pixels");
  if (options.up && !(options.up->allFinite() && options.up->norm() > 0))
    refuse("up: must be a direction, such as 0,0,1");
}

Drawing::Drawing(const SceneData& scene, const RenderOptions& options)
    : scene_(scene),
      options_((validate(options), options)),
      frame_(scene_frame(scene, options.up)),
      view_(choose_view(options.view, scene, frame_)),
      colors_(choose_colors(scene)),
      fitted_(points_to_fit(scene.result, frame_, {})) {
  if (options.cull_front && !view_.position) {  // a sensor saw all that it saw
    const Layout layout(options.size[0], options.size[1], {});
    cut_ = Cutaway(scene, frame_, camera(layout).position);
    fitted_ = points_to_fit(scene.result, frame_, cut_);
  }
  // From above the camera's left shoulder.
  const Eigen::Vector3d across = view_.forward.cross(view_.up);
  const Eigen::Vector3d light =
      options.eye_dome_lighting
          ? Eigen::Vector3d((-view_.forward + 0.6 * view_.up - 0.4 * across).normalized())
          : Eigen::Vector3d::Zero();
  points_renderer_ = make_renderer(window_, 0);
  shapes_renderer_ = make_renderer(window_, 1);
  window_.vtk()->SetNumberOfLayers(2);
  points_renderer_->SetBackground(options.background.data());
  if (options.eye_dome_lighting) {
    vtkNew<vtkRenderStepsPass> steps;
    shading_ = vtkSmartPointer<DepthShading>::New();
    shading_->SetDelegatePass(steps);
    if (view_.position)
      shading_->SetNoise(depth_noise(scene.result.cloud, *view_.position, view_.forward));
    points_renderer_->SetPass(shading_);
  }
  shapes_renderer_->PreserveDepthBufferOn();
  shapes_renderer_->UseDepthPeelingOn();
  shapes_renderer_->SetMaximumNumberOfPeels(12);
  shapes_renderer_->SetOcclusionRatio(0.0);
  points_ = std::make_unique<PointLayer>(scene, colors_, frame_.up, light, cut_);
  points_renderer_->AddActor(points_->actor());
}

Camera Drawing::camera(const Layout& layout) const {
  Frame frame;
  frame.top = std::min(frame.top, 1 - 2.0 * layout.band / layout.height);
  frame.bottom = std::max(frame.bottom, -1 + 2.0 * layout.footer / layout.height);
  return view_.fit(fitted_, static_cast<double>(layout.width) / layout.height, frame);
}

int Drawing::supersample(const std::array<int, 2>& size) const {
  int scale = options_.supersample;
  const auto too_large = [&] {
    return std::int64_t{size[0]} * size[1] * scale * scale > kMostPixels ||
           std::max(size[0], size[1]) * scale > window_.max_size();
  };
  while (scale > 1 && too_large()) --scale;
  if (too_large()) {
    throw Error(Error::Kind::Rendering, "the OpenGL renderer draws at most " +
                                            std::to_string(window_.max_size()) +
                                            " pixels a side; ask for a smaller picture");
  }
  return scale;
}

void Drawing::color_points(Layer layers) {
  if (given_colors_ != nullptr) return points_->show(*given_colors_);
  PointColors colors{has(layers, Layer::Scene), has(layers, Layer::Patches),
                     has(layers, Layer::Segments), false};
  if (!colors.scene && !colors.patches && !colors.segments) colors = {true, false, false, true};
  points_->show(colors);
}

void Drawing::show(Layer layers, const Camera& camera, const Layout& layout, int scale) {
  color_points(layers);
  const double tangent = std::tan(camera.view_angle * std::numbers::pi / 360);
  const double side = std::sqrt(static_cast<double>(layout.width) * layout.height);
  const double focal = layout.height * scale / (2 * tangent);
  points_->scale(
      {focal, options_.point_size * scale, static_cast<double>(scale), side * scale / 20});
  const Pen pen{scale * std::max(0.6, side / 1440), focal};
  if (shading_) {  // at 1920 x 1080: two pixels and six
    const double size = scale * side / 1440;
    shading_->SetRadii(std::max(scale, static_cast<int>(std::lround(2 * size))),
                       std::max(2 * scale, static_cast<int>(std::lround(6 * size))));
  }
  if (has(layers, Layer::Planes))
    add_all(*shapes_renderer_, plane_layer(scene_, colors_, cut_, camera, pen));
  if (has(layers, Layer::Graph)) add_all(*shapes_renderer_, graph_layer(scene_, cut_, camera, pen));
}

Image Drawing::draw(Layer layers, const std::array<int, 2>& size, Annotation annotation) {
  if (cut_.any() && annotation.has_band())
    annotation.note = "walls between camera and room are left out";
  const Layout layout(size[0], size[1], annotation);
  const Camera eye = camera(layout);
  const int scale = supersample(size);
  shapes_renderer_->RemoveAllViewProps();
  show(layers, eye, layout, scale);
  annotate(*shapes_renderer_, annotation, layout, scale, options_.background);
  const std::array<double, 2> depths = depth_range(scene_.result.cloud, eye);
  place(*points_renderer_, eye, depths.data());
  place(*shapes_renderer_, eye, depths.data());
  const Image image = downsample(window_.draw(size[0] * scale, size[1] * scale), scale);
  if (is_uniform(image, layout.band, layout.height - layout.footer)) {
    throw Error(Error::Kind::Rendering,
                "the picture would be one colour only, so it is not written; is the scene within "
                "view, and another colour than the background?");
  }
  return image;
}

Image Drawing::draw_colored(const std::vector<Pixel>& colors, const std::array<int, 2>& size) {
  given_colors_ = &colors;
  Image image = draw(Layer::Segments, size, {});
  given_colors_ = nullptr;
  return image;
}

}  // namespace planescope::draw
