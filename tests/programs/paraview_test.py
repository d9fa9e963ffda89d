"""The files for ParaView, as VTK's own reader sees them, or as plain XML does.

    python3 tests/programs/paraview_test.py vtk build/release/tests/programs/paraview_files
    python3 tests/programs/paraview_test.py plain build/release/tests/programs/paraview_files

Exit status 77 where VTK for Python is asked for and not installed.
"""

import base64
import csv
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

READER, PROGRAM = sys.argv.pop(1), sys.argv.pop(1)
if READER == "vtk":
    try:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError as missing:
        print(f"skipped: VTK for Python is not installed here ({missing})")
        sys.exit(77)

KINDS = ["particles", "contacts", "cracks"]
STATE = "state (0 intact, 1 tension, 2 shear, 3 preset)"
PLACE = "place (0 rock, 1 joint)"
STRESS = "stress (Pa, compression positive)"
MAJOR = "major principal stress (Pa, compression positive)"
MINOR = "minor principal stress (Pa, compression positive)"
NORMAL = "normal force (N/m, compression positive)"
ARRAYS = {  # name: components
    "particles": {"radius (m)": 1, "displacement (m)": 3, "rotation (rad)": 1, STRESS: 9, MAJOR: 1,
                  MINOR: 1},
    "contacts": {NORMAL: 1, "shear force (N/m)": 1, "bond moment (N m/m)": 1, STATE: 1,
                 PLACE: 1},
    "cracks": {"aperture (m)": 1, "pressure (Pa)": 1, "wet (0 dry, 1 wet)": 1, STATE: 1, PLACE: 1,
               "time of break (s)": 1},
    "pores": {"pressure (Pa)": 1, "filling (1 full)": 1, "place (0 pore, 1 crack)": 1},
}
RADIUS = 5e-3


class PlainXml:
    """A .vtp file by the standard library alone."""

    FORMATS = {"Float32": "f", "Int32": "i", "UInt8": "B"}

    def __init__(self, path):
        root = xml.etree.ElementTree.parse(path).getroot()
        self.order = {"LittleEndian": "<", "BigEndian": ">"}[root.get("byte_order")]
        header = {"UInt32": "I", "UInt64": "Q"}[root.get("header_type")]
        self.header = struct.Struct(self.order + header)
        piece = root.find("PolyData/Piece")
        self.time = float(root.find("PolyData/FieldData/DataArray[@Name='TimeValue']").text)
        self.on_points = self.arrays(piece.find("PointData"))
        self.on_cells = self.arrays(piece.find("CellData"))
        self.points = self.rows(piece.find("Points/DataArray"))
        assert len(self.points) == int(piece.get("NumberOfPoints"))
        self.vertices = self.cells(piece.find("Verts"), int(piece.get("NumberOfVerts")))
        self.lines = self.cells(piece.find("Lines"), int(piece.get("NumberOfLines")))
        self.polygons = self.cells(piece.find("Polys"), int(piece.get("NumberOfPolys")))

    def rows(self, element):
        data = base64.b64decode(element.text, validate=True)
        width = int(element.get("NumberOfComponents"))
        header = self.header.size
        size, = self.header.unpack(data[:header])
        assert size == len(data) - header
        number = self.FORMATS[element.get("type")]
        count = size // struct.calcsize(number)
        values = struct.unpack(f"{self.order}{count}{number}", data[header:])
        return [values[k:k + width] for k in range(0, len(values), width)]

    def arrays(self, element):
        return {array.get("Name"): self.rows(array) for array in element}

    def cells(self, element, count):
        arrays = self.arrays(element)
        ends = [0] + [end for end, in arrays["offsets"]]
        assert len(ends) == count + 1
        points = [point for point, in arrays["connectivity"]]
        return [points[a:b] for a, b in zip(ends, ends[1:])]


