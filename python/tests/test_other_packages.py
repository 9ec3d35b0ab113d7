# SPDX-License-Identifier: Apache-2.0
"""Objects of other packages themselves; test_show.py has stand-ins. MDAnalysis is tried where it is installed: it is large."""

import importlib.util
import io

import numpy as np
import pytest

import glint

WATER = "3\n\nO 0 0 0\nH 0.96 0 0\nH -0.24 0.93 0\n"


def seen(item, **options):
    """The shapes of a picture that shows something."""
    scene = glint.show(item, size=(40, 30), background="black", **options)
    assert scene.render().array.max() > 0.1
    return scene.shapes


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("package", ["ase", "openbabel", *(["MDAnalysis"] if importlib.util.find_spec("MDAnalysis") else [])])
def test_water(package):
    module = pytest.importorskip(package)
    if package == "ase":
        from ase.io import read

        item = read(io.StringIO(WATER), format="xyz")
        with pytest.raises(TypeError, match="cannot add 'Atom'"):
            glint.show(item[0])
    elif package == "openbabel":
        from openbabel import pybel

        item = pybel.readstring("xyz", WATER)
        assert len(seen(item.OBMol)) == 5
        with pytest.raises(ValueError, match="make3D"):
            glint.show(pybel.readstring("smi", "CCO"))
    else:
        item = module.Universe(io.StringIO(WATER), format="XYZ", topology_format="XYZ")
        assert len(seen(item.select_atoms("name H"), bonds=False)) == 2
    shapes = seen(item)
    assert len(shapes) == 5 and shapes[0].color.r > 0.9 and shapes[1].color == (1, 1, 1)


@pytest.mark.filterwarnings("ignore")
def test_meshes_of_meshio(tmp_path):
    meshio = pytest.importorskip("meshio")
    points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1.0)])
    for name, cells, count in (("a.vtk", [("triangle", [(0, 1, 2), (0, 1, 3)])], 2), ("b.vtk", [("tetra", [(0, 1, 2, 3)])], 4)):
        cells = [(kind, np.array(data)) for kind, data in cells]
        meshio.write(tmp_path / name, meshio.Mesh(points, cells, point_data={"T": np.arange(4.0)}))
        mesh = meshio.read(tmp_path / name)
        assert len(seen(mesh)) == count
        pytest.importorskip("matplotlib")
        seen(mesh, values=np.arange(count), colormap="plasma")
    square = np.pad([(0.0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (2, 1)], ((0, 0), (0, 1)))
    cells = [("quad", np.array([(0, 1, 4, 3), (1, 2, 5, 4)]))]
    meshio.write(tmp_path / "c.vtk", meshio.Mesh(square, cells, cell_data={"p": [np.array([1.0, 2.0])]}))
    mesh = meshio.read(tmp_path / "c.vtk")
    shapes = seen(mesh, values=mesh.cell_data["p"][0], colormap="plasma")
    assert shapes[0].color == shapes[1].color != shapes[2].color == shapes[3].color
