#!/usr/bin/env python3
"""glisson picture and view: against a stored picture by structure, bad input, displays that are not there.

usage: test_pictures.py GLISSON [--store]    (--store renews the stored picture; look at it)
Without VTK only what works without it is tested; without a display and Xvfb, nothing is drawn: exit code 77.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "app"))
import png
from simulations import box, pressed_plate

GLISSON = pathlib.Path(sys.argv.pop(1))
STORE = "--store" in sys.argv and not sys.argv.remove("--store")
HAS_VTK = (GLISSON.parent / "glisson-viz").exists()
CAN_DRAW = HAS_VTK and bool(shutil.which("Xvfb") or os.environ.get("DISPLAY"))


def run(*arguments, program=GLISSON, **environment):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          env={**os.environ, **environment})


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        (cls.folder / "box.xml").write_text(box(4, output=200))
        done = run("run", cls.folder / "box.xml", "-o", cls.folder / "out", "-q")
        assert done.returncode == 0, done.stderr
        cls.pvd = cls.folder / "out" / "box.pvd"
        cls.png = cls.folder / "a.png"

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def expect(self, done, code, *texts):
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for text in texts:
            self.assertIn(text, done.stderr)
        if code:
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def draw(self, *options):
        self.expect(run("picture", self.pvd, "-o", self.png, "--size", "400x300", *options), 0)
        return png.luminance(self.png)

    def test_without_vtk(self):
        alone = shutil.copy(GLISSON, self.folder / "glisson")
        self.expect(run("picture", self.pvd, "-o", self.png, program=alone), 4, "libvtk9-dev", "GLISSON_VTK=ON")
        self.expect(run("view", self.pvd, program=alone), 4, "libvtk9-dev")

    def test_options(self):
        for option, text in (("--cut=q", "y=50%"), ("--cut=x=120%", "100%"), ("--cut=0,0,0@1,1,1", "nx,ny,nz"),
                             ("--view=up", "oblique"), ("--size=10x10", "WIDTHxHEIGHT"), ("--scale=-1", "negative"),
                             ("--step=1.5", "whole"), ("--scale=nan", "negative")):
            self.expect(run("picture", self.pvd, "-o", self.png, option), 2, option.split("=")[0], text)
        self.expect(run("picture", self.pvd, "-o", "a.jpg"), 2, ".png")

    @unittest.skipUnless(HAS_VTK, "built without VTK")
    def test_no_display(self):
        nowhere = self.folder / "empty"
        nowhere.mkdir()
        for display in ("", ":77", "127.0.0.1:9"):
            self.expect(run("picture", self.pvd, "-o", self.png, DISPLAY=display, PATH=str(nowhere)), 4, "apt-get install xvfb")
            self.expect(run("view", self.pvd, DISPLAY=display), 4, "display")
        done = run("run", self.folder / "box.xml", "-o", self.folder / "plot", "-q", "-plot", DISPLAY="")
        self.expect(done, 0, "needs a display")

    @unittest.skipUnless(CAN_DRAW, "no VTK, or neither a display nor Xvfb")
    def test_against_the_stored_picture(self):
        stored = HERE / "block.png"
        rows = self.draw("--undeformed", "--loads")
        if STORE:
            shutil.copy(self.png, stored)
        correlation, overlap = png.similarity(rows, png.luminance(stored))
        self.assertGreater(correlation, 0.97)
        self.assertGreater(overlap, 0.93)
        # The measure tells other pictures apart.
        self.assertLess(min(png.similarity(self.draw("--view", "left"), png.luminance(stored))), 0.93)

    @unittest.skipUnless(CAN_DRAW, "no VTK, or neither a display nor Xvfb")
    def test_a_shell_between_rigid_bodies(self):
        """A ball of triangles, an analytic cylinder seen from its end, clamped nodes, the thickness."""
        (self.folder / "plate.xml").write_text(pressed_plate())
        self.expect(run("run", self.folder / "plate.xml", "-o", self.folder / "plate", "-q"), 0)
        results, stored = self.folder / "plate" / "plate.pvd", HERE / "plate.png"

        def draw(*options, of=results):
            self.expect(run("picture", of, "-o", self.png, "--size", "400x300", "--view", "front", *options), 0)
            return png.luminance(self.png)

        rows = draw("--loads")
        if STORE:
            shutil.copy(self.png, stored)
        correlation, overlap = png.similarity(rows, png.luminance(stored))
        self.assertGreater(correlation, 0.97)
        self.assertGreater(overlap, 0.93)
        # Without the simulation file there are no bodies: the plate at rest alone, 4 mm thick and 100 mm long.
        (self.folder / "plate" / "summary.json").unlink()
        rest = [[value < png.BACKGROUND - 20 for value in row[:310]] for row in draw("--step", "0")[:280]]
        height = sum(any(row) for row in rest)
        width = sum(any(row[x] for row in rest) for x in range(310))
        self.assertLess(abs(height - 0.04 * width), 2)
        self.assertLess(png.similarity(draw(), rows)[1], 0.8)

    @unittest.skipUnless(CAN_DRAW and os.environ.get("GLISSON_LIVER_PICTURES"), "no VTK, no display, or no CT asked for")
    def test_liver_with_and_without_capsule(self):
        script = HERE.parents[1] / "tools" / "liver_pictures.sh"
        done = subprocess.run(["bash", script, GLISSON, self.folder / "liver", "12mm", "400x300"], capture_output=True, text=True,
                              timeout=250)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        largest = {}
        for name in ("liver", "liver-capsule"):
            drawn, stored = self.folder / "liver" / f"{name}.png", HERE / f"{name}.png"
            if STORE:
                shutil.copy(drawn, stored)
            correlation, overlap = png.similarity(png.luminance(drawn), png.luminance(stored))
            self.assertGreater(correlation, 0.97, name)
            self.assertGreater(overlap, 0.93, name)
            summary = json.loads((self.folder / "liver" / name / "summary.json").read_text())
            largest[name] = summary["largest_displacement"]["value"]
        self.assertLess(largest["liver-capsule"], 0.75 * largest["liver"])

    @unittest.skipUnless(CAN_DRAW, "no VTK, or neither a display nor Xvfb")
    def test_fields_steps_and_cuts(self):
        whole = self.draw()
        for field in ("velocity:z", "stress", "stress:11", "strain", "J"):
            self.draw("--field", field)
        self.assertLess(png.similarity(self.draw("--cut", "x=50%"), whole)[0], 0.995)
        self.assertLess(png.similarity(self.draw("--step", "0"), whole)[0], 0.999)
        self.draw("--edges", "--scale", "3", "--view", "1,1,1")

    @unittest.skipUnless(CAN_DRAW, "no VTK, or neither a display nor Xvfb")
    def test_bad_input(self):
        def expect(code, *texts, results=self.pvd, output=self.png, options=()):
            self.expect(run("picture", results, "-o", output, *options), code, *texts)

        expect(2, "did you mean displacement", "velocity", options=("--field", "displacment"))
        expect(2, "11, 22", options=("--field", "stress:xx"))
        expect(2, "0 to", options=("--step", "999"))
        expect(2, "nothing to draw", options=("--cut", "x=-5", "--view", "right"))
        expect(3, "absent.pvd", results=self.folder / "absent.pvd")
        expect(3, "directory", results=self.folder)
        expect(3, "absent.xml", options=("--model", "absent.xml"))
        expect(1, "cannot", output=self.folder / "no" / "such" / "a.png")
        broken = self.folder / "broken.vtu"
        broken.write_text(next(self.folder.glob("out/*.vtu")).read_text()[:900])
        expect(3, "broken.vtu", results=broken)
        listing = self.folder / "broken.pvd"
        for text, words in (("<VTKFile", "XML"), ("<VTKFile/>", "Collection"),
                            ("<VTKFile><Collection/></VTKFile>", "no snapshot"),
                            ('<VTKFile><Collection><DataSet timestep="0"/></Collection></VTKFile>', "file"),
                            ('<VTKFile><Collection><DataSet file="gone.vtu"/></Collection></VTKFile>', "gone.vtu")):
            listing.write_text(text)
            expect(3, words, results=listing)

    @unittest.skipUnless(HAS_VTK and shutil.which("xvfb-run"), "no VTK or no xvfb-run")
    def test_window(self):
        done = subprocess.run(["xvfb-run", "-a", GLISSON, "view", self.pvd, "--seconds", "1"], capture_output=True,
                              text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


outcome = unittest.main(exit=False, verbosity=1).result
if outcome.wasSuccessful() and not CAN_DRAW:
    print("skipped: pictures need VTK (apt-get install libvtk9-dev xvfb xauth) and a display or Xvfb")
    sys.exit(77)
sys.exit(not outcome.wasSuccessful())
