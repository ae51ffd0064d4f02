"""Statistics of residuals, arrays in and out: coloured noise, projections, correlation, spectra."""
