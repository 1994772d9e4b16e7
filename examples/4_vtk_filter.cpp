// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file The engine in a plain VTK pipeline: reader -> segmentation -> OFF edges -> tubes -> file.
#include <cstdio>

#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkThreshold.h>
#include <vtkTubeFilter.h>
#include <vtkXMLPolyDataWriter.h>
#include <planescope/vtk/segmentation_filter.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: %s ROOM.ply OFF_EDGES.vtp\n", argv[0]), 2;
  using planescope::SegmentationFilter;
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<SegmentationFilter> segmentation;
  segmentation->SetInputConnection(reader->GetOutputPort());
  segmentation->SetConcavityTolerance(12);  // [deg] an option of the engine as a property
  vtkNew<vtkThreshold> off;
  off->SetInputConnection(segmentation->GetOutputPort(SegmentationFilter::GraphPort));
  off->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "on");
  off->SetThresholdFunction(vtkThreshold::THRESHOLD_LOWER);
  off->SetLowerThreshold(0.5);
  vtkNew<vtkGeometryFilter> lines;
  lines->SetInputConnection(off->GetOutputPort());
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(lines->GetOutputPort());
  tubes->SetRadius(0.01);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(tubes->GetOutputPort());
  writer->SetFileName(argv[2]);
  if (writer->Write() == 0) return 3;
  std::printf("%lld planes, %lld edges, %lld of them OFF\n",
              segmentation->GetOutput(SegmentationFilter::PlanesPort)->GetNumberOfCells(),
              segmentation->GetOutput(SegmentationFilter::GraphPort)->GetNumberOfCells(),
              lines->GetOutput()->GetNumberOfCells());
  return 0;
}
