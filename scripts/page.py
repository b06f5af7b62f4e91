"""Completes the folder of the page: index.html with its styles and their hashes, and the licences of all that is in it.

scripts/web runs it, with the folder as its one argument.
"""

import base64
import gzip
import hashlib
import json
import pathlib
import subprocess
import sys

WEB = pathlib.Path("assets/web")
TARGET = "wasm32-unknown-unknown"
PACKAGE = "bxdf-web"


def packages():
    """What the page is made of: the packages of the workspace's graph that its own one leads to in a browser."""
    command = ["cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", TARGET]
    known = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    by_id = {package["id"]: package for package in known["packages"]}
    nodes = {node["id"]: node for node in known["resolve"]["nodes"]}
    begin = next(id for id, package in by_id.items() if package["name"] == PACKAGE)
    found, waiting = set(), [begin]
    while waiting:
        id = waiting.pop()
        if id in found:
            continue
        found.add(id)
        for needed in nodes[id]["deps"]:
            if any(kind["kind"] is None for kind in needed["dep_kinds"]):
                waiting.append(needed["pkg"])
    return sorted((by_id[id] for id in found), key=lambda package: (package["name"], package["version"]))


def folder(package):
    return pathlib.Path(package["manifest_path"]).parent


def licences(all_packages):
    """The text of licences.txt: each text once, with those that stand under it."""
    texts, lines = {}, []
    for package in all_packages:
        name = f"{package['name']} {package['version']}"
        lines.append(f"{name}: {package['license'] or 'see its text'}")
        files = [file for file in folder(package).rglob("*") if file.is_file()]
        words = ("licen", "copying", "notice", "ofl", "ufl")
        for file in sorted(files):
            is_text = file.suffix.lower() in ("", ".txt", ".md") and file.name.lower().startswith(words)
            if is_text and file.stat().st_size < 1 << 16:
                text = file.read_text(encoding="utf-8", errors="replace").strip()
                texts.setdefault(text, []).append(name)
    parts = ["BRDF Explorer: what is in the page, and its licences", "\n".join(lines)]
    for text, names in sorted(texts.items(), key=lambda item: item[1]):
        parts.append(f"{'=' * 72}\n{', '.join(sorted(set(names)))}\n{'=' * 72}\n{text}")
    return "\n\n".join(parts) + "\n"


def hash_of(style):
    return f"'sha256-{base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()}'"


def main():
    out = pathlib.Path(sys.argv[1])
    all_packages = packages()
    dialogs = next(package for package in all_packages if package["name"] == "rfd")
    style = (WEB / "style.css").read_text().strip()
    # The library of dialogs brings a style of its own.
    of_dialogs = (folder(dialogs) / "src/backend/wasm/style.css").read_text()
    program = out / "explorer.wasm.gz"
    digest = hashlib.sha256(gzip.decompress(program.read_bytes())).hexdigest()[:12]
    values = {
        "@STYLES@": f"{hash_of(style)} {hash_of(of_dialogs)}",
        "@STYLE@": style,
        # Another version has another address: no cache mixes two of them.
        "@PROGRAM@": f"{program.name}?{digest}",
        "@BYTES@": str(program.stat().st_size),
    }
    page = (WEB / "index.html").read_text()
    for key, value in values.items():
        page = page.replace(key, value)
    (out / "index.html").write_text(page)
    (out / "licences.txt").write_text(licences(all_packages))


if __name__ == "__main__":
    main()
