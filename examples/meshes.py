"""What the scripts of the examples have in common: tetrahedra of lattices and layers, and files of them.
Only Python's standard library. Points are tuples; elements and facets lists of point numbers."""
import itertools
import math


def cross(u, v):
    return tuple(u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3))


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def minus(u, v):
    return tuple(a - b for a, b in zip(u, v))


def unit(u):
    length = math.sqrt(dot(u, u))
    return tuple(a / length for a in u) if length else u


def between(p, q, share):
    return tuple(a + share * (b - a) for a, b in zip(p, q))


def upright(tetrahedron, X):
    """With the order of nodes that gives a positive volume."""
    a, b, c, d = (X[i] for i in tetrahedron)
    volume = dot(minus(b, a), cross(minus(c, a), minus(d, a)))
    return tetrahedron if volume > 0 else [tetrahedron[i] for i in (0, 1, 3, 2)]


def kuhn(n, octants=((1, -1), (1, -1), (1, -1))):
    """Tetrahedra of unit bricks (Kuhn 1960), mirrored into the octants of [-n, n]^3, as integer corners."""
    tetrahedra = []
    for signs in itertools.product(*octants):
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


def outer_facets(elements):
    """Facets of one tetrahedron only, seen anticlockwise from outside."""
    once = {}
    for a, b, c, d in elements:
        for facet in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)):
            key = tuple(sorted(facet))
            if key in once:
                del once[key]
            else:
                once[key] = facet
    return list(once.values())


def node_normals(facets, X):
    """Unit normals of the nodes of the facets, weighted by area."""
    sums = {}
    for facet in facets:
        a, b, c = (X[i] for i in facet)
        normal = cross(minus(b, a), minus(c, a))
        for i in facet:
            sums[i] = tuple(s + n for s, n in zip(sums.get(i, (0, 0, 0)), normal))
    return {i: unit(n) for i, n in sums.items()}


def layers(triangles, sheets):
    """Prisms between sheets of points over the same triangles, three tetrahedra each, whose faces match because they are cut
    from the lowest point number: all points and elements."""
    X = [p for sheet in sheets for p in sheet]
    up = len(sheets[0])
    elements = []
    for below in range(0, up * (len(sheets) - 1), up):
        for t in triangles:
            a, b, c = sorted(below + i for i in t)
            for tetrahedron in ([a, b, c, c + up], [a, b, b + up, c + up], [a, a + up, b + up, c + up]):
                elements.append(upright(tetrahedron, X))
    return X, elements


def rod(radii, tail, tip, rings, segments, centre=(0.0, 0.0)):
    """An elliptic cylinder along z, flat at its tail, with half an ellipsoid at its tip: points and facets."""
    caps, cap = max(2, rings // 3), min(radii)
    profile = [(1.0, tail + (tip - tail) * i / rings) for i in range(rings)]
    profile += [(math.cos(a), tip + cap * math.sin(a)) for a in (math.pi / 2 * i / caps for i in range(caps))]
    X = [(*centre, tail), (*centre, tip + cap)]
    for share, z in profile:
        for a in (2 * math.pi * j / segments for j in range(segments)):
            x, y = (c + r * share * f for c, r, f in zip(centre, radii, (math.cos(a), math.sin(a))))
            X.append((x, y, z))

    def at(i, j):
        return 2 + i * segments + j % segments

    facets = [(0, at(0, j + 1), at(0, j)) for j in range(segments)]
    facets += [(1, at(len(profile) - 1, j), at(len(profile) - 1, j + 1)) for j in range(segments)]
    for i in range(len(profile) - 1):
        for j in range(segments):
            facets += [(at(i, j), at(i, j + 1), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i + 1, j))]
    return X, facets


def write_vtk(path, X, cells, polygons=False):
    with open(path, "w") as out:
        out.write("# vtk DataFile Version 3.0\nan example of Glisson\nASCII\n")
        out.write(f"DATASET {'POLYDATA' if polygons else 'UNSTRUCTURED_GRID'}\nPOINTS {len(X)} double\n")
        out.writelines("%.9g %.9g %.9g\n" % tuple(p) for p in X)
        size = len(cells[0])
        out.write(f"{'POLYGONS' if polygons else 'CELLS'} {len(cells)} {len(cells) * (size + 1)}\n")
        out.writelines(f"{size} {' '.join(map(str, c))}\n" for c in cells)
        if not polygons:
            out.write(f"CELL_TYPES {len(cells)}\n" + "10\n" * len(cells))


def read_vtk(path):
    """Points and cells of a file that write_vtk wrote."""
    words = path.read_text().split()
    at = words.index("POINTS")
    count = int(words[at + 1])
    numbers = list(map(float, words[at + 3:at + 3 + 3 * count]))
    at = words.index("POLYGONS" if "POLYGONS" in words else "CELLS")
    cells = list(map(int, words[at + 3:at + 3 + int(words[at + 2])]))
    return list(zip(*[iter(numbers)] * 3)), [list(c[1:]) for c in zip(*[iter(cells)] * (cells[0] + 1))]
