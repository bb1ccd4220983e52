"""The version of the package, in a module that code writing it into files can import alone."""

__version__ = "0.2.0"
