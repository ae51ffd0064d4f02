"""The Earth's main field at a place and date, by the models that geophysics keeps."""
