"""The script that a GPU machine runs, with programs in place of the real ones: what it writes and how it ends."""
import json
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(__file__), "..", "..", "tools", "gpu-check-run.sh")
TOOLS = ["bash", "cat", "date", "dirname", "env", "head", "ls", "mkdir", "rm", "tail", "timeout", "tr"]
GPU = "cuda:0      Fake 1, compute capability 9.0, 1000 MiB"
GTEST = 'echo "[  PASSED  ] 3 tests."'
PRECISION = r'printf "|a|\n|-|\n| element T4 | 1000 | 2.9e-07 |\n| law \"NH\" | 1000 | 1e-08 |\n" >$GLISSON_RESULTS/precision-CudaFloat.md'
GLISSON = """case $1 in
devices) echo "{gpu}" ;;
bench) echo '{{"version": "1"}}' >"${{@: -1}}" ;;
esac"""


class GpuCheck(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        os.makedirs(os.path.join(self.folder, "bin"))
        shutil.copy(SCRIPT, os.path.join(self.folder, "run.sh"))
        with open(os.path.join(self.folder, "build.txt"), "w") as file:
            file.write("abc123\n90\n")
        self.program("glisson", GLISSON.format(gpu=GPU))
        for name in "test_cuda", "test_scenarios", "test_shells", "test_contact":
            self.program(name, GTEST + "\n" + PRECISION)

    def program(self, name, text):
        path = os.path.join(self.folder, "bin", name)
        with open(path, "w") as file:
            file.write("#!/usr/bin/env bash\n" + text + "\n")
        os.chmod(path, stat.S_IRWXU)

    def run_script(self, *arguments):
        """With bash and coreutils alone, as the script promises, and nothing in the environment."""
        tools = os.path.join(self.folder, "tools")
        if not os.path.exists(tools):
            os.makedirs(tools)
            for name in TOOLS:
                os.symlink(shutil.which(name), os.path.join(tools, name))
        result = subprocess.run([os.path.join(self.folder, "run.sh"), *arguments], capture_output=True, text=True,
                                env={"PATH": tools})
        return result.returncode, result.stdout + result.stderr

    def written(self):
        with open(os.path.join(self.folder, "gpu-check.json")) as file:
            return json.load(file)

    def test_all_passed(self):
        self.assertEqual(self.run_script()[0], 0)
        found = self.written()
        self.assertEqual((found["commit"], found["architectures"]), ("abc123", "90"))
        self.assertIn("Fake 1", found["device"])
        self.assertEqual(found["single_against_double"][0], {"feature": "element T4", "steps": 1000, "difference": 2.9e-07})
        self.assertEqual(found["bench"], [{"version": "1"}] * 5)
        self.assertEqual(found["ensembles"], {"version": "1"})
        self.assertLessEqual({c["status"] for c in found["checks"]}, {"passed", "not run"})

    def test_no_gpu(self):
        self.program("glisson", GLISSON.format(gpu="cuda        no device or no driver here"))
        code, text = self.run_script()
        self.assertEqual(code, 4)
        self.assertIn("no GPU", text)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "gpu-check.json")))

    def test_a_failure_is_kept_with_its_reason(self):
        self.program("test_shells", r'printf "an error: bad \"value\"\a\n[  FAILED  ] Shells\tx\n"; exit 1')
        self.assertEqual(self.run_script()[0], 1)
        failed = [c for c in self.written()["checks"] if c["status"] == "failed"]
        self.assertEqual([c["name"] for c in failed], ["matrix, shells"])
        self.assertIn("\n[  FAILED  ] Shells x", failed[0]["detail"])
        self.assertIn('an error: bad "value"\n', failed[0]["detail"])

    def test_no_test_at_all_is_a_failure(self):
        self.program("test_scenarios", 'echo "[  PASSED  ] 0 tests."')
        self.assertEqual(self.run_script("--only", "tests")[0], 1)

    def test_a_bench_that_takes_too_long_loses_its_own_size_only(self):
        self.program("glisson", GLISSON.format(gpu=GPU) + '\n[[ " $* " != *" 30 "* ]] || exit 124')
        self.assertEqual(self.run_script("--only", "bench", "--bench-sizes", "10,20,30")[0], 1)
        self.assertEqual([c["status"] for c in self.written()["checks"]], ["passed", "passed", "failed"])

    def test_help(self):
        code, text = self.run_script("--help")
        self.assertEqual(code, 0)
        self.assertIn("usage: run.sh", text)

    def test_a_part(self):
        self.assertEqual(self.run_script("--only", "repeats")[0], 0)
        self.assertEqual([c["name"] for c in self.written()["checks"]], ["same bits 100 times"])
        self.assertEqual(self.written()["bench"], [])

    def test_wrong_use(self):
        self.assertEqual(self.run_script("--all")[0], 2)


if __name__ == "__main__":
    sys.exit(unittest.main())
