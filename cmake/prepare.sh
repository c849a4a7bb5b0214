# Sourced by ./run and ./test: packages, configuring, building. Messages go to standard error; standard output belongs to the caller.
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '%s\n' "$*" >&2; }
give_up() { say "$1"; exit "${2:-3}"; }

# Waits while another ./run or ./test works in build/. Held until released or the script ends.
lock_build() {
    mkdir -p "$top/build"
    exec 9>"$top/build/.lock"
    command -v flock >/dev/null || return 0
    flock --nonblock 9 || { say "Another ./run or ./test is at work here; waiting for it."; flock 9; }
}
release_build() { exec 9>&-; }

# find_missing KIND...: puts the packages of cmake/packages.txt that are marked with one of the kinds, and missing as dpkg says, into `missing`.
find_missing() {
    missing=()
    command -v dpkg-query >/dev/null || return 0  # not a Debian; CMake will say what it does not find
    local kind package rest wanted=" $* " packages=()
    while read -r kind package rest; do
        [[ -n $package && $wanted == *" $kind "* ]] && packages+=("$package")
    done < <(sed 's/#.*//' "$top/cmake/packages.txt")
    local installed
    installed=$'\n'$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)$'\n'
    for package in "${packages[@]}"; do
        [[ $installed == *$'\n'"installed $package"$'\n'* ]] || missing+=("$package")
    done
}

# install_missing KIND...: installs them.
install_missing() {
    local missing=()
    find_missing "$@"
    [ ${#missing[@]} -eq 0 ] && return 0

    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || give_up "Missing: ${missing[*]}
Become root, or install sudo, or ask someone who can: apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    say "Installing ${#missing[@]} packages: ${missing[*]}"
    # Runlevel 1: daemons are not started just because they are there.
    local log="$top/build/apt.log" apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive RUNLEVEL=1 apt-get -o DPkg::Lock::Timeout=300 -q -y)
    { "${apt[@]}" update && "${apt[@]}" install --no-install-recommends "${missing[@]}"; } >"$log" 2>&1 9>&- || {
        tail -n 20 "$log" >&2
        give_up "The packages could not be installed; all that apt said is in $log"
    }
    packages_changed=yes
}

# configure PRESET: by CMake where there is something new for it to know, else by ninja, which looks for changed CMake files and new sources.
configure() {
    local folder="$top/build/$1" log="$top/build/$1-configure.log"
    local again=(ninja -C "$folder" build.ninja)
    if [ ! -f "$folder/build.ninja" ] || [ "${packages_changed:-}" = yes ] ||
        [ "$top/CMakePresets.json" -nt "$folder/build.ninja" ] || [ "$top/cmake/packages.txt" -nt "$folder/build.ninja" ]; then
        say "Configuring build/$1"
        again=(cmake --preset "$1")
    fi
    (cd "$top" && "${again[@]}") >"$log" 2>&1 9>&- || {
        cat "$log" >&2
        give_up "Configuring build/$1 failed; the messages above are in $log"
    }
    [ "${again[0]}" = ninja ] || touch "$folder/build.ninja"
}

# build PRESET TARGET...: says nothing when there is nothing to do, shows ninja's status on a terminal, and whole messages on failure.
build() {
    local folder="$top/build/$1" preset=$1 jobs began=$SECONDS quiet=--quiet
    shift
    jobs=$(nproc 2>/dev/null || echo 2)
    say "Building build/$preset with $jobs processes"
    [ -t 2 ] && quiet=
    NINJA_STATUS="[%f/%t, %e s] " ninja $quiet -C "$folder" -j "$jobs" "$@" >&2 9>&- || give_up "The build failed; its messages are above." 3
    [ $((SECONDS - began)) -lt 5 ] || say "Built in $((SECONDS - began)) s"
}
