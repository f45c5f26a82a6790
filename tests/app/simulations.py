"""Simulation files that the tests of the command line write."""


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
