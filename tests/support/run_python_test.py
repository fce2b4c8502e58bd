"""Runs one test method of a unittest file, or lists them all; CTest calls it for each of them.

    run_python_test.py --list FILE      prints Class.method for every test in FILE, without importing it
    run_python_test.py FILE CASE        exit code 0 passed, 77 skipped (with the reason), 1 failed
"""

import ast
import importlib.util
import sys
import unittest
from pathlib import Path

SKIPPED = 77


def list_cases(file):
    tree = ast.parse(Path(file).read_text(encoding="utf-8"), file)
    classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    cases = [
        f"{node.name}.{method.name}"
        for node in classes
        for method in node.body
        if isinstance(method, ast.FunctionDef) and method.name.startswith("test")
    ]
    if not cases:
        raise SystemExit(f"{file}: no test method")
    return cases


def run_case(file, case):
    sys.path.insert(0, str(Path(file).parent))
    spec = importlib.util.spec_from_file_location(Path(file).stem, file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    try:
        spec.loader.exec_module(module)
    except unittest.SkipTest as reason:
        print("Skipped:", reason)
        return SKIPPED
    suite = unittest.defaultTestLoader.loadTestsFromName(case, module)
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    if not result.wasSuccessful():
        return 1
    for _, reason in result.skipped:
        print("Skipped:", reason)
        return SKIPPED
    return 0 if result.testsRun == 1 else 1


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--list":
        print("\n".join(list_cases(sys.argv[2])))
    elif len(sys.argv) == 3:
        sys.exit(run_case(sys.argv[1], sys.argv[2]))
    else:
        raise SystemExit(__doc__)
