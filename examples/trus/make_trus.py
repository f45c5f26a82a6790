#!/usr/bin/env python3
"""A transrectal ultrasound probe presses a prostate in its surroundings (Johnsen 2016, section 5.5.6), with
parametric geometry of about the same size: an ellipsoid in a block that it can slide in, and a rigid probe.

    python3 make_trus.py FOLDER [--cells 8]

writes FOLDER/trus.xml and its meshes. 8 cells per half axis give 24,576 + 64,512 tetrahedra (the thesis: 22,705 +
64,316); the number grows with the cube of it. SI units. x: left-right, y: towards the rectum, z: along the probe.
"""
import argparse
import itertools
import math
import pathlib

AXES = (0.022, 0.017, 0.020)  # half axes of the prostate [m]
LOW, HIGH = (-0.034, -0.030, -0.034), (0.034, 0.034, 0.034)  # block [m]
LAYERS_PER_CELLS = 7 / 8  # layers of the block per cell of the prostate
RADIUS, TIP, TAIL, GAP = 0.009, 0.008, -0.045, 0.0005  # probe [m]


def kuhn(n):
    """Tetrahedra of a cube [-n, n]^3 of unit bricks, mirrored in its octants, on integer corners."""
    tetrahedra = []
    for signs in itertools.product((1, -1), repeat=3):
        for corner in itertools.product(range(n), repeat=3):
            for order in itertools.permutations(range(3)):
                point = list(corner)
                points = [tuple(point)]
                for axis in order:
                    point[axis] += 1
                    points.append(tuple(point))
                tetrahedra.append([tuple(s * c for s, c in zip(signs, p)) for p in points])
    return tetrahedra


def on_sphere(p):
    """Shells of the cube become spheres; equal angles on its faces keep the triangles alike."""
    shell = max(map(abs, p))
    if shell == 0:
        return (0.0, 0.0, 0.0)
    bent = [math.tan(c / shell * math.pi / 4) for c in p]
    length = math.sqrt(sum(c * c for c in bent))
    return tuple(shell * c / length for c in bent)


def upright(tetrahedron, X):
    a, b, c, d = (X[i] for i in tetrahedron)
    u, v, w = ([q - p for p, q in zip(a, e)] for e in (b, c, d))
    volume = sum(u[i] * (v[(i + 1) % 3] * w[(i + 2) % 3] - v[(i + 2) % 3] * w[(i + 1) % 3]) for i in range(3))
    return tetrahedron if volume > 0 else [tetrahedron[i] for i in (0, 1, 3, 2)]


def prostate(n):
    number, X, elements = {}, [], []
    for tetrahedron in kuhn(n):
        for p in tetrahedron:
            if p not in number:
                number[p] = len(X)
                X.append(tuple(a * c / n for a, c in zip(AXES, on_sphere(p))))
        elements.append(upright([number[p] for p in tetrahedron], X))
    surface = {}
    for tetrahedron in kuhn(n):
        for face in itertools.combinations(tetrahedron, 3):
            if any(all(abs(p[axis]) == n and p[axis] == face[0][axis] for p in face) for axis in range(3)):
                surface[tuple(sorted(face))] = face
    return X, elements, list(surface)


def block(n, layers, triangles):
    """Prisms between the ellipsoid and the box over the triangles of the ellipsoid, three tetrahedra each."""
    points = sorted({p for t in triangles for p in t})
    number = {p: i for i, p in enumerate(points)}
    X = []
    for layer in range(layers + 1):
        r = layer / layers
        for p in points:
            inner = [a * c / n for a, c in zip(AXES, on_sphere(p))]
            outer = [l + (h - l) * (c / n + 1) / 2 for l, h, c in zip(LOW, HIGH, p)]
            X.append(tuple((1 - r) * i + r * o for i, o in zip(inner, outer)))
    elements = []
    for layer in range(layers):
        for t in triangles:
            a, b, c = sorted(number[p] + layer * len(points) for p in t)
            up = len(points)
            for tetrahedron in ([a, b, c, c + up], [a, b, b + up, c + up], [a, a + up, b + up, c + up]):
                elements.append(upright(tetrahedron, X))
    return X, elements


def probe(rings, segments):
    """A cylinder with a half sphere at its tip, beside the block."""
    y = HIGH[1] + GAP + RADIUS
    profile = [(RADIUS, TAIL + (TIP - TAIL) * i / rings) for i in range(rings)]
    caps = max(2, rings // 3)
    profile += [(RADIUS * math.cos(a), TIP + RADIUS * math.sin(a)) for a in
                (math.pi / 2 * i / caps for i in range(caps))]
    X = [(0.0, y, TAIL), (0.0, y, TIP + RADIUS)]
    for r, z in profile:
        X += [(r * math.cos(2 * math.pi * j / segments), y + r * math.sin(2 * math.pi * j / segments), z)
              for j in range(segments)]
    at = lambda i, j: 2 + i * segments + j % segments
    facets = [(0, at(0, j + 1), at(0, j)) for j in range(segments)]
    facets += [(1, at(len(profile) - 1, j), at(len(profile) - 1, j + 1)) for j in range(segments)]
    for i in range(len(profile) - 1):
        for j in range(segments):
            facets += [(at(i, j), at(i, j + 1), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i + 1, j))]
    return X, facets


def write_vtk(path, X, cells, polygons=False):
    with open(path, "w") as out:
        out.write("# vtk DataFile Version 3.0\nTRUS example\nASCII\n")
        out.write(f"DATASET {'POLYDATA' if polygons else 'UNSTRUCTURED_GRID'}\nPOINTS {len(X)} double\n")
        out.writelines("%.9g %.9g %.9g\n" % p for p in X)
        size = len(cells[0])
        out.write(f"{'POLYGONS' if polygons else 'CELLS'} {len(cells)} {len(cells) * (size + 1)}\n")
        out.writelines(f"{size} {' '.join(map(str, c))}\n" for c in cells)
        if not polygons:
            out.write(f"CELL_TYPES {len(cells)}\n" + "10\n" * len(cells))


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
    X, elements, triangles = prostate(n)
    write_vtk(options.folder / "prostate.vtk", X, elements)
    write_vtk(options.folder / "surroundings.vtk", *block(n, max(1, round(LAYERS_PER_CELLS * n)), triangles))
    write_vtk(options.folder / "probe.vtk", *probe(5 * n, 6 * n), polygons=True)
    small = 1e-6
    (options.folder / "trus.xml").write_text(XML.format(
        material=MATERIAL, total=options.time, left=LOW[0] - small, left_in=LOW[0] + small,
        right_in=HIGH[0] - small, right=HIGH[0] + small))


if __name__ == "__main__":
    main()
