#!/usr/bin/env python3
"""Runs the contact examples at reduced size by tools/contact_example.sh: equilibrium, energies, penetration, expected numbers.

usage: test_contact_examples.py GLISSON [unittest arguments]
The liver of the CT needs a download; here an image of two ellipsoids in its place takes its part.
"""
import gzip
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import vtu

GLISSON = os.path.abspath(sys.argv.pop(1))
CAN_DRAW = os.path.exists(os.path.join(os.path.dirname(GLISSON), "glisson-viz")) and shutil.which("Xvfb")
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples"))
from meshes import cross, dot, minus, outer_facets, read_vtk, unit


def liver_image(path):
    """INRIMAGE-4 of 3 mm voxels; a thick right lobe and a flat left one where those of the CT lie."""
    size, voxel = (84, 72, 70), 3.0
    lobes = (((95, 112, 120), (62, 82, 76)), ((175, 50, 118), (65, 27, 42)))  # centres and half axes [mm]
    head = ("#INRIMAGE-4#{\nXDIM=%d\nYDIM=%d\nZDIM=%d\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\n" % size +
            f"SCALE=2**0\nCPU=decm\nVX={voxel}\nVY={voxel}\nVZ={voxel}\n")
    voxels = bytearray()
    for z, y in ((z, y) for z in range(size[2]) for y in range(size[1])):
        row = bytearray(size[0])
        for centre, axes in lobes:
            rest = 1 - sum(((voxel * (k + 0.5) - c) / a) ** 2 for k, c, a in zip((y, z), centre[1:], axes[1:]))
            if rest > 0:
                half = axes[0] * math.sqrt(rest)
                low, high = (round((centre[0] + s * half) / voxel) for s in (-1, 1))
                row[low:high] = bytes([255]) * (high - low)
        voxels += row
    with gzip.open(path, "wb") as out:
        out.write(head.ljust(252, "\n").encode() + b"##}\n" + voxels)


def total(vectors):
    return tuple(math.fsum(v[k] for v in vectors) for k in range(3))


def node_masses(X, elements, density):
    masses = [0.0] * len(X)
    for a, b, c, d in elements:
        volume = dot(minus(X[b], X[a]), cross(minus(X[c], X[a]), minus(X[d], X[a]))) / 6
        for i in (a, b, c, d):
            masses[i] += density * volume / 4
    return masses


def sheet_masses(X, triangles, area_density):
    masses = [0.0] * len(X)
    for a, b, c in triangles:
        normal = cross(minus(X[b], X[a]), minus(X[c], X[a]))
        for i in (a, b, c):
            masses[i] += area_density * math.sqrt(dot(normal, normal)) / 6
    return masses


class Examples(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)

    def run_example(self, name, size):
        """The summary; self.end holds the arrays of the last snapshot."""
        image = self.folder / "image.inr.gz"
        liver_image(image)
        done = subprocess.run(
            [ROOT / "tools" / "contact_example.sh", name, self.folder, str(size), "--threads", "1"],
            capture_output=True, text=True, timeout=300,
            env={**os.environ, "GLISSON": GLISSON, "GLISSON_LIVER_IMAGE": str(image), "PYTHONDONTWRITEBYTECODE": "1"})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        if CAN_DRAW:
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000)
        return self.results(name)

    def results(self, name):
        self.end = vtu.arrays(sorted((self.folder / name).glob("*.vtu"))[-1])
        summary = json.loads((self.folder / name / "summary.json").read_text())
        self.assertEqual(summary["status"], "done")
        return summary

    def expect_rest(self, summary, throughput):
        """At rest at the end, no element turned inside out, the energy accounted for."""
        energies = summary["energies"]
        self.assertLess(energies["kinetic"], 2e-3 * energies["strain"])
        self.assertLess(abs(energies["imbalance"]), 2e-3 * throughput)
        self.assertGreater(min(self.end["J"]), 0.2)

    def expect_equilibrium(self, X, masses, first, acceleration, free, slack):
        """Internal, contact and body forces on the free nodes of one body whose first node has the number `first`."""
        nodes = [i for i in range(len(X)) if free(X[i])]
        contact = total([self.end["contact_force"][first + i] for i in nodes])
        internal = total([self.end["internal_force"][first + i] for i in nodes])
        mass = math.fsum(masses[i] for i in nodes)
        for k in range(3):
            self.assertAlmostEqual(internal[k] + contact[k] + mass * acceleration[k], 0, delta=slack)
        return contact