class Vtk:
    """A .vtp file by VTK."""

    def __init__(self, path):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        assert reader.GetErrorCode() == 0
        mesh = reader.GetOutput()
        self.time = mesh.GetFieldData().GetArray("TimeValue").GetValue(0)
        self.points = [mesh.GetPoint(k) for k in range(mesh.GetNumberOfPoints())]
        self.on_points = self.arrays(mesh.GetPointData())
        self.on_cells = self.arrays(mesh.GetCellData())
        self.vertices, self.lines, self.polygons = [], [], []
        for k in range(mesh.GetNumberOfCells()):
            cell = mesh.GetCell(k)
            kind = {"vtkVertex": self.vertices, "vtkLine": self.lines, "vtkPolygon": self.polygons,
                    "vtkQuad": self.polygons, "vtkTriangle": self.polygons}[cell.GetClassName()]
            kind.append([cell.GetPointId(p) for p in range(cell.GetNumberOfPoints())])

    @staticmethod
    def arrays(data):
        return {data.GetArrayName(a): [data.GetArray(a).GetTuple(k)
                                       for k in range(data.GetArray(a).GetNumberOfTuples())]
                for a in range(data.GetNumberOfArrays())}


read = {"vtk": Vtk, "plain": PlainXml}[READER]


def table(path):
    with open(path, newline="") as file:
        return [{k: v if k in ("mode", "place") else float(v) for k, v in row.items()}
                for row in csv.DictReader(file)]


class ParaViewTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        subprocess.run([PROGRAM, scratch.name], check=True)
        cls.runs = {run: {kind: read(sorted((cls.folder / run).glob(kind + "_*.vtp"))[-1])
                          for kind in KINDS} for run in ("intact", "injected", "sheared", "seeping")}

    def close(self, value, expected, *, scale=0.0, tolerance=1e-6):
        """Single precision: relative to the value, or to the largest of its kind."""
        self.assertLessEqual(abs(value - expected), tolerance * max(abs(expected), scale))

    def column(self, values, expected):
        self.assertEqual(len(values), len(expected))
        scale = max(map(abs, expected), default=0)
        for (value,), wanted in zip(values, expected):
            self.close(value, wanted, scale=scale)

    def test_every_array_has_its_name_its_unit_and_a_row_for_each_point_or_cell(self):
        for path in self.folder.glob("*/*.vtp"):
            mesh, expected = read(path), ARRAYS[path.name.split("_")[0]]
            on, off = mesh.on_points, mesh.on_cells
            count = len(mesh.points)
            cells = [mesh.vertices, mesh.lines, mesh.polygons]
            if path.name.startswith("particles"):
                self.assertEqual(cells, [[[k] for k in range(count)], [], []])
            else:
                own = 2 if path.name.startswith("pores") else 1
                on, off, count = off, on, len(cells.pop(own))
                self.assertEqual(cells, [[], []])
            self.assertEqual(off, {})
            self.assertEqual(set(on), set(expected))
            for name, rows in on.items():
                self.assertEqual(len(rows), count, name)
                self.assertTrue(all(len(row) == expected[name] for row in rows), name)
            self.assertTrue(all(z == 0 for _, _, z in mesh.points))

    def test_an_intact_array_carries_the_stress_that_holds_it(self):
        run = self.runs["intact"]
        arrays = run["particles"].on_points
        for stress, major, minor in zip(arrays[STRESS], arrays[MAJOR], arrays[MINOR]):
            for value, expected in zip(stress, [10e6, 0, 0, 0, 12e6, 0, 0, 0, 0]):
                self.close(value, expected, scale=10e6, tolerance=1e-5)
            self.close(major[0], 12e6, tolerance=1e-5)
            self.close(minor[0], 10e6, tolerance=1e-5)
        contacts = run["contacts"]
        self.assertEqual(len(contacts.lines), 9 * 8 + 10 * 7)
        for (a, b), (force,), (shear,), (moment,) in zip(
                contacts.lines, *(contacts.on_cells[n] for n in (NORMAL, "shear force (N/m)",
                                                                 "bond moment (N m/m)"))):
            self.close(force, (10e6 if b == a + 1 else 12e6) * 2 * RADIUS, tolerance=1e-5)
            self.assertLess(abs(shear), 1)
            self.assertLess(abs(moment), 1e-2)
        self.assertEqual({s for s, in contacts.on_cells[STATE]}, {0})
        self.assertEqual(run["cracks"].lines, [])

    def test_discs_and_contacts_are_those_of_the_run(self):
        for name, run in self.runs.items():
            rows, mesh = table(self.folder / name / "particles.csv"), run["particles"]
            self.assertEqual(len(mesh.points), len(rows))
            for point, moved, row in zip(mesh.points, mesh.on_points["displacement (m)"], rows):
                self.close(point[0], row["x"])
                self.close(point[1], row["y"])
                self.close(moved[0], row["dx"], scale=1e-6)
                self.close(moved[1], row["dy"], scale=1e-6)
                self.assertEqual(moved[2], 0)
            self.column(mesh.on_points["radius (m)"], [row["radius"] for row in rows])
            self.column(mesh.on_points["rotation (rad)"], [row["rotation"] for row in rows])

            rows, lines = table(self.folder / name / "contacts.csv"), run["contacts"]
            self.assertEqual(lines.points, mesh.points)
            self.assertEqual(lines.lines, [[row["first"], row["second"]] for row in rows])
            for array, column in ((NORMAL, "normal"), ("shear force (N/m)", "shear"),
                                  ("bond moment (N m/m)", "moment")):
                self.column(lines.on_cells[array], [row[column] for row in rows])
            self.assertEqual([s > 0 for s, in lines.on_cells[STATE]],
                             [row["open"] == 1 for row in rows])

    def facets(self, mesh):
        return [[mesh.points[end] for end in line] for line in mesh.lines]

    def test_cracks_are_the_broken_contacts_in_the_order_of_breaking(self):
        states = set()
        for name, run in self.runs.items():
            breaks, mesh = table(self.folder / name / "breaks.csv"), run["cracks"]
            facets, arrays = self.facets(mesh), mesh.on_cells
            preset = len(facets) - len(breaks)
            self.assertEqual(preset, 0 if name == "intact" else 4)
            times = arrays["time of break (s)"]
            self.assertEqual(arrays[STATE][:preset], preset * [(3,)])
            self.assertEqual(times[:preset], preset * [(0,)])
            self.column(times[preset:], [b["time_s"] for b in breaks])
            self.assertEqual([s for s, in arrays[STATE][preset:]],
                             [{"tension": 1, "shear": 2}[b["mode"]] for b in breaks])
            for (a, b), row in zip(facets[preset:], breaks):
                self.close((a[0] + b[0]) / 2, row["x_m"])
                self.close((a[1] + b[1]) / 2, row["y_m"])
                self.close(math.dist(a, b), row["length_m"], tolerance=1e-4)  # of coordinates
            # The same states on the contacts, and across them.
            contacts = run["contacts"]
            broken = [k for k, (s,) in enumerate(contacts.on_cells[STATE]) if s > 0]
            self.assertEqual(sorted(arrays[STATE]),
                             sorted(contacts.on_cells[STATE][k] for k in broken))
            middles = {k: self.middle([contacts.points[p] for p in contacts.lines[k]])
                       for k in broken}
            for facet, (state,) in zip(facets, arrays[STATE]):
                k = min(broken, key=lambda c: math.dist(middles[c], self.middle(facet)))
                a, b = (contacts.points[p] for p in contacts.lines[k])
                across = [p - q for p, q in zip(a, b)]
                along = [p - q for p, q in zip(*facet)]
                self.assertEqual(contacts.on_cells[STATE][k], (state,))
                self.assertLess(abs(sum(map(lambda p, q: p * q, across, along))), 1e-2 * RADIUS**2)
            states |= {s for s, in arrays[STATE]}
        self.assertEqual(states, {1, 2, 3})

    @staticmethod
    def middle(ends):
        return [(p + q) / 2 for p, q in zip(*ends)]

    def test_apertures_and_pressures_are_those_of_the_profile_and_dry_cracks_have_none(self):
        for name in ("injected", "sheared"):
            mesh, profile = self.runs[name]["cracks"], table(self.folder / name / "profile.csv")
            arrays, seen = mesh.on_cells, 0
            for facet, (width,), (pressure,), (wet,) in zip(
                    self.facets(mesh), *(arrays[n] for n in ("aperture (m)", "pressure (Pa)",
                                                             "wet (0 dry, 1 wet)"))):
                if not wet:
                    self.assertEqual((width, pressure), (0, 0))
                    continue
                seen += 1
                x, y, _ = self.middle(facet)
                row = min(profile, key=lambda p: math.hypot(p["x_m"] - x, p["y_m"] - y))
                self.assertLess(math.hypot(row["x_m"] - x, row["y_m"] - y), 1e-6)
                self.close(width, row["aperture_m"])
                self.close(pressure, row["pressure_Pa"])
            rows = table(self.folder / name / "contacts.csv")
            self.assertEqual(seen, len(profile))
            self.assertEqual(seen, sum(row["wet"] for row in rows))
            self.assertEqual(len(mesh.lines), sum(row["open"] for row in rows))
            if name == "sheared":  # else the check of dry cracks would say nothing
                self.assertLess(seen, len(mesh.lines))

    def test_pores_are_polygons_between_discs_where_fluid_flows_through_the_rock(self):
        self.assertEqual([p.parent.name for p in sorted(self.folder.glob("*/pores.pvd"))], ["seeping"])
        mesh = read(self.folder / "seeping" / "pores_0000.vtp")
        rows = table(self.folder / "seeping" / "pores.csv")
        self.assertEqual(mesh.points, self.runs["seeping"]["particles"].points)
        for name, column in (("pressure (Pa)", "pressure"), ("filling (1 full)", "filling"),
                             ("place (0 pore, 1 crack)", "in_crack")):
            self.column(mesh.on_cells[name], [row[column] for row in rows])
        self.assertEqual({row["in_crack"] for row in rows}, {0, 1})
        self.assertGreater(sum(row["pressure"] > 1e5 and not row["in_crack"] for row in rows), 5)
        inner = 0
        for polygon, row in zip(mesh.polygons, rows):
            corners = [mesh.points[p] for p in polygon]
            if len(corners) != 4:
                continue  # the rim
            inner += 1
            x, y = (sum(c[k] for c in corners) / 4 for k in (0, 1))
            self.assertLess(math.hypot(x - row["x"], y - row["y"]), 1e-2 * RADIUS)
            around = zip(corners, corners[1:] + corners[:1])
            area = sum(a[0] * b[1] - b[0] * a[1] for a, b in around) / 2
            self.close(area, 4 * RADIUS**2, tolerance=1e-2)  # counter-clockwise
        self.assertEqual(inner, 11 * 11)

    def test_the_lists_name_every_file_with_its_time(self):
        breaks = table(self.folder / "injected" / "breaks.csv")
        for kind in KINDS:
            root = xml.etree.ElementTree.parse(self.folder / "injected" / (kind + ".pvd")).getroot()
            self.assertEqual(root.get("type"), "Collection")
            steps = [(float(d.get("timestep")), d.get("file"))
                     for d in root.findall("Collection/DataSet")]
            self.assertEqual([time for time, _ in steps], [0, 0.002, 0.004, 0.006, 0.008, 0.0085])
            self.assertEqual(sorted(p.name for p in (self.folder / "injected").glob(kind + "_*")),
                             [file for _, file in steps])
            for time, file in steps:
                mesh = read(self.folder / "injected" / file)
                self.assertEqual(mesh.time, time)
                if kind == "cracks":
                    self.assertEqual(len(mesh.lines), 4 + sum(b["time_s"] <= time for b in breaks))
        self.assertGreater(len(breaks), 2)

    @unittest.skipUnless(READER == "vtk", "compares VTK with plain XML")
    def test_vtk_and_plain_xml_agree_on_every_number(self):
        for path in self.folder.glob("*/*.vtp"):
            mesh, plain = read(path), PlainXml(path)
            self.assertEqual(vars(mesh), {name: getattr(plain, name) for name in vars(mesh)})


if __name__ == "__main__":
    unittest.main()
