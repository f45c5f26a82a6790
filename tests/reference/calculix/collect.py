#!/usr/bin/env python3
"""collect.py NAME: the last increment of NAME.dat with the nodes of NAME.inp as node,X,Y,Z,ux,uy,uz on standard output."""
import sys

name = sys.argv[1]
nodes, reading = {}, False
for line in open(name + ".inp"):
    if line.startswith("*"):
        reading = line.startswith("*NODE,")
    elif reading:
        n, x, y, z = line.split(",")
        nodes[int(n)] = (float(x), float(y), float(z))
displacements, time = {}, 0.0
for line in open(name + ".dat"):
    words = line.split()
    if "time" in words:
        time = float(words[-1])
    elif len(words) == 4 and words[0].isdigit():
        displacements[int(words[0])] = words[1:]
assert abs(time - 1) < 1e-9, f"the run ended at {time}, not at 1"
print("node,X,Y,Z,ux,uy,uz")
for n, x in nodes.items():
    print(n - 1, *(f"{a:.9g}" for a in x), *displacements[n], sep=",")
