"""The JSON Schema of scenes as text.

`python -m physsim.scene.schema > schemas/scene.schema.json` renews the file in the repository.
"""

from __future__ import annotations

import json

from physsim.scene.spec.scene import SceneSpec


def schema_text() -> str:
    """The schema as it stands in its file."""
    return json.dumps(SceneSpec.model_json_schema(), indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    print(schema_text(), end="")
