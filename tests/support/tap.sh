# tap.sh — sourced by tests of scripts: counts and prints TAP. What the script said is in $work/said.
number=0
failed=0

report() { # STATUS NAME
    number=$((number + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $number - $2"
    else
        echo "not ok $number - $2; it said:"
        sed 's/^/#   /' "$work/said"
        failed=1
    fi
}
