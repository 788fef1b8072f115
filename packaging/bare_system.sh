# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced by check-package and check-sources: what is tried, and where: a bare Debian 12 in a folder of its own, $root, or what
# stands there instead. $work, around it, is for what they keep meanwhile; all of it is gone at the end.

work= root= failed=0

refuse() { echo "$0: $1" >&2 && exit 1; }
refuse_word() { echo "$0: $1" >&2 && exit 2; }
# The comment at the head of the script.
show_help() { sed -n '3,/^set/{/^set/d;s/^# \{0,1\}//;p}' "packaging/$(basename "$0")"; }

require_root() {
    [ "$(id -u)" -eq 0 ] || refuse "makes a system of its own and so needs root"
}

# `begin_work TOOL…`: makes $work where the tools are there.
begin_work() {
    local tool
    for tool in "$@"; do
        command -v "$tool" >/dev/null || refuse "$tool is missing; install it: apt-get install $tool"
    done
    work=$(mktemp -d)
    root=$work/root
    trap clean_up EXIT
    trap 'exit 130' INT TERM
}

# Unmounts everything inside first: nothing of the machine may be removed with it.
clean_up() {
    ! mountpoint -q "$root/proc" || umount "$root/proc" || refuse "$root/proc is still in use; unmount it and remove $work"
    rm -rf --one-file-system "$work"
}

make_bare_system() {
    echo "making a bare Debian 12 …"
    local mirror
    mirror=$(sed -n 's/^URIs: *//p; s/^deb \(\[[^]]*\] \)\?\([^ ]*\) .*/\2/p' /etc/apt/sources.list.d/*.sources /etc/apt/sources.list \
        2>/dev/null | grep -m 1 /debian || true)
    debootstrap --variant=minbase bookworm "$root" ${mirror:+"$mirror"} >"$work/debootstrap.txt" || refuse "$(tail -n 5 "$work/debootstrap.txt")"
    mount -t proc proc "$root/proc"
    cp /etc/resolv.conf "$root/etc"
    ! ls /etc/apt/apt.conf.d/*proxy* >/dev/null 2>&1 || cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d"
}

# Runs a line in that system: `inside COMMAND`, as a user would, at a terminal without a display; root, or whom $as names.
inside() {
    local home=/tmp/home
    [ -z "${as:-}" ] || home=/home/$as
    chroot ${as:+--userspec="$as"} "$root" env -i HOME=$home PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        LANG=C.UTF-8 TERM=dumb DEBIAN_FRONTEND=noninteractive bash -o pipefail -c "$1"
}

# `check WHAT COMMAND`: names what is tried, and whether it works there.
check() {
    if inside "$2" >"$work/said.txt" 2>&1; then
        echo "  ok      $1"
    else
        echo "  FAILED  $1: $2"
        tail -n 10 "$work/said.txt" | sed 's/^/          /'
        failed=1
    fi
}
