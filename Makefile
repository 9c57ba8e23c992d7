# kinescope — one non-recursive Makefile.
#
#   make demo    install what is missing, build, show the tour (or write its PNGs)
#   make test    install what is missing, build, run every test; ends with "N passed, N failed"
#   make help    everything else
#
# MODE=rel|dbg|asan|tsan|cov and CC=gcc|clang choose the folder o/$(MODE)-$(CC) that objects go to.

MODE ?= rel
ifeq ($(origin CC),default)
CC := gcc
endif
O ?= o/$(MODE)-$(notdir $(firstword $(CC)))
ARCH := $(shell $(CC) -dumpmachine 2>/dev/null | cut -d- -f1)

# ---- what the project is made of --------------------------------------------------------------

FOLDERS   := crt display_file raster input emu
EMU_PARTS := emu/cpu emu/board emu/debug emu/plot emu/lab emu/lesson
HEADERS   := $(foreach d,$(FOLDERS) $(EMU_PARTS),$(wildcard $(d)/*.h))
SOURCES   := $(filter-out emu/main.c,$(foreach d,$(FOLDERS) $(EMU_PARTS),$(wildcard $(d)/*.c)))
ifneq ($(ARCH),x86_64)
SOURCES   := $(filter-out %_avx2.c,$(SOURCES))
endif
TESTS     := $(wildcard tests/*/test_*.c)
TEST_LIB  := $(wildcard tests/support/*.c)
BENCHES   := $(wildcard tests/bench/bench_*.c)
FUZZERS   := $(wildcard tests/fuzz/fuzz_*.c)
FIGURES   := $(wildcard tests/figures/*.c)

OBJECTS   := $(SOURCES:%.c=$(O)/%.o)
KINESCOPE := $(O)/kinescope
TEST_BINS := $(TESTS:%.c=$(O)/%)
BENCH_BINS := $(BENCHES:%.c=$(O)/%)
FIGURE_BINS := $(FIGURES:%.c=$(O)/%)
REPLAY_BINS := $(FUZZERS:%.c=$(O)/%_replay)
# Archives from the top of the include order down; each may use only those after it.
ARCHIVES  := $(foreach d,emu input raster display_file crt,$(O)/lib$(d).a)

# ---- flags --------------------------------------------------------------------------------------

WARN      := -Wall -Wextra -Wpedantic -Wconversion -Wshadow
# WERROR=1: a warning fails the build, as in CI. Not the default: newer compilers warn of more.
ifeq ($(WERROR),1)
WARN      += -Werror
endif
# Same bytes everywhere: no contraction to fused multiply-add, no reassociation.
EXACT     := -ffp-contract=off
MODE_rel  := -O2
MODE_dbg  := -O0 -g3
MODE_asan := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
MODE_tsan := -O1 -g -fsanitize=thread
MODE_cov  := -O0 -g --coverage -fprofile-update=atomic
ifeq ($(MODE_$(MODE)),)
$(error MODE is $(MODE); it must be rel, dbg, asan, tsan or cov)
endif
CFLAGS    := -std=c11 -D_POSIX_C_SOURCE=200809L $(WARN) $(EXACT) $(MODE_$(MODE)) -g -I. -pthread $(EXTRA_CFLAGS)
LDFLAGS   := $(MODE_$(MODE)) -pthread
LIBS      := -lglfw -lxcvt -lpng -linih -lnettle -ldw -lelf -lm -ldl
TEST_LIBS := -lcmocka -lmpfr -lgmp

.DEFAULT_GOAL := all
.SECONDARY:
.DELETE_ON_ERROR:
.PHONY: all demo test check sanitize tsan coverage bench input-figures golden lesson-pictures layers headers format clean help deps fuzz pictures

all: $(KINESCOPE)

# The command in the top folder is the one to use: never a debug or sanitizer build.
ifeq ($(MODE),rel)
all: kinescope
kinescope: $(KINESCOPE)
	@ln -sf $< $@
endif

# ---- rules ---------------------------------------------------------------------------------------

$(O)/%_avx2.o: CFLAGS += -mavx2
$(O)/%.o: %.c Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -MMD -MP -c -o $@ $<

define archive_rule
$(O)/lib$(1).a: $(filter $(O)/$(1)/%.o,$(OBJECTS))
	@mkdir -p $$(@D)
	@rm -f $$@
	ar rcs $$@ $$^
endef
$(foreach d,$(FOLDERS),$(eval $(call archive_rule,$(d))))

$(KINESCOPE): $(O)/emu/main.o $(ARCHIVES)
	$(CC) $(LDFLAGS) -o $@ $^ $(LIBS)

# An archive, so that a benchmark takes only what it needs of it.
$(O)/libsupport.a: $(TEST_LIB:%.c=$(O)/%.o)
	@rm -f $@
	ar rcs $@ $^

$(TEST_BINS): $(O)/%: $(O)/%.o $(O)/libsupport.a $(ARCHIVES)
	$(CC) $(LDFLAGS) -o $@ $^ $(TEST_LIBS) $(LIBS)

$(BENCH_BINS) $(FIGURE_BINS): $(O)/%: $(O)/%.o $(O)/libsupport.a $(ARCHIVES)
	$(CC) $(LDFLAGS) -o $@ $^ $(LIBS)

$(REPLAY_BINS): $(O)/%_replay: $(O)/%.o $(O)/tests/fuzz/replay.o $(ARCHIVES)
	$(CC) $(LDFLAGS) -o $@ $^ $(LIBS)

# ---- what people call ------------------------------------------------------------------------------

PACKAGES_RUN  := libpng-dev libglfw3-dev libinih-dev nettle-dev libxcvt-dev libdw-dev libosmesa6 libegl1 libgl1-mesa-dri
PACKAGES_TEST := $(PACKAGES_RUN) libcmocka-dev xvfb xdotool imagemagick libmpfr-dev

# All processors build, unless make was told how many (-j).
JOBS = $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(shell nproc 2>/dev/null || echo 2))

# Names what is missing, then installs it; says nothing and needs no network when all is there.
deps-run: PACKAGES := $(PACKAGES_RUN)
deps-test: PACKAGES := $(PACKAGES_TEST)
deps: deps-test
.PHONY: deps-run deps-test
deps-run deps-test:
	@tests/install-missing.sh $(PACKAGES)

demo: deps-run
	@$(MAKE) $(JOBS) --no-print-directory all
	@tests/demo.sh ./kinescope

test: deps-test
	@$(MAKE) $(JOBS) --no-print-directory check

check: all layers headers $(TEST_BINS) $(REPLAY_BINS)
	@TEST_MODE=$(MODE) tests/run.sh $(O) $(TEST_BINS) $(REPLAY_BINS) -- $(sort $(wildcard tests/*/test_*.sh))

