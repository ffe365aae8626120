"""Reading the output folder of a run of mpm_granular."""

import json
import pathlib
import re
import xml.etree.ElementTree

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                 vtkXMLUnstructuredGridReader)

AXES = "xyz"


class NotARun(Exception):
    """The folder does not hold what a run writes."""


def read_parameters(path):
    """The entries of a parameter file as {"Section/Sub/Entry": value}."""
    entries, sections = {}, []
    for line in path.read_text().splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end":
            sections.pop()
        elif match := re.match(r"set\s+(.*?)\s*=\s*(.*)", line):
            entries["/".join(sections + [match[1]])] = match[2].strip()
    return entries


def read_grid(path):
    """What VTK makes of a VTU or PVTU file."""
    reader = (vtkXMLPUnstructuredGridReader() if path.suffix == ".pvtu"
              else vtkXMLUnstructuredGridReader())
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read_points(path):
    """Positions and fields of the points in a VTU or PVTU file, all SI units."""
    grid = read_grid(path)
    if grid.GetNumberOfPoints() == 0:
        return {"position": numpy.zeros((0, 3))}
    data = grid.GetPointData()
    fields = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
              for i in range(data.GetNumberOfArrays())}
    fields["position"] = vtk_to_numpy(grid.GetPoints().GetData())
    return fields


def read_mesh(path):
    """Positions of the nodes of a mesh, and the nodes of its cells."""
    grid = read_grid(path)
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return (vtk_to_numpy(grid.GetPoints().GetData()),
            cells.reshape(grid.GetNumberOfCells(), -1))


class Run:
    """A folder that a run wrote."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise NotARun(f"there is no folder '{folder}'")
        if (self.folder / "points.xdmf").is_file():
            raise NotARun(f"'{folder}' has HDF5 files of points; pictures are "
                          "made of runs with Output/Format = VTU or PVTU")
        for name in ("manifest.json", "parameters.prm", "observables.csv",
                     "points.pvd"):
            if not (self.folder / name).is_file():
                raise NotARun(f"'{folder}' is not the output folder of a run: "
                              f"it has no file {name}")
        try:
            self.manifest = json.loads(
                (self.folder / "manifest.json").read_text())
            self.parameters = read_parameters(self.folder / "parameters.prm")
            rows = numpy.genfromtxt(self.folder / "observables.csv",
                                    delimiter=",", names=True, ndmin=1)
            record = xml.etree.ElementTree.parse(self.folder / "points.pvd")
        except (ValueError, xml.etree.ElementTree.ParseError) as error:
            raise NotARun(f"'{folder}' cannot be read: {error}") from error
        # Rows of the stage that finds the initial equilibrium come before time 0.
        self.stage = rows[rows["time"] < 0.]
        self.table = rows if len(self.stage) == len(rows) else rows[
            len(self.stage):]
        self.frames = [(float(entry.get("timestep")), entry.get("file"))
                       for entry in record.iter("DataSet")]
        if not self.frames or self.table.size == 0:
            raise NotARun(f"the run in '{folder}' has not written a state yet")
        self.grid_frames = []
        if (self.folder / "grid.pvd").is_file():
            grids = xml.etree.ElementTree.parse(self.folder / "grid.pvd")
            self.grid_frames = [
                (float(entry.get("timestep")), entry.get("file"))
                for entry in grids.iter("DataSet")]
        self.dimension = int(self.manifest.get("dimension", 3))
        self.loaded = {}

    @property
    def name(self):
        """For titles."""
        return self.folder.resolve().name

    @property
    def has_adaptive_mesh(self):
        """Whether its mesh changed, and was written with the points."""
        return (self.parameters.get("Adaptive mesh/Names", "") != "" and
                len(self.grid_frames) == len(self.frames))

    @property
    def gravity(self):
        """The acceleration at the start [m/s^2]."""
        numbers = re.findall(r"[-+0-9.eE]+",
                             self.parameters.get("Body force/Gravity", ""))
        try:
            vector = [float(number) for number in numbers]
        except ValueError:
            vector = []
        return numpy.array(vector if len(vector) == self.dimension
                           else [0.] * self.dimension)

    @property
    def vertical(self):
        """Index of the axis that is drawn upwards."""
        gravity = numpy.abs(self.gravity)
        return (int(numpy.argmax(gravity)) if gravity.max() > 0.
                else self.dimension - 1)

    @property
    def horizontal(self):
        """Index of the axis that is drawn to the right."""
        letter = self.parameters.get("Observables/Run-out direction", "x")[-1]
        axis = AXES.index(letter)
        return axis if axis != self.vertical else (self.vertical + 1) % 2

    @property
    def depth(self):
        """Index of the third axis; of z in 2D, where it is zero."""
        return 3 - self.vertical - self.horizontal

    @property
    def height_label(self):
        """Of what part of the body the column `height` tells the height."""
        if self.parameters.get("Observables/Height of") != "column":
            return "height"
        place = self.parameters.get("Observables/Column position", "0")
        return f"height at {AXES[self.horizontal]} = {place} m"

    def points(self, frame):
        """Positions and fields of frame number `frame`."""
        if frame not in self.loaded:
            self.loaded[frame] = read_points(
                self.folder / self.frames[frame][1])
        return self.loaded[frame]

    def frame_at(self, time):
        """The number of the frame nearest to `time`."""
        return int(numpy.argmin([abs(t - time) for t, _ in self.frames]))

    def stages(self, count):
        """The numbers of up to `count` frames at equal distances in time."""
        last = self.frames[-1][0]
        wanted = numpy.linspace(self.frames[0][0], last, count)
        return sorted({self.frame_at(time) for time in wanted})

    @property
    def spacing(self):
        """Mean distance of the points at the start [m]."""
        points = self.points(0)
        densities = [float(value) for path, value in self.parameters.items()
                     if path.endswith("/Density")]
        if densities and "mass" in points:
            volume = points["mass"].sum() / numpy.mean(densities)
        else:
            size = numpy.ptp(points["position"], axis=0)
            volume = numpy.prod(size[:self.dimension])
        return (volume / len(points["position"])) ** (1 / self.dimension)

    def strain_field(self):
        """Name and label of the field that shows where the body has sheared."""
        known = self.points(0)
        for name in known:
            if name.endswith("strain"):
                return name, name.replace("_", " ") + " [-]"
        return "speed", "speed [m/s]"
