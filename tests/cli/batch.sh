#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# The batch against whatever may happen to it: batch.sh PROGRAM FOLDER KILLS. Killed at random moments, cut into shards,
# and with scenes that hang, are broken or eat memory, its table has the same scores.
set -euo pipefail
program=$1 work=$2 kills=$3
rm -rf "$work"
mkdir -p "$work/scenes"
cd "$work"

fail() {
  echo "batch.sh: $*" >&2
  exit 1
}
scores() { grep -v time_ms "$1/table.csv"; }  # times differ from run to run
few=(--methods ransac,ours --jobs 2 -q)
batch() { "$program" batch "$@" "${few[@]}"; }

for seed in 1 2 3 4; do
  "$program" synthesize -o "scenes/room$seed.ply" --points 20000 --random-seed "$seed" -q
done
batch 'scenes/*.ply' -o whole >stdout.md
[[ $(scores whole | wc -l) -gt 20 ]] || fail "the table is short"
cmp -s stdout.md whole/table.md || fail "stdout is not the table"
[[ $(grep -c '^| ours' stdout.md) == 2 ]] || fail "no row of ours, or no difference"

# Killed, with all of its processes left to fend for themselves, and started again.
RANDOM=11
for ((i = 0; i < kills; ++i)); do
  "$program" batch 'scenes/*.ply' -o killed "${few[@]}" >/dev/null 2>&1 &
  sleep "0.$(printf %03d $((RANDOM % 500)))"
  kill -KILL $! 2>/dev/null || true
  wait $! 2>/dev/null || true
done
batch 'scenes/*.ply' -o killed >/dev/null
diff <(scores whole) <(scores killed) || fail "the killed batch has another table"
[[ -z $(find killed -name '.*' -mindepth 1) ]] || fail "left behind: $(find killed -name '.*' -mindepth 1)"
started=$(stat -c %Y.%i killed/room1/ours/result.json)
batch 'scenes/*.ply' -o killed >/dev/null
[[ $(stat -c %Y.%i killed/room1/ours/result.json) == "$started" ]] || fail "what was done is done again"

# Three shards: two by --shard, one as a scheduler's array job.
batch 'scenes/*.ply' -o shards --shard 0/3
SLURM_ARRAY_TASK_ID=2 SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_COUNT=3 batch 'scenes/*.ply' -o shards
batch 'scenes/*.ply' -o shards --shard 2/3
"$program" batch --summary shards >/dev/null
diff <(scores whole) <(scores shards) || fail "the shards have another table"

# Half a file, a cloud that needs more memory than there is; and a program that crashes or hangs on some scenes.
head -c 100000 scenes/room1.ply >scenes/half.ply
hungry=4000000
[[ -z ${PLANESCOPE_NO_LIMITS:-} ]] || hungry=0  # the sanitizer's build has no limit to run into
((hungry == 0)) || "$program" synthesize -o scenes/hungry.ply --points "$hungry" -q
cp scenes/room1.ply scenes/crash.ply
cp scenes/room1.ply scenes/hang.ply
cat >wrapper <<END
#!/bin/sh
case \$2 in
  *crash.ply) kill -SEGV \$\$ ;;
  *hang.ply) exec sleep 600 ;;
esac
exec "$program" "\$@"
END
chmod +x wrapper
code=0
batch 'scenes/*.ply' -o bad --program ./wrapper --time-limit 20 --memory-limit 250 >/dev/null 2>stderr || code=$?
[[ $code == 6 ]] || fail "exits with $code where scenes failed: $(cat stderr)"
((hungry > 0)) && failed='8 of 16' || failed='6 of 14'
grep -q "$failed jobs failed" stderr || fail "$(cat stderr)"
diff <(scores whole) <(scores bad) || fail "bad scenes changed the scores of the good ones"
reason() { sed -n 's/.*"reason": "\(.*\)",/\1/p' "bad/$1/ours/job.json"; }
[[ $(reason crash) == "was ended by signal 11"* ]] || fail "crash: $(reason crash)"
[[ $(reason hang) == "took longer than 20 s"* ]] || fail "hang: $(reason hang)"
[[ $(reason half) == "exit code 3: "*half.ply* ]] || fail "half: $(reason half)"
((hungry == 0)) || [[ $(reason hungry) == "exit code 4: out of memory"* ]] || fail "hungry: $(reason hungry)"
