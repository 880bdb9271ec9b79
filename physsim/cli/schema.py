"""`physsim schema`: the scene language as JSON Schema, for editors and other programs."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

import click

from physsim.cli import output
from physsim.cli.verb import Example, Verb, debug_option


@click.command(
    cls=Verb,
    exits=(0, 2),
    examples=[
        Example("keep the schema beside your scenes", "physsim schema > scene.schema.json"),
        Example(
            "list the top-level keys of a scene",
            """physsim schema | python3 -c 'import json, sys; print(*json.load(sys.stdin)["properties"])'""",
        ),
    ],
)
@debug_option
def command() -> None:
    """Print the JSON Schema of the scene language.

    Editors with a YAML language server complete and check scenes with it. Name it in the first line of a
    scene:

    \b
        # yaml-language-server: $schema=./scene.schema.json

    What only a program can check (units, names of bodies, meshes) is checked by `physsim validate`.
    """
    import json

    from physsim.scene import SceneSpec

    output.result(json.dumps(SceneSpec.model_json_schema(), indent=2))
