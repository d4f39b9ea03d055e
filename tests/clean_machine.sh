#!/usr/bin/env bash
# The two commands of the README on a machine that has nothing yet: makes a bare Debian system in
# a folder, clones this repository into it, and runs them there. Needs root, debootstrap and git;
# no part of tests/run.sh.
#
#   bash tests/clean_machine.sh SUITE [COMMAND...]
#
#   SUITE     bookworm, trixie, ...: any suite that the machine's own Debian mirror has
#   COMMAND   bash commands to run in the clone, one argument each, in place of the two
#
# Only what is committed is tried. The log stays in clean_machine_SUITE.log of the present folder.
# Environment:
#   CLEAN_MACHINE_FOLDER  where the system is made (default: a folder in /var/tmp, removed at the end)
#   CLEAN_MACHINE_KEEP    a folder that is kept between calls: the packages, and ccache's objects
set -euo pipefail

usage() {
  sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "$0"
}

fail() {
  echo "tests/clean_machine.sh: $*" >&2
  exit 1
}

# mirror_of_this_machine: the address that apt has Debian itself from
mirror_of_this_machine() {
  apt-get indextargets --format '$(LABEL) $(REPO_URI)' 'Created-By: Packages' |
    awk '$1 == "Debian" { print $2; exit }'
}

# make_system: a bare system of the suite, with the machine's own way to the mirror
make_system() {
  local mirror
  local -a keep_packages=()
  mirror=$(mirror_of_this_machine)
  [[ -n $mirror ]] || fail "apt knows no Debian mirror; run 'apt-get update', then try again"
  if [[ -n $kept ]]; then
    mkdir -p "$kept/debootstrap"
    keep_packages=("--cache-dir=$kept/debootstrap")
  fi
  debootstrap --variant=minbase "${keep_packages[@]}" "$suite" "$root" "$mirror"
  apt-config dump | grep -E '^Acquire::(https?|Retries)' >"$root/etc/apt/apt.conf.d/90mirror" || true
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  git clone --quiet "$repository" "$root/root/clone"
}

# in_system COMMAND...: with the system's own processes, devices and memory files; whatever is
# mounted for it goes with the last of its processes
in_system() {
  unshare --mount --pid --fork --kill-child --propagation private \
    bash -c "$(declare -f mount_and_enter); mount_and_enter \"\$@\"" enter "$root" "$kept" "$suite" "$@"
}

mount_and_enter() {
  local root=$1 kept=$2 suite=$3
  shift 3
  mount -t proc proc "$root/proc"
  mount --bind -o ro /sys "$root/sys"
  mount -t tmpfs dev "$root/dev"
  for device in null zero full random urandom tty; do
    touch "$root/dev/$device"
    mount --bind "/dev/$device" "$root/dev/$device"
  done
  ln -s /proc/self/fd "$root/dev/fd"
  ln -s /proc/self/fd/0 "$root/dev/stdin"
  ln -s /proc/self/fd/1 "$root/dev/stdout"
  ln -s /proc/self/fd/2 "$root/dev/stderr"
  mkdir "$root/dev/shm" "$root/dev/pts"
  mount -t tmpfs shm "$root/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
  ln -s pts/ptmx "$root/dev/ptmx"
  if [[ -n $kept ]]; then
    mkdir -p "$kept/archives-$suite/partial" "$kept/ccache" "$root/root/.cache/ccache"
    mount --bind "$kept/archives-$suite" "$root/var/cache/apt/archives"
    mount --bind "$kept/ccache" "$root/root/.cache/ccache"
  fi
  exec env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    LANG=C.UTF-8 CCACHE_MAXSIZE=20G chroot "$root" bash -c 'cd /root/clone && bash -euo pipefail -c "$1"' \
    in_clone "$1"
}

remove_system() {
  if [[ -n ${root-} && -d $root && -z ${CLEAN_MACHINE_FOLDER-} ]]; then
    rm -rf --one-file-system "$root"
  fi
}

# stop_everything: what runs in the system ends with this script, however that is ended
stop_everything() {
  trap '' TERM INT HUP
  kill -TERM -- "-$running" 2>/dev/null || true
  sleep 2 # debootstrap takes its mounts back
  kill -KILL -- "-$running" 2>/dev/null || true
  wait "$running" 2>/dev/null || true
  fail "$suite: stopped; log: $log"
}

try_everything() {
  local command
  make_system
  for command in "${commands[@]}"; do
    printf '\n##### %s: %s\n' "$suite" "$command"
    in_system "$command"
  done
}

if [[ $# -eq 0 || $1 == -h || $1 == --help ]]; then
  usage
  exit
fi
suite=$1
shift
commands=("$@")
[[ $# -gt 0 ]] || commands=("bash inputs/quickstart.sh" "bash tests/run.sh")
[[ $(id -u) -eq 0 ]] || fail "needs root, to make a system of its own and to mount in it"
for program in debootstrap git unshare; do
  command -v "$program" >/dev/null || fail "the program '$program' is missing; install its package"
done
repository=$(cd "$(dirname "$0")/.." && pwd)
kept=${CLEAN_MACHINE_KEEP-}
log=$PWD/clean_machine_$suite.log
trap remove_system EXIT
root=${CLEAN_MACHINE_FOLDER:-$(mktemp -d "/var/tmp/clean_machine_$suite.XXXXXX")}
mkdir -p "$root"

echo "$suite in $root; log: $log"
set -m # a process group of its own
(set -e && try_everything) >"$log" 2>&1 </dev/null &
running=$!
set +m
trap stop_everything TERM INT HUP
status=0
wait "$running" || status=$?
if [[ $status -eq 0 ]]; then
  echo "$suite: passed ($((SECONDS / 60)) minutes); last lines of $log:"
  tail -n 8 "$log"
else
  tail -n 40 "$log"
  fail "$suite: failed after $((SECONDS / 60)) minutes (exit status $status); all of it: $log"
fi
