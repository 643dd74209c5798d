# shellcheck shell=bash
# SPDX-License-Identifier: MIT
#
# Sourced by the tests here. They run in a folder of their own that is removed at the end; the
# tool's outputs of the last `expect` are in out and err there. The sourcing script sets $csgcast.

# shellcheck disable=SC2154

set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
num_failed=0

report()
{
    if [[ $1 -eq 0 ]]; then
        echo "ok $2"
    else
        echo "FAIL $2"
        num_failed=$((num_failed + 1))
    fi
}

# check NAME COMMAND...: the command must succeed.
check()
{
    local name=$1
    shift
    "$@"
    report $? "$name"
}

# expect CODE NAME ARGS...: csgcast ARGS must exit with CODE.
expect()
{
    local code=$1 name=$2 status=0
    shift 2
    timeout 60 "$csgcast" "$@" >out 2>err || status=$?
    report $((status != code)) "$name: exit $status"
    [[ $status -eq $code ]] || cat err
}

# says TEXT: the last call's standard error contains TEXT.
says()
{
    grep -qF -- "$1" err
    report $? "says \"$1\""
}

prints()
{
    grep -qF -- "$1" out
    report $? "prints \"$1\""
}

is_silent()
{
    [[ ! -s err ]]
    report $? "says nothing"
}

is_png()
{
    [[ $(head -c 8 "$1" | od -An -tx1 | tr -d ' \n') == 89504e470d0a1a0a ]]
}

# The folder holds exactly the files named, besides out and err.
holds_only()
{
    local found expected
    found=$(find . -mindepth 1 ! -name out ! -name err -printf '%P\n' | sort | xargs)
    expected=$(printf '%s\n' "$@" | sort | xargs)
    [[ $found == "$expected" ]]
    report $? "files are: $found"
}

finish()
{
    [[ $num_failed -eq 0 ]]
    exit
}
