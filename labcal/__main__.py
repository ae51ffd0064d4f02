"""`python -m labcal`: the command line where the folder of scripts is on no path."""

from labcal.cli import main

main()
