"""The JSON documents of the program against the schemas in docs/schemas."""

import json
import re

import jsonschema

from parsers import require


def with_definitions(schema, folder):
    """The schema with what it refers to in another one, `results.json#/$defs/trial`, among its own definitions."""
    text = json.dumps(schema)
    for other in sorted(set(re.findall(r'"\$ref": "([^"#]+\.json)#/\$defs/', text))):
        text = text.replace(f'"{other}#/$defs/', '"#/$defs/')
        definitions = json.loads((folder / other).read_text(encoding="utf-8"))["$defs"]
        both = set(definitions) & set(schema.get("$defs", {}))
        require(not both, f"defined here and in {other}: {sorted(both)}")
        schema = json.loads(text)
        schema["$defs"] = {**definitions, **schema.get("$defs", {})}
        text = json.dumps(schema)
    return json.loads(text)


class Schemas:
    """The schemas of a folder, by the name that a document gives: edvo.NAME."""

    def __init__(self, folder):
        self.validators = {}
        for path in sorted(folder.glob("*.json")):
            schema = json.loads(path.read_text(encoding="utf-8"))
            jsonschema.Draft202012Validator.check_schema(schema)
            name = "edvo." + path.stem
            require(schema["properties"]["schema"] == {**schema["properties"]["schema"], "const": name},
                    f"{path.name}: its schema is not {name}")
            self.require_complete(schema, path.name)
            self.validators[name] = jsonschema.Draft202012Validator(with_definitions(schema, folder))
        self.used = set()

    def require_complete(self, node, place):
        """Objects name all their members or what all have in common, and values say what they are."""
        if isinstance(node, list):
            for index, item in enumerate(node):
                self.require_complete(item, f"{place}/{index}")
        if not isinstance(node, dict):
            return
        if node.get("type") == "object":
            require("additionalProperties" in node, f"{place}: has no additionalProperties")
            for name, value in node.get("properties", {}).items():
                require("description" in value or "$ref" in value, f"{place}/{name}: has no description")
        for key, value in node.items():
            self.require_complete(value, f"{place}/{key}")

    def validate(self, document):
        name = document.get("schema")
        require(name in self.validators, f"schema {name} is not in docs/schemas")
        error = jsonschema.exceptions.best_match(self.validators[name].iter_errors(document))
        if error:
            raise ValueError(f"{name}: {'/'.join(map(str, error.absolute_path))}: {error.message[:300]}")
        self.used.add(name)

    def unused(self):
        return sorted(set(self.validators) - self.used)
