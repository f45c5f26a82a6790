#!/usr/bin/env python3
"""Drives the glisson program: exit codes, messages, interruption, full disk, bad input.

usage: test_command_line.py GLISSON [unittest arguments]
"""
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import malformed
from simulations import box

GLISSON = os.path.abspath(sys.argv.pop(1))


def run(*arguments, timeout=120, **options):
    return subprocess.run([GLISSON, *map(str, arguments)], capture_output=True, text=True, errors="replace",
                          timeout=timeout, **options)


class InFolder(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)

    def tearDown(self):
        self.scratch.cleanup()

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def expect(self, done, code, *texts):
        everything = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, everything)
        for text in texts:
            self.assertIn(text, done.stderr if code else everything)


EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "membrane"


class Shells(InFolder):
    def summary(self, name, *options):
        folder = self.folder / name
        self.expect(run("run", EXAMPLES / f"{name}.xml", "-o", folder, *options), 0)
        return json.loads((folder / "summary.json").read_text())

    def test_examples_give_one_result_on_every_device(self):
        for name in ("inflated", "capsule"):
            largest = [self.summary(name, "--device", device, "--precision", precision)["largest_displacement"]["value"]
                       for device in ("cpu", "serial", "emulated") for precision in ("single", "double")]
            self.assertLess(max(largest) - min(largest), 1e-4 * max(largest))
            self.assertGreater(min(largest), 0.001)

    def test_energies_of_shells(self):
        inflated, capsule = self.summary("inflated"), self.summary("capsule")
        self.assertEqual(inflated["model"]["shell_triangles"], 32)
        self.assertAlmostEqual(inflated["energies"]["shell_strain"], inflated["energies"]["strain"])
        self.assertLess(0, capsule["energies"]["shell_strain"])
        self.assertLess(capsule["energies"]["shell_strain"], capsule["energies"]["strain"])
        self.assertIn("shell triangle", inflated["steps"]["limited_by"])
        self.assertTrue((self.folder / "inflated" / "history.csv").read_text().splitlines()[0].endswith("shell strain [J]"))

    def test_check_tells_of_shells(self):
        self.expect(run("check", EXAMPLES / "inflated.xml"), 0, "32 triangles (membrane, NeoHookean)", "thickness 0.001",
                    "mass 0.01", "limited by shell triangle")


class Contact(InFolder):
    def test_the_probe_presses_the_prostate_through_its_surroundings(self):
        """examples/trus with 1,536 tetrahedra."""
        maker = EXAMPLES.parent / "trus" / "make_trus.py"
        subprocess.run([sys.executable, maker, self.folder, "--cells", "2"], check=True)
        largest = []
        for precision in ("single", "double"):
            out = self.folder / precision
            self.expect(run("run", self.folder / "trus.xml", "-o", out, "--precision", precision), 0)
            summary = json.loads((out / "summary.json").read_text())
            largest.append(summary["largest_displacement"]["value"])
            self.assertLess(abs(summary["energies"]["imbalance"]), 1e-3 * summary["energies"]["contact"])
            probe, bodies = summary["contact"]
            self.assertGreater(probe["touches"], 2)
            self.assertLess(probe["force"][1], -0.1)
            self.assertGreater(bodies["touches"], 20)
            self.assertLess(bodies["largest_depth"], 0.05 * 0.0066)  # of the edges of the prostate
            self.check_statistics(probe["search"], bodies["search"])
        self.assertGreater(largest[0], 0.005)
        self.assertAlmostEqual(largest[0], largest[1], delta=1e-3 * largest[1])

    def test_bodies_that_start_in_each_other(self):
        sub = lambda name, z: f"""<SubModel Name="{name}"><Nodes NumNodes="8" DOF="3">
            0 0 {z}  1 0 {z}  1 1 {z}  0 1 {z}  0 0 {z + 1}  1 0 {z + 1}  1 1 {z + 1}  0 1 {z + 1} </Nodes>
            <Elements NumEls="1" Type="H8"> 0 1 2 3 4 5 6 7 </Elements><ElementSet Size="all"><Material Type="NH">
            <ElasticParams NumParams="2"> 2000 20000 </ElasticParams></Material></ElementSet></SubModel>"""
        for z, code, words in ((1.0, 0, ""), (0.9, 0, "bodies start up to 0.1 inside of each other"),
                               (0.5, 3, "starts inside of the one with node")):
            file = self.write("two.xml", f"""<Model>{sub("low", 0)}{sub("high", z)}<SystemParams><TotalTime> 1 </TotalTime>
                <Density> 1000 </Density><DoDeformableCollision> 1 </DoDeformableCollision></SystemParams></Model>""")
            done = run("check", file)
            self.expect(done, code, words)
            self.assertEqual("bodies start" in done.stdout, z == 0.9)

    def check_statistics(self, probe, bodies):
        self.assertEqual(set(probe), {"nodes", "volumes", "total_s"})
        self.assertGreater(min(probe.values()), 0)
        self.assertGreater(bodies["searches"], 1)
        self.assertEqual(bodies["volumes_refitted"], bodies["searches"] * bodies["volumes"])
        self.assertGreater(bodies["triangle_pairs"], bodies["searches"])
        self.assertGreater(min(bodies[stage] for stage in ("refit_s", "pairs_s", "lists_s", "touches_s", "forces_s")), 0)
        self.assertLessEqual(bodies["refit_s"] + bodies["pairs_s"] + bodies["lists_s"], bodies["search_s"])
        self.assertLessEqual(bodies["search_s"] + bodies["touches_s"] + bodies["forces_s"], bodies["total_s"])


