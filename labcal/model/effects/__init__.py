"""Effects the affine map lacks, one file each, found through the entry-point group `labcal.effects`."""
