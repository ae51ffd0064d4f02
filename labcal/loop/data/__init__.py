"""The rows of a run that the loop works on, checked, decimated, and as one whitened linear problem."""
