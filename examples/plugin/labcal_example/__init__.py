"""One part of each kind that another lab can add to labcal; nothing of labcal is touched."""
