#include "emu/debug/config.h"

#include <nettle/sha2.h>
#include <stdio.h>
#include <string.h>

#define VERSION 3

/* ---- fields, written as a snapshot would ------------------------------------------------------- */

static void rate_fields(struct crt_state *s, struct crt_rate rate)
{
    crt_state_u64(s, &rate.num);
    crt_state_u64(s, &rate.den);
}

static void stroke_fields(struct crt_state *s, struct crt_stroke stroke)
{
    crt_state_u64(s, &stroke.t0);
    crt_state_u64(s, &stroke.t1);
    crt_state_f32(s, &stroke.x0);
    crt_state_f32(s, &stroke.y0);
    crt_state_f32(s, &stroke.x1);
    crt_state_f32(s, &stroke.y1);
    crt_state_f32(s, &stroke.drive);
    crt_state_u32(s, &stroke.source);
    crt_state_u32(s, &stroke.level);
}

static void segment_fields(struct crt_state *s, struct vm_elf_segment segment)
{
    crt_state_u32(s, &segment.address);
    crt_state_u32(s, &segment.memory_size);
    crt_state_bool(s, &segment.writable);
    crt_state_u32(s, &segment.file_size);
    crt_state_bytes(s, (uint8_t *)segment.bytes, segment.file_size); /* saving: only read */
}

static void firmware_fields(struct crt_state *s, const struct vm_elf *given)
{
    uint32_t entry = given->entry;
    crt_state_u32(s, &entry);
    for (int i = 0; i < given->segments; i++)
        segment_fields(s, given->segment[i]);
}

static void program_fields(struct crt_state *s, const struct vm_input *input)
{
    bool recording = input->is_recording, firmware = input->has_firmware;
    bool display = input->program.words != NULL;
    uint32_t entry = input->program.entry;
    crt_state_bool(s, &recording);
    crt_state_bool(s, &firmware);
    crt_state_bool(s, &display);
    for (size_t i = 0; recording && i < input->count; i++)
        stroke_fields(s, input->strokes[i]);
    if (firmware)
        firmware_fields(s, &input->elf);
    if (!display)
        return;
    crt_state_u32(s, &entry);
    crt_state_word_pages(s, input->program.words, DF_MEMORY_BYTES / 2);
}

static void tube_fields(struct crt_state *s, const struct crt_tube_row *given)
{
    struct crt_tube_row row = *given;
#define X(field, unit, meaning) crt_state_f64(s, &row.field.value);
    CRT_TUBE_FIGURES(X)
#undef X
}

static void phosphor_fields(struct crt_state *s, const struct crt_phosphor *given)
{
    struct crt_phosphor p = *given;
    for (int c = 0; c < p.colours; c++) {
        crt_state_f64(s, &p.colour[c].x);
        crt_state_f64(s, &p.colour[c].y);
    }
    for (int k = 0; k < p.terms; k++) {
        int32_t colour = p.term[k].colour;
        crt_state_f64(s, &p.term[k].w);
        crt_state_f64(s, &p.term[k].tau_s);
        crt_state_i32(s, &colour);
    }
}

static void span_fields(struct crt_state *s, struct ras_span span)
{
    crt_state_u32(s, &span.visible);
    crt_state_u32(s, &span.sync_start);
    crt_state_u32(s, &span.sync_end);
    crt_state_u32(s, &span.total);
}

static void timing_fields(struct crt_state *s, struct ras_timing timing)
{
    rate_fields(s, timing.clock);
    span_fields(s, timing.h);
    span_fields(s, timing.v);
    crt_state_bool(s, &timing.interlaced);
}

static void input_fields(struct crt_state *s, const struct inp_setup *given)
{
    struct inp_setup setup = *given;
    uint32_t kinds[] = {setup.has_pen,    setup.has_keyboard, setup.tablet.kind,
                        setup.touch.kind, setup.touch.screen, setup.mouse.kind};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        crt_state_u32(s, &kinds[i]);
    for (unsigned i = 0; inp_setup_key(i); i++) {
        struct crt_figure *figure = inp_setup_figure(&setup, inp_setup_key(i), NULL, NULL);
        if (figure)
            crt_state_f64(s, &figure->value);
    }
}

static void machine_fields(struct crt_state *s, const struct vm_machine_desc *desc)
{
    struct df_timing t = desc->timing;
    uint64_t *const times[] = {
        &t.fetch_ps,       &t.vector_setup_ps,  &t.vector_unit_ps, &t.vector_rest_ps, &t.settle_ps,
        &t.settle_unit_ps, &t.settle_max_ps,    &t.point_ps,       &t.character_ps,   &t.dot_ps,
        &t.intensify_ps,   &t.colour_switch_ps, &t.average_ps};
    uint32_t memory_bytes = desc->memory_bytes;
    uint8_t on_stop = (uint8_t)desc->on_stop, personality = (uint8_t)desc->personality;
    for (size_t i = 0; i < sizeof times / sizeof *times; i++)
        crt_state_u64(s, times[i]);
    crt_state_u32(s, &memory_bytes);
    crt_state_u8(s, &on_stop);
    crt_state_u8(s, &personality);
    rate_fields(s, desc->tick);
    if (desc->board)
        rate_fields(s, desc->board->clock);
}

