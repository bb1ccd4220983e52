"""What came of a batch, for people and for engines: `report.csv`, `report.html`, `index.json`. Made of the manifest's
rows alone, so that the same rows give the same bytes. Begin with `writing`."""
