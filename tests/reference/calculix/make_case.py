#!/usr/bin/env python3
"""Writes the CalculiX input of the static reference: a neo-Hookean block, one end clamped, pulled sideways at the other.

CalculiX's *HYPERELASTIC, NEO HOOKE has W = C10 (I1bar - 3) + (J - 1)^2 / D1, the law NH with mu = 2 C10, kappa = 2 / D1.
C3D4 is the linear tetrahedron with one point: the same discrete equations as T4, so nodal displacements must agree.
C3D20R on a finer mesh is the converged solution that the better elements must approach.

  make_case.py tet 6 2 2  > block_c3d4.inp      ccx block_c3d4
  make_case.py hex20 12 4 4 > block_c3d20r.inp  ccx block_c3d20r
  make_case.py hex20 12 4 4 100000 > block_c3d20r_incompressible.inp  ccx block_c3d20r_incompressible
The displacements at the end of the .dat file are kept beside it as NAME.displacements.csv (node, X, u).
"""
import itertools
import sys

LENGTH, MU, FORCE = (0.06, 0.02, 0.02), 1000.0, 0.03  # m, Pa, N
KAPPA = float(sys.argv[5]) if len(sys.argv) > 5 else 5000.0  # Pa


def grid(cells):
    nx, ny, nz = cells
    nodes, index = [], {}
    for k, j, i in itertools.product(range(nz + 1), range(ny + 1), range(nx + 1)):
        index[i, j, k] = len(nodes)
        nodes.append(tuple(L * a / n for L, a, n in zip(LENGTH, (i, j, k), cells)))
    return nodes, index


def tetrahedra(cells):
    """Six Kuhn tetrahedra per cell, positively oriented."""
    nodes, index = grid(cells)
    elements = []
    for k, j, i in itertools.product(range(cells[2]), range(cells[1]), range(cells[0])):
        for order in itertools.permutations(range(3)):
            corner, path = [i, j, k], [index[i, j, k]]
            for axis in order:
                corner[axis] += 1
                path.append(index[tuple(corner)])
            even = order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
            elements.append(path if even else [path[0], path[2], path[1], path[3]])
    return nodes, elements


def bricks20(cells):
    fine = tuple(2 * n for n in cells)
    nodes, index = grid(fine)
    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
    middles = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    local = corners + [tuple((a + b) // 2 for a, b in zip(corners[p], corners[q])) for p, q in middles]
    elements = []
    for k, j, i in itertools.product(range(cells[2]), range(cells[1]), range(cells[0])):
        elements.append([index[2 * i + a, 2 * j + b, 2 * k + c] for a, b, c in local])
    used = sorted({n for e in elements for n in e})
    new = {old: n for n, old in enumerate(used)}
    return [nodes[n] for n in used], [[new[n] for n in e] for e in elements]


def end_forces(nodes):
    """The total force shared among the nodes of the end face by their tributary area (trapezoid weights on the grid)."""
    end = [n for n, x in enumerate(nodes) if abs(x[0] - LENGTH[0]) < 1e-12]
    ys, zs = sorted({nodes[n][1] for n in end}), sorted({nodes[n][2] for n in end})
    weight = {n: (0.5 if nodes[n][1] in (ys[0], ys[-1]) else 1) * (0.5 if nodes[n][2] in (zs[0], zs[-1]) else 1) for n in end}
    total = sum(weight.values())
    return {n: FORCE * w / total for n, w in weight.items()}


def lines(values, per_line=8):
    for start in range(0, len(values), per_line):
        last = start + per_line >= len(values)
        yield ", ".join(str(v) for v in values[start:start + per_line]) + ("" if last else ",")


def main():
    kind, cells = sys.argv[1], tuple(int(a) for a in sys.argv[2:5])
    nodes, elements = tetrahedra(cells) if kind == "tet" else bricks20(cells)
    print("*NODE, NSET=ALL")
    for n, x in enumerate(nodes, 1):
        print(f"{n}, {x[0]:.15g}, {x[1]:.15g}, {x[2]:.15g}")
    print(f"*ELEMENT, TYPE={'C3D4' if kind == 'tet' else 'C3D20R'}, ELSET=BLOCK")
    for e, its in enumerate(elements, 1):
        print("\n".join(lines([e] + [n + 1 for n in its])))
    print("*NSET, NSET=CLAMP")
    print("\n".join(lines([n + 1 for n, x in enumerate(nodes) if x[0] == 0])))
    print(f"*MATERIAL, NAME=NH\n*HYPERELASTIC, NEO HOOKE\n{MU / 2:.15g}, {2 / KAPPA:.15g}")
    print("*SOLID SECTION, ELSET=BLOCK, MATERIAL=NH")
    print("*STEP, NLGEOM, INC=1000\n*STATIC\n0.1, 1.0")
    print("*BOUNDARY\nCLAMP, 1, 3\n*CONTROLS, PARAMETERS=FIELD\n1e-9, 1e-9, , , , , , \n*CLOAD")
    for n, f in sorted((end_forces(nodes) if kind == "tet" else end_forces_quadratic(nodes, cells)).items()):
        print(f"{n + 1}, 3, {f:.15g}")
    print("*NODE PRINT, NSET=ALL\nU\n*END STEP")


def end_forces_quadratic(nodes, cells):
    """Consistent loads of a uniform traction on 8-node faces: corners -1/12, edge middles 1/3 of a face."""
    load = {}
    where = {tuple(round(c / (L / (2 * n))) for c, L, n in zip(x, LENGTH, cells)): k for k, x in enumerate(nodes)}
    share = FORCE / (cells[1] * cells[2])
    for j, k in itertools.product(range(cells[1]), range(cells[2])):
        for b, c in itertools.product(range(3), range(3)):
            if (b, c) == (1, 1):
                continue
            weight = 1 / 3 if 1 in (b, c) else -1 / 12
            n = where[2 * cells[0], 2 * j + b, 2 * k + c]
            load[n] = load.get(n, 0) + share * weight
    return load


if __name__ == "__main__":
    main()
