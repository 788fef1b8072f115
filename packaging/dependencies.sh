# Sourced by run and test: installs what is missing on Debian 12, or says which command would.

build_packages=(g++ cmake ninja-build qt6-base-dev qt6-svg-dev libqcustomplot-dev libeigen3-dev libyaml-cpp-dev
    libgl-dev fonts-dejavu-core)
test_packages=(locales)

is_installed() {
    dpkg -s "$1" 2>/dev/null | grep -q '^Status: install ok installed'
}

# Installs those of the packages that are missing: as root, or through sudo where that asks for no password.
# A machine that has them all needs no network.
require_packages() {
    local package missing=() as_root=()
    for package in "$@"; do
        is_installed "$package" || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0

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
    if ! { "${as_root[@]}" apt-get update &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}"; } >"$log" 2>&1; then
        tail -n 5 "$log" >&2
        rm -f "$log"
        echo "packages could not be installed; check the network, or run as root: apt-get update && ${install[*]}" >&2
        exit 1
    fi
    rm -f "$log"
}
