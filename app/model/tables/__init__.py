"""Fixed tables that several stages share: the lexemes of gazes and faces, and the mouth shapes."""
