"""What is done already, and of what: `OUT/manifest.sqlite`, one row a line. Begin with `store`."""
