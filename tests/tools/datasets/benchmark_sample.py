"""Holds a sample of the benchmark, assets/datasets/edvo-bench.toml, to its checksums.

    benchmark_sample.py EDVO REPOSITORY SCRATCH
    benchmark_sample.py --write DATASET    prints edvo-bench.sequences from the whole data set's checksums
"""

import hashlib
import json
import pathlib
import shutil
import subprocess
import sys

SAMPLE = "room_spin_kinect_0"


def digest_of(lines):
    """The SHA-256 of a sequence: of `SHA-256  NAME` of its files, sorted by name, a line each."""
    ordered = sorted(lines, key=lambda line: line.split("  ", 1)[1])
    return hashlib.sha256("".join(line + "\n" for line in ordered).encode()).hexdigest()


def write(dataset):
    sequences = {}
    for line in (dataset / "checksums.sha256").read_text().splitlines():
        split, _, rest = line.split("  ", 1)[1].partition("/")
        if split == "test":
            scene, sequence, _ = rest.split("/", 2)
            sequences.setdefault(sequence, []).append(line.replace(f"  test/{scene}/", "  "))
    for sequence in sorted(sequences):
        print(f"{digest_of(sequences[sequence])}  {sequence}")


def main():
    program, repository, scratch = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    spec = repository / "assets/datasets/edvo-bench.toml"
    expected = dict(reversed(line.split("  ")) for line in spec.with_suffix(".sequences").read_text().splitlines())
    words = [program, "dataset", "render", spec, "--out", scratch / "bench", "--quiet"]
    subprocess.run([*words, "--shard", "1/100000"], check=True, capture_output=True)  # the plan
    plan = json.loads((scratch / "bench.part/plan.json").read_text())
    names = [sequence["name"] for sequence in plan["sequences"]]
    assert sorted(names) == sorted(expected), set(names) ^ set(expected)
    (part,) = [i for i, (sequence, *_) in enumerate(plan["parts"]) if names[sequence] == SAMPLE]
    total = sum(sequence["frames"] for sequence in plan["sequences"])
    before = sum(end - first for _, _, first, end in plan["parts"][:part])
    middle = before + (plan["parts"][part][3] - plan["parts"][part][2]) // 2
    subprocess.run([*words, "--shard", f"{middle * 500 // total + 1}/500"], check=True, capture_output=True)
    (record,) = scratch.glob(f"bench.part/parts/*/{SAMPLE}-000/part.json")
    files = json.loads(record.read_text())["files"]
    actual = digest_of([f"{file['sha256']}  {file['name']}" for file in files])
    assert actual == expected[SAMPLE], f"{SAMPLE}: {actual}, expected {expected[SAMPLE]}"
    shutil.rmtree(scratch)


if sys.argv[1] == "--write":
    write(pathlib.Path(sys.argv[2]))
else:
    main()
