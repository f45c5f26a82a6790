#!/usr/bin/env python3
"""A diaphragm over the liver: an offset of its upper surface, as a layer of tetrahedra.

    python3 make_diaphragm.py liver.vtk diaphragm.vtk [--gap 0.001] [--thickness 0.004] [--angle 65]

liver.vtk: as smooth_liver.py writes it. The upper surface are the facets whose outward normals lean less than the angle
from +z, the largest part of them that hangs together by edges. Lengths in the unit of the mesh.
"""
import argparse
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from meshes import cross, layers, minus, node_normals, outer_facets, read_vtk, unit, write_vtk

SMOOTHING = 20  # rounds in which normals become the mean of their neighbours', so that the offset does not fold
FLARE = (3, 2, 1)  # gaps by which the border and the next rows stand off more, so that no sharp edge cuts into the liver


def by_edges(facets):
    """Parts of the facets that hang together by edges."""
    at_edge = {}
    for k, facet in enumerate(facets):
        for i in range(3):
            at_edge.setdefault(frozenset((facet[i], facet[i - 1])), []).append(k)
    parts, seen = [], set()
    for start in range(len(facets)):
        part, stack = [], [start]
        while stack:
            k = stack.pop()
            if k in seen:
                continue
            seen.add(k)
            part.append(facets[k])
            for i in range(3):
                stack += at_edge[frozenset((facets[k][i], facets[k][i - 1]))]
        parts.append(part)
    return parts


def upper(facets, X, angle):
    def leans(facet):
        a, b, c = (X[i] for i in facet)
        return unit(cross(minus(b, a), minus(c, a)))[2] > math.cos(math.radians(angle))

    return max(by_edges([f for f in facets if leans(f)]), key=len)


def border(facets):
    """Edges of one facet only."""
    once = set()
    for facet in facets:
        for i in range(3):
            once ^= {frozenset((facet[i], facet[i - 1]))}
    return once


def without_teeth(facets):
    """Facets that hang on one edge make the border ragged; a few rounds suffice."""
    for _ in range(4):
        edges = border(facets)
        facets = [f for f in facets if sum(frozenset((f[i], f[i - 1])) in edges for i in range(3)) < 2]
    return max(by_edges(facets), key=len)


def gaps(facets):
    """How many gaps each node lies above the liver: one, and more near the border."""
    row = {i for edge in border(facets) for i in edge}
    lift = dict.fromkeys((i for f in facets for i in f), 1)
    done = set()
    for more in FLARE:
        lift.update((i, 1 + more) for i in row)
        done |= row
        row = {i for f in facets if done & set(f) for i in f} - done
    return lift


def smoothed(normals, facets):
    around = {}
    for facet in facets:
        for i in facet:
            around.setdefault(i, set()).update(facet)
    for _ in range(SMOOTHING):
        normals = {i: unit(tuple(map(sum, zip(*(normals[k] for k in near))))) for i, near in around.items()}
    return normals


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("liver", type=pathlib.Path)
    parser.add_argument("diaphragm", type=pathlib.Path)
    parser.add_argument("--gap", type=float, default=0.001, help="to the liver (default 0.001)")
    parser.add_argument("--thickness", type=float, default=0.004, help="(default 0.004)")
    parser.add_argument("--angle", type=float, default=65, help="[degrees] (default 65)")
    parser.add_argument("--layers", type=int, default=2, help="(default 2)")
    options = parser.parse_args()
    X, elements = read_vtk(options.liver)
    facets = outer_facets(elements)
    top = without_teeth(upper(facets, X, options.angle))
    lift = gaps(top)
    normals = smoothed(node_normals(facets, X), top)
    number = {i: k for k, i in enumerate(normals)}
    heights = [options.thickness * k / options.layers for k in range(options.layers + 1)]
    sheets = [[tuple(c + (h + lift[i] * options.gap) * n for c, n in zip(X[i], normals[i])) for i in normals]
              for h in heights]
    points, tetrahedra = layers([[number[i] for i in t] for t in top], sheets)
    write_vtk(options.diaphragm, points, tetrahedra)
    print(f"{options.diaphragm}: {len(points)} nodes, {len(tetrahedra)} tetrahedra")


if __name__ == "__main__":
    main()
