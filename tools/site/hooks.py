"""What mkdocs.yml cannot say by itself."""

import pathlib


def on_config(config):
    """Puts a page for each command where the navigation says `commands/`, in the order of the program's help."""
    folder = pathlib.Path(config["docs_dir"]) / "commands"
    names = [line.split("](")[1].rstrip(")") for line in (folder / "index.md").read_text().splitlines()
             if line.startswith("- [")]
    for entry in config["nav"]:
        for title, pages in entry.items():
            if pages == "commands/":
                entry[title] = ["commands/index.md"] + [f"commands/{name}" for name in names]
    return config
