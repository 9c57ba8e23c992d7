# shellcheck shell=sh
# tools.sh — sourced by the tests that compare with qemu-riscv32: compilers, or one skipped test and the end
# when QEMU is missing, or one of the tools in $needed.
for tool in qemu-riscv32 ${needed:-}; do
    if ! command -v "$tool" >/dev/null 2>&1; then
        echo "ok 1 - comparison with QEMU # SKIP $tool is not installed"
        echo "1..1"
        exit 0
    fi
done

warnings="-std=c11 -Wall -Wextra -Wpedantic -Wconversion -Wshadow"

cross() { # for RV32IMF, without a library
    # shellcheck disable=SC2086
    riscv64-unknown-elf-gcc $warnings -march=rv32imf -mabi=ilp32f -O2 -ffreestanding -nostdlib -static \
        -I. "$@"
}

# For here, with what the mode of the tests asks for.
case ${TEST_MODE:-rel} in
asan) sanitizers="-fsanitize=address,undefined -fno-sanitize-recover=all" ;;
*) sanitizers= ;;
esac
host() {
    # shellcheck disable=SC2086
    ${CC:-cc} $warnings -D_POSIX_C_SOURCE=200809L -O2 -ffp-contract=off $sanitizers -I. "$@" -lm
}
