# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Builds the documentation site and checks every link in it.

    build_site.py OUTPUT       PYTHONPATH holding the package raygauge

OUTPUT/html is the site: the pages of docs/, the Python API from its docstrings, the C++ API by Doxygen (html/cpp).
"""

import html.parser
import inspect
import json
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

HERE = pathlib.Path(__file__).resolve().parent
AWESOME = pathlib.Path("/usr/share/doxygen-awesome-css")  # the C++ API's look, where that package is
ROOT = HERE.parent.parent

# Pages by kind, in order; what is in docs/ but not here stands under "More".
NAVIGATION = {
    "Tutorials": ["tutorials", "tutorial-scenes", "python", "pandas"],
    "How-to": ["user-guide", "experiments", "analysis", "scenes", "depth", "scaling", "bindings", "beside", "contributing"],
    "Reference": ["python-api", "file-format", "columns", "promises", "sets", "generators", "baselines", "dependencies", "glossary"],
    "Explanation": ["quantities", "methods", "three-dimensions", "numerics", "performance", "soak"],
    "Gallery": ["gallery"],
}


def signature_of(member):
    """name(parameters) of a function; pybind11 writes it into the first line of the docstring."""
    try:
        return str(inspect.signature(member))
    except (TypeError, ValueError):
        first = (member.__doc__ or "").splitlines()[:1]
        return re.sub(r"^\w+|raygauge\._raygauge\.", "", first[0]) if first and "(" in first[0] else ""


def body_of(member):
    """The docstring without the signature that pybind11 puts before it."""
    text = inspect.cleandoc(member.__doc__ or "")
    if re.match(r"\w+\(.*\) -> ", text):
        text = text.partition("\n")[2].strip()
    lines, example = [], False
    for line in text.splitlines():
        begins = line.startswith(">>>")
        if begins and not example:
            lines += ["", "```pycon"]
            example = True
        if example and not line.strip():
            lines.append("```")
            example = False
        lines.append(line)
    return "\n".join(lines + (["```"] if example else []))


def constructor_of(member):
    first = (member.__init__.__doc__ or "").splitlines()[:1]
    match = re.match(r"__init__\(self: [\w.]+(?:, )?(.*)\) -> None", first[0]) if first else None
    return f"({match.group(1)})" if match else ""


def python_api(package):
    parts = ["# Python API\n\n`import raygauge as rg`. Arrays are NumPy's; [python.md](python.md) is the tutorial.\n"]
    kinds = {"Queries": [], "Sets": [], "Results": [], "Sweeps and figures": [], "Errors": []}
    for name in sorted(package.__all__, key=str.lower):
        member = getattr(package, name)
        if inspect.ismodule(member):
            kinds["Sweeps and figures"] += [(f"{name}.{key}", value) for key, value in vars(member).items()
                                            if inspect.isfunction(value) and not key.startswith("_")]
        elif inspect.isclass(member) and issubclass(member, Exception):
            kinds["Errors"].append((name, member))
        elif inspect.isclass(member) and issubclass(member, package.ConvexSet):
            kinds["Sets"].append((name, member))
        elif inspect.isclass(member):
            kinds["Results"].append((name, member))
        elif callable(member):
            kinds["Sweeps and figures" if name in ("open", "run") else "Queries"].append((name, member))
    for kind, members in kinds.items():
        parts.append(f"## {kind}\n")
        for name, member in members:
            call = constructor_of(member) if inspect.isclass(member) else signature_of(member)
            parts.append(f"### rg.{name}\n\n" + (f"`{name}{call}`\n\n" if call else "") + body_of(member) + "\n")
    return "\n".join(parts)


class Links(html.parser.HTMLParser):
    """What a page links to or loads, and the anchors that it has."""

    def __init__(self):
        super().__init__()
        self.targets, self.anchors, self.loaded = [], set(), []

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(value for key, value in attributes if key in ("id", "name") and value)
        if tag == "a" and values.get("href"):
            self.targets.append(values["href"])
        if tag in ("script", "img", "iframe") and values.get("src"):
            self.loaded.append(values["src"])
        if tag == "link" and values.get("href") and "canonical" not in (values.get("rel") or ""):
            self.loaded.append(values["href"])


def read_links(page):
    links = Links()
    links.feed(page.read_text(encoding="utf-8"))
    return links


def broken_links(site):
    """One line for each link of the site that leads nowhere, or thing that is loaded from the network."""
    pages = {page: read_links(page) for page in sorted(site.rglob("*.html"))}
    for page, links in pages.items():
        place = page.relative_to(site)
        for target in links.loaded:
            if urllib.parse.urlparse(target).netloc:
                yield f"{place}: loads {target}"
        for target in links.targets + links.loaded:
            parsed = urllib.parse.urlparse(target)
            if parsed.scheme or parsed.netloc or target.startswith("javascript:"):
                continue
            path = urllib.parse.unquote(parsed.path)
            linked = page if not path else (page.parent / path).resolve()
            if place.name == "404.html":  # written for the root of a server
                continue
            if linked.is_dir():
                linked = linked / "index.html"
            if not linked.exists():
                yield f"{place}: no {target}"
            elif parsed.fragment and linked in pages and "cpp" not in linked.parts:
                if urllib.parse.unquote(parsed.fragment) not in pages[linked].anchors:
                    yield f"{place}: no anchor {target}"


def navigation_text(pages):
    """The nav of mkdocs.yml for these pages (names without .md)."""
    listed = {name for names in NAVIGATION.values() for name in names} | {"index"}
    kinds = {**NAVIGATION, "More": sorted(set(pages) - listed)}
    lines = ["nav:", "  - Home: index.md"]
    for kind, names in kinds.items():
        present = [name for name in names if name in pages]
        if present:
            lines += [f"  - {kind}:", *(f"      - {name}.md" for name in present)]
    return "\n".join(lines) + "\n"


# Of the README, what the first page shows before the list of pages.
FIRST_PAGE = ["A first result", "In Python"]
# Pictures have a white ground, which they keep in the dark.
EXTRA_STYLE = """[data-md-color-scheme="slate"] img { background: #fff; border-radius: 2px; }
.md-typeset h1 { font-weight: 600; }
"""


def first_page(readme, pages):
    """What raygauge is, with its picture and a first result, from README.md; then the list of pages of docs/README.md."""
    parts = re.split(r"(?m)^## (.*)\n", readme)
    sections = dict(zip(parts[1::2], parts[2::2]))
    text = parts[0] + "".join(f"## {name}\n{sections[name]}" for name in FIRST_PAGE)
    text = re.sub(r"\]\((?:docs/)([^)]*)\)", r"](\1)", text)
    listed = re.sub(r"(?m)^(#+) ", r"\1# ", pages)
    return f"{text}\n{listed}\nThe C++ API: [classes and functions](cpp/index.html).\n"


def write_sources(folder):
    import raygauge

    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "docs", folder, ignore=shutil.ignore_patterns("site"))
    pages = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.md")}
    pages["python-api.md"] = python_api(raygauge)
    pages["index.md"] = first_page((ROOT / "README.md").read_text(encoding="utf-8"), pages.pop("README.md"))
    (folder / "extra.css").write_text(EXTRA_STYLE, encoding="utf-8")
    (folder / "README.md").unlink()
    for name, text in pages.items():
        # The lists and tables of the pages follow their paragraphs at once, as GitHub reads them.
        text = re.sub(r"(?m)^([^\n|>#`\-* ][^\n]*)\n(?=(?:- |\* |\| ))", r"\1\n\n", text)
        text = re.sub(r"\[([^\]]*)\]\(\.\./[^)]*\)", r"\1", text)  # files that are not of the site
        (folder / name).write_text(text.replace("(README.md", "(index.md"), encoding="utf-8")


def run_doxygen(output):
    settings = (HERE / "Doxyfile").read_text(encoding="utf-8")
    first = HERE / "cpp.md"
    settings += f"\nINPUT = {ROOT / 'include'} {first}\nUSE_MDFILE_AS_MAINPAGE = {first}\n"
    settings += f"FILE_PATTERNS = *.h\nSTRIP_FROM_PATH = {ROOT}\nSTRIP_FROM_INC_PATH = {ROOT / 'include'}\n"
    settings += f"INPUT_FILTER = \"{sys.executable} {HERE / 'whole_sentences.py'}\"\n"
    settings += f"OUTPUT_DIRECTORY = {output / 'html'}\n"
    styles = [AWESOME / "doxygen-awesome.css", AWESOME / "doxygen-awesome-sidebar-only.css"]
    if all(style.exists() for style in styles):
        settings += f"HTML_EXTRA_STYLESHEET = {' '.join(map(str, styles))}\n"
    warnings = subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, stderr=subprocess.PIPE).stderr
    if warnings:
        sys.exit(warnings)


def search_without_server(site):
    """A page opened from the disk may neither fetch the index nor start a worker from a file: a script brings both."""
    index = (site / "search" / "search_index.json").read_text(encoding="utf-8")
    worker = next((site / "assets" / "javascripts" / "workers").glob("search.*.min.js")).read_text(encoding="utf-8")
    script = f"""if (location.protocol === "file:") {{
  var __search = {{ index: Promise.resolve({index}) }};
  const source = new Blob([{json.dumps(worker)}], {{ type: "text/javascript" }});
  const Started = window.Worker;
  window.Worker = function () {{ return new Started(URL.createObjectURL(source)); }};
}}
"""
    (site / "search" / "offline.js").write_text(script, encoding="utf-8")
    bundle = re.compile(r'<script src="([^"]*)assets/javascripts/bundle')
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8", errors="surrogateescape")
        if bundle.search(text):
            text = bundle.sub(r'<script src="\1search/offline.js"></script>\n      \g<0>', text)
            page.write_text(text, encoding="utf-8", errors="surrogateescape")


def main():
    output = pathlib.Path(sys.argv[1]).resolve()
    output.mkdir(parents=True, exist_ok=True)
    write_sources(output / "source")
    pages = sorted(path.stem for path in (output / "source").glob("*.md"))
    settings = (HERE / "mkdocs.yml").read_text(encoding="utf-8") + navigation_text(pages)
    (output / "mkdocs.yml").write_text(settings, encoding="utf-8")
    (output / "source" / "cpp").mkdir(exist_ok=True)
    (output / "source" / "cpp" / "index.html").write_text("", encoding="utf-8")  # Doxygen writes it below
    subprocess.run([sys.executable, "-m", "mkdocs", "build", "--quiet", "--strict"], cwd=output, check=True)
    search_without_server(output / "html")
    run_doxygen(output)
    broken = list(broken_links(output / "html"))
    print("\n".join(broken))
    pages = len(list((output / "html").rglob("*.html")))
    print(f"{pages} pages, {len(broken)} broken links: {output / 'html' / 'index.html'}")
    sys.exit(bool(broken))


if __name__ == "__main__":
    main()
