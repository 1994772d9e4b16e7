// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// picture_speed [--points N]: the four standard pictures (overview, segments, planes,
// graph) of a synthesized room, and the same four actors drawn and written by VTK alone, in one
// process and on the same OpenGL, in turn; medians of 5 and their ratio.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <unistd.h>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "freed_memory.hpp"
#include "geometry.hpp"
#include "inputs.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/render.hpp"
#include "window.hpp"

namespace planescope::bench {
namespace {

using Actor = vtkSmartPointer<vtkActor>;

/// Seconds that passed, and seconds of processor time of all threads.
struct Times {
  std::vector<double> wall, processor;
};

void add_run(Times& times, const std::function<void()>& action) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t busy = std::clock();
  action();
  times.processor.push_back(static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC);
  times.wall.push_back(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void compare(const char* what, const Times& ours, const Times& bare) {
  const double wall = median(ours.wall), bare_wall = median(bare.wall);
  const double busy = median(ours.processor), bare_busy = median(bare.processor);
  std::printf("%s: ours %.2f, VTK alone %.2f, ratio %.2f; processor time %.2f, %.2f, ratio %.2f\n",
              what, wall, bare_wall, wall / bare_wall, busy, bare_busy, busy / bare_busy);
}

Actor make_actor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = Actor::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

/// The points as one polyvertex with a colour each: the quickest that VTK knows.
Actor point_actor(const PointCloud& cloud, const std::function<Rgb(std::size_t)>& color) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell(static_cast<int>(cloud.size()));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.positions[i];
    vertices->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), p.z()));
    const Rgb c = color(i);
    colors->InsertNextTuple3(c.r, c.g, c.b);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetScalars(colors);
  Actor actor = make_actor(data);
  actor->GetProperty()->SetPointSize(3);
  return actor;
}

Rgb any_color(std::uint32_t label) {
  const std::uint32_t hash = label * 2654435761U;
  return {static_cast<std::uint8_t>(hash >> 24), static_cast<std::uint8_t>(hash >> 16),
          static_cast<std::uint8_t>(hash >> 8)};
}

void write(const draw::Image& image, const std::filesystem::path& file) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(image.rgb.begin(), image.rgb.end(),
            static_cast<unsigned char*>(data->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  writer->Write();
}

/// What somebody writes with VTK alone: one renderer, four actors, depth peeling for the planes,
/// four pictures: points, segments, planes over points, graph over points.
void draw_bare(const Segmentation& scene, const PointCloud& cloud, const std::array<int, 2>& size,
               const std::filesystem::path& folder) {
  const Actor points = point_actor(cloud, [&](std::size_t i) { return cloud.colors[i]; });
  const Actor segments =
      point_actor(cloud, [&](std::size_t i) { return any_color(scene.point_label[i]); });
  const Actor planes = make_actor(draw::plane_geometry(scene, cloud));
  planes->GetProperty()->SetOpacity(0.4);
  const Actor graph = make_actor(draw::graph_geometry(scene));
  for (const Actor& actor : {planes, graph}) actor->GetMapper()->ScalarVisibilityOff();

  draw::Window window;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->UseDepthPeelingOn();
  renderer->SetMaximumNumberOfPeels(12);
  renderer->SetOcclusionRatio(0);
  window.vtk()->AddRenderer(renderer);
  for (const Actor& actor : {points, segments, planes, graph}) renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(-1, -1, 0.9);
  renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  const std::vector<std::vector<Actor>> pictures = {
      {points}, {segments}, {points, planes}, {points, graph}};
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (const Actor& actor : {points, segments, planes, graph}) actor->VisibilityOff();
    for (const Actor& actor : pictures[i]) actor->VisibilityOn();
    write(window.draw(size[0], size[1]), folder / ("bare" + std::to_string(i) + ".png"));
  }
}

int run(std::uint64_t points) {
  const PointCloud cloud = room(points);
  const Segmentation scene = segment(cloud, Options::automatic(cloud));
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       ("planescope-picture-speed-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto ours = [&](int supersample) {
    RenderOptions options;
    options.supersample = supersample;
    render_pictures(scene, cloud, options, folder);
  };
  const auto bare = [&](int scale) {
    draw_bare(scene, cloud, {1920 * scale, 1080 * scale}, folder);
  };
  Times plain, bare_plain, smooth, bare_smooth;
  for (int i = 0; i < 5; ++i) {  // in turn, so that other load on the machine meets all alike
    add_run(plain, [&] { ours(1); });
    add_run(bare_plain, [&] { bare(1); });
    add_run(smooth, [&] { ours(2); });
    add_run(bare_smooth, [&] { bare(2); });
  }
  std::printf("four pictures of %zu points at 1920 x 1080, medians of 5 [s]\n", cloud.size());
  compare("not antialiased", plain, bare_plain);
  compare("at twice the size (ours shrunk)", smooth, bare_smooth);
  compare("ours by default (antialiased), VTK alone (not antialiased)", smooth, bare_plain);
  std::filesystem::remove_all(folder);
  return 0;
}

}  // namespace
}  // namespace planescope::bench

int main(int argc, char** argv) {
  planescope::keep_freed_memory();  // as the command line does
  try {
    const bool given = argc == 3 && std::string(argv[1]) == "--points";
    return planescope::bench::run(given ? std::stoull(argv[2]) : 1'000'000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "picture_speed: %s\n", error.what());
    return 1;
  }
}
