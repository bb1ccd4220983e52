"""From lines to a blind page, in order: `lines`, `modes` or `singletons`, `clips`, `ordering`, `site`; `making` is
all of it."""
