#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Runs one line of cases.txt: run_case.sh PROGRAM JSON_CHECK CASES SHARED NAME
set -euo pipefail
program=$1 json_check=$2 cases=$3 shared=$4 name=$5
inputs=$(dirname "$cases")/inputs

fail() {
  echo "$name: $*" >&2
  for stream in stdout stderr; do
    echo "--- $stream" >&2
    head -c 4000 "$work/$stream" >&2
  done
  exit 1
}

trim() {
  local text=$1
  text=${text#"${text%%[![:space:]]*}"}
  printf '%s' "${text%"${text##*[![:space:]]}"}"
}

# The fields; a regex holds no " | ".
line=$(grep -E "^$name *\\|" "$cases" | head -n 1)
fields=()
while IFS= read -r field; do fields+=("$(trim "$field")"); done < <(sed 's/ *|\( \|$\)/\n/g' <<<"$line")
expected=${fields[1]} out_regex=${fields[2]:-} err_regex=${fields[3]:-} arguments=${fields[4]:-} checks=${fields[5]:-}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/own"
cd "$work/own"

expand() {
  local text=${1//@O/$work/own}
  text=${text//@S/$shared}
  printf '%s' "${text//@I/$inputs}"
}

# One run of the program; words are quoted as in a shell, NAME=value words come first.
run() {
  local -a words environment=()
  eval "words=($1)"
  while [[ ${words[0]:-} =~ ^[A-Z_]+= ]]; do
    environment+=("${words[0]}")
    words=("${words[@]:1}")
  done
  code=0
  env "${environment[@]}" "$program" "${words[@]}" >"$work/stdout" 2>"$work/stderr" </dev/null || code=$?
}

rest=$(expand "$arguments")
while [[ $rest == *";;"* ]]; do
  run "${rest%%;;*}"
  [[ $code == 0 ]] || fail "an earlier run exits with $code"
  rest=${rest#*;;}
done
run "$rest"
[[ $code == "$expected" ]] || fail "exits with $code, should with $expected"
if [[ $code != 0 && $(grep -c '^planescope: ' "$work/stderr") != 1 ]]; then fail "should say what is wrong in one line"; fi

matches() {  # STREAM REGEX
  local text
  text=$(tr '\n' ' ' <"$work/$1")
  case $2 in
    '*') return 0 ;;
    '') [[ ! -s $work/$1 ]] ;;
    *) grep -qE -- "$2" <<<"$text" ;;
  esac
}
matches stdout "$out_regex" || fail "stdout should match: $out_regex"
matches stderr "$err_regex" || fail "stderr should match: $err_regex"

same_folder() {
  [[ $(ls "$1") == "$(ls "$2")" ]] || fail "$1 and $2 hold other files"
  local file
  for file in "$1"/*; do
    [[ -d $file || $(basename "$file") =~ ^(run.json|times.csv|track.png)$ ]] || cmp -s "$file" "$2/$(basename "$file")" || fail "$file differs"
  done
}

# Names of files with ":" do not occur in checks; words are quoted as in a shell.
eval "set -- $checks"
for check in "$@"; do
  what=${check#*:}
  case $check in
    has:*) [[ -s $what ]] || fail "$what should be there" ;;
    lacks:*) [[ ! -e $what ]] || fail "$what should not be there" ;;
    same:*) cmp -s "${what%,*}" "${what#*,}" || fail "$what should be the same" ;;
    samedir:*) same_folder "${what%,*}" "${what#*,}" ;;
    json:*)
      file=${what%%:*}
      [[ $file == stdout ]] && file=$work/stdout
      path="" regex=""
      if [[ $what == *:* ]]; then path=${what#*:} regex=${path#*=} path=${path%%=*}; fi
      "$json_check" "$file" "$path" "$regex" || fail "$check"
      ;;
    *) fail "unknown check: $check" ;;
  esac
done
# Nothing unfinished is left behind.
[[ -z $(find "$work/own" -name '.*' -mindepth 1) ]] || fail "left behind: $(find "$work/own" -name '.*' -mindepth 1)"
