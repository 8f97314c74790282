"""A class for each shape that the library knows; types beside it, made with the module (shape_types.py)."""

from . import _native

__all__ = list(_native.shapes)
globals().update((name, getattr(_native, name)) for name in __all__)
