# roms.mk — firmware: `make roms` builds the images that are checked in. Included by the Makefile.
#
#   roms/NAME.c or roms/NAME/*.c   a program        -> roms/NAME.elf
#   roms/bench/NAME.c              a benchmark      -> roms/bench/NAME.elf
#                                  … and for comparison -> tests/bench/user/NAME.elf, the same object
#                                  code as a program of a Linux user
#   tests/roms/NAME.c              a program for tests -> tests/roms/NAME.elf (test_*.c are tests)
#   ROM_LIBRARY                    board support and the drawing library, an archive: programs take what
#                                  they use
#
# The same sources and tool versions (roms/TOOLCHAIN) give the same bytes wherever the tree lies:
# paths are mapped away, and what a build would tell of itself is stripped. Symbols stay, and line tables,
# packed: kinescope why names the line of C that stored a pixel. Without columns and statement frontiers
# they are a third as large, and an image with them a fifth larger than without.
# ROM_O says where objects go; ROM_O/linked/NAME.elf is the same program before stripping, with all that
# gdb wants.

ROM_CROSS ?= riscv64-unknown-elf-
ROM_O     ?= o/roms

# Never _zicsr or _zifencei in -march when linking: the compiler then picks a 64-bit library.
ROM_ARCH   := -march=rv32imf -mabi=ilp32f -mcmodel=medany
ROM_SPECS  := --specs=picolibc.specs
ROM_CFLAGS := $(ROM_SPECS) $(ROM_ARCH) -std=c11 $(WARN) -Os -g -gno-column-info -gno-statement-frontiers \
              -fno-math-errno -ffunction-sections -fdata-sections -fno-asynchronous-unwind-tables "-ffile-prefix-map=$(CURDIR)=." -I.
ROM_LDFLAGS := -nostartfiles -T $(ROM_O)/link.ld -Wl,--gc-sections -Wl,--build-id=none -Wl,-n \
              -Wl,-z,noexecstack -Wl,--fatal-warnings
# Which printf: whole numbers only, unless the program's own variable says otherwise.
ROM_PRINTF := -DPICOLIBC_INTEGER_PRINTF_SCANF
ROM_PRINTF_tables := -DPICOLIBC_DOUBLE_PRINTF_SCANF
ROM_PRINTF_monitor := -DPICOLIBC_DOUBLE_PRINTF_SCANF
ROM_PRINTF_spline := -DPICOLIBC_DOUBLE_PRINTF_SCANF
ROM_PRINTF_digitise := -DPICOLIBC_DOUBLE_PRINTF_SCANF
ROM_PRINTF_check_light := -DPICOLIBC_DOUBLE_PRINTF_SCANF
ROM_PRINTF_check_curves := -DPICOLIBC_DOUBLE_PRINTF_SCANF

