"""What the years say of a lab: control charts, gage R&R, drift, recalibration intervals, comparisons, batches.

Statistics of arrays alone: nothing here knows a run, a calibration or a file.
"""
