"""`edvo dataset` as the tests of data sets call it: TEST.py EDVO REPOSITORY SCRATCH."""

import os
import pathlib
import subprocess
import sys

EDVO, REPOSITORY, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])


def edvo(*words, code=0, env=None):
    """Runs `edvo dataset`, holds it to its exit code and returns what it printed."""
    result = subprocess.run([EDVO, "dataset", *map(str, words)], capture_output=True, text=True, cwd=SCRATCH,
                            env={**os.environ, **(env or {})})
    assert result.returncode == code, (words, result.returncode, result.stdout, result.stderr)
    return result.stdout + result.stderr


def files_of(folder):
    """Returns the bytes of all files below a folder by their names in it."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
