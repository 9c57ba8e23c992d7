/* settings.h — the options every subcommand shares: which tube, which phosphor, how it is set up.
 *
 *      --tube --phosphor --tubes FILE --set key=value --refresh HZ --on-stop --threads --simd
 *      --personality
 *          │                                    options.h fills struct vm_settings_options
 *          ▼
 *      rows of the catalogue, copied and changed ─▶ struct vm_settings ─▶ machine and tube descs
 *
 * Units:      as named in crt/tube_table.h; memory in bytes.
 * Ownership:  vm_settings_free releases the catalogue; row and phosphor live in the struct.
 * Errors:     an exit status (0, 1 host trouble, 2 usage) and one sentence.
 */
#ifndef EMU_SETTINGS_H
#define EMU_SETTINGS_H

#include "crt/beam_file.h"
#include "crt/tube.h"
#include "emu/machine.h"
#include "emu/options.h"

struct vm_settings_options {
    const char *tube, *phosphor, *personality, *on_stop, *simd;
    struct vm_list tubes, set;
    struct crt_rate refresh;
    long threads;
};

#define VM_SETTINGS_ROWS 9
extern const struct vm_option vm_settings_rows[VM_SETTINGS_ROWS];

struct vm_settings {
    struct crt_catalogue catalogue;
    struct crt_tube_row row;
    struct crt_phosphor phosphor;
    struct crt_rate tick;
    struct crt_knobs knobs;
    uint32_t memory_bytes;
    uint64_t average_ps; /* 0 = the row's times */
    enum vm_on_stop on_stop;
    enum df_personality personality; /* of the display processor; VS60 by default with colours */
    int threads;
    enum crt_simd simd;
};

/* `recording` names tube, phosphor and tick where the options do not; NULL for programs. `tube` is
 * what the program or the tour names (TUBE or TUBE/PHOSPHOR); NULL for the default. */
int vm_settings_resolve(const struct vm_settings_options *options,
                        const struct crt_beam_header *recording, const char *tube,
                        struct vm_settings *settings, struct crt_error *err);
void vm_settings_free(struct vm_settings *settings);

/* The descs that follow from them. */
struct vm_machine_desc vm_settings_machine(const struct vm_settings *settings,
                                           enum df_timing_choice choice, struct crt_tube *tube);
struct crt_tube_desc vm_settings_tube(const struct vm_settings *settings);

#endif
