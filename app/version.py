"""The version of the package, in a module that whatever writes it into a file can import by itself."""

__version__ = "0.1.0"
