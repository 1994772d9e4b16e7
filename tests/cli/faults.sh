#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# What may befall a run: faults.sh PROGRAM SHARED WORK OSMESA_STUB CASE [TIMES]. One function a case. SHARED is what setup.sh
# made. Cases that need what the machine does not grant (a file system of their own) end with 77: skipped.
set -euo pipefail
program=$1 shared=$2 work=$3/$5 stub=$4 case=$5 times=${6:-20}
room=$shared/room.ply
rm -rf "$work"
mkdir -p "$work"
cd "$work"

fail() {
  echo "$case: $*" >&2
  [[ ! -s stderr ]] || sed 's/^/    /' stderr >&2
  exit 1
}

# expect CODE REGEX COMMAND...: how it ends, and that its last words are one line of ours and nothing of anybody else.
expect() {
  local code=0 wanted=$1 regex=$2
  shift 2
  "$@" >stdout 2>stderr || code=$?
  [[ $code == "$wanted" ]] || fail "exits with $code, should with $wanted: $*"
  if [[ $wanted != 0 ]]; then
    [[ $(grep -c '^planescope: ' stderr) == 1 && $(grep -c . stderr) == 1 ]] || fail "should say one line: $*"
    grep -qE -- "$regex" stderr || fail "should say $regex: $*"
  fi
}
hidden() { find "$1" -name '.*' -mindepth 1; }
segment() { "$program" segment "$room" -q --size 160x120 "$@"; }

