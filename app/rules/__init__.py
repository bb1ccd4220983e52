"""The rule language and the two stages that it runs: communicative functions derived from an utterance (paper §3.3) and
the movements that could show them (§3.4). The rules themselves are data in `functions/` and `behaviors/`, over the
predicates of `vocabulary.rules`. The rooms are `language` (files to syntax trees), `program` (checked and compiled) and
`chaining` (run); `knowledge.py` belongs between the first two. Imports only the ground floor. Begin with
`derivation.py` and `mapping.py`, which are the stages, and docs/rule-language.md."""
