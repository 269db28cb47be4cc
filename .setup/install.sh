#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# .setup/install.sh SECTION...: installs what is missing of those sections of packages.txt beside it: kit, compare,
# games, tests. Prints nothing, and needs no root, when all is there.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$here")
log=$root/build/setup.log

# On other systems than Debian and Ubuntu CMake says what it does not find.
command -v dpkg-query >/dev/null && command -v apt-get >/dev/null || exit 0

installed() { [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }
offered() { [[ -n $(apt-cache madison "$1" 2>/dev/null) ]]; }

required=()
optional=()
wantedSection=false
while read -r package _; do
    case $package in
        '' | '#'*) ;;
        '['*']') [[ " $* " == *" ${package:1:-1} "* ]] && wantedSection=true || wantedSection=false ;;
        *) $wantedSection || continue ;;&
        '?'*) installed "${package#\?}" || optional+=("${package#\?}") ;;
        *) installed "$package" || [[ " ${required[*]} " == *" $package "* ]] || required+=("$package") ;;
    esac
done <"$here/packages.txt"

wanted=("${required[@]}")
for package in "${optional[@]}"; do
    # When a required package is missing, the lists of packages may be missing, too.
    if [[ ${#required[@]} -gt 0 ]] || offered "$package"; then wanted+=("$package"); fi
done
[[ ${#wanted[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
        echo "plumb: these packages are missing, and there is neither root nor sudo to install them: ${wanted[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --yes --quiet \
        --option DPkg::Lock::Timeout=300 --option Dpkg::Use-Pty=0 "$@" >>"$log" 2>&1
}

mkdir -p "$root/build"
: >"$log"
echo "plumb: installing ${wanted[*]} (log: build/setup.log)" >&2
# A list that cannot be fetched, for example of another vendor's packages, is no reason to stop.
apt update || echo "plumb: apt-get update failed; trying with the lists there are" >&2
offers=()
for package in "${wanted[@]}"; do
    if [[ " ${required[*]} " == *" $package "* ]] || offered "$package"; then
        offers+=("$package")
    else
        echo "plumb: $package is not offered here; doing without" >&2
    fi
done
if ! apt install --no-install-recommends "${offers[@]}"; then
    cat "$log" >&2
    echo "plumb: could not install ${offers[*]}" >&2
    exit 1
fi
