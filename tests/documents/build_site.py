#!/usr/bin/env python3
"""build_site.py ROOT EDVO OUT: tools/make-site builds the site, which is whole and loads nothing from elsewhere.

Where a package of tools/packages-site.txt is missing, the exit code is 77.
"""

import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("object", "data")}


class Page(html.parser.HTMLParser):
    """What a page links to, what it loads, and the anchors that it has."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.anchors = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name"):
                self.anchors.add(value)
            elif value and (tag, name) in LOADED:
                self.loaded.append(value)
            elif value and tag == "a" and name == "href":
                self.links.append(value)


def missing_packages():
    equations = "/usr/share/javascript/katex/katex.min.js"
    programs = [name for name in ("mkdocs", "doxygen") if shutil.which(name) is None]
    return programs + ([] if os.path.exists(equations) else ["libjs-katex"])


def is_elsewhere(link):
    return re.match(r"^(https?:)?//", link) is not None


def check_page(page, pages, site):
    """Faults of links of the guide and the documents; Doxygen sees to its own."""
    name = page.relative_to(site)
    for link in pages[page].loaded:
        if is_elsewhere(link):
            yield f"{name} loads {link}"
    for link in pages[page].links + pages[page].loaded:
        url = urllib.parse.urlsplit(link)
        if url.scheme or url.netloc or not (url.path or url.fragment):
            continue
        target = page if not url.path else pathlib.Path(os.path.normpath(page.parent / urllib.parse.unquote(url.path)))
        target = target / "index.html" if target.is_dir() else target
        if not target.exists():
            yield f"{name}: {link} does not exist"
        elif url.fragment and target in pages and urllib.parse.unquote(url.fragment) not in pages[target].anchors:
            yield f"{name}: {link}: there is no such anchor"


def faults_of(site, commands):
    pages = {path: Page(path.read_text()) for path in site.rglob("*.html")}
    for page in pages:
        if page.relative_to(site).parts[0] != "api" and page.name != "404.html":
            yield from check_page(page, pages, site)
        elif any(is_elsewhere(link) for link in pages[page].loaded):
            yield f"{page.relative_to(site)} loads something from elsewhere"
    for path in (site / "theme").rglob("*.css"):
        if re.search(r"url\(['\"]?(https?:)?//", path.read_text()):
            yield f"{path.relative_to(site)} loads something from elsewhere"
    for command in commands:
        if not (site / f"commands/{command}.html").exists():
            yield f"there is no page of edvo {command}"
    if not (site / "api/classvo_1_1RgbdOdometry.html").exists():
        yield "there is no page of vo::RgbdOdometry"
    if 'class="arithmatex"' not in (site / "docs/guide/how_it_works.html").read_text():
        yield "the guide has no equations"


def main(root, program, out):
    missing = missing_packages()
    if missing:
        print(f"{', '.join(missing)}: not installed, the site was not built (tools/packages-site.txt)")
        return 77
    subprocess.run([f"{root}/tools/make-site", out], check=True, env=os.environ | {"EDVO_PROGRAM": program})
    manual = subprocess.run([program, "manual", "--format", "markdown"], check=True, capture_output=True, text=True)
    faults = list(faults_of(pathlib.Path(out), set(re.findall(r"^## edvo ([\w-]+)", manual.stdout, re.MULTILINE))))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