class Breast(Examples):
    def expect_sharing(self, summary, tissue, skin, skin_masses):
        """Both at rest; what the breast takes from the skin the skin gives. Gives that."""
        self.expect_rest(summary, summary["energies"]["external"])
        masses, gravity = node_masses(*tissue, 1000), [9.81 * g for g in (0, -0.866, -0.5)]
        weight, free = math.fsum(masses) * 9.81, lambda x: x[2] > 1e-6
        on_tissue = self.expect_equilibrium(tissue[0], masses, 0, gravity, free, 2e-3 * weight)
        on_skin = self.expect_equilibrium(skin[0], skin_masses, len(masses), gravity, free, 2e-3 * weight)
        for k in range(3):
            self.assertAlmostEqual(on_tissue[k], -on_skin[k], delta=1e-5 * weight)
        self.assertLess(summary["contact"][0]["largest_depth"], 1e-6)
        return on_tissue

    def test_the_skin_slides_and_carries(self):
        summary = self.run_example("breast", 4)
        tissue, skin = (read_vtk(self.folder / f"{name}.vtk") for name in ("breast", "skin"))
        on_tissue = self.expect_sharing(summary, tissue, skin, node_masses(*skin, 1000))
        self.assertAlmostEqual(on_tissue[2], -0.3135, delta=0.01)
        self.assertAlmostEqual(summary["largest_displacement"]["value"], 4.302e-3, delta=0.05e-3)
        self.assertAlmostEqual(self.slip(tissue, skin), 0.723e-3, delta=0.03e-3)

    def test_so_does_a_shell(self):
        maker = ROOT / "examples" / "breast" / "make_breast.py"
        subprocess.run([sys.executable, "-B", maker, self.folder, "--cells", "6", "--skin", "shell"], check=True)
        subprocess.run([GLISSON, "run", self.folder / "breast.xml", "-o", self.folder / "breast", "--threads", "1", "-q"],
                       check=True)
        tissue, skin = (read_vtk(self.folder / f"{name}.vtk") for name in ("breast", "skin"))
        on_tissue = self.expect_sharing(self.results("breast"), tissue, skin, sheet_masses(*skin, 1000 * 0.005))
        largest = max(math.sqrt(dot(u, u)) for u in self.end["displacement"])
        self.assertAlmostEqual(on_tissue[2], -0.662, delta=0.02)
        self.assertAlmostEqual(largest, 5.93e-3, delta=0.06e-3)
        self.assertAlmostEqual(self.slip(tissue, skin), 2.29e-3, delta=0.06e-3)

    def slip(self, tissue, skin):
        """Largest motion of a node inside of the skin along the breast's node below it."""
        facets = outer_facets(tissue[1])
        below = sorted({i for f in facets if any(tissue[0][i][2] > 1e-6 for i in f) for i in f})
        u, largest = self.end["displacement"], 0
        for k, i in enumerate(below):
            apart = minus(u[len(tissue[0]) + k], u[i])
            out = unit(minus(skin[0][k], tissue[0][i]))
            aside = minus(apart, tuple(dot(apart, out) * c for c in out))
            largest = max(largest, math.sqrt(dot(aside, aside)))
        return largest


class Probe(Examples):
    def test_trus(self):
        """The motion ends with the run: not at rest."""
        summary = self.run_example("trus", 4)
        self.assertLess(summary["energies"]["kinetic"], 5e-3 * summary["energies"]["strain"])
        self.assertGreater(min(self.end["J"]), 0.4)
        probe, bodies = summary["contact"]
        self.assertAlmostEqual(summary["largest_displacement"]["value"], 11.16e-3, delta=0.1e-3)
        self.assertAlmostEqual(probe["force"][1], -1.731, delta=0.05)
        self.assertGreater(bodies["touches"], 150)
        self.assertLess(bodies["largest_depth"], 0.05 * 0.0033)  # of the edges of the prostate


class Liver(Examples):
    def test_diaphragm(self):
        summary = self.run_example("diaphragm", 12)
        self.expect_rest(summary, summary["energies"]["prescribed"])
        X, elements = read_vtk(self.folder / "liver.vtk")
        free = lambda x: not (x[0] < 0.13 and x[1] > 0.155 and x[2] < 0.12)
        on_liver = self.expect_equilibrium(X, node_masses(X, elements, 1060), 0, (0, 0, 2), free, 0.05)
        whole = total(self.end["contact_force"])
        self.assertLess(math.sqrt(dot(whole, whole)), 1e-5 * abs(on_liver[2]))
        self.assertAlmostEqual(on_liver[2], -12.37, delta=0.3)
        self.assertAlmostEqual(summary["largest_displacement"]["value"], 23.98e-3, delta=0.5e-3)
        contact = summary["contact"][0]
        self.assertGreater(contact["touches"], 100)
        self.assertLess(contact["largest_depth"], 0.05 * 0.012)  # of the lattice's cubes
        self.assertLess(contact["depth"], 2e-5)

    def test_forceps(self):
        summary = self.run_example("forceps", 12)
        self.expect_rest(summary, summary["energies"]["contact"])
        X, elements = read_vtk(self.folder / "liver.vtk")
        free = lambda x: not (x[0] < 0.13 and x[1] > 0.155)
        on_liver = self.expect_equilibrium(X, node_masses(X, elements, 1060), 0, (0, 0, 0), free, 0.01)
        front, back = summary["contact"]
        for k in range(3):
            self.assertAlmostEqual(on_liver[k], front["force"][k] + back["force"][k], delta=1e-4)
        self.assertAlmostEqual(front["force"][1], 4.76, delta=0.15)
        self.assertAlmostEqual(back["force"][1], -4.09, delta=0.15)
        self.assertAlmostEqual(summary["largest_displacement"]["value"], 10.51e-3, delta=0.2e-3)
        for jaw in (front, back):
            self.assertLess(jaw["largest_depth"], 5e-5)


if __name__ == "__main__":
    unittest.main(verbosity=1)
