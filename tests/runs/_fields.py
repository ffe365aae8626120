"""Reads the files of points and grid of a run, for tests, which import this file."""

import ctypes
import re
import subprocess
import sys
import xml.etree.ElementTree

import numpy
from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow

from _program import PROGRAM, SOURCE_DIR

sys.path.insert(0, str(SOURCE_DIR / "scripts"))
from plotting.run import read_grid, read_mesh, read_points  # noqa: E402,F401

# What VTK complains about, instead of printing it.
MESSAGES = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(MESSAGES)


def read_vtk(path):
    """Positions and fields in a VTU or PVTU file; of a mesh also its cells."""
    before = MESSAGES.GetOutput()
    fields = read_points(path)
    if path.parent.name == "grid":
        fields["cells"] = read_mesh(path)[1]
    assert path.is_file() and MESSAGES.GetOutput() == before, \
        f"{path}: {MESSAGES.GetOutput()}"
    return fields


class Hdf5:
    """An HDF5 file, read by the library that the program uses."""

    library = None
    KINDS = {0: numpy.uint32, 1: numpy.float32}  # classes of HDF5's types

    def __init__(self, path):
        if Hdf5.library is None:
            names = subprocess.run(["ldd", PROGRAM], check=True, text=True,
                                   capture_output=True).stdout
            Hdf5.library = ctypes.CDLL(
                re.search(r"=> (\S*libhdf5\w*\.so\S*)", names)[1])
            for name in ("H5Fopen", "H5Dopen2", "H5Dget_space", "H5Dget_type"):
                getattr(Hdf5.library, name).restype = ctypes.c_int64
            Hdf5.library.H5Tget_size.restype = ctypes.c_size_t
            Hdf5.library.H5open()
        self.file = self.library.H5Fopen(str(path).encode(), 0, 0)
        assert self.file >= 0, f"HDF5 cannot open {path}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.library.H5Fclose(ctypes.c_int64(self.file))

    def read(self, name):
        """An array of single precision or of natural numbers."""
        call, number = self.library, ctypes.c_int64
        dataset = number(call.H5Dopen2(number(self.file), name.encode(),
                                       number(0)))
        assert dataset.value >= 0, f"there is no {name}"
        space = number(call.H5Dget_space(dataset))
        kind = number(call.H5Dget_type(dataset))
        size = (ctypes.c_uint64 * call.H5Sget_simple_extent_ndims(space))()
        call.H5Sget_simple_extent_dims(space, size, None)
        assert call.H5Tget_size(kind) == 4
        data = numpy.empty(list(size), self.KINDS[call.H5Tget_class(kind)])
        status = call.H5Dread(dataset, kind, number(0), number(0), number(0),
                              data.ctypes.data_as(ctypes.c_void_p))
        assert status >= 0, f"{name} cannot be read"
        call.H5Tclose(kind)
        call.H5Sclose(space)
        call.H5Dclose(dataset)
        return data


def read_xdmf_item(folder, item):
    """The array that an item of an XDMF file refers to, which must be as the
    item says."""
    assert item.get("Format") == "HDF" and item.get("Precision") == "4"
    path, name = item.text.split(":")
    with Hdf5(folder / path) as file:
        data = file.read(name)
    kind = {"Float": numpy.float32, "UInt": numpy.uint32}[item.get("NumberType")]
    assert data.dtype == kind, f"{path}:{name} is of another type"
    assert list(data.shape) == [int(n) for n in item.get("Dimensions").split()], \
        f"{path}:{name} has the shape {data.shape}"
    return data


def read_xdmf_grid(folder, grid):
    """Positions and fields of one instant; of a mesh also its cells."""
    fields = {each.get("Name"): read_xdmf_item(folder, each.find("DataItem"))
              for each in grid.iter("Attribute")}
    fields["position"] = read_xdmf_item(folder, grid.find("Geometry/DataItem"))
    topology = grid.find("Topology")
    cells = read_xdmf_item(folder, topology.find("DataItem"))
    assert len(cells) == int(topology.get("NumberOfElements"))
    if topology.get("TopologyType") == "Polyvertex":
        assert numpy.array_equal(cells, numpy.arange(len(fields["position"])))
    else:
        fields["cells"] = cells
    return fields


def read_series(folder, name="points"):
    """All instants of a run that its record names, as (time, fields)."""
    record = folder / f"{name}.xdmf"
    if record.exists():
        root = xml.etree.ElementTree.parse(record).getroot()
        return [(float(grid.find("Time").get("Value")),
                 read_xdmf_grid(folder, grid))
                for grid in root.findall("Domain/Grid/Grid")]
    root = xml.etree.ElementTree.parse(folder / f"{name}.pvd").getroot()
    return [(float(entry.get("timestep")),
             read_vtk(folder / entry.get("file")))
            for entry in root.iter("DataSet")]


def by_id(fields):
    """The rows of all fields in the order of the points' ids."""
    order = numpy.argsort(fields["id"])
    return {name: values[order] for name, values in fields.items()}
