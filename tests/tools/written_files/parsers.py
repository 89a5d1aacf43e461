"""Parsers of every kind of text file that the program writes, none of them the project's own.

Each takes a path and returns nothing; it raises ValueError, or its library's error, for what is not
valid or does not mean what a file of its kind must.
"""

import csv
import hashlib
import html.parser
import io
import json
import math
import re
import struct
import subprocess
import tarfile
import tomllib
import xml.etree.ElementTree as ElementTree
import zipfile
import zlib

import numpy

VOID_TAGS = {"meta", "link", "img", "input", "br", "hr", "area", "col", "source", "wbr", "base", "embed", "track"}
SVG = "{http://www.w3.org/2000/svg}"


def require(condition, message):
    if not condition:
        raise ValueError(message)


def unique_members(pairs):
    members = dict(pairs)
    require(len(members) == len(pairs), f"a key is there twice: {[key for key, _ in pairs]}")
    return members


def refuse_constant(name):
    raise ValueError(f"{name} is no JSON")


def load_json(text):
    """JSON as RFC 8259 has it: no NaN, no Infinity, and no key twice."""
    return json.loads(text, object_pairs_hook=unique_members, parse_constant=refuse_constant)


def parse_json(path):
    return load_json(path.read_text(encoding="utf-8"))


def load_json_lines(path):
    """The members of a head, which names the schema, and of what it heads, a line each, together."""
    text = path.read_text(encoding="utf-8")
    require(text.endswith("\n"), "the last line does not end")
    head, *rest = [load_json(line) for line in text.splitlines()]
    require({"schema", "schema_version", "hash"} == set(head), f"the head has {list(head)}")
    require(len(rest) == 1, f"{len(rest)} lines after the head, expected one")
    require(not set(head) & set(rest[0]), "a member is in the head and below it")
    return {**head, **rest[0]}


def parse_toml(path):
    with path.open("rb") as file:
        tomllib.load(file)


def is_number(field):
    try:
        return math.isfinite(float(field))
    except ValueError:
        return False


