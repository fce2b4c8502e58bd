"""The documents of every command follow their JSON Schema, those of errors too; keys may be added."""

import json
import os
import unittest
from pathlib import Path

import jsonschema

from program import CAD, Case, example, run

FOLDER = Path(os.environ["SUTURE_SOURCE_DIR"]) / "docs/schema"
SCHEMAS = {name: json.loads((FOLDER / f"{name}.schema.json").read_text())
           for name in ("inspect", "fill", "check", "convert", "methods")}


class Schemas(Case):
    def validated(self, command, *words):
        document = run(command, *words, "--json").json
        jsonschema.validate(document, SCHEMAS[command])
        return document

    def test_they_are_schemas(self):
        for schema in SCHEMAS.values():
            jsonschema.Draft202012Validator.check_schema(schema)

    def test_documents_follow_them(self):
        part = example("suitcase_corner")
        self.validated("inspect", part)
        self.validated("check", part)
        self.validated("fill", part, "-o", self.folder / "out.step")
        for name in ("a.step", "a.iges", "a.brep", "a.stl", "a.3mf", "a.glb"):
            document = self.validated("convert", part, self.folder / name)
            self.assertEqual("mesh" in document, name in ("a.stl", "a.3mf", "a.glb"))
        self.validated("methods")
        if CAD.is_dir():
            for name in ("goteborg.iges", "bearing.iges"):
                self.validated("inspect", CAD / "files" / name)

    def test_documents_of_errors_follow_them(self):
        for command in SCHEMAS:
            document = self.validated(command, self.folder / "nowhere.step", "--nonsense")
            self.assertEqual(document["error"]["code"], "usage")
        for command in ("inspect", "check"):
            self.assertEqual(self.validated(command, self.folder / "nowhere.step")["error"]["code"], "unreadable")

    def test_new_keys_are_allowed_and_wrong_values_are_not(self):
        document = self.validated("inspect", example("suitcase_corner"))
        document["new"] = document["holes"][0]["new"] = 1
        jsonschema.validate(document, SCHEMAS["inspect"])
        for change in ({"kind": "gap"}, {"diameter": -1}, {"edges": [0]}):
            wrong = {**document, "holes": [{**document["holes"][0], **change}]}
            with self.assertRaises(jsonschema.ValidationError):
                jsonschema.validate(wrong, SCHEMAS["inspect"])
        for command, key in (("check", "edges"), ("fill", "holes")):
            words = ["-o", self.folder / "o.step"] if command == "fill" else []
            document = self.validated(command, example("suitcase_corner"), *words)
            document[key][0]["new"] = document["new"] = 1
            jsonschema.validate(document, SCHEMAS[command])


if __name__ == "__main__":
    unittest.main()
