"""What the author of a driver needs: roles, declared numbers and settings, registers, framing, a scripted line.

With `labcal.bench.links`, `labcal.bench.clock` and `labcal.errors` that is all; nothing here knows what runs the bench.
"""
