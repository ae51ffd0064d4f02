"""`python -m labcal`: the command line where the folder of scripts is on no path."""

from labcal.start import main

main()