def parse_csv(path):
    """A header of names or of EuRoC's `#name [unit]`, rows of as many fields, and in a column either
    numbers and gaps or text."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file, strict=True))
    require(len(rows) > 0, "no header")
    header = rows[0]
    require(len(set(header)) == len(header), f"two columns have the same name: {header}")
    require(not any(is_number(name) for name in header), f"the first row is no header: {header}")
    for number, row in enumerate(rows[1:], start=2):
        require(len(row) == len(header), f"row {number} has {len(row)} fields, expected {len(header)}")
    for index, name in enumerate(header):
        column = [row[index] for row in rows[1:] if row[index]]
        numbers = [is_number(field) for field in column]
        require(all(numbers) or not any(numbers), f"{name}: numbers and text in one column: {column[:5]}")
        require(not any(re.fullmatch("[-+]?(nan|inf)", field) for field in column), f"{name}: nan or inf")


def run_xmllint(arguments, path):
    done = subprocess.run(["xmllint", "--noout", "--nonet", *arguments, str(path)], capture_output=True,
                          text=True, check=False)
    require(done.returncode == 0 and not done.stderr, done.stderr)


def parse_svg(path):
    """Well formed, with a view box, a title, and no coordinate that is not a number."""
    run_xmllint([], path)
    root = ElementTree.parse(path).getroot()
    require(root.tag == SVG + "svg", f"the root is {root.tag}")
    box = root.get("viewBox", "").split()
    require(len(box) == 4 and all(is_number(field) for field in box), "no viewBox")
    texts = [text for text in ("".join(element.itertext()) for element in root.iter(SVG + "text")) if text]
    require(texts, "no text")
    for element in root.iter():
        for name, value in element.attrib.items():
            words = re.split(r"[\s,()]+", value)
            require(not {"nan", "-nan", "inf", "-inf"} & set(words), f"{name}={value[:60]}")


def parse_junit(path):
    """Counts agree with the cases, times and names are there."""
    run_xmllint([], path)
    suites = ElementTree.parse(path).getroot()
    require(suites.tag == "testsuites", f"the root is {suites.tag}")
    for suite in suites.iter("testsuite"):
        cases = suite.findall("testcase")
        for attribute, count in (("tests", len(cases)),
                                 ("failures", sum(case.find("failure") is not None for case in cases)),
                                 ("errors", sum(case.find("error") is not None for case in cases))):
            require(int(suite.get(attribute)) == count, f"{attribute}={suite.get(attribute)}, are {count}")
        for case in cases:
            require(case.get("name") and case.get("classname"), "a case without name")
            require(float(case.get("time")) >= 0, "a negative time")
    total = len(list(suites.iter("testcase")))
    require(suites.get("tests") in (None, str(total)), f"tests={suites.get('tests')}, are {total}")


class HtmlReader(html.parser.HTMLParser):
    """Every tag is closed in turn, and scripts of JSON are JSON."""

    def __init__(self):
        super().__init__()
        self.open_tags = []
        self.json = None
        self.has_json = False

    def handle_starttag(self, tag, attrs):
        if tag not in VOID_TAGS:
            self.open_tags.append(tag)
        if tag == "script" and dict(attrs).get("type") == "application/json":
            self.json = ""

    def handle_startendtag(self, tag, attrs):
        pass

    def handle_endtag(self, tag):
        require(self.open_tags and self.open_tags.pop() == tag, f"</{tag}> closes another tag")
        if self.json is not None:
            load_json(self.json)
            self.json, self.has_json = None, True

    def handle_data(self, data):
        if self.json is not None:
            self.json += data


def parse_html(path):
    """As Python's parser and libxml2's (HTML 4 with its complaints on the tags of HTML 5) read it."""
    reader = HtmlReader()
    reader.feed(path.read_text(encoding="utf-8"))
    reader.close()
    require(not reader.open_tags, f"not closed: {reader.open_tags}")
    require(reader.has_json, "a report without its data as JSON")
    done = subprocess.run(["xmllint", "--html", "--noout", "--nonet", "--huge", str(path)], capture_output=True,
                          text=True, check=False)
    errors = [line for line in done.stderr.splitlines() if " error : " in line and "Tag " not in line]
    require(done.returncode == 0 and not errors, "\n".join(errors[:5]))


def parse_markdown(path):
    """Tables have rows of as many cells as their heads, and pictures are there."""
    text = path.read_text(encoding="utf-8")
    cells = None
    for line in text.splitlines():
        count = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
        require(None in (cells, count) or cells == count, f"{count} bars, expected {cells}: {line}")
        cells = count
    for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", text):
        require((path.parent / picture).exists(), f"there is no picture {picture}")


def parse_file_list(path):
    """The list of a folder's own files: `hash bytes name` for each, and each is there with its size."""
    names = []
    for line in path.read_text(encoding="utf-8").splitlines():
        match = re.fullmatch(r"[0-9a-f]{32} (\d+) (.+)", line)
        require(match is not None, f"no hash, size and name: {line}")
        file = path.parent / match[2]
        require(file.is_file() and file.stat().st_size == int(match[1]), f"{match[2]} is not there as listed")
        names.append(match[2])
    there = {str(file.relative_to(path.parent)) for file in path.parent.rglob("*") if file.is_file()}
    require(set(names) | {path.name} == there, f"lists {len(names)} of {len(there) - 1} files")


NUMPY_TYPES = {"float": "<f4", "uchar": "u1", ("F", "4"): "<f4", ("U", "4"): "<u4"}


def parse_ply(path):
    """Binary PLY as its specification has it: numbers of the header's properties, to the last byte."""
    head, _, body = path.read_bytes().partition(b"end_header\n")
    lines = head.decode("ascii").splitlines()
    require(lines[:2] == ["ply", "format binary_little_endian 1.0"], f"begins with {lines[:2]}")
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex "))
    fields = [line.split()[1:] for line in lines if line.startswith("property ")]
    points = numpy.frombuffer(body, dtype=[(name, NUMPY_TYPES[kind]) for kind, name in fields])
    require(len(points) == count, f"has {len(points)} points, its header says {count}")
    require_points(points)


def parse_pcd(path):
    """Binary PCD as its specification has it; where a PLY of the same name lies beside it, with the same points."""
    head, _, body = path.read_bytes().partition(b"DATA binary\n")
    words = dict(line.split(" ", 1) for line in head.decode("ascii").splitlines() if not line.startswith("#"))
    kinds = [NUMPY_TYPES[pair] for pair in zip(words["TYPE"].split(), words["SIZE"].split(), strict=True)]
    points = numpy.frombuffer(body, dtype=list(zip(words["FIELDS"].split(), kinds, strict=True)))
    require(words["VERSION"] == "0.7" and set(words["COUNT"].split()) == {"1"}, f"is of {words}")
    require(len(points) == int(words["POINTS"]) == int(words["WIDTH"]) * int(words["HEIGHT"]),
            f"has {len(points)} points, its header says {words['POINTS']}")
    require_points(points)
    ply = path.with_suffix(".ply")
    require(not ply.exists() or ply.read_bytes().endswith(points_as_ply(points)), f"has other points than {ply.name}")


