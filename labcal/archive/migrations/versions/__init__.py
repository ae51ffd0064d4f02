"""One file a version of the catalogue; what is released is never changed."""
