#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs what .ci/packages.txt lists, as root or by sudo; does nothing where all of it is there already.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

mapfile -t packages < <(sed 's/#.*//; s/[[:space:]]*//g; /^$/d' "$here/packages.txt")
missing=() wanted=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "${package#\?}" 2>/dev/null || true)
  [[ $status == *installed* && $status != *not-installed* ]] && continue
  if [[ $package == \?* ]]; then wanted+=("${package#\?}"); else missing+=("$package"); fi
done
((${#missing[@]} + ${#wanted[@]} > 0)) || exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "these packages are missing, and there is no sudo: ${missing[*]} ${wanted[*]}" >&2
    exit $((${#missing[@]} > 0))
  fi
  as_root=(sudo)
fi
install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends)

# The lists may be there and fresh enough; fetch them only where they are not.
try() { "${install[@]}" "$@" >&2 || { "${as_root[@]}" apt-get update >&2 && "${install[@]}" "$@" >&2; }; }

echo "installing ${missing[*]} ${wanted[*]}" >&2
((${#missing[@]} == 0)) || try "${missing[@]}"
for package in "${wanted[@]}"; do
  try "$package" || echo "$package cannot be installed: going on without it" >&2
done