sanitize: deps-test
	@$(MAKE) $(JOBS) --no-print-directory MODE=asan check

tsan: deps-test
	@$(MAKE) $(JOBS) --no-print-directory MODE=tsan check

# Lines that the kept inputs of the fuzzers run, alone and together with the C tests.
coverage: deps-test
	@$(MAKE) $(JOBS) --no-print-directory MODE=cov coverage-run
coverage-run: $(REPLAY_BINS) $(TEST_BINS)
	@tests/coverage.sh $(O) $(REPLAY_BINS) -- $(TEST_BINS)
.PHONY: coverage-run

bench: deps-test
	@$(MAKE) $(JOBS) --no-print-directory all $(BENCH_BINS)
	@tests/bench.sh $(BENCH_BINS)

# Figures of input devices that are told in the README: tables, no timing.
input-figures: all $(FIGURE_BINS)
	@for f in $(FIGURE_BINS); do echo; echo "$$(basename $$f):"; $$f || exit 1; done

# Flicker as the probe measures it, against closed forms, for every phosphor at four rates: a table.
flicker-figures: all
	@KINESCOPE=./kinescope tests/figures/flicker.sh
.PHONY: flicker-figures

# All lessons of the flicker laboratory: pictures, plots and one page, o/laboratory/index.html.
laboratory: all
	./kinescope lesson all -o o/laboratory
.PHONY: laboratory

