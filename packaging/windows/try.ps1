# Tries lightfall.exe on a real Windows machine and writes a report to send back:
#
#     powershell -ExecutionPolicy Bypass -File try.ps1
#
# The script lies beside lightfall.exe, or its path is given: -Exe PATH. It changes nothing but the
# folder of its report.
param(
    [string]$Exe = (Join-Path $PSScriptRoot 'lightfall.exe'),
    [string]$Folder = (Join-Path $env:TEMP ('lightfall-' + (Get-Date -Format 'yyyyMMdd-HHmmss')))
)
$ErrorActionPreference = 'Stop'
if (-not (Test-Path -LiteralPath $Exe)) { throw "$Exe is not there: give its path with -Exe" }
$Exe = (Resolve-Path -LiteralPath $Exe).Path
New-Item -ItemType Directory -Force -Path $Folder | Out-Null
$report = Join-Path $Folder 'report.txt'

function Write-Report([string]$text) {
    Write-Host $text
    Add-Content -LiteralPath $report -Value $text -Encoding UTF8
}

# Runs the program in the report's folder, and notes its output, exit status and time.
function Invoke-Lightfall([string[]]$arguments) {
    Write-Report "> lightfall $($arguments -join ' ')"
    $out = Join-Path $Folder 'out.txt'
    $errors = Join-Path $Folder 'errors.txt'
    $watch = [Diagnostics.Stopwatch]::StartNew()
    $process = Start-Process -FilePath $Exe -ArgumentList $arguments -WorkingDirectory $Folder -NoNewWindow -PassThru `
        -RedirectStandardOutput $out -RedirectStandardError $errors
    $handle = $process.Handle # Without it the exit status is lost.
    $process.WaitForExit()
    foreach ($file in $out, $errors) {
        Get-Content -LiteralPath $file -Encoding UTF8 | ForEach-Object { Write-Report "  $_" }
        Remove-Item -LiteralPath $file
    }
    Write-Report ("  exit status {0}, {1:N1} s" -f $process.ExitCode, $watch.Elapsed.TotalSeconds)
}

Write-Report "Lightfall, tried on $(Get-Date -Format u)"
$system = Get-CimInstance Win32_OperatingSystem
Write-Report "$($system.Caption) $($system.Version)"
Get-CimInstance Win32_VideoController | ForEach-Object { Write-Report "$($_.Name), driver $($_.DriverVersion)" }
Write-Report "lightfall.exe: SHA-256 $((Get-FileHash -LiteralPath $Exe -Algorithm SHA256).Hash)"

Invoke-Lightfall @('--version')
Invoke-Lightfall @('--list-gpus')
Invoke-Lightfall @('doctor')
foreach ($preset in 2, 4, 8) {
    Invoke-Lightfall @('render', '--preset', "$preset", '--timings', '-o', "preset-$preset.png")
    $picture = Join-Path $Folder "preset-$preset.png"
    if (Test-Path -LiteralPath $picture) {
        Write-Report "  SHA-256 $((Get-FileHash -LiteralPath $picture -Algorithm SHA256).Hash)"
    }
}
# With Direct3D 12 Windows' own compiler translates the shaders, which may take minutes.
Invoke-Lightfall @('render', '--preset', '2', '--backend', 'dx12', '-o', 'dx12.png')
Invoke-Lightfall @('render', '--preset', '99', '-o', 'none.png')
Write-Host ''
Write-Host "Please send the folder $Folder (a report and the pictures)."
