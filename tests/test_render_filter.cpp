// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>
#include <vtkUnsignedCharArray.h>

#include "fixtures.hpp"
#include "geometry.hpp"
#include "planescope/synthesize.hpp"
#include "planescope/vtk/segmentation_filter.hpp"

namespace planescope {
namespace {

const PointCloud& room() {
  static const PointCloud kRoom = [] {
    SynthesisOptions options;
    options.random_seed = 5;
    options.points = 40'000;
    return synthesize(options).cloud;
  }();
  return kRoom;
}

vtkSmartPointer<vtkPolyData> to_vtk(const PointCloud& cloud, const Eigen::Vector3d& shift) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("rgb");
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.positions[i].cast<double>() + shift;
    points->InsertNextPoint(p.data());
    const unsigned char rgb[3] = {cloud.colors[i].r, cloud.colors[i].g, cloud.colors[i].b};
    colors->InsertNextTypedTuple(rgb);
  }
  data->SetPoints(points);
  data->GetPointData()->SetScalars(colors);
  return data;
}

/// What a filter reports.
struct Reports {
  std::vector<double> progress;
  std::vector<std::string> stages, errors;

  explicit Reports(vtkAlgorithm* filter) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long event, void* self, void* text) {
      auto& reports = *static_cast<Reports*>(self);
      if (event == vtkCommand::ErrorEvent) {
        reports.errors.emplace_back(static_cast<const char*>(text));
        return;
      }
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      reports.progress.push_back(algorithm->GetProgress());
      const char* stage = algorithm->GetProgressText();
      if (stage != nullptr) reports.stages.emplace_back(stage);
    });
    filter->AddObserver(vtkCommand::ProgressEvent, command);
    filter->AddObserver(vtkCommand::ErrorEvent, command);
  }
};

void expect_same_arrays(vtkDataSetAttributes& a, vtkDataSetAttributes& b) {
  ASSERT_EQ(a.GetNumberOfArrays(), b.GetNumberOfArrays());
  for (int k = 0; k < a.GetNumberOfArrays(); ++k) {
    vtkDataArray &x = *a.GetArray(k), &y = *b.GetArray(k);
    EXPECT_STREQ(x.GetName(), y.GetName());
    ASSERT_EQ(x.GetNumberOfValues(), y.GetNumberOfValues()) << x.GetName();
    for (vtkIdType i = 0; i < x.GetNumberOfValues(); ++i)
      ASSERT_EQ(x.GetVariantValue(i), y.GetVariantValue(i)) << x.GetName() << " " << i;
  }
}

TEST(RenderFilter, GivesWhatSegmentAndItsFilesHold) {
  const Segmentation scene = segment(room(), Options::automatic(room()));
  vtkNew<SegmentationFilter> filter;
  filter->SetInputData(to_vtk(room(), Eigen::Vector3d::Zero()));
  filter->Update();
  vtkPolyData& points = *filter->GetOutput(SegmentationFilter::PointsPort);
  ASSERT_EQ(points.GetNumberOfPoints(), static_cast<vtkIdType>(room().size()));
  EXPECT_EQ(points.GetNumberOfVerts(), points.GetNumberOfPoints());
  EXPECT_NE(points.GetPointData()->GetArray("rgb"), nullptr);  // what came in stays
  for (std::size_t i = 0; i < room().size(); ++i) {
    const auto at = static_cast<vtkIdType>(i);
    ASSERT_EQ(points.GetPointData()->GetArray("label")->GetTuple1(at), scene.point_label[i]);
    ASSERT_EQ(points.GetPointData()->GetArray("plane")->GetTuple1(at), scene.point_plane[i]);
    ASSERT_EQ(points.GetPointData()->GetArray("patch")->GetTuple1(at), scene.graph.point_patch[i]);
  }
  vtkPolyData& planes = *filter->GetOutput(SegmentationFilter::PlanesPort);
  vtkPolyData& graph = *filter->GetOutput(SegmentationFilter::GraphPort);
  const auto drawn_planes = draw::plane_geometry(scene, room());
  const auto drawn_graph = draw::graph_geometry(scene);
  EXPECT_GT(planes.GetNumberOfCells(), 4);
  expect_same_arrays(*planes.GetCellData(), *drawn_planes->GetCellData());
  expect_same_arrays(*graph.GetCellData(), *drawn_graph->GetCellData());
  expect_same_arrays(*graph.GetPointData(), *drawn_graph->GetPointData());
  EXPECT_EQ(filter->GetSegmentation().edges.size(), scene.edges.size());
  EXPECT_GT(filter->GetSigma(), 0);  // what `auto` chose
}

