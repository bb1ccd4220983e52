"""From lines to a blind page: `lines` are read and performed in every condition (`singletons` has NGS's two versions,
`by_model` those of a motion model), `site` writes clips and page; `making` is all of it."""
