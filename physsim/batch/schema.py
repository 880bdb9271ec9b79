"""The JSON Schema of sweeps as text.

`python -m physsim.batch.schema > schemas/sweep.schema.json` renews the file in the repository.
"""

from __future__ import annotations

import json

from physsim.batch.spec import SweepSpec


def schema_text() -> str:
    """The schema as it stands in its file."""
    return json.dumps(SweepSpec.model_json_schema(), indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    print(schema_text(), end="")
