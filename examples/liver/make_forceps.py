#!/usr/bin/env python3
"""One jaw of a pair of forceps, along +z with its hinge at the origin, as a closed rigid surface.

    python3 make_forceps.py forceps.vtk
"""
import argparse
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from meshes import rod, write_vtk

RADII, TAIL, TIP = (0.007, 0.003), -0.015, 0.070  # half width and half thickness, ends [m]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surface", type=pathlib.Path)
    X, facets = rod(RADII, TAIL, TIP, 30, 24)
    write_vtk(parser.parse_args().surface, X, facets, polygons=True)


if __name__ == "__main__":
    main()
