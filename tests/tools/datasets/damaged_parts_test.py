"""Parts and plans of a data set that were edited, cut or exchanged before `edvo dataset merge` sees them.

    damaged_parts_test.py EDVO REPOSITORY SCRATCH
"""

import json
import pathlib
import shutil
import subprocess

from dataset_program import EDVO, REPOSITORY, SCRATCH, edvo, files_of

SPEC = """
name = "small"
about = "A small data set."
part_frames = 4
{more}
[camera]
width = 64
height = 48
[path]
rate = 10
duration = 1.0
[scenes.box]
gltf = "{assets}/plane_and_box/plane_and_box.gltf"
[scenes.moving]
gltf = "{assets}/moving_room/moving_room.gltf"
split = "test"
[paths.orbit]
kind = "orbit"
orbit.radius = 2.0
[sensors.plain]
"""
FIRST = "box_orbit_plain_0-000"


def render_once():
    """Makes the parts `made.part`, from which every check begins, and the data set `one` of them."""
    (SCRATCH / "small.toml").write_text(SPEC.format(more="", assets=REPOSITORY / "assets"))
    edvo("render", "small.toml", "--out", "made")
    shutil.copytree(SCRATCH / "made.part", SCRATCH / "one.part")
    edvo("merge", "small.toml", "--out", "one")


def begin():
    """Returns the folder of all parts as they were made, of the data set `set`."""
    for name in ("set", "set.part"):
        shutil.rmtree(SCRATCH / name, ignore_errors=True)
    shutil.copytree(SCRATCH / "made.part", SCRATCH / "set.part")
    return SCRATCH / "set.part/parts/000"


def require_made_again(*parts):
    """`merge` removes and names the parts, `render` makes them again, and the data set is the one of undamaged parts."""
    out = edvo("merge", "small.toml", "--out", "set", code=5)
    assert out.count("removed: ") == len(parts) and f"{len(parts)} of 6 parts are missing" in out, out
    assert all(f"removed: {part}: " in out for part in parts), out
    edvo("render", "small.toml", "--out", "set")
    edvo("merge", "small.toml", "--out", "set")
    assert files_of(SCRATCH / "set") == files_of(SCRATCH / "one")
    return out


def change_record(part_folder, change):
    record = json.loads((part_folder / "part.json").read_text())
    change(record)
    (part_folder / "part.json").write_text(json.dumps(record))


def check_names_that_lead_out():
    """A record that names a folder of the user's has its part made again, and the folder stays."""
    mine = SCRATCH / "mine"
    mine.mkdir()
    (mine / "notes.txt").write_text("precious")
    for name in (str(mine), "../../../../../mine", "box_orbit_plain_0/../../../../../mine", ".", ""):
        part = begin() / FIRST
        (SCRATCH / "set.part/dataset/train/box").mkdir(parents=True)
        change_record(part, lambda record, name=name: record["files"].append(
            {"name": name, "bytes": 0, "sha256": 64 * "0"}))
        assert "part.json" in require_made_again(FIRST)
        assert (mine / "notes.txt").read_text() == "precious", name


def check_checksums_that_lead_out():
    begin()
    edvo("merge", "small.toml", "--out", "set")
    list_file = SCRATCH / "set/checksums.sha256"
    lines = list_file.read_text().splitlines()
    list_file.write_text("\n".join([*lines, f"{64 * '0'}  ../mine/notes.txt"]) + "\n")
    out = edvo("verify", "set", code=3)
    assert f"checksums.sha256:{len(lines) + 1}: '../mine/notes.txt' leads out of set" in out, out


def check_edited_records():
    """A record that says less than was made, or that it is of another part, is damage."""
    for change in (lambda record: record.update(files=[]), lambda record: record.update(index_files=[]),
                   lambda record: record["files"].pop(), lambda record: record.update(part="box_orbit_plain_0-001"),
                   lambda record: record.update(files=3), lambda record: record.pop("hash"), dict.clear):
        change_record(begin() / FIRST, change)
        require_made_again(FIRST)


def check_exchanged_parts():
    """The folder of another part, or of the same part of another data set, is none of this part."""
    parts = begin()
    shutil.rmtree(parts / FIRST)
    shutil.copytree(parts / "moving_orbit_plain_0-000", parts / FIRST)
    shutil.rmtree(parts / "box_orbit_plain_0-002")
    shutil.copytree(parts / "box_orbit_plain_0-001", parts / "box_orbit_plain_0-002")
    out = require_made_again(FIRST, "box_orbit_plain_0-002")
    assert "is of part box_orbit_plain_0-001, expected box_orbit_plain_0-002" in out, out
    (SCRATCH / "other.toml").write_text((SCRATCH / "small.toml").read_text().replace("radius = 2.0", "radius = 2.5"))
    edvo("render", "other.toml", "--out", "other")
    parts = begin()
    shutil.rmtree(parts / FIRST)
    shutil.copytree(SCRATCH / "other.part/parts/000" / FIRST, parts / FIRST)
    assert "is of another data set" in require_made_again(FIRST)