static bool finish(struct crt_state *s, uint8_t hash[VM_CONFIG_HASH], struct crt_error *err)
{
    struct sha256_ctx sha;
    if (s->failed)
        *err = s->err;
    else {
        sha256_init(&sha);
        sha256_update(&sha, s->size, s->out);
        sha256_digest(&sha, VM_CONFIG_HASH, hash);
    }
    bool ok = !s->failed;
    crt_state_free(s);
    crt_state_save(s);
    return ok;
}

bool vm_config_of(struct vm_config *config, const struct vm_rig *rig,
                  const struct vm_settings *settings, const struct vm_input *input,
                  struct crt_error *err)
{
    struct crt_state s;
    *config = (struct vm_config){.tick = settings->tick};
    snprintf(config->program, sizeof config->program, "%s", input->name);
    snprintf(config->tube, sizeof config->tube, "%s", settings->monitor[VM_VECTOR].row.name);
    snprintf(config->phosphor, sizeof config->phosphor, "%s",
             settings->monitor[VM_VECTOR].phosphor.name);
    snprintf(config->raster, sizeof config->raster, "%s", settings->monitor[VM_RASTER].row.name);
    crt_state_save(&s);
    program_fields(&s, input);
    if (!finish(&s, config->hash[VM_CONFIG_PROGRAM], err))
        return false;
    tube_fields(&s, &settings->monitor[VM_VECTOR].row);
    if (!finish(&s, config->hash[VM_CONFIG_TUBE], err))
        return false;
    phosphor_fields(&s, &settings->monitor[VM_VECTOR].phosphor);
    if (!finish(&s, config->hash[VM_CONFIG_PHOSPHOR], err))
        return false;
    if (input->has_firmware) {
        tube_fields(&s, &settings->monitor[VM_RASTER].row);
        phosphor_fields(&s, &settings->monitor[VM_RASTER].phosphor);
        timing_fields(&s, settings->timing);
    }
    if (!finish(&s, config->hash[VM_CONFIG_RASTER], err))
        return false;
    input_fields(&s, &settings->setup);
    if (!finish(&s, config->hash[VM_CONFIG_INPUT], err))
        return false;
    machine_fields(&s, &rig->machine->desc);
    return finish(&s, config->hash[VM_CONFIG_MACHINE], err);
}

/* ---- comparison -------------------------------------------------------------------------------- */

static bool differs(const struct vm_config *a, const struct vm_config *b, enum vm_config_kind kind)
{
    return memcmp(a->hash[kind], b->hash[kind], VM_CONFIG_HASH) != 0;
}

static bool refuse(const char *what, const char *theirs, const char *ours, const char *remedy,
                   struct crt_error *err)
{
    if (strcmp(theirs, ours) == 0)
        return crt_fail(err, "made with another version of the %s %s; %s", what, ours, remedy);
    return crt_fail(err, "made with another %s (%s, this run has %s); %s", what, theirs, ours,
                    remedy);
}

bool vm_config_agree(const struct vm_config *theirs, const struct vm_config *ours,
                     struct crt_error *err)
{
    if (differs(theirs, ours, VM_CONFIG_PROGRAM))
        return refuse("program", theirs->program, ours->program, "run that program", err);
    if (differs(theirs, ours, VM_CONFIG_TUBE))
        return refuse("tube", theirs->tube, ours->tube,
                      "give the same --tube, --tubes and --set figures", err);
    if (differs(theirs, ours, VM_CONFIG_PHOSPHOR))
        return refuse("phosphor", theirs->phosphor, ours->phosphor,
                      "give the same --phosphor and --tubes", err);
    if (differs(theirs, ours, VM_CONFIG_RASTER))
        return refuse("raster tube", theirs->raster, ours->raster,
                      "give the same --tube, --phosphor, --mode and --set figures", err);
    if (theirs->tick.num != ours->tick.num || theirs->tick.den != ours->tick.den)
        return crt_fail(err,
                        "made with another sync tick (%g Hz, this run has %g Hz); give the same "
                        "--refresh",
                        crt_rate_hz(theirs->tick), crt_rate_hz(ours->tick));
    if (differs(theirs, ours, VM_CONFIG_INPUT))
        return crt_fail(err,
                        "made with other input devices; give the same --set pen, tablet, touch, "
                        "mouse, keyboard and their figures");
    if (differs(theirs, ours, VM_CONFIG_MACHINE))
        return crt_fail(err, "made with another machine; give the same --set memory, "
                             "--set dpu.average, --personality and --on-stop");
    return true;
}

/* ---- in a snapshot ----------------------------------------------------------------------------- */

/* A name that ends within its field and can be printed. */
static void name_state(struct crt_state *s, char *name, size_t size)
{
    crt_state_bytes(s, name, size);
    name[size - 1] = '\0';
    for (char *p = name; *p; p++)
        if (*p < ' ' || *p > '~')
            *p = '?';
}

void vm_config_state(struct vm_config *config, struct crt_state *s)
{
    crt_state_begin(s, "CONF", VERSION);
    name_state(s, config->program, sizeof config->program);
    name_state(s, config->tube, sizeof config->tube);
    name_state(s, config->phosphor, sizeof config->phosphor);
    name_state(s, config->raster, sizeof config->raster);
    crt_state_u64(s, &config->tick.num);
    crt_state_u64(s, &config->tick.den);
    for (int kind = 0; kind < VM_CONFIG_KINDS; kind++)
        crt_state_bytes(s, config->hash[kind], VM_CONFIG_HASH);
    crt_state_end(s);
}
