"""The examples in the repository that are no tests of their own."""
