"""From README.md every folder that git knows is reached by at most two links, and the README of a folder names a file of it.

folders.py SOURCE. A link to a file reaches its folder; a link to a folder goes on in its README.
"""
import os
import pathlib
import re
import subprocess
import sys

# Folders that need no link, with all below them, and why.
EXEMPT = {
    ".ci": "one script, which CI calls by its path",
    ".devcontainer": "a container for editors, which find it by its path",
    ".github": "workflows and templates, which the forge finds by their paths",
    "formats/drawings/viewer/three": "three.js, of other authors, beside the page that loads it",
    "include": "a link, so that #include names a path of the checkout",
    "tests/formats/corpus": "inputs, a folder for each format",
    "tests/formats/foreign": "files that other programs wrote, for one test",
    "tests/verify/arithmetic": "three sources that are compiled in another way, for one test",
}
# The large folders say what comes in, what goes out and which file to read first.
WITH_README = ["algorithms", "analysis", "apps", "base", "bench", "formats", "generators", "model", "optimum", "store", "tests", "tools", "verify"]
MOST_LINKS = 2


def targets(source, page):
    """What the links of a page lead to, as paths from the root."""
    for link in re.findall(r"\]\(([^)#\s]+)[^)]*\)|<img src=\"([^\"]+)\"", (source / page).read_text()):
        link = "".join(link)
        if "://" not in link:
            yield os.path.normpath(os.path.join(os.path.dirname(page), link))


def reached_folders(source, files):
    reached, pages = set(), {"README.md"}
    for _ in range(MOST_LINKS):
        found = {target for page in pages for target in targets(source, page)}
        folders = {target for target in found if (source / target).is_dir()} | {os.path.dirname(target) for target in found}
        reached |= folders
        pages = {target for target in found if target.endswith(".md")} | {f"{folder}/README.md" for folder in found}
        pages &= files
    return reached


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=source, capture_output=True, text=True, check=True)
    files = {name for name in listed.stdout.splitlines() if (source / name).exists()}
    folders = {os.path.dirname(name) for name in files} - {""}
    wrong = [f"{gone}: no such folder, yet exempt" for gone in EXEMPT if not (source / gone).exists()]
    exempt = {folder for folder in folders for root in EXEMPT if folder == root or folder.startswith(root + "/")}
    for folder in sorted(folders - exempt - reached_folders(source, files)):
        wrong.append(f"{folder}: not reached from README.md by {MOST_LINKS} links")
    wrong += [f"{folder}: has no README.md" for folder in WITH_README if f"{folder}/README.md" not in files]
    for readme in sorted(name for name in files if name.endswith("/README.md")):
        folder = os.path.dirname(readme) + "/"
        named = set(targets(source, readme)) | {folder + word for word in re.findall(r"`([\w./-]+)`", (source / readme).read_text())}
        if not any(name.startswith(folder) and name in files for name in named):
            wrong.append(f"{readme}: names no file of its folder")
    print("\n".join(wrong) or f"{len(folders)} folders, each {MOST_LINKS} links away at most")
    sys.exit(bool(wrong))


main()
