"""Shapes as triangles, the same ones for the page, glTF files and pictures."""
