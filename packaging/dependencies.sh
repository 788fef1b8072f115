# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by run, test and check-package: installs what is missing on Debian 12, or says which command would; shows how far a build is.

build_packages=(g++ cmake ninja-build qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-l10n-tools libqcustomplot-dev libboost-dev
    libeigen3-dev libyaml-cpp-dev zlib1g-dev libgl-dev fonts-dejavu-core)
test_packages=(locales)

is_installed() {
    dpkg -s "$1" 2>/dev/null | grep -q '^Status: install ok installed'
}

# In a plain chroot nothing is mounted; programs, tests and bash look there for themselves.
require_proc() {
    mountpoint -q /proc && return 0
    echo "$0: /proc is not mounted here; run this as root, then try again: mount -t proc proc /proc" >&2
    exit 1
}

# Prints the packages that are not installed.
missing_of() {
    local package
    for package in "$@"; do
        is_installed "$package" || echo "$package"
    done
}

# Installs what the packages for building and testing need that is missing: as root, or through sudo where that asks for
# no password. All commands name what building and testing need, so that an administrator is asked once. A machine that has what this
# command needs, the packages given, needs no network.
require_packages() {
    local needed missing as_root=()
    require_proc
    mapfile -t needed < <(missing_of "$@")
    [ ${#needed[@]} -gt 0 ] || return 0
    mapfile -t missing < <(missing_of "${build_packages[@]}" "${test_packages[@]}" "$@" | awk '!seen[$0]++')

    local install=(apt-get install -y --no-install-recommends "${missing[@]}")
    if [ "$(id -u)" -ne 0 ]; then
        if ! sudo -n true 2>/dev/null; then
            echo "packages are missing; run this as root, then try again: apt-get update && ${install[*]}" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    echo "installing missing packages: ${missing[*]}"
    local log
    log=$(mktemp)
    if ! install_packages; then
        tail -n 5 "$log" >&2
        rm -f "$log"
        echo "packages could not be installed; check the network, or run as root: apt-get update && ${install[*]}" >&2
        exit 1
    fi
    rm -f "$log"
}

# The output of apt-get goes to $log, and its progress to the screen. The archives are fetched into a folder of their own,
# which is removed afterwards: those that were there before stay.
install_packages() {
    local archives plan
    "${as_root[@]}" apt-get update 2>&1 | tee "$log" | progress_line "fetching the lists of packages" || return 1
    plan=$("${as_root[@]}" env LC_ALL=C apt-get install --assume-no --no-install-recommends "${missing[@]}" 2>&1 || true)
    echo "$plan" | sed -n 's/^Need to get \(.*\) of archives\.$/  download: \1/p
        s/^After this operation, \(.*\) of additional disk space.*$/  on the disk: \1/p'
    archives=$(mktemp -d)
    mkdir "$archives/partial"
    chmod 755 "$archives"
    "${as_root[@]}" chown _apt "$archives/partial" 2>/dev/null || true # apt fetches as this user where there is one
    local status=0
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" -o Dir::Cache::archives="$archives" \
        -o Dpkg::Use-Pty=0 2>&1 | tee -a "$log" | progress_line "installing" || status=1
    "${as_root[@]}" rm -rf "$archives"
    return $status
}

# Shows the lines on standard input one over the other on a terminal, elsewhere every hundredth behind a title.
progress_line() {
    local line count=0 width=100
    while IFS= read -r line; do
        count=$((count + 1))
        if [ -t 1 ]; then
            printf '\r\033[K  %s' "${line:0:$width}"
        elif [ $((count % 100)) -eq 0 ]; then
            printf '  %s: %s\n' "$1" "${line:0:$width}"
        fi
    done
    [ ! -t 1 ] || printf '\r\033[K'
}

# Builds a preset: `build PRESET OPTION…`. Ninja tells how far it is: one line on a terminal, a line for every tenth of
# the work elsewhere. Errors of the compiler are shown in full.
build() {
    local log status=0
    cmake --preset "$1" >/dev/null || return 1
    if [ -t 1 ]; then
        NINJA_STATUS="  [%f/%t, %es] " cmake --build --preset "$@"
        return
    fi
    log=$(mktemp)
    NINJA_STATUS="[%f/%t] " cmake --build --preset "$@" 2>&1 | tee "$log" | tenths || status=1
    [ $status -eq 0 ] || sed -n '/^FAILED:/,$p' "$log" >&2
    rm -f "$log"
    return $status
}

# Prints the first of every ten lines that begin with "[17/190]".
tenths() {
    local line tenth last=0
    while IFS= read -r line; do
        if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
            tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
            [ "$tenth" -le "$last" ] || echo "  ${BASH_REMATCH[0]}"
            last=$tenth
        fi
    done
}
