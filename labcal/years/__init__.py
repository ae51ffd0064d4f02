"""What a lab asks over the years: check standards, gage studies, intervals, comparisons, the fleet, and a watch.

Reads calibrations of this lab's folder, of files and of the archive; the statistics are `labcal.quality`'s.
"""
