"""What the pages show, without widgets: the lab, a run, a run under study, and what all pages share."""