class Usage(InFolder):
    def test_nothing(self):
        self.expect(run(), 2, "subcommand")

    def test_help_and_version(self):
        self.expect(run("--help"), 0, "run", "bench", "selftest")
        self.expect(run("run", "--help"), 0, "--precision")
        self.expect(run("--version"), 0, "Glisson 0.")

    def test_unknown_option_names_the_near_one(self):
        self.expect(run("run", "a.xml", "--threds", "2"), 2, "--threds", "did you mean --threads")
        self.expect(run("rum", "a.xml"), 2, "rum", "did you mean run")

    def test_wrong_values(self):
        file = self.write("box.xml", box(1))
        for arguments in (["--threads", "-1"], ["--threads", "two"], ["--precision", "half"], ["--device", "gpu"],
                          ["--log-level", "loud"], ["--print", "XX"], ["--checkpoint-minutes", "-1"]):
            self.expect(run("run", file, "-o", self.folder / "out", *arguments), 2)
        self.expect(run("run", file, "--precision", "half"), 2, "half", "double", "single")
        self.expect(run("bench", "--cases", "T5"), 2, "T5", "T4")

    def test_no_such_device(self):
        file = self.write("box.xml", box(1))
        self.expect(run("run", file, "--device", "cuda:77"), 4, "cuda:77")
        self.expect(run("run", file, "--device", "cuda:x"), 2, "cuda:x")
        if "cuda:0" not in run("devices").stdout:
            self.expect(run("run", "-x", file, "-sport"), 4, "--device cpu")
            self.expect(run("run", file, "-o", self.folder / "out"), 0, "auto chose the CPU")


class Input(InFolder):
    def test_wrong_paths(self):
        self.expect(run("run", self.folder / "absent.xml"), 3, "absent.xml")
        self.expect(run("run", self.folder), 3, str(self.folder), "is a folder")
        self.expect(run("info", self.folder / "absent.msh"), 3, "absent.msh")
        self.expect(run("info", self.folder / "absent.nii"), 3, "absent.nii")

    def test_a_pipe_is_read(self):
        text = self.write("box.xml", box(1)).read_text()
        self.expect(run("check", "/dev/stdin", "--no-prediction", input=text), 0, "can be run")

    def test_the_place_is_named_once(self):
        done = run("run", self.write("box.xml", box(1).replace("> 2000 20000", "> -2000 20000")))
        self.expect(done, 3, "ElementSet at line", "mu of NH")
        self.assertEqual(done.stderr.count("ElementSet at line"), 1)

    def test_output_that_cannot_be_written(self):
        file = self.write("box.xml", box(1))
        blocker = self.write("blocker", "a file")
        self.expect(run("run", file, "-o", blocker / "out"), 1, "blocker")
        self.expect(run("run", file, "-o", blocker), 1, "blocker")

    def test_malformed_files(self):
        count = 0
        for name, content in malformed.files():
            file = self.write(name, content)
            with self.subTest(name):
                done = run("run" if name.endswith(".xml") else "info", file, *(["-o", self.folder / "out"]
                                                                             if name.endswith(".xml") else []))
                self.expect(done, 3, "error:", name)
            count += 1
        self.assertGreaterEqual(count, 80)

    def test_lenient(self):
        file = self.write("box.xml", box(1, extra="<Colour/>"))
        self.expect(run("run", file, "-o", self.folder / "out"), 3, "Colour")
        self.expect(run("run", file, "-o", self.folder / "out", "--lenient"), 0, "Colour")


