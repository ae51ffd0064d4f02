"""Many jobs, on processes of this computer or a Dask cluster: begun, gone on with, and summed up by `study.run`.

The file says what is asked (`specification`, `grid`), `jobs` makes it a list of jobs, `work` does one, `engine` and
`cluster` do many, `folder` keeps each that is done, and `summary`, `table` and `page` say what came of them, in the
order of jobs. Nothing in the results tells who did a job, when, or how fast: the same study gives the same bytes.
This file loads nothing, so that a worker begins with what its job needs.
"""
