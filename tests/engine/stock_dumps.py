"""The host's dumps show shape and orientation: dump custom, custom/vtk (also of a group), and the
script of the page on ParaView makes the ellipsoids' axes of the latter.

Oracle: the data file that the engine has read. The page's script and filter run in VTK's Python layer,
on which ParaView's Programmable Filter is built; a build without VTK says that it lacks the style.
"""

import os
import re
import unittest
from pathlib import Path

import numpy as np

from _contact_rows import crowd, crowd_setup
from _engine import dump, host_is_inl, read_dump, rotation, run

FIELDS = "id type mass vx vy vz omegax omegay omegaz quat1 quat2 quat3 quat4 shapex shapey shapez"
AXES = (2.6e-3, 2.3e-3, 1.8e-3)
FIRST, LAST = 5, 12  # ids of the group
PAGE = Path(os.environ["ELLIPSOID_SOURCE"]) / "src_liggghts/doc/paraview.md"


def read_vtk(file):
    """Point arrays {name: (points, components)} of an ASCII legacy VTK file."""
    tokens = Path(file).read_text().split()
    arrays = {"points": (tokens.index("POINTS") + 3, 3)}
    at = tokens.index("FieldData") + 2
    count = int(tokens[tokens.index("POINTS") + 1])
    for _ in range(int(tokens[at - 1])):
        arrays[tokens[at]] = at + 4, int(tokens[at + 1])
        at += 4 + count * int(tokens[at + 1])
        if at < len(tokens) and tokens[at] == "METADATA":
            at = next(k for k in range(at, len(tokens)) if tokens[k] in FIELDS.split() + ["TENSOR"])
    return {name: np.array(tokens[start:start + count * width], float).reshape(count, width)
            for name, (start, width) in arrays.items()}


def simulate():
    script = crowd_setup("smooth").with_particles(crowd(AXES), "crowd.data")
    script += f"group some id <> {FIRST} {LAST}\n" + dump("all.dump")
    script += f"dump v some custom/vtk 1 some.*.vtk {FIELDS}\n"
    return script + "dump_modify v binary no\n" * host_is_inl()


class StockDumps(unittest.TestCase):
    def test_text_dump(self):
        run(simulate().split("dump v ")[0] + "run 0\n")
        _, columns = read_dump("all.dump")
        for k, particle in enumerate(crowd(AXES)):
            for names, expected in (("x y z", particle.position),
                                    ("shapex shapey shapez", particle.semiaxes),
                                    ("quat1 quat2 quat3 quat4", particle.quaternion),
                                    ("vx vy vz", particle.velocity), ("omegax omegay omegaz",
                                                                      particle.omega)):
                found = [columns[n][0, k] for n in names.split()]
                np.testing.assert_allclose(found, expected, rtol=1e-14, atol=1e-15)

    def test_vtk_dump_of_a_group(self):
        if os.environ["ELLIPSOID_VTK"] != "1":
            outcome = run(simulate() + "run 0\n", check=False)
            self.assertEqual(outcome.code, 1)
            self.assertIn("Unknown dump style 'custom/vtk'; correct it (those with 'vtk' need an engine built "
                          "with VTK)", outcome.text)
            return
        run(simulate() + "run 0\n")
        arrays = read_vtk("some.0.vtk")
        self.assertEqual(list(arrays["id"][:, 0]), list(range(FIRST, LAST + 1)))
        particles = crowd(AXES)[FIRST - 1:LAST]
        matrices = np.array([rotation(p.quaternion) for p in particles])
        np.testing.assert_allclose(arrays["TENSOR"].reshape(-1, 3, 3), matrices, atol=1e-10)
        np.testing.assert_allclose(arrays["points"], [p.position for p in particles], atol=1e-8)
        np.testing.assert_allclose(arrays["omega"], [p.omega for p in particles], rtol=1e-9)
        self.check_glyphs("some.0.vtk", particles, matrices)

    def check_glyphs(self, file, particles, matrices):
        """The page's script and tensor glyph: every glyph is the ellipsoid of its particle."""
        from vtkmodules.numpy_interface import dataset_adapter
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkFiltersCore import vtkTensorGlyph
        from vtkmodules.vtkFiltersSources import vtkSphereSource
        from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
        reader = vtkGenericDataObjectReader()
        reader.SetFileName(file)
        reader.Update()
        points = reader.GetOutput().NewInstance()
        points.CopyStructure(reader.GetOutput())
        script = re.search(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL).group(1)
        exec("\n".join(line[3:] for line in script.splitlines()),
             {"inputs": [dataset_adapter.WrapDataObject(reader.GetOutput())],
              "output": dataset_adapter.WrapDataObject(points)})
        points.GetPointData().SetActiveTensors("ellipsoid")
        sphere = vtkSphereSource()
        sphere.SetRadius(1.0)
        glyph = vtkTensorGlyph()
        glyph.SetSourceConnection(sphere.GetOutputPort())
        glyph.SetInputData(points)
        glyph.ExtractEigenvaluesOff()
        glyph.Update()
        surfaces = vtk_to_numpy(glyph.GetOutput().GetPoints().GetData()).reshape(
            len(particles), -1, 3)
        for surface, particle, matrix in zip(surfaces, particles, matrices):
            body = (surface - particle.position) @ matrix / particle.semiaxes
            np.testing.assert_allclose(np.linalg.norm(body, axis=1), 1.0, atol=1e-4)


if __name__ == "__main__":
    unittest.main(verbosity=2)