def require_points(points):
    for name in ("x", "y", "z", "inverse_depth_sigma"):
        require(numpy.isfinite(points[name]).all(), f"{name} is not finite")
    require((points["inverse_depth_sigma"] > 0).all(), "inverse_depth_sigma is not positive")


def points_as_ply(points):
    """The body of the PLY that has these points of a PCD."""
    kinds = [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("rgb", "u1", 3), ("inverse_depth_sigma", "<f4")]
    rewritten = numpy.zeros(len(points), dtype=kinds)
    for name in ("x", "y", "z", "inverse_depth_sigma"):
        rewritten[name] = points[name]
    for channel, shift in enumerate((16, 8, 0)):
        rewritten["rgb"][:, channel] = points["rgb"] >> shift & 255
    return rewritten.tobytes()


def parse_zip(path):
    """An archive of evo's: its files are whole, and its arrays and statistics are those of one another."""
    with zipfile.ZipFile(path) as archive:
        require(archive.testzip() is None, f"{archive.testzip()} is damaged")
        files = {name: archive.read(name) for name in archive.namelist()}
    require({"info.json", "stats.json", "error_array.npy"} <= set(files), f"is not for evo_res: {sorted(files)}")
    info, stats = load_json(files["info.json"].decode()), load_json(files["stats.json"].decode())
    require({"title", "label", "ref_name", "est_name"} == set(info), f"info.json has {sorted(info)}")
    arrays = {name[:-4]: numpy.load(io.BytesIO(data)) for name, data in files.items() if name.endswith(".npy")}
    alignment = arrays.pop("alignment_transformation_sim3", numpy.eye(4))
    require(alignment.shape == (4, 4) and not alignment[3].dot([1, 1, 1, 0]), "the alignment is no 4 x 4 matrix")
    errors = arrays["error_array"]
    for name, array in arrays.items():
        require(array.dtype == numpy.float64 and array.shape == errors.shape, f"{name} is {array.dtype}{array.shape}")
        require(numpy.isfinite(array).all(), f"{name}: nan or inf")
    require((numpy.diff(arrays["timestamps"]) > 0).all(), "stamps do not increase")
    expected = {"rmse": numpy.sqrt(numpy.mean(errors ** 2)), "mean": errors.mean(), "median": numpy.median(errors),
                "std": errors.std(), "min": errors.min(), "max": errors.max(), "sse": numpy.sum(errors ** 2)}
    require(set(stats) == set(expected), f"stats.json has {sorted(stats)}")
    for name, value in expected.items():
        require(math.isclose(stats[name], value, rel_tol=1e-9, abs_tol=1e-12), f"{name} is {stats[name]}, not {value}")


def parse_mcap(path):
    """An MCAP file as its specification has it: records to the last byte, CRC-32s, chunks that their index finds, and
    as many messages as the statistics say."""
    data, magic = path.read_bytes(), b"\x89MCAP0\r\n"
    require(data.startswith(magic) and data.endswith(magic), "does not begin and end as MCAP does")
    counts, chunks, indexed, statistics, summary = {}, set(), set(), None, None
    for opcode, begin, content in mcap_records(data, len(magic), len(data) - len(magic)):
        if opcode == 0x06:
            chunks.add(begin)
            size, crc, name = struct.unpack_from("<QII", content, 16)
            require(name == 0, "this parser reads chunks that are not compressed")
            records = content[40:]
            require(len(records) == size and zlib.crc32(records) == crc, f"the chunk at {begin} is damaged")
            for kind, _, message in mcap_records(records, 0, len(records)):
                if kind == 0x05:
                    (channel,) = struct.unpack_from("<H", message)
                    counts[channel] = counts.get(channel, 0) + 1
        elif opcode == 0x08:
            indexed.add(struct.unpack_from("<Q", content, 16)[0])
        elif opcode == 0x0B:
            statistics = struct.unpack_from("<QHIIII", content)
        elif opcode == 0x0F:
            require(zlib.crc32(data[:begin]) == struct.unpack("<I", content)[0], "the data's CRC-32 is wrong")
        elif opcode == 0x02:
            summary, _, crc = struct.unpack("<QQI", content)
            require(zlib.crc32(data[summary : begin + 25]) == crc, "the summary's CRC-32 is wrong")
    require(summary and chunks == indexed, f"chunks are at {sorted(chunks)}, their index has {sorted(indexed)}")
    require(statistics[0] == sum(counts.values()) and statistics[5] == len(chunks), f"statistics are {statistics}")


