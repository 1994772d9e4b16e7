// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>

#include <vtkPolyDataAlgorithm.h>

#include "planescope/pipeline.hpp"

/// \file The engine as a VTK filter (target planescope::render; the one public header that needs
/// VTK).
namespace planescope {

/// Segments the points of its input. Outputs:
/// - port 0, PointsPort: the input's points and arrays, with point arrays `label` (0: in no
///   segment), `plane` and `patch` (-1: none); vertices are added where the input has no cells;
/// - port 1, PlanesPort: the supporting planes as convex polygons, as in planes.vtp;
/// - port 2, GraphPort: the patches' centroids and the edges between them with state, rule and
///   every measured value, as in graph.vtp.
///
/// The input: points [m] of any precision; map coordinates are fine. Colours: the active point
/// scalars where they are 3 or 4 bytes each. Normals: the active point normals, towards the sensor.
/// Reports vtkCommand::ProgressEvent with the stage as its text, stops on AbortExecute, and where
/// planescope throws it reports vtkCommand::ErrorEvent and leaves its outputs empty.
class SegmentationFilter : public vtkPolyDataAlgorithm {
 public:
  static SegmentationFilter* New();
  // clang-format off
  vtkTypeMacro(SegmentationFilter, vtkPolyDataAlgorithm)  // its last brace needs no semicolon
                                                          // clang-format on
      void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Port { PointsPort = 0, PlanesPort = 1, GraphPort = 2 };

  /// What the options start from: `auto` (from the points, the default), `room`, or `tabletop`.
  vtkSetStdStringFromCharMacro(Preset);
  vtkGetCharFromStdStringMacro(Preset);

  /// Any option of option_table() by its name, over the preset's value; text as on the command
  /// line. A bad name or value is reported by ErrorEvent, and nothing changes.
  void SetOption(const char* name, const char* value);
  /// The value that was set, else that of the last run; empty before it.
  std::string GetOption(const char* name) const;
  /// Back to the preset.
  void ClearOptions();

  /// Options as properties. 0 where nothing was set and nothing has run.
#define planescopeOptionMacro(Name, option)                        \
  void Set##Name(double value) { this->SetNumber(option, value); } \
  double Get##Name() const { return this->GetNumber(option); }
  planescopeOptionMacro(VoxelSize, "patches.voxel_size");
  planescopeOptionMacro(PatchSize, "patches.patch_size");
  planescopeOptionMacro(RangeExponent, "patches.range_exponent");
  planescopeOptionMacro(Sigma, "planes.sigma");
  planescopeOptionMacro(MinArea, "planes.min_area");
  planescopeOptionMacro(Alpha, "planes.alpha");
  planescopeOptionMacro(NormalGate, "planes.normal_gate");
  planescopeOptionMacro(MaxCurvature, "planes.max_curvature");
  planescopeOptionMacro(WeightAngle, "planes.weight_angle");
  planescopeOptionMacro(WeightOverlap, "planes.weight_overlap");
  planescopeOptionMacro(Smoothness, "planes.smoothness");
  planescopeOptionMacro(RandomSeed, "planes.random_seed");
  planescopeOptionMacro(ConcavityTolerance, "edges.concavity_tolerance");
  planescopeOptionMacro(SmoothnessTolerance, "edges.smoothness_tolerance");
  planescopeOptionMacro(SingularAngle, "edges.singular_angle");
  planescopeOptionMacro(MinPatches, "segments.min_patches");
#undef planescopeOptionMacro

  /// Where the points were seen from [m], where that is known: normals are turned there.
  void SetSensor(double x, double y, double z);
  void ClearSensor();

  /// What the last Update() found out, for explain() and the rest of the library; its coordinates
  /// are relative to GetOrigin(). Empty before it.
  const Segmentation& GetSegmentation() const { return scene_; }
  const std::array<double, 3>& GetOrigin() const { return origin_; }

 protected:
  SegmentationFilter();
  ~SegmentationFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

 private:
  SegmentationFilter(const SegmentationFilter&) = delete;
  void operator=(const SegmentationFilter&) = delete;

  void SetNumber(const char* name, double value);
  double GetNumber(const char* name) const;
  Options ResolveOptions(const PointCloud& cloud) const;
  planescope::Progress MakeProgress();  // vtkAlgorithm has a Progress of its own

  std::string Preset = "auto";
  std::map<std::string, std::string> given_;  // options over the preset
  std::unique_ptr<std::array<double, 3>> sensor_;
  Segmentation scene_;
  std::array<double, 3> origin_{0, 0, 0};
};

}  // namespace planescope
