// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry_files.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataWriter.h>

#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "vtk_arrays.hpp"
#include "vtk_errors.hpp"
#include "vtp_reader.hpp"
#include "vtp_xml.hpp"

namespace planescope::draw {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  refuse_vtp(file.string(), what);
}

std::string read_all(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  if (!in || size <= 0) refuse(file, "missing or empty");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  in.seekg(0);
  if (!in.read(bytes.data(), size)) refuse(file, "cannot be read to its end");
  return bytes;
}

void check_cells(const std::filesystem::path& file, vtkCellArray& cells, vtkIdType point_count,
                 std::size_t least) {
  vtkIdType end = 0;
  vtkDataArray& offsets = *cells.GetOffsetsArray();
  vtkDataArray& ids = *cells.GetConnectivityArray();
  for (vtkIdType i = 0; i < offsets.GetNumberOfTuples(); ++i) {
    const auto offset = static_cast<vtkIdType>(offsets.GetTuple1(i));
    if (offset < end || offset > ids.GetNumberOfTuples() ||
        (i > 0 && static_cast<std::size_t>(offset - end) < least))
      refuse(file, "cell " + std::to_string(i) + " is not where the file says");
    end = offset;
  }
  for (vtkIdType i = 0; i < ids.GetNumberOfTuples(); ++i) {
    const double id = ids.GetTuple1(i);
    if (id < 0 || id >= static_cast<double>(point_count))
      refuse(file, "a cell has the corner " + std::to_string(static_cast<long long>(id)) +
                       ", and there are " + std::to_string(point_count) + " points");
  }
}

void check(const std::filesystem::path& file, vtkPolyData& data, const VtpContract& contract) {
  const vtkIdType points = data.GetNumberOfPoints();
  if (contract.points >= 0 ? points != contract.points : points > contract.max_points)
    refuse(file, "has " + std::to_string(points) + " points, which result.json contradicts");
  check_cells(file, *data.GetVerts(), points, 1);
  check_cells(file, *data.GetLines(), points, 2);
  check_cells(file, *data.GetPolys(), points, 3);
  if (data.GetNumberOfCells() !=
      std::max({data.GetNumberOfVerts(), data.GetNumberOfLines(), data.GetNumberOfPolys()}))
    refuse(file, "mixes kinds of cells");
  const bool of_points = contract.columns == VtpContract::Columns::OfPoints;
  const vtkIdType rows = of_points ? points : data.GetNumberOfCells();
  vtkDataSetAttributes* columns = data.GetCellData();
  if (of_points) columns = data.GetPointData();
  for (const VtpContract::Column& column : contract.required) {
    vtkDataArray* array = columns->GetArray(column.name);
    if (array == nullptr || array->GetNumberOfTuples() != rows ||
        array->GetNumberOfComponents() != column.components)
      refuse(file, "has no whole array `" + std::string(column.name) + "`");
  }
}

}  // namespace

void write_vtp(vtkPolyData* data, const Eigen::Vector3d& origin,
               const std::filesystem::path& file) {
  vtkNew<vtkPolyData> moved;
  moved->ShallowCopy(data);
  if (!origin.isZero(0)) move_points<vtkDoubleArray>(*moved, origin);
  vtkNew<vtkXMLPolyDataWriter> writer;
  VtkErrors errors(writer);
  writer->SetInputData(moved);
  writer->WriteToOutputStringOn();
  writer->SetCompressorTypeToZLib();
  if (writer->Write() == 0 || errors.any())
    throw Error(Error::Kind::Internal, file.string() + ": VTK cannot write it: " + errors.first());
  write_whole(file, writer->GetOutputString());
}

vtkSmartPointer<vtkPolyData> read_vtp(const std::filesystem::path& file,
                                      const Eigen::Vector3d& origin, const VtpContract& contract) {
  vtkSmartPointer<vtkPolyData> data = parse_vtp(read_all(file), file.string());
  check(file, *data, contract);
  if (!origin.isZero(0)) move_points<vtkFloatArray>(*data, -origin);
  return data;
}

}  // namespace planescope::draw
