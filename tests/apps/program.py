"""What the tests share that only start the program: X_test.py AR3D [UNITTEST'S ARGUMENTS]."""
import collections
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

AR3D = sys.argv[1]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
IS_SANITISED = b"__asan_init" in pathlib.Path(AR3D).read_bytes()
SHIM = pathlib.Path(AR3D).parents[1] / "tests" / "libar3d_fault_shim.so"
Outcome = collections.namedtuple("Outcome", "command code out err")
os.environ.update(PATH=":".join([os.path.dirname(AR3D), *os.get_exec_path()]))


def run(command):
    """Runs a line with bash, in which `ar3d` is the program. What it prints goes to files, so that no reader waits for its children."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        code = subprocess.run(["bash", "-c", command], stdin=subprocess.DEVNULL, stdout=out, stderr=err, check=False).returncode
        for file in (out, err):
            file.seek(0)
        return Outcome(command, code if code >= 0 else 128 - code, *(file.read().decode(errors="surrogateescape") for file in (out, err)))


def with_fault(fault, **variables):
    """What stands before a command so that it meets a fault of tests/shim/fault_shim.cpp, such as "before:3"."""
    named = "".join(f"AR3D_FAULT_{name}={value} " for name, value in variables.items())
    return f"env ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD={SHIM} AR3D_FAULT={fault} {named}"


def read(name):
    return pathlib.Path(name).read_bytes().decode(errors="surrogateescape")


def write(name, text):
    pathlib.Path(name).write_bytes(text.encode(errors="surrogateescape"))


class Program(unittest.TestCase):
    """Tests in a fresh folder each, which is the working directory."""
    maxDiff = None

    def setUp(self):
        folder = self.enterContext(tempfile.TemporaryDirectory(prefix="ar3d-test-"))
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder)

    def assertHas(self, text, parts, said=""):
        for part in [parts] if isinstance(parts, str) else parts:
            self.assertIn(part, text, said)

    def expect(self, command, code=0, out=(), err=()):
        """The line ends with that exit code and prints these parts. @return its outcome."""
        said = run(command)
        self.assertEqual(said.code, code, said)
        self.assertHas(said.out, out, said)
        self.assertHas(said.err, err, said)
        return said

    def refused(self, command, *parts):
        """The line ends with exit code 2 and one line on standard error, which holds these parts. @return its outcome."""
        said = self.expect(command, 2, err=parts)
        self.assertEqual(said.err.count("\n"), 1, said)
        return said


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
