"""The streams of samples: put together, watched for silence and limits, brought back when their line was lost."""
