"""The scene with every default filled in and every number in SI, as YAML that reads back to the same spec."""

from __future__ import annotations

from typing import Any

import yaml

from physsim.scene.scalars import meaning
from physsim.scene.spec.scene import SceneSpec
from physsim.uncollected import uncollected

_BASE = getattr(yaml, "CSafeDumper", yaml.SafeDumper)


class _Dumper(_BASE):  # type: ignore[misc, valid-type]
    """Quotes what YAML 1.2 would not read as text; never writes aliases."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _text(dumper: Any, text: str) -> Any:
    style = None if isinstance(_meaning(text), str) else '"'
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style=style)


def _meaning(text: str) -> Any:
    try:
        return meaning(text)
    except ValueError:
        return None


_Dumper.add_representer(str, _text)


def _type_first(part: Any) -> Any:
    """The same data; a mapping that has a type begins with it, as people write it."""
    if isinstance(part, list):
        return [_type_first(item) for item in part]
    if not isinstance(part, dict):
        return part
    keys = sorted(part, key=lambda key: key != "type")
    return {key: _type_first(part[key]) for key in keys}


@uncollected()
def resolved_yaml(spec: SceneSpec) -> str:
    """The spec as YAML; what is not given and has no default is left out."""
    data = spec.model_dump(mode="json", by_alias=True, exclude_none=True)
    text: str = yaml.dump(
        _type_first(data),
        Dumper=_Dumper,
        sort_keys=False,
        allow_unicode=True,
        default_flow_style=None,
        width=120,
    )
    return text
