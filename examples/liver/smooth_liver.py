#!/usr/bin/env python3
"""Tetrahedra with a smooth surface of one label of an image, for contact; `glisson mesh` leaves stairs.

    python3 smooth_liver.py liver.inr.gz liver.vtk [--label 255] [--cell 8] [--scale 0.001]

Isosurface stuffing (Labelle & Shewchuk 2007): a body-centred cubic lattice whose nodes near the surface move onto it;
what still crosses the surface is cut there. The surface is where half of the tissue in a window of about 8 mm has
the label: sharper edges are rounded. Reads INRIMAGE-4 with one byte per voxel.
"""
import argparse
import gzip
import itertools
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from meshes import between, outer_facets, upright, write_vtk

WINDOW = 4.0  # edge of the blocks that voxels are counted in [mm]
LONG, SHORT = 0.24999, 0.41189  # how near on its edges a node moves to the surface (table 1 of the paper)


class Share:
    """Share of the label around a point less a half, piecewise trilinear; lengths in mm."""

    def __init__(self, path, label):
        data = gzip.open(path).read()
        head = dict(line.split("=", 1) for line in data[:256].decode("latin1").split("\n") if "=" in line)
        if int(head["PIXSIZE"].split()[0]) != 8:
            raise SystemExit(f"{path}: only one byte per voxel is read")
        size = [int(head[k]) for k in ("XDIM", "YDIM", "ZDIM")]
        voxel = [float(head.get(k, 1)) for k in ("VX", "VY", "VZ")]
        step = [max(1, round(WINDOW / v)) for v in voxel]
        self.edge = [s * v for s, v in zip(step, voxel)]
        self.count = [-(-n // s) + 1 for n, s in zip(size, step)]
        self.value = self.corners(self.blocks(memoryview(data)[256:], size, step, label), step)

    def blocks(self, voxels, size, step, label):
        """Voxels with the label in each block."""
        counts = {}
        for z, y in itertools.product(range(size[2]), range(size[1])):
            row = bytes(voxels[(z * size[1] + y) * size[0]:(z * size[1] + y + 1) * size[0]])
            if label not in row:
                continue
            for x in range(0, size[0], step[0]):
                if n := row.count(label, x, x + step[0]):
                    key = (x // step[0], y // step[1], z // step[2])
                    counts[key] = counts.get(key, 0) + n
        return counts

    def corners(self, counts, step):
        """At the corners of the blocks: the mean of the eight blocks around."""
        whole = 8 * step[0] * step[1] * step[2]
        value = {}
        for block, n in counts.items():
            for shift in itertools.product((0, 1), repeat=3):
                corner = tuple(b + s for b, s in zip(block, shift))
                value[corner] = value.get(corner, -0.5) + n / whole
        return value

    def box(self):
        """Low and high corner of where the label is."""
        return [[f(c[axis] for c in self.value) * self.edge[axis] for axis in range(3)] for f in (min, max)]

    def __call__(self, p):
        place = [c / e for c, e in zip(p, self.edge)]
        low = [int(c // 1) for c in place]
        rest = [c - l for c, l in zip(place, low)]
        total = 0.0
        for shift in itertools.product((0, 1), repeat=3):
            weight = 1.0
            for r, s in zip(rest, shift):
                weight *= r if s else 1 - r
            total += weight * self.value.get(tuple(l + s for l, s in zip(low, shift)), -0.5)
        return total


class Stuffing:
    def __init__(self, share, cell):
        self.share, self.half = share, cell / 2
        low, high = share.box()
        self.low = [c - cell for c in low]
        counts = [int((h - l) / self.half) + 4 for l, h in zip(self.low, high)]
        self.X = {k: tuple(l + self.half * c for l, c in zip(self.low, k))
                  for k in itertools.product(*map(range, counts)) if k[0] % 2 == k[1] % 2 == k[2] % 2}
        self.value = {k: share(p) for k, p in self.X.items()}

    def cut(self, inside, outside):
        """Where the edge meets the surface, as share of the edge, by bisection."""
        p, q, low, high = self.X[inside], self.X[outside], 0.0, 1.0
        for _ in range(10):
            mid = (low + high) / 2
            low, high = (mid, high) if self.share(between(p, q, mid)) > 0 else (low, mid)
        return (low + high) / 2

    def warp(self):
        """Moves nodes that are near the surface onto it; keeps the cuts of the other edges."""
        edges = [(s, LONG) for s in ((2, 0, 0), (0, 2, 0), (0, 0, 2))]
        edges += [((1, y, z), SHORT) for y in (1, -1) for z in (1, -1)]
        cuts, nearest = {}, {}
        for a in self.X:
            for shift, near in edges:
                b = tuple(i + s for i, s in zip(a, shift))
                if b not in self.X or (self.value[a] > 0) == (self.value[b] > 0):
                    continue
                pair = (a, b) if self.value[a] > 0 else (b, a)
                at = self.cut(*pair)
                cuts[pair] = point = between(self.X[pair[0]], self.X[pair[1]], at)
                for node, way in zip(pair, (at, 1 - at)):
                    length = way * (1 if near == LONG else 3 ** 0.5 / 2)
                    if way < near and length < nearest.get(node, (2, None))[0]:
                        nearest[node] = (length, point)
        for node, (_, point) in nearest.items():
            self.X[node], self.value[node] = point, 0.0
        self.cuts = {pair: p for pair, p in cuts.items() if pair[0] not in nearest and pair[1] not in nearest}

    def lattice(self):
        """Its tetrahedra: an edge between centres of neighbouring cubes and one edge of their common face."""
        for a in self.X:
            if a[0] % 2 == 0:
                continue
            for axis in range(3):
                b = tuple(c + (2 if k == axis else 0) for k, c in enumerate(a))
                ring = []
                for one, two in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
                    shift = [1, 1, 1]
                    shift[axis - 1], shift[axis - 2] = one, two
                    ring.append(tuple(c + s for c, s in zip(a, shift)))
                if b in self.X and all(r in self.X for r in ring):
                    for k in range(4):
                        yield a, b, ring[k], ring[k - 1]

    def mesh(self):
        self.warp()
        number, X = {}, []

        def named(key):
            if key not in number:
                number[key] = len(X)
                X.append(self.cuts[key] if key in self.cuts else self.X[key])
            return number[key]

        elements = []
        for corners in self.lattice():
            inside = [k for k in corners if self.value[k] > 0]
            if inside:
                on = [named(k) for k in corners if self.value[k] == 0]
                outside = [k for k in corners if self.value[k] < 0]
                elements += clipped([named(k) for k in inside], on, [[named((i, o)) for o in outside] for i in inside])
        return X, [upright(e, X) for e in elements]


def clipped(inside, on, cuts):
    """The part of a tetrahedron that lies inside. cuts: of each node inside, those of its edges to the nodes outside.
    Quadrilaterals are cut from the lowest number, so that neighbours agree (Dompierre et al. 1999)."""
    if len(inside) == 1 or not cuts[0]:
        return [inside + on + cuts[0]]
    if len(inside) == 3:
        return prism(inside, [c[0] for c in cuts])
    if len(on) == 1:
        quad = [inside[0], inside[1], cuts[1][0], cuts[0][0]]
        return [t + on for t in halves(*quad)]
    return prism([inside[0]] + cuts[0], [inside[1]] + cuts[1])


def halves(a, b, c, d):
    return [[a, b, c], [a, c, d]] if min(a, b, c, d) in (a, c) else [[a, b, d], [b, c, d]]


def prism(a, b):
    """Tetrahedra between two triangles."""
    if min(b) < min(a):
        a, b = b, a
    k = a.index(min(a))
    a, b = a[k:] + a[:k], b[k:] + b[:k]
    return [[a[0], *b]] + [[a[0], *t] for t in halves(a[1], a[2], b[2], b[1])]


def largest_piece(X, elements):
    """The largest part that hangs together by nodes, without unused points."""
    root = list(range(len(X)))

    def find(i):
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i

    for e in elements:
        for i in e[1:]:
            root[find(i)] = find(e[0])
    sizes = {}
    for e in elements:
        sizes[find(e[0])] = sizes.get(find(e[0]), 0) + 1
    most = max(sizes, key=sizes.get)
    kept = [e for e in elements if find(e[0]) == most]
    used = sorted({i for e in kept for i in e})
    number = {old: new for new, old in enumerate(used)}
    return [X[i] for i in used], [[number[i] for i in e] for e in kept]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", type=pathlib.Path)
    parser.add_argument("mesh", type=pathlib.Path)
    parser.add_argument("--label", type=int, default=255, help="(default 255)")
    parser.add_argument("--cell", type=float, default=8, help="edge of the lattice's cubes [mm] (default 8)")
    parser.add_argument("--scale", type=float, default=0.001, help="of the coordinates (default 0.001: metres)")
    options = parser.parse_args()
    X, elements = largest_piece(*Stuffing(Share(options.image, options.label), options.cell).mesh())
    write_vtk(options.mesh, [tuple(options.scale * c for c in p) for p in X], elements)
    print(f"{options.mesh}: {len(X)} nodes, {len(elements)} tetrahedra, {len(outer_facets(elements))} facets outside")


if __name__ == "__main__":
    main()
