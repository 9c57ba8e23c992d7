/* Executables as the cross compiler makes them: loaded where readelf says, named as nm says, and
 * refused when they were built for another processor. Skipped without riscv64-unknown-elf-gcc. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/board/elf.h"

#define CROSS "riscv64-unknown-elf-"

static const char source[] =
    "int counter = 5; int zeroed[100]; const char text[] = \"constant\";\n"
    "static __attribute__((noinline)) int helper(int x) { return x * counter + zeroed[x & 63]; }\n"
    "int main(void) { return helper(text[0]); }\n"
    "__asm__(\".section .init; .globl _start; _start: call main; 1: j 1b\");\n";

/* %s is where data are linked and loaded. */
static const char script[] = "ENTRY(_start)\n"
                             "PHDRS { text PT_LOAD FLAGS(5); data PT_LOAD FLAGS(6); }\n"
                             "SECTIONS {\n"
                             "  . = 0x80000000;\n"
                             "  .text : { *(.init) *(.text*) *(.rodata* .srodata*) } :text\n"
                             "  . = ALIGN(4096);\n"
                             "  .data %s { *(.data*) *(.sdata*) } :data\n"
                             "  .bss : { *(.bss*) *(.sbss*) *(COMMON) } :data\n"
                             "  stack_size = 1234;\n"
                             "}\n";

static const char *folder(void)
{
    const char *out = getenv("TEST_OUT");
    return out ? out : "/tmp";
}

static void path_of(char path[512], const char *name)
{
    assert_true(snprintf(path, 512, "%s/elf_gcc_%s", folder(), name) < 512);
}