class Runs(InFolder):
    def test_summary_and_files(self):
        file, out = self.write("box.xml", box(2, output=20)), self.folder / "out"
        self.expect(run("run", file, "-o", out), 0, "largest displacement", "ms per step")
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual(summary["status"], "done")
        self.assertEqual(summary["steps"]["count"], summary["steps"]["planned"])
        self.assertEqual((summary["version"].count("."), summary["compiler"].split()[0] in ("g++", "clang")), (2, True))
        self.assertAlmostEqual(summary["time_s"], 0.5)
        self.assertGreater(summary["largest_displacement"]["value"], 0.0099)
        energies = summary["energies"]
        self.assertLess(abs(energies["imbalance"]), 0.01 * energies["strain"])
        names = {path.name for path in out.iterdir()}
        self.assertLessEqual({"box.pvd", "history.csv", "U.txt", "box_000000.vtu"}, names)
        self.assertNotIn("checkpoint.glisson", names)
        columns = {len(line.split()) for line in (out / "U.txt").read_text().splitlines()}
        self.assertEqual(columns, {summary["steps"]["count"] // 20})

    def test_quiet_and_locale(self):
        file = self.write("box.xml", box(1))
        environment = {**os.environ, "LC_ALL": "de_DE.UTF-8", "LC_NUMERIC": "de_DE.UTF-8"}
        done = run("run", file, "-o", self.folder / "out", "--quiet", env=environment)
        self.expect(done, 0)
        self.assertEqual(done.stdout + done.stderr, "")
        self.assertIn("0.", (self.folder / "out/history.csv").read_text())

    def test_options_of_niftysim(self):
        file = self.write("box.xml", box(1, output=5))
        prefix = self.folder / "case1_"
        done = run("-x", file, "-v", "-t", "-print", "ND", "-print", "ES", "-output-prefix", prefix, "-o", self.folder / "out")
        self.expect(done, 0, "Execution time:", "strain energy", "\n7 ")
        self.assertTrue((self.folder / "case1_U.txt").exists())

    def test_exports_of_niftysim(self):
        file = EXAMPLES / "inflated.xml"
        mesh, membrane = self.folder / "end.vtu", self.folder / "end.vtp"
        self.expect(run("-x", file, "-o", self.folder / "out", "-export-mesh", mesh, "-export-membrane", membrane), 0)
        self.assertIn("displacement", mesh.read_text())
        self.assertIn("thickness", membrane.read_text())
        self.expect(run("run", file, "-o", self.folder / "out", "-export-membrane", "end.vtk"), 2, "end.vtp")
        box_file = self.write("box.xml", box(1))
        self.expect(run("run", box_file, "-o", self.folder / "out", "-export-membrane", membrane), 2, "ShellElements")

    def test_divergence_is_a_failed_run(self):
        file = self.write("box.xml", box(2, system="<TimeStep> 0.02 </TimeStep>"))
        out = self.folder / "out"
        self.expect(run("run", file, "-o", out), 1, "step")
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual(summary["status"], "failed")
        self.assertTrue(summary["message"])
        for file in out.iterdir():
            self.assertNotIn(b"nan", file.read_bytes().lower())

    def test_divergence_before_a_snapshot_says_where(self):
        file = self.write("box.xml", box(2, total=2, output=7, system="<TimeStep> 0.02 </TimeStep><MonitorFreq> 99 </MonitorFreq>"))
        self.expect(run("run", file, "-o", self.folder / "out"), 1, "found at step", "stable step")

    def test_a_body_that_flies_off_is_not_at_rest(self):
        gravity = ('<Constraint Type="Gravity" NumNodes="all" LoadShape="STEP"><AccelerationMagnitude> 9.81 </AccelerationMagnitude>'
                   '<AccelerationDirection> 0 0 -1 </AccelerationDirection></Constraint>')
        text = re.sub('<Constraint Type="(Fix|Disp)".*?</Constraint>', "", box(2, extra=gravity, system="<QuasiStatic/>"),
                      flags=re.DOTALL)
        self.expect(run("run", self.write("box.xml", text), "-o", self.folder / "out"), 1, "not converged", "free to move away")

    def test_a_tip_between_nodes_is_named(self):
        tip = ('<ContactSurface><Nodes NumNodes="5"> 0.024 0.024 0.12  0.026 0.024 0.12  0.026 0.026 0.12  0.024 0.026 0.12  '
               '0.025 0.025 0.101 </Nodes><Elements NumEls="4" Type="T3"> 0 4 1  1 4 2  2 4 3  3 4 0 </Elements>'
               '<Motion Type="Translation"> 0 0 -0.05 </Motion></ContactSurface>')
        done = run("run", self.write("box.xml", box(2, extra=tip)), "-o", self.folder / "out")
        self.expect(done, 0)
        self.assertIn("went in between them", done.stderr)
        self.assertIn("went in between them", json.loads((self.folder / "out" / "summary.json").read_text())["warnings"][0])

    def test_other_commands(self):
        file = self.write("box.xml", box(2))
        self.expect(run("check", file), 0, "can be run", "stable up to", "at the peak of a run")
        self.expect(run("info", file), 0, "8 hexahedra")
        self.expect(run("devices"), 0, "cpu")
        self.expect(run("bench", "--sizes", "1000", "--seconds", "0.05", "--json", self.folder / "b/bench.json"), 0, "T4ANP")
        self.assertEqual(len(json.loads((self.folder / "b/bench.json").read_text())["results"]), 12)

    def test_image_to_mesh_to_other_formats(self):
        header = b"#INRIMAGE-4#{\nXDIM=6\nYDIM=6\nZDIM=6\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=8 bits\nSCALE=2**0\n" \
                 b"CPU=decm\nVX=1\nVY=1\nVZ=1\n"
        image = self.write("cube.inr", header + b"\n" * (256 - len(header) - 4) + b"##}\n" + b"\7" * 216)
        self.expect(run("info", image), 0, "7 (216 voxels)")
        mesh = self.folder / "cube.vtu"
        self.expect(run("mesh", image, "--voxel", "3mm", "--element", "H8", cwd=self.folder), 0, "8 hexahedra", "written: cube.vtu")
        self.expect(run("info", mesh), 0, "8 hexahedra")
        self.expect(run("mesh", image, "-o", mesh, "--voxel", "3"), 2, "as in 6mm")
        self.expect(run("mesh", image, "-o", mesh, "--voxel", "3mm", "--labels", "7"), 0, "48 elements")
        self.expect(run("mesh", image, "-o", mesh, "--voxel", "3mm", "--labels", "9"), 3, "cube.inr", "7 (216 voxels)")
        for name in ("cube.msh", "cube.vtk", "again.vtu"):
            self.expect(run("convert", mesh, self.folder / name), 0)
            self.expect(run("info", self.folder / name), 0, "48 tetrahedra", "label 7: 48 elements")


class Interruption(InFolder):
    def start(self, file, out, *arguments):
        return subprocess.Popen([GLISSON, "run", file, "-o", out, *arguments], stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def wait_for(self, path):
        for _ in range(600):
            if path.exists():
                return
            time.sleep(0.05)
        self.fail(f"{path} did not appear")

    def test_stopped_and_resumed_gives_the_same_bits(self):
        file = self.write("box.xml", box(8, output=150, total=10))
        whole, parts = self.folder / "whole", self.folder / "parts"
        self.expect(run("run", file, "-o", whole), 0)
        interrupted = 0
        for attempt in range(4):
            there = len(list(parts.glob("*.vtu")))
            process = self.start(file, parts, *(["--resume"] if attempt else []), *(["--threads", "1"] if attempt % 2 else []))
            if attempt < 3:
                self.wait_for(parts / f"box_{there + 1:06}.vtu")
                process.send_signal(signal.SIGINT if attempt else signal.SIGTERM)
            _, errors = process.communicate(timeout=120)
            interrupted += process.returncode == 130
            if process.returncode == 0:
                break
            self.assertEqual(process.returncode, 130, errors)
            self.assertIn("--resume", errors)
        self.assertGreaterEqual(interrupted, 1, "the run was over before it could be stopped")
        self.assertEqual(process.returncode, 0, errors)
        names = sorted(p.name for p in whole.iterdir())
        self.assertEqual(names, sorted(p.name for p in parts.iterdir()))
        for name in names:
            if name != "summary.json":
                self.assertEqual((whole / name).read_bytes(), (parts / name).read_bytes(), name)

    def test_checkpoint_of_another_model(self):
        out = self.folder / "out"
        first, second = self.write("box.xml", box(8, total=20)), self.write("changed.xml", box(8, total=21))
        process = self.start(first, out)
        self.wait_for(out / "history.csv")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.expect(run("run", second, "-o", out, "--resume"), 3, "checkpoint.glisson", "another model")
        self.expect(run("run", first, "-o", out, "--resume", "--precision", "double"), 3, "checkpoint.glisson")
        checkpoint = out / "checkpoint.glisson"
        data = checkpoint.read_bytes()
        checkpoint.write_bytes(data[:-100])
        self.expect(run("run", first, "-o", out, "--resume"), 3, "cut off")
        checkpoint.write_bytes(data[:-100] + bytes(b ^ 255 for b in data[-100:]))
        self.expect(run("run", first, "-o", out, "--resume"), 3, "damaged")
        self.expect(run("run", first, "-o", self.folder / "new", "--resume"), 3, "no checkpoint")

    def test_killed_run_leaves_complete_snapshots(self):
        file, out = self.write("box.xml", box(8, output=20, total=60)), self.folder / "out"
        process = self.start(file, out)
        self.wait_for(out / "box_000003.vtu")
        process.kill()
        process.communicate(timeout=60)
        listed = [line.split('file="')[1].split('"')[0] for line in (out / "box.pvd").read_text().splitlines() if "file=" in line]
        self.assertGreaterEqual(len(listed), 2)
        for name in listed:
            self.assertTrue((out / name).read_text().rstrip().endswith("</VTKFile>"), name)
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "running")

    def test_full_disk(self):
        file, out = self.write("box.xml", box(8, output=20, total=5)), self.folder / "out"
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (30000, 30000))
        done = run("run", file, "-o", out, preexec_fn=limit)
        self.expect(done, 1, "cannot write", "bytes")
        for snapshot in out.glob("*.vtu"):
            self.assertTrue(snapshot.read_text().rstrip().endswith("</VTKFile>"), snapshot.name)
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "failed")


