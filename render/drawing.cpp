// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderStepsPass.h>

#include "depth_shading.hpp"
#include "marks.hpp"
#include "planescope/error.hpp"
#include "scene_box.hpp"
#include "sensor_noise.hpp"
#include "thinning.hpp"
#include "validate.hpp"

namespace planescope::draw {
namespace {

constexpr std::size_t kDepthSample = 200'000;
constexpr double kRound = 5;  // [pixel of the picture] from here on corners of squares are seen

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
  active.SetParallelProjection(camera.parallel());
  if (camera.parallel()) active.SetParallelScale(camera.parallel_height / 2);
  active.SetClippingRange(clipping_range[0], clipping_range[1]);
}

/// Nearest and farthest depth of what is drawn before the camera, with room to spare: both
/// renderers share it, and with it the depth buffer.
std::array<double, 2> depth_range(const PointCloud& cloud, const SceneBox& box,
                                  const Camera& camera) {
  const std::size_t step = 1 + cloud.size() / kDepthSample;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 1e-3;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    if (!box.holds(cloud.positions[i])) continue;
    const double depth =
        (cloud.positions[i].cast<double>() - camera.position).dot(camera.forward());
    if (depth > 0) nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  return {std::clamp(0.8 * nearest, 1e-3 * farthest, 0.99 * farthest), 1.5 * farthest};
}

/// [pixel] Left, bottom, right and top of what a box can be seen in, `margin` around it: the whole
/// picture where the camera is inside, or beside it.
std::array<int, 4> seen_region(const Camera& camera, const Eigen::AlignedBox3d& box, double margin,
                               int width, int height) {
  const double aspect = static_cast<double>(width) / height;
  Eigen::AlignedBox2d seen;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d at =
        project(camera, aspect, box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)));
    if (!(at.z() > 0) || !(at.head<2>().cwiseAbs().maxCoeff() < 1e3)) return {0, 0, width, height};
    seen.extend(Eigen::Vector2d((at.x() + 1) / 2 * width, (at.y() + 1) / 2 * height));
  }
  const Eigen::Vector2d low = seen.min().array() - margin, high = seen.max().array() + margin + 1;
  return {static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()),
          static_cast<int>(high.y())};
}

}  // namespace

namespace {

SceneColors all_colors(const SceneData& scene, const RenderOptions& options, const Shot& shot) {
  SceneColors colors = scene_colors(scene, options);
  colors.heights = height_range(scene.result.cloud, shot.axes().up.cast<float>());
  if (!options.truth.empty()) add_truth(colors, scene, options.truth);
  return colors;
}

}  // namespace

Drawing::Drawing(const SceneData& scene, const RenderOptions& options, Fit fit,
                 std::unique_ptr<Window> window)
    : scene_(scene),
      options_((validate(options), options)),
      shot_(scene, options, fit),
      colors_(all_colors(scene, options, shot_)),
      window_(window ? std::move(window) : std::make_unique<Window>()) {
  make_renderers();
}

void Drawing::upload(const std::array<int, 2>& size, int scale) {
  // From above the left shoulder of the first picture's camera.
  const Eigen::Vector3d lamp = -eye_.forward() + 0.6 * eye_.up - 0.4 * eye_.right();
  const Eigen::Vector3d light =
      options_.eye_dome_lighting ? Eigen::Vector3d(lamp.normalized()) : Eigen::Vector3d(0, 0, 0);
  painter_ = std::make_unique<PointPainter>(scene_, colors_, shot_.axes().up, light);
  std::vector<std::uint32_t> points = visible_points(scene_, shot_.cut());
  Splats sizes = splats(scene_, points);
  usual_splat_ = sizes.usual;
  if (points.size() >= options_.thin_from) {
    points = seen_splats(scene_.result.cloud, points, sizes.diameters, point_scale(size, scale),
                         eye_, size[0] * scale, size[1] * scale);
    sizes = splats(scene_, points);
  }
  points_ = std::make_unique<PointLayer>(scene_, *painter_, std::move(points), sizes.diameters);
  points_renderer_->AddActor(points_->actor());
}

void Drawing::make_renderers() {
  points_renderer_ = make_renderer(*window_, 0);
  shapes_renderer_ = make_renderer(*window_, 1);
  window_->vtk()->SetNumberOfLayers(2);
  if (options_.eye_dome_lighting) {
    vtkNew<vtkRenderStepsPass> steps;
    shading_ = vtkSmartPointer<DepthShading>::New();
    shading_->SetDelegatePass(steps);
    const Viewpoint& view = shot_.view();
    if (view.position)
      shading_->SetNoise(depth_noise(scene_.result.cloud, *view.position, view.forward));
    points_renderer_->SetPass(shading_);
  }
  shapes_renderer_->PreserveDepthBufferOn();
  // These steps blend translucent cells in the order in which they come: plane_layer() sorts them.
  vtkNew<vtkRenderStepsPass> blended;
  shapes_renderer_->SetPass(blended);
}

Camera Drawing::camera(const Layout& layout) const {
  Frame frame;
  frame.top = std::min(frame.top, 1 - 2.0 * layout.band / layout.height);
  frame.bottom = std::max(frame.bottom, -1 + 2.0 * layout.footer / layout.height);
  return shot_.camera(static_cast<double>(layout.width) / layout.height, frame);
}

int Drawing::supersample(const std::array<int, 2>& size) const {
  int scale = options_.supersample;
  const auto too_large = [&] {
    return std::int64_t{size[0]} * size[1] * scale * scale > kMostPixels ||
           std::max(size[0], size[1]) * scale > window_->max_size();
  };
  while (scale > 1 && too_large()) --scale;
  if (too_large()) {
    throw Error(Error::Kind::Rendering, "the OpenGL renderer draws at most " +
                                            std::to_string(window_->max_size()) +
                                            " pixels a side; ask for a smaller picture");
  }
  return scale;
}