def check_index_files():
    """Rows of the index and the picture of the card are held to their hashes, as frames are."""
    middle = "box_orbit_plain_0-001"
    for name in ("frames.rows", "picture.webp"):
        for change in (lambda path: path.write_bytes(b""), pathlib.Path.unlink,
                       lambda path: path.write_bytes(path.read_bytes()[:-3] + b"7\n")):
            change(begin() / middle / name)
            assert f"{name} is " in require_made_again(middle)


def check_edited_plans():
    """No command takes a plan that was edited, and all of them name it; nothing is removed."""
    text = (SCRATCH / "made.part/plan.json").read_text()
    plan = json.loads(text)
    sequences, parts = plan["sequences"], plan["parts"]
    edited = "is not as it was written: its hash differs; expected another --out, or its folder removed"
    without_hash = {key: value for key, value in plan.items() if key != "hash"}
    for changes, message, code in (
            ({"sequences": [{**sequences[0], "frames": 14}, sequences[1]], "parts": [*parts[:2], [0, 2, 7, 14], *parts[3:]]},
             edited, 3),
            ({"sequences": [{**sequences[0], "frames": -1}, sequences[1]]}, edited, 3),
            ({"parts": []}, edited, 3), ({"parts": parts[1:]}, edited, 3), ({"parts": [parts[0], *parts]}, edited, 3),
            ({"parts": [[0, 0, 0, 5], *parts[1:]]}, edited, 3), ({"cameras": 1e8}, edited, 3), ({"hash": 7}, edited, 3),
            ({"schema_version": 9}, "schema_version: got 9, expected 1", 3), ({"schema": "edvo.dataset_part"}, "schema", 3),
            (None, "was written by an earlier edvo, without a hash; expected another --out", 6)):
        begin()
        (SCRATCH / "set.part/plan.json").write_text(json.dumps(without_hash if changes is None else {**plan, **changes}))
        for action in ("render", "status", "merge"):
            out = edvo(action, "small.toml", "--out", "set", code=code)
            assert f"set.part/plan.json: {message}" in out or message == "schema" and "is no JSON" in out, out
        assert len(list((SCRATCH / "set.part/parts/000").iterdir())) == 6 and not (SCRATCH / "set").exists()
    (SCRATCH / "set.part/plan.json").write_text(json.dumps(plan))  # other blanks, the same plan
    edvo("merge", "small.toml", "--out", "set")
    assert files_of(SCRATCH / "set") == files_of(SCRATCH / "one")


def check_folders_without_record():
    """A folder that is no part, as one that was copied in part, does not keep the part from being made."""
    for names in ((FIRST,), (FIRST, "moving_orbit_plain_0-002")):
        parts = begin()
        for name in names:
            (parts / name / "part.json").unlink()
            (parts / name / "stray").write_text("left of a copy")
        assert f"{6 - len(names)} of 6 parts are there" in edvo("status", "small.toml", "--out", "set", code=5)
        tasks = [subprocess.Popen([EDVO, "dataset", "render", "small.toml", "--out", "set"], cwd=SCRATCH,
                                  stdout=subprocess.PIPE, text=True) for _ in range(2)]
        assert all("all are there" in task.communicate()[0] and task.returncode == 0 for task in tasks)
        assert {path.name for path in parts.iterdir()} == {path.name for path in (SCRATCH / "made.part/parts/000").iterdir()}
        edvo("merge", "small.toml", "--out", "set")
        assert files_of(SCRATCH / "set") == files_of(SCRATCH / "one")


def check_files_of_ones_own():
    """What somebody put beside the parts stays when they go, and is named."""
    begin()
    staging = SCRATCH / "set.part"
    (staging / "notes.txt").write_text("precious")
    (staging / "pictures").mkdir()
    (staging / "pictures/parts").write_text("precious, too")
    (staging / ".index.elsewhere-1").mkdir()  # of a merge that was killed on another machine
    out = edvo("merge", "small.toml", "--out", "set")
    assert out.count("note: ") == 2 and f"{staging / 'notes.txt'} is not edvo's and stays there" in out, out
    for action, message in (("merge", "there already"), ("render", "all are there"), ("status", "6 of 6 parts are there")):
        assert files_of(SCRATCH / "set") == files_of(SCRATCH / "one")
        assert files_of(staging) == {"notes.txt": b"precious", "pictures/parts": b"precious, too"}
        assert sorted(path.name for path in staging.iterdir()) == ["notes.txt", "pictures"]
        assert message in edvo(action, "small.toml", "--out", "set")
    shutil.copy(SCRATCH / "made.part/plan.json", staging)  # of a merge that was killed when it had the data set
    said = json.loads(edvo("merge", "small.toml", "--out", "set", "--json", "--quiet").partition("note: ")[0])
    assert said["left"] == ["notes.txt", "pictures"] and said["was_there"], said
    assert sorted(path.name for path in staging.iterdir()) == ["notes.txt", "pictures"]


def main():
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    render_once()
    for check in (check_names_that_lead_out, check_checksums_that_lead_out, check_edited_records,
                  check_exchanged_parts, check_index_files, check_edited_plans,
                  check_folders_without_record, check_files_of_ones_own):
        check()
        print(check.__name__, "ok", flush=True)
    shutil.rmtree(SCRATCH)


if __name__ == "__main__":
    main()
