"""Simulation files that the tests of the command line write."""
import math


def box(n, total=0.5, damping=10, output=0, extra="", element="H8", system=""):
    """A cube of 10 cm in n^3 hexahedra, held at the bottom, pushed on top. SI units."""
    nodes, elements = [], []
    number = lambda i, j, k: (k * (n + 1) + j) * (n + 1) + i
    for k in range(n + 1):
        for j in range(n + 1):
            for i in range(n + 1):
                nodes.append(f"{0.1 * i / n:.9g} {0.1 * j / n:.9g} {0.1 * k / n:.9g}")
    for k in range(n):
        for j in range(n):
            for i in range(n):
                low = [number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k)]
                elements.append(" ".join(map(str, low + [a + (n + 1) ** 2 for a in low])))
    bottom = " ".join(str(number(i, j, 0)) for j in range(n + 1) for i in range(n + 1))
    top = " ".join(str(number(i, j, n)) for j in range(n + 1) for i in range(n + 1))
    count = (n + 1) ** 2
    text = "\n".join(nodes)
    connectivity = "\n".join(elements)
    frequency = f'<Output Freq="{output}"><Variable>U</Variable></Output>' if output else ""
    return f"""<?xml version="1.0"?>
<Model units="SI">
<Nodes NumNodes="{len(nodes)}" DOF="3">
{text}
</Nodes>
<Elements NumEls="{len(elements)}" Type="{element}">
{connectivity}
</Elements>
<ElementSet Size="all">
<Material Type="NH"><ElasticParams NumParams="2"> 2000 20000 </ElasticParams></Material>
</ElementSet>
<Constraint Type="Fix" DOF="all" NumNodes="{count}"><Nodes> {bottom} </Nodes></Constraint>
<Constraint Type="Disp" DOF="2" LoadShape="POLY345" NumNodes="{count}"><Nodes> {top} </Nodes>
<Magnitudes Type="UNIFORM"> -0.01 </Magnitudes></Constraint>
{extra}{frequency}
<SystemParams><TotalTime> {total} </TotalTime><DampingCoeff> {damping} </DampingCoeff><Density> 1000 </Density>
<HGKappa> 0.075 </HGKappa>{system}</SystemParams>
</Model>
"""


def ball(radius, x, y, z, parts=12):
    """A sphere of triangles facing outwards: the nodes and the elements of a ContactSurface."""
    nodes, facets = [(x, y, z - radius)], []
    ring = lambda i, j: 1 + (i - 1) * parts + j % parts
    for i in range(1, parts):
        for j in range(parts):
            tilt, turn = math.pi * i / parts, 2 * math.pi * j / parts
            nodes.append((x + radius * math.sin(tilt) * math.cos(turn), y + radius * math.sin(tilt) * math.sin(turn),
                          z - radius * math.cos(tilt)))
    nodes.append((x, y, z + radius))
    for j in range(parts):
        facets += [(0, ring(1, j + 1), ring(1, j)), (len(nodes) - 1, ring(parts - 1, j), ring(parts - 1, j + 1))]
        for i in range(1, parts - 1):
            a, b, c, d = ring(i, j), ring(i, j + 1), ring(i + 1, j + 1), ring(i + 1, j)
            facets += [(a, b, c), (a, c, d)]
    text = lambda rows: "\n".join(" ".join(f"{v:.9g}" for v in row) for row in rows)
    return (f'<Nodes NumNodes="{len(nodes)}">{text(nodes)}</Nodes>'
            f'<Elements NumEls="{len(facets)}" Type="T3">{text(facets)}</Elements>')


def pressed_plate(n=10, thickness=0.004):
    """A plate of 10 cm in n^2 fields, clamped at x = 0, that a ball of triangles presses down and a cylinder supports."""
    nodes = "\n".join(f"{0.1 * i / n:.9g} {0.1 * j / n:.9g} 0" for j in range(n + 1) for i in range(n + 1))
    number = lambda i, j: j * (n + 1) + i
    quads = "\n".join(f"{number(i, j)} {number(i + 1, j)} {number(i + 1, j + 1)} {number(i, j + 1)}"
                      for j in range(n) for i in range(n))
    held = " ".join(str(number(0, j)) for j in range(n + 1))
    return f"""<?xml version="1.0"?>
<Model units="SI">
<Nodes NumNodes="{(n + 1) ** 2}" DOF="3">
{nodes}
</Nodes>
<ShellElements Type="Q4" NumEls="{n * n}">
{quads}
</ShellElements>
<ShellElementSet Size="all"><Material Type="LinearShell"> 100000 0.3 100000 0.3
<Density> 1000 </Density> <Thickness> {thickness} </Thickness></Material>
<ClampedNodes> {held} </ClampedNodes></ShellElementSet>
<Constraint Type="Fix" NumNodes="{n + 1}"><Nodes> {held} </Nodes></Constraint>
<ContactSurface>{ball(0.02, 0.075, 0.05, 0.0225)}
<Motion Type="Translation" LoadShape="POLY345"> 0 0 -0.02 </Motion></ContactSurface>
<ContactCylinder><Origin> 0.03 -0.01 -0.0105 </Origin><Axis> 0 1 0 </Axis><Radius> 0.01 </Radius><Length> 0.12 </Length>
<OrigDisp> 0 0 0 </OrigDisp><RadChange> 0 </RadChange></ContactCylinder>
<SystemParams><TotalTime> 0.4 </TotalTime><DampingCoeff> 20 </DampingCoeff></SystemParams>
</Model>
"""
