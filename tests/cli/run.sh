#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   run.sh RUN: the script ./run with stand-ins for the programs that it calls: which packages it
#   asks for, when it sets up and when it does not, and how it sums up ctest's results.

# shellcheck disable=SC2016 # the stand-ins expand their variables themselves

run=$1
# shellcheck source=tests/cli/checks.sh
source "$(dirname "$(readlink -f "$0")")/checks.sh"

# stand_in NAME: a program of that name, made of standard input, that notes its calls in calls.
mkdir programs
stand_in()
{
    {
        printf '#!/bin/bash\necho "%s $*" >>"%s/calls"\n' "$1" "$work"
        cat
    } >"programs/$1"
    chmod +x "programs/$1"
}

# call CODE NAME ARGS...: ./run ARGS must exit with CODE.
call()
{
    local code=$1 name=$2 status=0
    shift 2
    : >calls
    PATH=$work/programs:$PATH CSGCAST_BUILD_DIR=$work/build "$run" "$@" >out 2>err || status=$?
    report $((status != code)) "$name: exit $status"
}

was_called()
{
    grep -q "^$1" calls
    report $? "calls $1"
}

was_not_called()
{
    ! grep -q "^$1" calls
    report $? "does not call $1"
}

# Without root and with packages missing it names them, gives the command to type and stops.
stand_in dpkg-query <<<'echo "cmake installed"; exit 1'
stand_in apt-get <<<'exit 1'
stand_in cmake <<<'exit 1'
stand_in id <<<'echo 1000'
call 2 "packages are missing" --version
says "sudo apt-get install"
says "libopenimageio-dev"
was_not_called apt-get
was_not_called cmake
! grep -qw xvfb err
report $? "rendering needs no test packages"
call 2 "packages of the tests are missing" test
says "xvfb"

# As root it installs them; when that fails it gets fresh lists, tries once more and shows the log.
stand_in id <<<'echo 0'
stand_in apt-get <<<'echo "apt-get says no"; exit 100'
call 1 "packages cannot be installed" --version
was_called "apt-get update"
says "apt-get says no"
was_not_called cmake

# The build fails: the reason is shown, and the next call tries again.
stand_in apt-get <<<'exit 0'
stand_in cmake <<<'[[ $1 == -S ]] || { echo "cc says no"; exit 1; }'
call 1 "the build fails" --version
was_called "apt-get .*install"
says "cc says no"

# The tool gets the arguments as they are and runs where the caller is.
stand_in tool <<<'[[ $1 == warm ]] && echo warmed >>"'"$work"'/calls"; printf "%s|" "$PWD" "$@"'
stand_in cmake <<<"cp -f '$work/programs/tool' '$work/build/csgcast'"
call 0 "the first call that works" render "a b.csg" -o ''
was_called "cmake --build"
prints "$work|render|a b.csg|-o||"
was_called warmed
call 0 "the second call" --version
was_not_called dpkg-query
was_not_called cmake
was_not_called warmed
touch -d '2001-01-01' build/.run-built
call 0 "a source is newer than the build" --version
was_called "cmake --build"
was_not_called apt-get

# sums OUTPUT CODE LINE: how ./run test sums up what ctest printed.
sums()
{
    stand_in ctest <<<"printf '%b' '$1'; exit $2"
    call "$3" "ctest says $1" test -R name
    [[ $(tail -n 1 out) == "$4" ]]
    report $? "sums up: $(tail -n 1 out)"
}
sums '\n100% tests passed, 0 tests failed out of 12\n' 0 0 '12 passed, 0 failed'
sums '\n75% tests passed, 3 tests failed out of 12\n' 8 1 '9 passed, 3 failed'
sums ' 1/2 Test  #1: a ...***Skipped   0.0 sec\n100% tests passed, 0 tests failed out of 2\n' \
    0 1 '1 passed, 1 failed'
sums 'No tests were found!!!\n' 0 1 '0 passed, 0 failed'
was_called "ctest .*-R name"

finish
