"""What is written for others and read from them: whole files, what may be replaced, where they lie, safe text."""
