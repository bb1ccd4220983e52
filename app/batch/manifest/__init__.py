"""The manifest: which lines are done, and from which input: `OUT/manifest.sqlite`, one row a line. Begin with
`store`."""
