# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens a result folder with VTK's own Python bindings and a reader of PCD written here, and checks counts and arrays against
result.json: vtk_reader.py FOLDER. Exits with 77 where the bindings are absent."""
import json
import struct
import sys
from pathlib import Path

try:
    from vtk import vtkXMLPolyDataReader
except ImportError:
    sys.exit(77)

RULES = ["same_plane", "different_planes", "plane_boundary", "convex", "nearly_flat", "concave", "singular", "step", "no_support"]
FORMATS = {("F", 4): "f", ("F", 8): "d", ("U", 4): "I", ("I", 4): "i", ("U", 2): "H", ("U", 1): "B"}


def read_vtp(file):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    assert reader.GetErrorCode() == 0, file
    return reader.GetOutput()


def columns(attributes):
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {a.GetName(): [a.GetTuple(i) if a.GetNumberOfComponents() > 1 else a.GetTuple1(i)
                          for i in range(a.GetNumberOfTuples())] for a in arrays}


def read_pcd(file):
    data = file.read_bytes()
    header = {}
    at = 0
    while "DATA" not in header:
        end = data.index(b"\n", at)
        words = data[at:end].decode().split()
        at = end + 1
        if words and not words[0].startswith("#"):
            header[words[0]] = words[1:]
    assert header["DATA"] == ["binary"], header["DATA"]
    kinds = [FORMATS[(t, int(s))] for t, s in zip(header["TYPE"], header["SIZE"])]
    record = struct.Struct("<" + "".join(kinds))
    count = int(header["POINTS"][0])
    rows = list(record.iter_unpack(data[at:at + count * record.size]))
    assert len(rows) == count
    return dict(zip(header["FIELDS"], zip(*rows)))


def main(folder):
    result = json.loads((folder / "result.json").read_text())
    points = read_pcd(folder / "points.pcd")
    assert len(points["x"]) == result["input"]["points"]
    assert {"rgb", "label", "plane", "patch"} <= points.keys()
    for segment in result["segments"]:
        assert points["label"].count(segment["label"]) == segment["points"], segment
    for plane in result["planes"]:
        assert points["plane"].count(plane["id"]) == plane["points"], plane

    patches = read_vtp(folder / "patches.vtp")
    assert patches.GetNumberOfPoints() == result["patches"]
    of_patches = columns(patches.GetPointData())
    for plane in result["planes"]:
        assert of_patches["plane"].count(plane["id"]) == plane["patches"], plane
    for i, count in enumerate(of_patches["point_count"]):
        if i % 97 == 0:
            assert points["patch"].count(i) == count, i

    graph = read_vtp(folder / "graph.vtp")
    assert graph.GetNumberOfPoints() == result["patches"]
    assert graph.GetNumberOfLines() == graph.GetNumberOfCells() == result["edges"]["count"]
    edges = columns(graph.GetCellData())
    for array in ("border", "normal_angle", "convexity", "singular_angle", "singular_limit", "step", "step_limit", "support",
                  "margin"):
        assert len(edges[array]) == result["edges"]["count"], array
    assert edges["on"].count(1) == result["edges"]["on"]
    for index, rule in enumerate(RULES):
        assert edges["rule"].count(index) == result["edges"]["by_rule"][rule], rule
    labels = columns(graph.GetPointData())["label"]
    for i in range(graph.GetNumberOfCells()):
        ends = graph.GetCell(i).GetPointIds()
        if edges["on"][i]:
            assert labels[ends.GetId(0)] == labels[ends.GetId(1)], i

    planes = read_vtp(folder / "planes.vtp")
    hulls = columns(planes.GetCellData())
    assert planes.GetNumberOfPolys() == planes.GetNumberOfCells() > 0
    assert set(hulls["plane"]) == {plane["id"] for plane in result["planes"]}
    for i in range(planes.GetNumberOfCells()):
        plane = result["planes"][int(hulls["plane"][i])]
        corners = planes.GetCell(i).GetPoints()
        for k in range(corners.GetNumberOfPoints()):
            off = sum(a * b for a, b in zip(plane["normal"], corners.GetPoint(k))) - plane["distance"]
            assert abs(off) < 1e-4, (i, k, off)
    print(f"{result['patches']} patches, {result['edges']['count']} edges, {len(result['planes'])} planes: as result.json says")


main(Path(sys.argv[1]))
