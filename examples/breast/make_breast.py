#!/usr/bin/env python3
"""A breast under gravity in a skin that slides on it (after Johnsen 2016, section 5.5.6), with parametric geometry: half an
ellipsoid on the chest wall, and a layer of its own around it that is held along its border on the chest wall.

    python3 make_breast.py FOLDER [--cells 12]

writes FOLDER/breast.xml, FOLDER/bare.xml (the same without skin) and their meshes. 12 cells per half axis give 41,472
tetrahedra of breast (the thesis: 37,613) and 20,736 of skin; the numbers grow with its cube and square. With --skin shell
the skin is a shell of 3,456 triangles (the thesis: 4,425) on its middle.
SI units. x: left-right, y: towards the head, z: away from the chest wall.
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from meshes import kuhn, layers, on_sphere, outer_facets, upright, write_vtk

AXES = (0.075, 0.075, 0.065)  # half axes of the breast [m]
GAP, THICKNESS, SHEETS = 0.0005, 0.005, 2  # between breast and skin, of the skin [m]; elements through the skin


def ellipsoid(p, n, more=0.0):
    return tuple((a + more) * c / n for a, c in zip(AXES, on_sphere(p)))


def breast(n):
    """Points on the lattice of half a cube and elements of half an ellipsoid."""
    tetrahedra = kuhn(n, ((1, -1), (1, -1), (1,)))
    points = list(dict.fromkeys(p for t in tetrahedra for p in t))
    number = {p: i for i, p in enumerate(points)}
    X = [ellipsoid(p, n) for p in points]
    return points, X, [upright([number[p] for p in t], X) for t in tetrahedra]


def dome(n, points, elements):
    """Facets away from the chest wall, with the points of them numbered anew, and sheets over them by their distance."""
    facets = [f for f in outer_facets(elements) if any(points[i][2] > 0 for i in f)]
    used = sorted({i for f in facets for i in f})
    number = {i: k for k, i in enumerate(used)}
    return [tuple(number[i] for i in f) for f in facets], lambda off: [ellipsoid(points[i], n, off) for i in used]


GRAVITY = """<Constraint Type="Gravity" LoadShape="POLY345" EndTime="1" NumNodes="all">
    <AccelerationMagnitude> 9.81 </AccelerationMagnitude>
    <AccelerationDirection> 0 -0.866 -0.5 </AccelerationDirection>
  </Constraint>"""

WALL = """<Constraint Type="Fix" DOF="all" SpecType="BOX"> <Box> -1 1  -1 1  -1e-6 1e-6 </Box> </Constraint>"""

BREAST = f"""<SubModel Name="breast">
    <VTKMesh Type="T4"> breast.vtk </VTKMesh>
    <!-- Stiffer away from the chest wall: Johnsen 2016, section 5.5.6. -->
    <ElementSet Size="all"><Material Type="TI">
      <ElasticParams NumParams="6"> 3570 16670 37710  0 0 1 </ElasticParams></Material></ElementSet>
    {WALL}
  </SubModel>"""

SKIN = f"""<SubModel Name="skin">
    <VTKMesh Type="T4"> skin.vtk </VTKMesh>
    <!-- E = 25 kPa, nu = 0.4 (the same section) as shear and bulk modulus. -->
    <ElementSet Size="all"><Material Type="NH">
      <ElasticParams NumParams="2"> 8929 41667 </ElasticParams></Material></ElementSet>
    {WALL}
  </SubModel>"""

SHELL = f"""<SubModel Name="skin">
    <ShellElements Type="FILE"> skin.vtk </ShellElements>
    <!-- Young's modulus and Poisson's ratio of the membrane and of bending: the same section. -->
    <ShellElementSet Size="all">
      <Material Type="LinearShell"> 25000 0.4  5000 0.25 <Thickness> {THICKNESS} </Thickness></Material>
      <ClampedNodes> <Box> -1 1  -1 1  -1e-6 1e-6 </Box> </ClampedNodes>
    </ShellElementSet>
    {WALL}
  </SubModel>"""

CONTACT = """
    <DoDeformableCollision> 1 </DoDeformableCollision>
    <DeformableFrictionCoefficient> 0.1 </DeformableFrictionCoefficient>"""

XML = """<?xml version="1.0"?>
<!-- Made by make_breast.py. The patient sits and leans back by 30 degrees. -->
<Model units="SI">
  {bodies}
  {gravity}
  <Output Freq="2000"/>
  <SystemParams>
    <TotalTime> {total} </TotalTime>
    <DampingCoeff> 40 </DampingCoeff>
    <Density> 1000 </Density>{contact}
  </SystemParams>
</Model>
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--cells", type=int, default=12, help="per half axis (default 12)")
    parser.add_argument("--skin", choices=("solid", "shell"), default="solid", help="(default solid)")
    parser.add_argument("--time", type=float, default=1.5, help="of the simulation [s] (default 1.5)")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    points, X, elements = breast(options.cells)
    write_vtk(options.folder / "breast.vtk", X, elements)
    facets, sheet = dome(options.cells, points, elements)
    shell = options.skin == "shell"
    if shell:
        write_vtk(options.folder / "skin.vtk", sheet(GAP + THICKNESS / 2), facets, polygons=True)
    else:
        sheets = [sheet(GAP + THICKNESS * k / SHEETS) for k in range(SHEETS + 1)]
        write_vtk(options.folder / "skin.vtk", *layers(facets, sheets))
    for name, bodies, contact in (("breast", BREAST + "\n  " + (SHELL if shell else SKIN), CONTACT), ("bare", BREAST, "")):
        (options.folder / f"{name}.xml").write_text(
            XML.format(bodies=bodies, gravity=GRAVITY, contact=contact, total=options.time))


if __name__ == "__main__":
    main()