PointScale Drawing::point_scale(const std::array<int, 2>& size, int scale) const {
  const double side = std::sqrt(static_cast<double>(size[0]) * size[1]);
  const double depth = eye_.parallel() ? 1 : (eye_.focal - eye_.position).norm();
  const PointScale squares{pixels_per_metre(eye_, static_cast<double>(size[1]) * scale, 1),
                           options_.point_size * scale, static_cast<double>(scale),
                           side * scale / 20};
  return rounded(squares, usual_splat_, depth, kRound * scale);
}

void Drawing::show(Layer layers, const PointColors& colors, const Layout& layout, int scale) {
  given_colors_ != nullptr ? points_->show(*given_colors_) : points_->show(colors);
  const double side = std::sqrt(static_cast<double>(layout.width) * layout.height);
  const double height = static_cast<double>(layout.height) * scale;
  const PointScale splats = point_scale({layout.width, layout.height}, scale);
  points_->scale(splats);
  const Pen pen{scale * std::max(0.6, side / 1440), height};
  if (shading_) {  // at 1920 x 1080: two pixels and six
    const double size = scale * side / 1440;
    shading_->SetRadii(std::max(scale, static_cast<int>(std::lround(2 * size))),
                       std::max(2 * scale, static_cast<int>(std::lround(6 * size))));
    shading_->SetRegion(seen_region(eye_, points_->bounds(), splats.most / 2 + 1,
                                    layout.width * scale, layout.height * scale));
  }
  shapes_ = given_shapes_;
  const auto add = [&](const Actors& actors) {
    shapes_.insert(shapes_.end(), actors.begin(), actors.end());
  };
  if (has(layers, Layer::Planes)) add(plane_layer(scene_, colors_, shot_.cut(), eye_, pen));
  if (has(layers, Layer::Graph)) add(graph_layer(scene_, shot_.cut(), eye_, pen));
}

void Drawing::complete(Annotation& annotation, Layer layers, const PointColors& colors,
                       const std::array<int, 2>& size) const {
  const AnnotationOptions& asked = options_.annotation;
  if (asked.legend) {
    const auto legend = color_legend(scene_, colors_, colors, layers);
    annotation.legend.insert(annotation.legend.end(), legend.begin(), legend.end());
  }
  shorten_legend(annotation, size[0], size[1]);
  if (shot_.cut().any() && annotation.has_band())
    annotation.note = "walls between camera and room are left out";
  if (asked.scale_bar) annotation.scale_bar = ScaleBar{};  // has its place before it is known
}

void Drawing::mark(Annotation& annotation, const Layout& layout) const {
  if (annotation.scale_bar) annotation.scale_bar = scale_bar(eye_, layout);
  if (options_.annotation.axes) annotation.axes = axis_marks(eye_);
  if (!options_.annotation.labels) return;
  annotation.marks = segment_marks(scene_, shot_.cut(), eye_, layout);
  thin_out(annotation.marks, layout);
}

Image Drawing::picture(const std::array<int, 2>& size, int scale, const Annotation& annotation,
                       const Layout& layout) {
  const auto on = [&](const std::array<double, 3>& ground) {
    shapes_renderer_->RemoveAllViewProps();
    for (const auto& actor : shapes_) shapes_renderer_->AddActor(actor);
    annotate(*shapes_renderer_, annotation, layout, scale, ground, options_.background);
    points_renderer_->SetBackground(ground.data());
    return window_->draw(size[0], size[1], scale);
  };
  if (!options_.transparent) return on(options_.background);
  // What lets white through and not black is how transparent the picture is; words keep the ink of
  // the background that was asked for, because that is like what they will lie on.
  return matte(on({1, 1, 1}), on({0, 0, 0}));
}

Image Drawing::draw(Layer layers, const std::array<int, 2>& size, Annotation annotation,
                    ColorBy by) {
  const PointColors colors = point_colors(layers, by);
  if ((colors.patches || by == ColorBy::Patch) && colors_.patches.empty())
    colors_.patches = patch_colors(scene_, options_.palette);
  complete(annotation, layers, colors, size);
  const Layout layout(size[0], size[1], annotation);
  eye_ = camera(layout);
  mark(annotation, layout);
  const int scale = supersample(size);
  if (!points_) upload(size, scale);
  show(layers, colors, layout, scale);
  const std::array<double, 2> depths =
      depth_range(scene_.result.cloud, SceneBox(scene_.result), eye_);
  place(*points_renderer_, eye_, depths.data());
  place(*shapes_renderer_, eye_, depths.data());
  Image image = picture(size, scale, annotation, layout);
  if (!uniform_allowed_ && is_uniform(image, layout.band, layout.height - layout.footer)) {
    throw Error(Error::Kind::Rendering,
                "the picture would be one colour only, so it is not written; is the scene within "
                "view, and another colour than the background?");
  }
  return image;
}

Image Drawing::draw_colored(const std::vector<Pixel>& colors, const std::array<int, 2>& size) {
  return draw_marked(colors, size, {}, {});
}

Image Drawing::draw_marked(const std::vector<Pixel>& colors, const std::array<int, 2>& size,
                           Annotation annotation, const Actors& shapes) {
  given_colors_ = &colors;
  given_shapes_ = shapes;
  Image image = draw(Layer::Segments, size, std::move(annotation));
  given_colors_ = nullptr;
  given_shapes_.clear();
  return image;
}

}  // namespace planescope::draw
