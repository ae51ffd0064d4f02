"""The window in other languages: labcal.ts holds every text of it."""
