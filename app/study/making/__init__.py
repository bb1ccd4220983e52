"""Makes a study from lines: `lines` reads them, `singletons` and `by_model` perform them in each condition, `site`
writes clips and page; `making` runs all of it."""
