#!/usr/bin/env python3
"""An outside tracker that does what none should: misbehaving.py HOW [PATH]"""

import os
import pathlib
import shutil
import signal
import sys
import time

SEQUENCE = pathlib.Path(os.environ["EDVO_SEQUENCE"])
OUTPUT = pathlib.Path(os.environ["EDVO_OUTPUT"])


def copies_truth(_):
    shutil.copy(SEQUENCE / "groundtruth.txt", OUTPUT)


def guesses_truth(cache):
    """Copies whatever truth lies below the path, rounded."""
    for file in sorted(pathlib.Path(cache).rglob("groundtruth.txt")):
        lines = [line.split() for line in file.read_text().splitlines() if not line.startswith("#")]
        OUTPUT.write_text("".join(" ".join(f"{float(n):.6f}" for n in line) + "\n" for line in lines))


def writes_input(_):
    for change in (lambda: (SEQUENCE / "rgb" / "000000.png").write_bytes(b"x"),
                   lambda: os.remove(SEQUENCE / "rgb.txt"), lambda: shutil.rmtree(SEQUENCE)):
        try:
            SEQUENCE.chmod(0o777)
            change()
            print("changed its input")
        except OSError:
            pass


def forks_daemon(mark):
    """Becomes a daemon that says who it is and is otherwise idle."""
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            part = pathlib.Path(f"{mark}.part")
            part.write_text(str(os.getpid()))
            part.rename(mark)
            time.sleep(600)
        os._exit(0)
    while not os.path.exists(mark):
        time.sleep(0.01)


def prints_for_ever(_):
    while True:
        sys.stdout.write("lost, lost\n" * 10000)


def hangs(_):
    time.sleep(600)


def leaves_half_a_file(_):
    OUTPUT.write_text("0.000000 0 0 0 0 0 0 1\n0.033333 0.1 0")


def crashes_the_third_time(count):
    with open(count, "a+") as file:
        file.write("x")
        file.flush()
        file.seek(0)
        if len(file.read()) == 3:
            os.kill(os.getpid(), signal.SIGSEGV)
    stamps = [line.split()[0] for line in (SEQUENCE / "rgb.txt").read_text().splitlines()
              if not line.startswith("#")]
    OUTPUT.write_text("".join(f"{stamp} 0 0 0 0 0 0 1\n" for stamp in stamps))


def kills_edvo(_):
    """Ends the process that waits for the tracker as an abort would: its parent's parent."""
    with open(f"/proc/{os.getppid()}/status") as status:
        parent = next(int(line.split()[1]) for line in status if line.startswith("PPid"))
    os.kill(parent, signal.SIGABRT)
    time.sleep(600)


globals()[sys.argv[1]](sys.argv[2] if len(sys.argv) > 2 else None)