class Ensembles(InFolder):
    def test_table(self):
        file = self.write("box.xml", box(3, total=0.05))
        table = self.write("table.csv", "ElasticParams#1,Constraint[2]/Magnitudes\n"
                           + "".join(f"{1500 + 100 * k},{-0.002 - 0.0001 * k}\n" for k in range(5)))
        done = run("run", "--ensemble", table, file, "-o", self.folder / "out")
        self.expect(done, 0, "5 members of 27 elements", "written:")
        rows = (self.folder / "out/ensemble.csv").read_text().splitlines()
        self.assertEqual(len(rows), 6)
        self.assertTrue(rows[0].startswith('member,"ElasticParams#1","Constraint[2]/Magnitudes",status,steps'))
        for k, row in enumerate(rows[1:]):
            cells = row.split(",")
            self.assertEqual(cells[0:4], [str(k), str(1500 + 100 * k), f"{-0.002 - 0.0001 * k}", "done"])
            self.assertGreater(float(cells[7]), 0.0019 + 0.0001 * k)
            self.assertLess(float(cells[7]), 0.003 + 0.0001 * k)
            self.assertTrue((self.folder / f"out/member-{k}.vtu").exists())

    def test_a_failed_member_is_named(self):
        file = self.write("box.xml", box(3, total=2, system="<TimeStep> 1e-3 </TimeStep>"))
        table = self.write("table.csv", "TimeStep\n1e-3\n2e-2\n2e-3\n")
        done = run("run", "--ensemble", table, file, "-o", self.folder / "out")
        self.expect(done, 1, "error: member 1: ")
        rows = (self.folder / "out/ensemble.csv").read_text().splitlines()
        self.assertEqual([row.split(",")[2] for row in rows[1:]], ["done", "failed", "done"])

    def test_refused(self):
        file = self.write("box.xml", box(2))
        table = self.write("table.csv", "Elastic#1\n1\n")
        self.expect(run("run", "--ensemble", table, file), 3, "table.csv:1", "names nothing")
        self.expect(run("run", "--ensemble", "no.csv", file), 3, "no.csv")
        self.expect(run("run", "--ensemble", table, file, "--resume"), 2, "--resume")


if __name__ == "__main__":
    unittest.main()