# The pictures of the README (glass: they vary a little with the GL driver).
pictures: all
	@mkdir -p roms/pictures
	./kinescope capture roms/lander.df --at 0.7s --size 640x640 -o roms/pictures/lander.png
	./kinescope capture roms/radar.df --at 11s --size 640x640 -o roms/pictures/radar.png
	./kinescope capture roms/clock.elf --at 0.7s --size 640x640 -o roms/pictures/clock.png
	./kinescope capture roms/village.df --at 0.7s --size 640x640 -o roms/pictures/village.png
	./kinescope capture roms/pattern.elf --size 800x600 -o roms/pictures/pattern.png
	./kinescope capture roms/mask.elf --closeup 512,374,14 --size 800x600 -o roms/pictures/mask.png
	./kinescope capture roms/heads.elf --size 1200x512 -o roms/pictures/heads.png
	./kinescope capture roms/colours.df --size 640x640 -o roms/pictures/colours.png
	./kinescope capture --type 'step on\nline bresenham 20 10 30 18\n     ' --at 1s --view both --size 1200x600 -o roms/pictures/step.png
	./kinescope capture --type 'lesson shading\n' --at 4s --view both --size 1200x600 -o roms/pictures/shading.png
	./kinescope capture --type 'lesson flight\n' --at 9s --view both --size 1200x600 -o roms/pictures/flight.png
	./kinescope capture --type 'lesson map\n' --at 2s --view raster --size 800x600 -o roms/pictures/map.png
	./kinescope capture --type 'lesson art\n' --at 2s --view vector --size 640x640 -o roms/pictures/art.png
	./kinescope capture roms/sketch.elf --input roms/sketch.script --view raster --size 800x600 -o roms/pictures/sketch.png
	./kinescope capture roms/spline.elf --input roms/spline.script --view raster --size 800x600 -o roms/pictures/spline.png
	./kinescope capture roms/pick.elf --input roms/pick.script --at 10.75s --view raster --size 800x600 -o roms/pictures/pick.png
	./kinescope capture roms/digitise.elf --input roms/digitise.script --at 11s --view raster --size 800x600 -o roms/pictures/digitise.png
	./kinescope capture roms/track.elf --input roms/track.script --at 7.5s --view vector --size 640x640 -o roms/pictures/track.png
	./kinescope capture roms/calibrate.elf --input roms/calibrate.script --when mark:100 --size 800x600 -o roms/pictures/calibrate.png
	./kinescope probe roms/rose.df --at 512,690 --size 960x540 -o roms/pictures/waveform.png >/dev/null
	./kinescope sweep --field 30 --phosphors P1,P4,P7,P22,P31,P33,P39,P43,P46 -o roms/pictures/flicker.png >/dev/null
	./kinescope capture roms/lander.df --phosphor P31 --step stroke --count 400 --gain peakx4 --sheet 6x3 --size 260x260 -o roms/pictures/sheet.png

# Every lesson on both heads, into o/lessons/.
lesson-pictures: all
	@mkdir -p o/lessons
	@printf 'lessons\nquit\n' | ./kinescope run --headless --console 2>/dev/null | sed -n 's/^  \([a-z]*\) .*/\1/p' | \
	  while read -r name; do \
	    ./kinescope capture --type "lesson $$name\n" --at 4s --view both --size 1200x600 -o o/lessons/$$name.png </dev/null && \
	    echo "  o/lessons/$$name.png"; \
	  done

golden: all
	@tests/golden.sh --regenerate ./kinescope
	@KINESCOPE=./kinescope TEST_OUT=$(O)/test-out sh tests/roms/test_lessons.sh --regenerate tests/golden/lessons.txt

layers:
	@tests/layers.sh

# Every public header compiles alone.
headers:
	@for h in $(HEADERS); do \
	  printf '#include "%s"\nextern int translation_unit;\n' $$h | \
	    $(CC) $(CFLAGS) -x c -fsyntax-only - || exit 1; done

format:
	clang-format -i $(wildcard $(addsuffix /*.[ch],$(FOLDERS) $(EMU_PARTS) tests/* tests/*/* roms roms/*) crt/*.inc emu/cpu/*.inc)

FUZZ_SECONDS ?= 60
fuzz:
	@tests/fuzz.sh $(FUZZ_SECONDS) $(FUZZERS)

clean:
	rm -rf o kinescope

help:
	@echo "make             build ./kinescope (MODE=rel|dbg|asan|tsan|cov, CC=gcc|clang)"
	@echo "                 WERROR=1 makes warnings errors"
	@echo "make demo        install what is missing, build, show the tour in a window or write its PNGs"
	@echo "make test        install what is missing, build, run all tests: 'N passed, N failed'"
	@echo "make sanitize    all tests under AddressSanitizer and UndefinedBehaviorSanitizer"
	@echo "make tsan        all tests under ThreadSanitizer"
	@echo "make coverage    lines of the readers and of display_file/ that corpora and tests run (gcov)"
	@echo "make bench       speeds, as ratios within one run"
	@echo "make input-figures   tables: how exact a light pen is, how late hands are seen"
	@echo "make flicker-figures flicker of every phosphor at four rates, measured and in closed form"
	@echo "make laboratory  run all lessons on refresh and flicker: o/laboratory/index.html"
	@echo "make fuzz        run the fuzzers for FUZZ_SECONDS each (clang)"
	@echo "make check       the tests of 'make test' without installing anything (TEST_ONLY=pattern)"
	@echo "make golden      regenerate the golden traces and films (look at them before committing)"
	@echo "make pictures    draw the pictures of the README"
	@echo "make lesson-pictures   a picture of every lesson of the monitor, on both heads, into o/lessons/"
	@echo "make roms        build the firmware images in roms/ anew (cross compiler: tests/toolchain.sh)"
	@echo "make layers      check that includes go one way"
	@echo "make headers     check that every header compiles alone"
	@echo "make format      clang-format the tree"
	@echo "make deps        install what the tests need, and nothing else"
	@echo "make clean       remove what was built"

include roms/roms.mk

-include $(shell find $(O) -name '*.d' 2>/dev/null)