# A result folder that is there is whole: its own reader says so, and each file by its end.
whole() {
  [[ -e $1 ]] || return 0
  local file
  for file in "$1"/*; do
    [[ -e $file ]] || continue
    case $file in
      *.png) tail -c 8 "$file" | grep -q IEND || fail "$file is cut" ;;
      *.vtp) tail -c 12 "$file" | grep -q '</VTKFile>' || fail "$file is cut" ;;
      *.json) tail -c 2 "$file" | grep -q '^}' || fail "$file is cut" ;;
      *.pcd) "$program" evaluate "$file" --truth "$file" >/dev/null || fail "$file is cut" ;;
      *) fail "$file should not be there" ;;
    esac
  done
  [[ ! -e $1/result.json ]] || "$program" render "$1" -o loads.png --size 64x48 -q || fail "the result does not load"
}

moment() { sleep "$(printf '0.%03d' $((RANDOM % 600)))"; }

killed() {
  RANDOM=7
  for ((i = 0; i < times; ++i)); do
    (exec "$program" segment "$room" -q --size 160x120 -o out 2>/dev/null) &
    moment
    kill -KILL $! 2>/dev/null || true
    wait $! 2>/dev/null || true
    whole out
  done
  segment -o out || fail "the run after it fails"
  [[ -e out/result.json && -z $(hidden .) ]] || fail "left behind: $(hidden .)"
  whole out
}

signalled() {
  RANDOM=8
  local code signal
  for ((i = 0; i < times; ++i)); do
    signal=$([[ $((i % 2)) == 0 ]] && echo INT || echo TERM)
    # A shell has its background jobs ignore SIGINT; env gives it back.
    env --default-signal=INT "$program" segment "$room" -q --size 160x120 -o "out$i" 2>stderr &
    moment
    kill -"$signal" $! 2>/dev/null || true
    code=0
    wait $! || code=$?
    [[ $code == 0 || $code == 130 || $code == 143 ]] || fail "ends with $code by SIG$signal"
    [[ ! -s stderr ]] || fail "says something"
    [[ $code == 0 || ! -e out$i || -e out$i/result.json ]] || fail "out$i is half there"
    [[ -z $(hidden .) ]] || fail "left behind by SIG$signal: $(hidden .)"
    whole "out$i"
  done
}

# The jobs of a batch are asked to end too.
batch_signalled() {
  mkdir scenes
  cp "$room" scenes/a.ply
  cp "$room" scenes/b.ply
  "$program" batch 'scenes/*.ply' -o out --methods ours --no-scores --pictures --jobs 2 -q >/dev/null 2>stderr &
  sleep 0.7
  kill -TERM $!
  wait $! && fail "should end by the signal"
  [[ -z $(find out -name '.planescope*') ]] || fail "left behind: $(hidden out)"
  "$program" batch 'scenes/*.ply' -o out --methods ours --no-scores --jobs 2 -q >/dev/null || fail "the run after it fails"
  [[ -z $(hidden out) ]] || fail "left behind: $(hidden out)"
}

together() {
  local i
  for ((i = 0; i < times / 2; ++i)); do
    segment -o out --no-pictures --planes.alpha 10 &
    first=$!
    segment -o out --no-pictures --planes.alpha 12 &
    wait $! || fail "the second fails"
    wait "$first" || fail "the first fails"
    [[ -z $(hidden .) ]] || fail "left behind: $(hidden .)"
    whole out
  done
}

own_input() {
  cp "$shared/result/points.pcd" points.pcd
  cp points.pcd before
  expect 2 'would overwrite the input' "$program" segment points.pcd -o . --no-pictures
  expect 2 'would overwrite the input' "$program" segment "$PWD/points.pcd" -o "$PWD/../$(basename "$PWD")"
  ln points.pcd other.pcd
  expect 2 'would overwrite the input' "$program" segment other.pcd -o .
  cmp points.pcd before || fail "the input is another"
}

names() {
  local name
  for name in "it's \"quoted\" Möbelhaus" $'new\nline' '$(touch pwned)' '; touch pwned;' '-o' $'\e[2J' '%s%n'; do
    cp "$room" "./$name.ply"
    "$program" segment "./$name.ply" -o "./$name" --no-pictures 2>stderr || fail "segment $name"
    [[ $(grep -c . stderr) == 3 && $(tr -d '\n' <stderr | tr -d '[:print:]' | wc -c) -le 2 ]] || fail "says $name as it is"
    whole "./$name"
    expect 0 '' "$program" batch "./$name.ply" -o "./$name.batch" --methods ours --no-scores -q
    expect 3 '' "$program" segment "./$name.none" -o out
  done
  [[ -z $(find . -name 'pwned*') ]] || fail "a shell was called"
  long=$(printf 'x%.0s' {1..240})
  cp "$room" "$long.ply"
  expect 0 '' "$program" synthesize -o "$long.ply" --points 10 -q
  expect 3 'too long' "$program" synthesize -o "$long.much.too.long.ply" --points 10 -q
}

links() {
  mkdir -p elsewhere/ours scenes out
  echo mine | tee elsewhere/ours/result.json elsewhere/ours/.hidden elsewhere/segment.log >elsewhere/job.json
  cp "$room" scenes/room.ply
  ln -s ../elsewhere out/room
  expect 3 'out/room: is a link' "$program" batch scenes/room.ply -o out --methods ours -q
  rm out/room
  mkdir out/room
  ln -s ../../elsewhere out/room/ours
  expect 3 'out/room/ours: is a link' "$program" batch scenes/room.ply -o out --methods ours -q
  rm out/room/ours
  mkdir out/room/ours
  for file in segment.log evaluate.log job.json run.json; do ln -s ../../../elsewhere/job.json "out/room/ours/$file"; done
  ln -s ../elsewhere/job.json out/table.md
  "$program" batch scenes/room.ply -o out --methods ours -q >/dev/null || fail "links in the place of files"
  cp "$room" scenes/...ply # its stem is ..
  "$program" batch scenes/...ply -o out --methods ours --no-scores -q >/dev/null || fail "a name of dots"
  [[ -e out/_../ours/result.json && ! -e ours ]] || fail "a name of dots leads out of the folder"
  [[ $(cat elsewhere/ours/* elsewhere/ours/.hidden elsewhere/*.* | sort -u) == mine ]] || fail "a link was followed"
  ln -s "$PWD/elsewhere/job.json" picture.png
  expect 0 '' "$program" render "$shared/result" -o picture.png --size 64x48 -q
  [[ $(cat elsewhere/job.json) == mine && ! -L picture.png ]] || fail "a link was followed"
}

# A small file system of this shell's own.
own_disk() {
  mkdir -p disk
  mount -t tmpfs -o "size=$1" tmpfs disk 2>/dev/null || exit 77
  trap 'umount "$work/disk"' EXIT
}

full_disk() {
  own_disk 4m
  local size
  for size in 4k 64k 500k 1m 1500k 2m; do
    mount -o "remount,size=$size" disk
    expect 3 'disk/out.*: cannot be written|disk full' "$program" segment "$room" -o disk/out -q --size 640x480
    [[ ! -e disk/out && -z $(hidden disk) ]] || fail "left behind at $size: $(find disk)"
    expect 3 'cannot be written.*disk full' "$program" synthesize -o disk/a.ply --points 200000 -q
    code=0
    "$program" batch "$room" -o disk/batch --methods ours -q >/dev/null 2>stderr || code=$?
    [[ $code == 0 || (($code == 3 || $code == 6) && $(cat stderr) == 'planescope: '*'No space left'*) ]] || fail "batch ends with $code"
    rm -rf disk/batch
    [[ -z $(find disk -type f) ]] || fail "left behind at $size: $(find disk)"
  done
  # What was there stays.
  mount -o remount,size=4m disk
  expect 0 '' "$program" segment "$room" -o disk/out -q --no-pictures
  before=$(md5sum disk/out/*)
  mount -o remount,size=$(($(du -sk disk | cut -f1) + 100))k disk
  expect 3 'cannot be written' "$program" segment "$room" -o disk/out -q --no-pictures --planes.alpha 12
  [[ $(md5sum disk/out/*) == "$before" ]] || fail "the earlier result is damaged"
}

file_limit() {
  ulimit -f 100
  expect 3 'cannot be written: File too large' "$program" segment "$room" -o out -q --no-pictures
  [[ ! -e out && -z $(hidden .) ]] || fail "left behind: $(find .)"
}

read_only() {
  own_disk 1m
  mkdir disk/out
  mount -o remount,ro disk
  expect 3 'cannot be written' "$program" segment "$room" -o disk/out -q
  expect 3 'cannot be written' "$program" segment "$room" -o disk/new/folder -q
  expect 3 'Read-only' "$program" render "$shared/result" -o disk/a.png --size 64x48 -q
  expect 3 'the folder cannot be made|cannot create' "$program" batch "$room" -o disk/batch --methods ours -q
}

no_memory() {
  local limit code
  for limit in 450 500 600 700 800 900 1000 1200 1500 2000; do
    code=0
    (ulimit -v $((limit * 1000)) && exec "$program" segment "$room" -o "out$limit" -q) >stdout 2>stderr || code=$?
    if [[ $code == 127 ]] && grep -q 'shared' stderr; then continue; fi # not even its libraries
    [[ $code == 0 || $code == 4 ]] || fail "exits with $code at ulimit -v ${limit}000"
    [[ $code == 0 || ($(grep -c . stderr) == 1 && $(cat stderr) == 'planescope: out of memory'*) ]] || fail "at $limit MB"
    [[ -z $(hidden .) && ($code == 0 || ! -e out$limit) ]] || fail "left behind at $limit MB"
  done
  [[ $code == 0 ]] || fail "2 GB should be enough"
  "$program" synthesize -o large.ply --points 2000000 -q
  expect 4 'out of memory' "$program" segment large.ply -o out -q --no-pictures --max-memory 120
  expect 3 'large.ply: the header has 2000000 points, the limit is 1000' "$program" evaluate large.ply --truth large.ply --max-points 1000
}

broken_osmesa() {
  export LD_PRELOAD=$stub
  expect 5 'cannot draw: OSMesa gives no OpenGL' "$program" segment "$room" -o out -q
  expect 5 'cannot draw: OSMesa gives no OpenGL' "$program" render "$shared/result" -o a.png -q
  expect 5 'cannot draw: OSMesa gives no OpenGL' "$program" figure "$room" -o a.png -q
  expect 0 '' "$program" segment "$room" -o out -q --no-pictures
  "$program" --version | grep -q 'GL renderer none: cannot draw' || fail "the version does not say it"
  [[ ! -e a.png && ! -e a.json && -z $(hidden .) ]] || fail "left behind: $(find .)"
}

# Files then have a name while they are written: a hidden one, which goes away.
named_files() {
  export LD_PRELOAD=$(dirname "$stub")/libtmpfile_stub.so
  expect 0 '' segment -o out
  whole out
  (ulimit -f 100 && expect 3 'cannot be written: File too large' "$program" synthesize -o a.ply --points 20000 -q)
  [[ ! -e a.ply && -z $(hidden .) ]] || fail "left behind: $(find .)"
  "$program" synthesize -o b.ply --points 9000000 -q 2>/dev/null &
  for ((i = 0; i < 400; ++i)); do
    [[ -n $(find . -name '.planescope.*' -size +0) ]] && break
    sleep 0.05
  done
  kill -TERM $!
  wait $! && fail "was done before"
  [[ $i -lt 400 && ! -e b.ply && -z $(hidden .) ]] || fail "left behind: $(find .)"
}

closed_pipe() {
  "$program" segment "$room" -o out --no-pictures -v 2> >(exec true) || fail "ends because nobody listens"
  [[ -e out/result.json ]] || fail "no result"
  code=0
  { "$program" segment "$room" -o out --no-pictures -q --json 2>stderr || echo $? >code; } | true
  [[ $(cat code) == 3 ]] && grep -q '^planescope: stdout: ' stderr || fail "lost output is not told"
}

# Files of a result folder that are another's, cut, or spoilt: a sentence, and not VTK's.
foreign_files() {
  local file
  "$program" segment "$shared/other.ply" -o other -q --no-pictures --preset room
  for file in points.pcd patches.vtp graph.vtp planes.vtp; do
    for spoil in other cut byte empty gone; do
      rm -rf spoilt
      cp -r "$shared/result" spoilt
      case $spoil in
        other) cp "other/$file" spoilt ;;
        cut) truncate -s -100 "spoilt/$file" ;;
        byte) printf 'X' | dd of="spoilt/$file" bs=1 seek=600 conv=notrunc status=none ;;
        empty) : >"spoilt/$file" ;;
        gone) rm "spoilt/$file" ;;
      esac
      expect 3 "spoilt/$file: " "$program" render spoilt -o a.png --size 64x48 -q
    done
  done
  for spoil in '' '{}' '[]' 'null' '{"schema": 2}' '{"schema": 1e400}' "$(printf '[%.0s' {1..9999})"; do
    printf '%s' "$spoil" >spoilt/result.json
    expect 3 'spoilt/result.json: ' "$program" render spoilt -o a.png -q
    expect 3 'spoilt/result.json: ' "$program" evaluate spoilt --truth label -q
  done
  expect 3 'is a folder|not a|no file' "$program" render "$shared/result" -o a.png --camera "$shared" -q
  mkfifo spoilt/pipe
  mv spoilt/pipe spoilt/result.json
  expect 3 'spoilt/result.json: ' "$program" render spoilt -o a.png -q # and does not wait for a writer
}

"$case"
