#!/usr/bin/env python3
"""stage.py ROOT EDVO OUT: writes what the site is built from into the folder OUT.

Pages keep their places in the repository, so links between them hold. What they link to and is no page is
put beside them: pictures as they are, sources and folders as pages. Commands are what `EDVO manual` says.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
import documents  # noqa: E402

PICTURES = {".png", ".svg", ".webp"}
LANGUAGES = {".h": "cpp", ".cpp": "cpp", ".ts": "ts", ".py": "python", ".ipynb": "json", ".pyi": "python",
             ".json": "json", ".toml": "toml"}


class Stage:
    def __init__(self, root, out):
        self.root, self.out = root, out
        self.pages = [path.relative_to(root) for path in documents.pages(root)]

    def write(self, path, text):
        file = self.out / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def target(self, page, link):
        """Puts what `page` links to into its place; returns the link to it."""
        path, _, anchor = link.partition("#")
        if not path or re.match(r"^\w+:", link):
            return link
        file = pathlib.Path(os.path.normpath(page.parent / path))
        if file in self.pages:
            return link
        source = self.root / file
        if source.is_dir():
            return self.folder_link(page, file)
        if source.suffix in PICTURES:
            self.out.joinpath(file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, self.out / file)
            return link
        self.source_page(file)
        return f"{path}.md" + (f"#{anchor}" if anchor else "")

    def folder_link(self, page, folder):
        index = folder / "README.md"
        if index not in self.pages:
            index = folder / "index.md"
            files = sorted(path for path in (self.root / folder).iterdir() if path.is_file())
            for file in files:
                self.source_page(file.relative_to(self.root))
            lines = [f"- [`{file.name}`]({file.name}.md)" for file in files]
            self.write(index, "\n".join([f"# `{folder}`", "", *lines, ""]))
        return os.path.relpath(index, page.parent)

    def source_page(self, file):
        text = (self.root / file).read_text()
        fence = "~" * max(3, *(len(run) + 1 for run in re.findall("~+", text)), 3)
        language = LANGUAGES.get(file.suffix, "text")
        self.write(f"{file}.md", f"---\nsearch:\n  exclude: true\n---\n\n# `{file}`\n\n"
                                 f"{fence}{language}\n{text.rstrip()}\n{fence}\n")

    def page(self, page):
        text = (self.root / page).read_text()
        self.write(page, documents.replace_links(text, lambda link: self.target(page, link)))

    def commands(self, manual):
        """One page for each command of the program, with its subcommands below it."""
        title, *sections = re.split(r"^## edvo ", manual, flags=re.MULTILINE)
        texts = {}
        for section in sections:
            name = section.split()[0]
            if name in texts:
                texts[name] += "## edvo " + section
            else:
                texts[name] = "# edvo " + section
        rows = "".join(f"- [edvo {name}]({name}.md)\n" for name in texts)
        self.write("commands/index.md", f"{title.rstrip()}\n\n{rows}")
        for name, text in texts.items():
            self.write(f"commands/{name}.md", text)


def main(root, edvo, out):
    if out.exists():
        shutil.rmtree(out)
    stage = Stage(root, out)
    for page in stage.pages:
        stage.page(page)
    manual = subprocess.run([edvo, "manual", "--format", "markdown"], check=True, capture_output=True, text=True)
    stage.commands(manual.stdout)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3]).resolve())
