"""No module of the workbench needs itself, not even by an import inside of a function."""

import ast
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "plugin" / "suture_workbench"


def modules_in(folder):
    """Module name to file; a package is its __init__."""
    found = {}
    for path in sorted(folder.rglob("*.py")):
        parts = path.relative_to(folder).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports_of(name, path, modules):
    """The modules of the same package that one imports, wherever in it that stands."""
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    needed = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.ImportFrom) or node.level == 0:
            continue
        parts = package.split(".") if package else []
        base = parts[: len(parts) - node.level + 1]
        source = ".".join(base + ([node.module] if node.module else []))
        for alias in node.names:
            inner = f"{source}.{alias.name}" if source else alias.name
            needed.add(inner if inner in modules else source)
    return (needed & set(modules)) - {name}


def circle_in(graph):
    """A list of names, each of which needs the next and the last the first; [] if there is none."""
    done, way = set(), []

    def walk(name):
        if name in way:
            return way[way.index(name) :]
        if name in done:
            return []
        way.append(name)
        for needed in sorted(graph[name]):
            if circle := walk(needed):
                return circle
        way.pop()
        done.add(name)
        return []

    for name in sorted(graph):
        if circle := walk(name):
            return circle
    return []


def graph_of(folder):
    modules = modules_in(folder)
    return {name: imports_of(name, path, modules) for name, path in modules.items()}


class PluginImports(unittest.TestCase):
    def test_there_is_no_circle(self):
        graph = graph_of(PLUGIN)
        self.assertIn("feature", graph["api"])
        self.assertIn("feature", graph["gui.fill_panel"])
        self.assertEqual(circle_in(graph), [])

    def test_a_circle_through_a_function_is_seen(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "gui").mkdir()
            (folder / "gui" / "__init__.py").write_text("")
            (folder / "gui" / "panel.py").write_text("from .. import api\n")
            (folder / "api.py").write_text("def show():\n    from .gui.panel import Panel\n")
            self.assertEqual(circle_in(graph_of(folder)), ["api", "gui.panel"])


if __name__ == "__main__":
    unittest.main()
