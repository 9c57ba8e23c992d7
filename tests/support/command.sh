# command.sh — sourced after tap.sh by tests of one subcommand, whose name is in $subcommand. Output goes to
# $work/out, sentences to $work/said.

# ask ARGUMENTS...: runs it; exit status in $got.
ask() {
    timeout 120 "$KINESCOPE" "$subcommand" "$@" >"$work/out" 2>"$work/said" </dev/null
    got=$?
}

works() { # NAME ARGUMENTS...
    name=$1
    shift
    ask "$@"
    report $got "$name"
}

# fails NAME STATUS SENTENCE ARGUMENTS...: with that status, one sentence that has these words, and no output.
fails() {
    name=$1 want=$2 sentence=$3
    shift 3
    ask "$@"
    [ $got -eq "$want" ] && [ "$(wc -l <"$work/said")" -eq 1 ] && [ ! -s "$work/out" ] &&
        grep -qF -- "$sentence" "$work/said"
    report $? "$name"
}

# says NAME PATTERN: the last sentences have the pattern.
says() {
    grep -q -e "$2" "$work/said"
    report $? "$1"
}

# refuses NAME PATTERN ARGUMENTS...: exit status 2, and nothing but a sentence with the pattern.
refuses() {
    name=$1 pattern=$2
    shift 2
    "$KINESCOPE" "$subcommand" "$@" >"$work/said" 2>&1
    [ $? -eq 2 ] && [ "$(wc -l <"$work/said")" -eq 1 ] && grep -q -e "$pattern" "$work/said"
    report $? "$name"
}
