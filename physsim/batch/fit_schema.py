"""The schema of fit files, for editors.

`python -m physsim.batch.fit_schema > schemas/fit.schema.json` renews the file in the repository.
"""

from __future__ import annotations

import json

from physsim.batch.fit_spec import FitSpec


def schema_text() -> str:
    """JSON Schema, draft 2020-12."""
    return json.dumps(FitSpec.model_json_schema(), indent=2) + "\n"


if __name__ == "__main__":
    print(schema_text(), end="")
