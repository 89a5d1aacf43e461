#!/usr/bin/env python3
"""Compare the stubs of the module edvo with the module, by mypy's stubtest. Ends with 77 where stubtest is not installed.

What pybind11 makes so and a user never sees is no fault: the class of its classes, and the arguments that the
constructor of a class without one takes before it refuses them.
"""

import re
import shutil
import subprocess
import sys

UNSEEN = ("metaclass differs", 'stub does not have *args argument')


def main():
    stubtest = shutil.which("stubtest", path="/usr/bin") or shutil.which("stubtest")
    if not stubtest:
        print("skipped: stubtest was not found (Debian's package mypy)")
        return 77
    run = subprocess.run([stubtest, "edvo", "--concise"], capture_output=True, text=True)
    lines = run.stdout.splitlines()
    faults = [line for line in lines if not any(unseen in line for unseen in UNSEEN)]
    checked = [line for line in lines if re.match(r"edvo\._edvo\.\w+ is inconsistent, metaclass", line)]
    if not checked:  # every class of pybind11 has this line: without any, nothing was compared
        faults.append(run.stderr or "stubtest compared nothing")
    print("\n".join(faults) or f"the stubs of {len(checked)} classes are as the module is")
    return 1 if faults else 0


sys.exit(main())
