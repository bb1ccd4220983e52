"""The reports of a batch, for people and for game engines: `report.csv`, `report.html`, `index.json`. They are made
from the manifest's rows alone, so that the same rows give the same bytes. Begin with `writing`."""
