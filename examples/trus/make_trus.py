#!/usr/bin/env python3
"""A transrectal ultrasound probe presses a prostate in its surroundings (Johnsen 2016, section 5.5.6), with
parametric geometry of about the same size: an ellipsoid in a block that it can slide in, and a rigid probe.

    python3 make_trus.py FOLDER [--cells 8]

writes FOLDER/trus.xml and its meshes. 8 cells per half axis give 24,576 + 64,512 tetrahedra (the thesis: 22,705 +
64,316); the number grows with the cube of it. SI units. x: left-right, y: towards the rectum, z: along the probe.
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from meshes import between, kuhn, layers, on_sphere, outer_facets, rod, upright, write_vtk

AXES = (0.022, 0.017, 0.020)  # half axes of the prostate [m]
LOW, HIGH = (-0.034, -0.030, -0.034), (0.034, 0.034, 0.034)  # block [m]
LAYERS_PER_CELLS = 7 / 8  # layers of the block per cell of the prostate
RADIUS, TIP, TAIL, GAP = 0.009, 0.008, -0.045, 0.0005  # probe [m]


def ellipsoid(p, n):
    return tuple(a * c / n for a, c in zip(AXES, on_sphere(p)))


def prostate(n):
    """Points on the lattice of the cube and elements of the ellipsoid."""
    tetrahedra = kuhn(n)
    points = list(dict.fromkeys(p for t in tetrahedra for p in t))
    number = {p: i for i, p in enumerate(points)}
    X = [ellipsoid(p, n) for p in points]
    return points, X, [upright([number[p] for p in t], X) for t in tetrahedra]


def block(n, count, points, facets):
    """Layers between the ellipsoid and the box, over the facets of the ellipsoid."""
    outside = sorted({i for f in facets for i in f}, key=lambda i: points[i])
    number = {i: k for k, i in enumerate(outside)}
    inner = [ellipsoid(points[i], n) for i in outside]
    outer = [tuple(l + (h - l) * (c / n + 1) / 2 for l, h, c in zip(LOW, HIGH, points[i])) for i in outside]
    sheets = [[between(i, o, k / count) for i, o in zip(inner, outer)] for k in range(count + 1)]
    return layers([[number[i] for i in f] for f in facets], sheets)


MATERIAL = """<ElementSet Size="all"><Material Type="NH">
      <ElasticParams NumParams="2"> 1800 6900 </ElasticParams><Density> 1000 </Density></Material></ElementSet>"""

XML = """<?xml version="1.0"?>
<!-- Made by make_trus.py. The probe moves by (0, -11.5, 5) mm; left and right of the block are held. -->
<Model units="SI">
  <SubModel Name="prostate">
    <VTKMesh Type="T4"> prostate.vtk </VTKMesh>
    {material}
  </SubModel>
  <SubModel Name="surroundings">
    <VTKMesh Type="T4"> surroundings.vtk </VTKMesh>
    {material}
    <Constraint Type="Fix" DOF="all" SpecType="BOX"><Box> {left} {left_in} -1 1 -1 1 </Box></Constraint>
    <Constraint Type="Fix" DOF="all" SpecType="BOX"><Box> {right_in} {right} -1 1 -1 1 </Box></Constraint>
  </SubModel>
  <ContactSurface>
    <VTKSurface Type="T3"> probe.vtk </VTKSurface>
    <Motion Type="Translation"> 0 -0.0115 0.005 </Motion>
  </ContactSurface>
  <SystemParams>
    <TotalTime> {total} </TotalTime>
    <DampingCoeff> 20 </DampingCoeff>
    <DoDeformableCollision> 1 </DoDeformableCollision>
  </SystemParams>
</Model>
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--cells", type=int, default=8, help="per half axis of the prostate (default 8)")
    parser.add_argument("--time", type=float, default=0.3, help="of the motion [s] (default 0.3)")
    options = parser.parse_args()
    n = options.cells
    options.folder.mkdir(parents=True, exist_ok=True)
    points, X, elements = prostate(n)
    count = max(1, round(LAYERS_PER_CELLS * n))
    beside = (0.0, HIGH[1] + GAP + RADIUS)
    write_vtk(options.folder / "prostate.vtk", X, elements)
    write_vtk(options.folder / "surroundings.vtk", *block(n, count, points, outer_facets(elements)))
    write_vtk(options.folder / "probe.vtk", *rod((RADIUS, RADIUS), TAIL, TIP, 5 * n, 6 * n, beside), polygons=True)
    small = 1e-6
    (options.folder / "trus.xml").write_text(XML.format(
        material=MATERIAL, total=options.time, left=LOW[0] - small, left_in=LOW[0] + small,
        right_in=HIGH[0] - small, right=HIGH[0] + small))


if __name__ == "__main__":
    main()
