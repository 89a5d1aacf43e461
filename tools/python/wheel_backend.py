"""Builds the wheel of edvo for pip (PEP 517) by CMake, with nothing but Python's own library: a build that pip
isolates finds no other, and there may be no network."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def _version():
    return re.search(r"project\(edvo VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub("[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def _metadata():
    return (f"Metadata-Version: 2.1\nName: edvo\nVersion: {_version()}\n"
            "Summary: Edge-direct visual odometry and its synthetic RGB-D laboratory\n"
            "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")


def _built_files(folder):
    """The files of the installed package, by their path below site-packages."""
    build, prefix = folder / "build", folder / "prefix"
    options = ["-DEDVO_BUILD_TOOLS=OFF", "-DEDVO_BUILD_PYTHON=ON", "-DEDVO_INSTALL=OFF", "-DBUILD_TESTING=OFF",
               "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0",
               f"-DPython3_EXECUTABLE={sys.executable}", "-DEDVO_PYTHON_DIR=."]
    generator = ["-G", "Ninja"]
    subprocess.check_call(["cmake", "-S", ROOT, "-B", build, *generator, *options])
    subprocess.check_call(["cmake", "--build", build, "--target", "edvo_python"])
    subprocess.check_call(["cmake", "--install", build, "--component", "python", "--strip", "--prefix", prefix])
    return {path.relative_to(prefix).as_posix(): path.read_bytes()
            for path in sorted(prefix.rglob("*")) if path.is_file()}


def _record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    info = f"edvo-{_version()}.dist-info"
    with tempfile.TemporaryDirectory() as folder:
        files = _built_files(pathlib.Path(folder))
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: edvo {_version()}\nRoot-Is-Purelib: false\n"
                              f"Tag: {_tag()}\n").encode()
    files[f"{info}/licenses/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(_record_line(name, content) for name, content in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    name = f"edvo-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("edvo is built from its repository; there is no source archive of its Python module alone")
