#!/usr/bin/env bash
# run.sh PROGRAM READER CORPUS SECONDS: a seed when there is none, then libFuzzer for so long.
# An input that takes over a second, allocates over 256 MB at once or breaks a rule is kept beside the corpus and fails.
set -euo pipefail
program="$1" reader="$2" corpus="$3" seconds="$4"
mkdir -p "$corpus"
export AUTHALIC_FUZZ_READER="$reader"
AUTHALIC_FUZZ_SEEDS="$corpus" "$program"
exec "$program" -max_total_time="$seconds" -timeout=1 -malloc_limit_mb=256 -rss_limit_mb=1024 -max_len=65536 \
  -print_final_stats=1 -verbosity=1 -artifact_prefix="$corpus-" "$corpus"
