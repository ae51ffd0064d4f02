"""Which candidates are accepted: stepwise selection, cross-validation, equivalent models."""
