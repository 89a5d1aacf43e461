"""The program in a folder of its own, with what the tests of rigs render and compare."""

import subprocess

PATH = ("--path orbit --orbit.centre=-0.95,0.5,0.3 --orbit.radius 1.2 --orbit.height 0.8 --rate 10 --duration 0.3 "
        "--samples 1 --quiet")


class Program:
    """The program, and the folder in which it works."""

    def __init__(self, program, source, work):
        self.program, self.source, self.work = program, source, work

    def run(self, words, code=0):
        """Runs a command; returns its stdout and stderr."""
        done = subprocess.run([self.program, *words.split()], cwd=self.work, capture_output=True, text=True)
        assert done.returncode == code, f"edvo {words}: exit code {done.returncode}, expected {code}: {done.stderr}"
        return done.stdout, done.stderr

    def render(self, scene, options, code=0):
        return self.run(f"render {self.source}/assets/{scene}/{scene}.gltf {PATH} {options}", code)

    def rig(self, name, text):
        (self.work / name).write_text(text, encoding="utf-8")
        return name


def contents(folder):
    return {path.relative_to(folder): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def require_same(a, b):
    one, other = contents(a), contents(b)
    assert one.keys() == other.keys(), f"{a} and {b}: {one.keys() ^ other.keys()}"
    different = [str(name) for name in one if one[name] != other[name]]
    assert not different, f"{a} and {b} differ in {different[:5]}"