def mcap_records(data, at, end):
    while at < end:
        opcode, size = struct.unpack_from("<BQ", data, at)
        require(at + 9 + size <= end, f"the record at {at} has {size} bytes, which are not there")
        yield opcode, at, data[at + 9 : at + 9 + size]
        at += 9 + size


def parse_avi(path):
    """An AVI file of one RIFF chunk: chunks to the last byte, and as many images as its headers say."""
    data = path.read_bytes()
    require(data[:4] + data[8:12] == b"RIFFAVI ", "does not begin as AVI does")
    require(struct.unpack_from("<I", data, 4)[0] == len(data) - 8, "RIFF's size is not the file's")
    stated, images, indexed = set(), 0, 0
    for name, content in riff_chunks(data, 12, len(data)):
        if name == b"avih":
            stated.add(struct.unpack_from("<I", content, 16)[0])
        elif name == b"strh":
            require(content[:4] == b"vids", f"a stream is of {content[:4]}")
            stated.add(struct.unpack_from("<I", content, 32)[0])
        elif name == b"00dc":
            images += 1
        elif name == b"idx1":
            indexed = len(content) // 16
    require(stated == {images} and indexed == images, f"{images} images, {indexed} in the index, stated are {stated}")


def riff_chunks(data, at, end):
    """The chunks of RIFF, those within lists, too."""
    while at < end:
        name, size = struct.unpack_from("<4sI", data, at)
        require(at + 8 + size <= end, f"the chunk at {at} has {size} bytes, which are not there")
        if name == b"LIST":
            yield from riff_chunks(data, at + 12, at + 8 + size)
        else:
            yield name, data[at + 8 : at + 8 + size]
        at += 8 + size + size % 2


def parse_tar(path):
    """An archive of regular files without owner and time."""
    with tarfile.open(path) as archive:
        for member in archive:
            require(member.isreg() and member.mtime == 0 and member.uid == 0, f"{member.name}: {member.get_info()}")
            require(len(archive.extractfile(member).read()) == member.size, f"{member.name}: is cut")


def parse_checksums(path):
    """SHA-256 of each file beside it, as sha256sum --check reads them, and of no other."""
    names = []
    for line in path.read_text(encoding="utf-8").splitlines():
        match = re.fullmatch(r"([0-9a-f]{64})  (.+)", line)
        require(match is not None, f"no checksum and name: {line}")
        require(hashlib.sha256((path.parent / match[2]).read_bytes()).hexdigest() == match[1], f"{match[2]} differs")
        names.append(match[2])
    there = {str(file.relative_to(path.parent)) for file in path.parent.rglob("*") if file.is_file()}
    require(set(names) | {path.name} == there and len(set(names)) == len(names), "lists other files than there are")


def parse_webp(path):
    """A RIFF file of the size that it states, with a picture (WebP Container Specification)."""
    data = path.read_bytes()
    require(data[:4] == b"RIFF" and data[8:12] == b"WEBP" and data[12:16] in (b"VP8 ", b"VP8L", b"VP8X"), "no WebP")
    require(struct.unpack("<I", data[4:8])[0] + 8 == len(data), f"{len(data)} bytes are not as many as it states")


def parse_script(path):
    """A script of bash, as bash itself reads it."""
    done = subprocess.run(["bash", "-n", path], capture_output=True, text=True, check=False)
    require(done.returncode == 0, done.stderr)


PARSERS = {".json": parse_json, ".jsonl": load_json_lines, ".toml": parse_toml, ".csv": parse_csv, ".svg": parse_svg,
           ".xml": parse_junit, ".html": parse_html, ".md": parse_markdown,
           ".ply": parse_ply, ".pcd": parse_pcd, ".zip": parse_zip, ".mcap": parse_mcap,
           ".avi": parse_avi, ".tar": parse_tar, ".sha256": parse_checksums, ".webp": parse_webp,
           ".sbatch": parse_script}
OTHERS = {".png", ".npy", ".flo", ".txt", ".gz", ".yaml", ".depth", ".freiburg", ".files", ".rows", ""}


def parse(path):
    """Reads a file by its extension. A kind that is not known fails: a new one needs a parser, or a
    line in OTHERS."""
    extension = path.suffix.lower()
    require(extension in PARSERS or extension in OTHERS, f"no parser for {extension}")
    if path.name == ".edvo-files":
        parse_file_list(path)
    if extension in PARSERS:
        PARSERS[extension](path)
