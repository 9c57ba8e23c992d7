/* settings.h — the options every subcommand shares: which tubes, which phosphor, how they are set up.
 *
 *      --tube --phosphor --personality --mode --view --tubes FILE --set key=value --refresh HZ …
 *          │                                    options.h fills struct vm_settings_options
 *          ▼
 *      rows of the catalogue, copied and changed ─▶ struct vm_settings ─▶ machine and tube descs
 *
 * Heads:      a tube is of one head, vector or raster, by its kind. The main head is the raster head
 *             when --view or the tube named says so, else the vector head; --phosphor and figures
 *             that both kinds of tube have are those of the main head, unless --set names the head
 *             (raster.spot=0.5).
 * Input:      --set pen=none, tablet=sonic, tablet.rate=30 … : input/setup.h.
 * Units:      as named in crt/tube_table.h and input/; memory in bytes.
 * Ownership:  vm_settings_free releases the catalogue; row and phosphor live in the struct.
 * Errors:     an exit status (0, 1 host trouble, 2 usage) and one sentence.
 */
#ifndef EMU_SETTINGS_H
#define EMU_SETTINGS_H

#include "crt/beam_file.h"
#include "crt/tube.h"
#include "emu/heads.h"
#include "emu/machine.h"
#include "emu/options.h"
#include "input/setup.h"
#include "raster/mode.h"

struct vm_settings_options {
    const char *phosphor, *personality, *on_stop, *simd, *mode, *view;
    struct vm_list tube, tubes, set;
    struct crt_rate refresh;
    long threads;
};

#define VM_SETTINGS_ROWS 11
extern const struct vm_option vm_settings_rows[VM_SETTINGS_ROWS];

/* A tube as it stands there: the row and phosphor copied, and how its knobs are set. */
struct vm_monitor {
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_knobs knobs;
    bool turned; /* by --set */
};

struct vm_settings {
    struct crt_catalogue catalogue;
    struct vm_monitor monitor[VM_HEADS];
    enum vm_view view;
    enum vm_head main;
    struct crt_rate tick;     /* of the vector head */
    struct ras_timing timing; /* of the raster head at power-on */
    bool raster_asked;        /* --mode or --set raster.… is given */
    uint32_t memory_bytes;
    uint64_t average_ps; /* 0 = the row's times */
    enum vm_on_stop on_stop;
    enum df_personality personality; /* of the display processor; VS60 by default with colours */
    int threads;
    enum crt_simd simd;
    struct inp_setup setup; /* input devices */
};

/* `recording` names tube, phosphor and tick where the options do not; NULL for programs. `tube` is
 * what the program or the tour names (TUBE or TUBE/PHOSPHOR); NULL for the default. */
int vm_settings_resolve(const struct vm_settings_options *options,
                        const struct crt_beam_header *recording, const char *tube,
                        struct vm_settings *settings, struct crt_error *err);
void vm_settings_free(struct vm_settings *settings);

/* What --set can name, for suggestions: at most `most` names; how many. A figure may have "vector." or
 * "raster." before it. */
size_t vm_settings_keys(const char **names, size_t most);
bool vm_settings_is_key(const char *key, size_t length);
/* What a key of --set stands at: a number and its unit ("" for none), or a name. */
struct vm_setting {
    double number;
    const char *unit, *name;
};
bool vm_settings_value(const struct vm_settings *settings, const char *key,
                       struct vm_setting *value);

/* The number in front of a figure's unit, or a time where the unit is one. */
bool vm_figure_value(const char *text, const char *unit, double *value, struct crt_error *err);

/* The descs that follow from them; the machine's has no tubes, board, console or buffer yet. */
struct vm_machine_desc vm_settings_machine(const struct vm_settings *settings,
                                           enum df_timing_choice choice);
/* What the tubes of the heads looked at are to be like. */
struct vm_tubes {
    unsigned heads; /* bits: 1 << VM_VECTOR, 1 << VM_RASTER */
    struct crt_tube_desc desc[VM_HEADS];
};
struct vm_tubes vm_settings_tubes(const struct vm_settings *settings, enum vm_view view);

#endif