ROM_LIBRARY  := bsp raster geometry clip curves solids visible light stage interact
# A program whose sources lie in more folders than its own.
ROM_PARTS_monitor := commands lessons scenery
ROM_BSP      := $(sort $(foreach d,$(ROM_LIBRARY),$(wildcard roms/$(d)/*.c)))
ROM_FOLDERS  := $(filter-out $(ROM_LIBRARY) $(ROM_PARTS_monitor) bench pictures,$(patsubst roms/%/,%,$(sort $(dir $(wildcard roms/*/*.c)))))
ROM_PROGRAMS := $(sort $(ROM_FOLDERS) $(patsubst roms/%.c,%,$(wildcard roms/*.c)))
ROM_BENCHES  := $(patsubst roms/%.c,%,$(sort $(filter-out roms/bench/main.c,$(wildcard roms/bench/*.c))))
ROM_USERS    := $(ROM_BENCHES:bench/%=tests/bench/user/%.elf)
ROM_TESTS    := $(sort $(filter-out tests/roms/test_%,$(wildcard tests/roms/*.c)))
ROM_IMAGES   := $(patsubst %,roms/%.elf,$(ROM_PROGRAMS) $(ROM_BENCHES))
ROM_HEADERS  := $(wildcard roms/*/*.h)

rom_sources = $(sort $(wildcard roms/$(1).c $(foreach d,$(1) $(ROM_PARTS_$(1)),roms/$(d)/*.c)))
rom_objects = $(patsubst roms/%.c,$(ROM_O)/%.o,$(rom_sources))

.PHONY: roms rom-images rom-headers
roms: rom-images
	@tests/toolchain.sh >roms/TOOLCHAIN

rom-images: $(ROM_IMAGES) $(ROM_TESTS:.c=.elf) $(ROM_USERS)

# As fast code is compiled; loops stay loops, so that kernels call nothing.
$(ROM_O)/bench/%.o: ROM_CFLAGS += -O2 -ffp-contract=fast -fno-tree-loop-distribute-patterns

$(ROM_O)/%.o: roms/%.c roms/roms.mk
	@mkdir -p $(@D)
	$(ROM_CROSS)gcc $(ROM_CFLAGS) -MMD -MP -c -o $@ $<

# The assembler maps no path by itself.
$(ROM_O)/%.o: roms/%.S roms/roms.mk
	@mkdir -p $(@D)
	$(ROM_CROSS)gcc $(ROM_CFLAGS) "-Wa,--debug-prefix-map=$(CURDIR)=." -MMD -MP -c -o $@ $<

$(ROM_O)/link.ld: roms/bsp/link.ld emu/memmap.h roms/roms.mk
	@mkdir -p $(@D)
	$(ROM_CROSS)gcc -E -P -x c -I. -o $@ $<

# Pixels and places are worth the room that fast code takes.
$(foreach d,raster pageflip visible light clip geometry curves solids stage interact scenery lessons spline digitise choice,$(ROM_O)/$(d)/%.o): ROM_CFLAGS += -O2

# Archive members without time or owner (D).
$(ROM_O)/libbsp.a: $(ROM_BSP:roms/%.c=$(ROM_O)/%.o)
	@rm -f $@
	$(ROM_CROSS)ar rcsD $@ $^

# Linking, then stripping: local labels, debugging sections but lines, the compiler's name.
# IMAGE, OBJECTS, what printf knows
define rom_rule
$(1): $(ROM_O)/bsp/crt0.o $(ROM_O)/bsp/trap.o $(2) $(ROM_O)/libbsp.a $(ROM_O)/link.ld
	@mkdir -p $$(@D) $(ROM_O)/linked
	$(ROM_CROSS)gcc $(ROM_SPECS) $(or $(3),$(ROM_PRINTF)) $(ROM_ARCH) $(ROM_LDFLAGS) \
	  -o $(ROM_O)/linked/$$(@F) $$(filter %.o,$$^) \
	  -Wl,--start-group $(ROM_O)/libbsp.a -lm -lc -lgcc -Wl,--end-group
	$(ROM_CROSS)objcopy --strip-debug -X -R .comment --keep-section=.debug_line \
	  --keep-section=.debug_line_str --compress-debug-sections=zlib $(ROM_O)/linked/$$(@F) $$@
endef
$(foreach p,$(ROM_PROGRAMS),$(eval \
  $(call rom_rule,roms/$(p).elf,$(call rom_objects,$(p)),$(ROM_PRINTF_$(p)))))
$(foreach p,$(ROM_BENCHES),$(eval \
  $(call rom_rule,roms/$(p).elf,$(ROM_O)/$(p).o $(ROM_O)/bench/main.o)))
$(foreach p,$(ROM_TESTS:.c=),$(eval $(call rom_rule,$(p).elf,$(ROM_O)/$(p).o,$(ROM_PRINTF_$(notdir $(p))))))

$(ROM_O)/tests/roms/%.o: tests/roms/%.c roms/roms.mk
	@mkdir -p $(@D)
	$(ROM_CROSS)gcc $(ROM_CFLAGS) -MMD -MP -c -o $@ $<

$(ROM_O)/user/%.o: tests/bench/user/%.c roms/roms.mk
	@mkdir -p $(@D)
	$(ROM_CROSS)gcc $(ROM_CFLAGS) -MMD -MP -c -o $@ $<

$(ROM_O)/user/%.o: tests/bench/user/%.S roms/roms.mk
	@mkdir -p $(@D)
	$(ROM_CROSS)gcc $(ROM_CFLAGS) -MMD -MP -c -o $@ $<

tests/bench/user/%.elf: $(ROM_O)/user/start.o $(ROM_O)/user/main.o $(ROM_O)/bench/%.o \
                            tests/bench/user/link.ld
	$(ROM_CROSS)gcc $(ROM_ARCH) -nostdlib -static -T tests/bench/user/link.ld -Wl,--gc-sections \
	  -Wl,--build-id=none -Wl,-z,noexecstack -Wl,--fatal-warnings -o $(ROM_O)/user/$*.linked \
	  $(filter %.o,$^)
	$(ROM_CROSS)strip --strip-debug -X -R .comment -o $@ $(ROM_O)/user/$*.linked

# Every header compiles alone.
rom-headers:
	@for h in $(ROM_HEADERS); do \
	  printf '#include "%s"\nextern int translation_unit;\n' $$h | \
	    $(ROM_CROSS)gcc $(ROM_CFLAGS) -x c -fsyntax-only - || exit 1; done

-include $(shell find $(ROM_O) -name '*.d' 2>/dev/null)
