"""What the user wrote in a sweep file, typed: field names are the keys of the sweep language."""

from physsim.batch.spec.sweep import SweepSpec

__all__ = ["SweepSpec"]
