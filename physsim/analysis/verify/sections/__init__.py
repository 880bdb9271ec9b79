"""The sections of the formula sheet, one file each: the closed forms, and the scenes that they are held
against.
"""