static void write_text(const char *name, const char *text)
{
    char path[512];
    path_of(path, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static bool run(const char *command)
{
    return system(command) == 0;
}

static bool has_compiler(void)
{
    return run("command -v " CROSS "gcc >/dev/null 2>&1");
}

/* Builds with the given options to elf_gcc_NAME. */
static void build_at(const char *name, const char *options, const char *data)
{
    char command[4096], text[1024], c[512], ld[512], out[512];
    snprintf(text, sizeof text, script, data);
    write_text("source.c", source);
    write_text("link.ld", text);
    path_of(c, "source.c");
    path_of(ld, "link.ld");
    path_of(out, name);
    snprintf(command, sizeof command, CROSS "gcc -Os -nostdlib %s -Wl,-T,'%s' -o '%s' '%s' 2>&1",
             options, ld, out, c);
    if (!run(command))
        fail_msg("failed: %s", command);
}

static void build(const char *name, const char *options)
{
    build_at(name, options, ":");
}

static uint8_t *read_file(const char *name, size_t *size)
{
    char path[512];
    path_of(path, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    uint8_t *bytes = malloc(*size);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, *size, file), *size);
    fclose(file);
    return bytes;
}

/* Every symbol of text and data that nm lists is found, at its own address, under its own name. */
static void compare_names(const struct vm_elf *elf, const char *name)
{
    char command[600], path[512], line[256], symbol[200], type;
    unsigned address, count = 0;
    path_of(path, name);
    snprintf(command, sizeof command, CROSS "nm '%s'", path);
    FILE *nm = popen(command, "r");
    assert_non_null(nm);
    while (fgets(line, sizeof line, nm)) {
        uint32_t offset = 1, found = 0;
        if (sscanf(line, "%x %c %199s", &address, &type, symbol) != 3 ||
            !strchr("TtDdBbRrGgSs", type))
            continue;
        const char *is = vm_elf_symbol(elf, address, &offset);
        assert_non_null(is);
        assert_string_equal(is, symbol);
        assert_int_equal(offset, 0);
        assert_true(vm_elf_find(elf, symbol, &found));
        assert_int_equal(found, address);
        count++;
    }
    pclose(nm);
    assert_true(count >= 6);
    assert_int_equal(count, elf->symbols);
}

/* Segments as readelf prints them. */
static void compare_segments(const struct vm_elf *elf, const uint8_t *bytes, const char *name)
{
    char command[600], path[512], line[256];
    unsigned offset, linked, address, in_file, in_memory;
    int count = 0;
    path_of(path, name);
    snprintf(command, sizeof command, CROSS "readelf -lW '%s'", path);
    FILE *readelf = popen(command, "r");
    assert_non_null(readelf);
    while (fgets(line, sizeof line, readelf)) {
        if (sscanf(line, " LOAD %x %x %x %x %x", &offset, &linked, &address, &in_file,
                   &in_memory) != 5)
            continue;
        assert_true(count < elf->segments);
        const struct vm_elf_segment *s = &elf->segment[count++];
        assert_int_equal(s->address, address);
        assert_int_equal(s->file_size, in_file);
        assert_int_equal(s->memory_size, in_memory);
        assert_ptr_equal(s->bytes, bytes + offset);
        assert_int_equal(s->writable, strchr(line, 'W') != NULL);
        assert_int_equal(s->executable, strstr(line, " E ") != NULL);
    }
    pclose(readelf);
    assert_int_equal(count, 2);
    assert_int_equal(elf->segments, 2);
}

static void accepted(const char *name)
{
    struct vm_elf elf;
    struct crt_error err;
    size_t size;
    uint8_t *bytes = read_file(name, &size);
    if (!vm_elf_parse(&elf, name, bytes, size, &err))
        fail_msg("%s", err.text);
    assert_int_equal(elf.entry, 0x80000000);
    compare_segments(&elf, bytes, name);
    compare_names(&elf, name);
    vm_elf_free(&elf);
    free(bytes);
}

static void refused(const char *name, const char *why)
{
    struct vm_elf elf;
    struct crt_error err = {""};
    size_t size;
    uint8_t *bytes = read_file(name, &size);
    assert_false(vm_elf_parse(&elf, name, bytes, size, &err));
    if (!strstr(err.text, why))
        fail_msg("'%s' does not say '%s'", err.text, why);
    free(bytes);
}

static void good(void **state)
{
    (void)state;
    if (!has_compiler())
        skip();
    build("f.elf", "-march=rv32imf -mabi=ilp32f");
    accepted("f.elf");
    build("i.elf", "-march=rv32i -mabi=ilp32 -g");
    accepted("i.elf");
}

static void wrong_processor(void **state)
{
    (void)state;
    if (!has_compiler())
        skip();
    build("c.elf", "-march=rv32imfc -mabi=ilp32f");
    refused("c.elf", "compressed");
    build("d.elf", "-march=rv32imfd -mabi=ilp32d");
    refused("d.elf", "doubles");
    build("e.elf", "-march=rv32e -mabi=ilp32e");
    refused("e.elf", "RV32E");
    build("64.elf", "-march=rv64imf -mabi=lp64f -mcmodel=medany");
    refused("64.elf", "64-bit");
    build("o.elf", "-march=rv32imf -mabi=ilp32f -r");
    refused("o.elf", "object file");
}

/* A start-up routine would copy .data from where it is loaded, behind the text. */
static void loaded_elsewhere(void **state)
{
    (void)state;
    if (!has_compiler())
        skip();
    build_at("at.elf", "-march=rv32imf -mabi=ilp32f", "0x80800000 : AT(LOADADDR(.text) + 0x800)");
    accepted("at.elf");
}

/* What runs this test is an executable, too. */
static void host_executable(void **state)
{
    (void)state;
    struct vm_elf elf;
    struct crt_error err = {""};
    size_t size = 0;
    static uint8_t bytes[1 << 20];
    FILE *self = fopen("/proc/self/exe", "rb");
    if (self == NULL)
        skip();
    size = fread(bytes, 1, sizeof bytes, self);
    fclose(self);
    assert_false(vm_elf_parse(&elf, "self", bytes, size, &err));
    assert_true(strstr(err.text, "64-bit") || strstr(err.text, "not for RISC-V"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good),
        cmocka_unit_test(wrong_processor),
        cmocka_unit_test(loaded_elsewhere),
        cmocka_unit_test(host_executable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