TEST(RenderFilter, OptionsAreProperties) {
  vtkNew<SegmentationFilter> filter;
  filter->SetInputData(to_vtk(room(), Eigen::Vector3d::Zero()));
  EXPECT_EQ(filter->GetConcavityTolerance(), 0);
  filter->SetPreset("room");
  filter->SetVoxelSize(0.04);
  filter->SetPatchSize(0.2);
  filter->SetOption("planes.solver", "lsa_tr");
  filter->Update();
  Options options = Options::room();
  options.patches.voxel_size = 0.04;
  options.patches.patch_size = 0.2;
  options.planes.solver = PlaneSolver::LsaTr;
  const Segmentation scene = segment(room(), options);
  EXPECT_EQ(filter->GetSegmentation().point_label, scene.point_label);
  EXPECT_EQ(filter->GetConcavityTolerance(), 10);  // of the run
  // Nothing changed: nothing runs. A property changes: it runs again.
  Reports reports(filter);
  filter->SetVoxelSize(0.04);
  filter->Update();
  EXPECT_TRUE(reports.progress.empty());
  filter->SetConcavityTolerance(40);
  filter->Update();
  EXPECT_FALSE(reports.progress.empty());
  options.edges.concavity_tolerance = 40;
  EXPECT_EQ(filter->GetSegmentation().point_label, segment(room(), options).point_label);
}

TEST(RenderFilter, ReportsProgressUpwardsAndByStage) {
  vtkNew<SegmentationFilter> filter;
  filter->SetInputData(to_vtk(room(), Eigen::Vector3d::Zero()));
  Reports reports(filter);
  filter->Update();
  ASSERT_GT(reports.progress.size(), 5u);
  EXPECT_TRUE(std::is_sorted(reports.progress.begin(), reports.progress.end()));
  EXPECT_EQ(reports.progress.back(), 1);
  for (const char* stage : {"patches", "hypotheses", "selection", "assignment"})
    EXPECT_NE(std::find(reports.stages.begin(), reports.stages.end(), stage), reports.stages.end());
}

TEST(RenderFilter, StopsWhenAsked) {
  vtkNew<SegmentationFilter> filter;
  filter->SetInputData(to_vtk(room(), Eigen::Vector3d::Zero()));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (algorithm->GetProgress() > 0.3) algorithm->SetAbortExecute(1);
  });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_TRUE(filter->GetSegmentation().edges.empty());
  EXPECT_EQ(filter->GetOutput(SegmentationFilter::GraphPort)->GetNumberOfCells(), 0);
}

TEST(RenderFilter, KeepsMapCoordinates) {
  const Eigen::Vector3d shift(512'345, 5'212'345, 420);
  vtkNew<SegmentationFilter> filter;
  filter->SetInputData(to_vtk(room(), shift));
  filter->Update();
  vtkPolyData& graph = *filter->GetOutput(SegmentationFilter::GraphPort);
  ASSERT_GT(graph.GetNumberOfCells(), 100);
  double bounds[6];
  graph.GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GT(bounds[2 * axis], shift[axis] - 10);
    EXPECT_LT(bounds[2 * axis + 1], shift[axis] + 10);
  }
  EXPECT_EQ(graph.GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(filter->GetOrigin()[1], shift.y(), 10);
}

TEST(RenderFilter, ReportsWhatIsWrong) {
  vtkNew<SegmentationFilter> filter;
  Reports reports(filter);
  filter->SetOption("planes.sgima", "1");
  ASSERT_EQ(reports.errors.size(), 1u);
  EXPECT_NE(reports.errors[0].find("did you mean"), std::string::npos) << reports.errors[0];
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  ASSERT_EQ(reports.errors.size(), 2u);
  EXPECT_NE(reports.errors[1].find("no point"), std::string::npos);
  filter->SetInputData(to_vtk(room(), Eigen::Vector3d::Zero()));
  filter->SetPreset("hall");
  filter->Update();
  ASSERT_EQ(reports.errors.size(), 3u);
  EXPECT_EQ(filter->GetOutput(SegmentationFilter::PointsPort)->GetNumberOfPoints(), 0);
}

// Normals that are given are taken: turned away from the room, they turn its folds inside out.
TEST(RenderFilter, TakesNormalsAndTheSensor) {
  vtkNew<SegmentationFilter> plain, seen;
  for (SegmentationFilter* filter : {plain.Get(), seen.Get()})
    filter->SetInputData(to_vtk(room(), Eigen::Vector3d::Zero()));
  seen->SetSensor(0, 0, 50);  // above: normals of the floor point up, of a table's underside too
  plain->Update();
  seen->Update();
  EXPECT_TRUE(plain->GetSegmentation().graph.patches.size() ==
              seen->GetSegmentation().graph.patches.size());
  for (const Patch& patch : seen->GetSegmentation().graph.patches)
    EXPECT_GE(patch.own_normal.dot(Eigen::Vector3f(0, 0, 50) - patch.centroid), 0);
}

}  // namespace
}  // namespace planescope
