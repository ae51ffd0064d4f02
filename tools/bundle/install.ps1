# Installs labcal from this folder for this user, without a network and without an administrator.
#   powershell -ExecutionPolicy Bypass -File install.ps1 [--roll-back | --remove | --no-self-test]
$ErrorActionPreference = "Stop"
foreach ($line in Get-Content -Encoding UTF8 "$PSScriptRoot\SHA256SUMS") {
    $stated, $name = $line -split "  ", 2
    $file = Join-Path $PSScriptRoot $name
    if (-not (Test-Path -LiteralPath $file) -or (Get-FileHash -LiteralPath $file -Algorithm SHA256).Hash -ne $stated) {
        [Console]::Error.WriteLine("install: $name is not as it was packed: nothing was installed")
        exit 1
    }
}
$wanted = (Get-Content -Raw -Encoding UTF8 "$PSScriptRoot\bundle.json" | ConvertFrom-Json).python
$python = $env:PYTHON
if (-not $python -and (Get-Command py -ErrorAction SilentlyContinue)) {
    $python = & py "-$wanted" -c "import sys; print(sys.executable)" 2>$null
}
if (-not $python) {
    [Console]::Error.WriteLine("install: Python $wanted is needed: install it from python.org for this user alone")
    exit 1
}
& $python -B "$PSScriptRoot\install.py" @args
exit $LASTEXITCODE
