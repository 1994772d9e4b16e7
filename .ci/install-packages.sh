#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the planescope authors
# SPDX-License-Identifier: BSD-3-Clause
# Installs what .ci/packages.txt lists, as root or by sudo; does nothing where all of it is there already.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

mapfile -t packages < <(sed 's/#.*//; s/[[:space:]]*//g; /^$/d' "$here/packages.txt")
missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == *installed* && $status != *not-installed* ]] || missing+=("$package")
done
((${#missing[@]} > 0)) || exit 0

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || { echo "these packages are missing, and there is no sudo: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends)

echo "installing ${missing[*]}" >&2
# The lists may be there and fresh enough; fetch them only where they are not.
if ! "${install[@]}" "${missing[@]}" >&2; then
  "${as_root[@]}" apt-get update >&2
  "${install[@]}" "${missing[@]}" >&2
fi
