/* show.h — a program in a window: real time or slowed, with knobs, help and a status line; on one machine or
 * on two side by side.
 *
 *      host clock ─▶ pace ─▶ machine ─▶ tubes ─▶ films of this frame ─▶ glass ─▶ window
 *      events ─▶ keys (show_keys.c) ─▶ pause, scale, knobs, program ─┘      hud ┘
 *         └────▶ mouse, the guest's keys (show_hands.c) ─▶ acts ─▶ machine, record
 *
 * Time:       each host frame the machine runs to T + min(elapsed, 50 ms) × scale and the film
 *             gathers exactly that time. An elapsed time within a third of a frame interval of a
 *             whole number of them counts as that number: exposures of a steady display are equal.
 * Sides:      one machine, or two that are compared: the same acts, the same instants. What there is only one of
 *             (pace, words, moments, the record) is the left one's.
 * Ownership:  vm_show does all in one call.
 * Errors:     an exit status and one sentence. Trouble with a program is shown on the glass; it
 *             does not end the show. Nor does firmware that ends itself, unless its console is a
 *             terminal: somebody waits there; its exit status is the show's.
 */
#ifndef EMU_SHOW_H
#define EMU_SHOW_H

#include "emu/debug/gdb_server.h"
#include "emu/debug/gdb_past.h"
#include "emu/calm.h"
#include "emu/debug/history.h"
#include "emu/hud.h"
#include "emu/frame.h"
#include "emu/hand.h"
#include "emu/lab/probe.h"
#include "emu/picture.h"
#include "emu/roms.h"
#include "emu/saved.h"
#include "emu/sliding.h"
#include "emu/terminal.h"
#include "emu/versus.h"
#include "emu/view.h"
#include "emu/window.h"

/* What may be different from side to side. */
struct vm_show_options {
    struct vm_settings_options settings;
    struct vm_light_options light;
};
#define VM_SHOW_TABLES 2 /* that fill it */

struct vm_show_lesson;

struct vm_show_desc {
    const struct vm_show_lesson *lesson;             /* NULL: none; this is its first page's */
    const char *path;                                /* NULL: the tour */
    const char *roms;                                /* folder of the tour, NULL: look for it */
    const struct vm_show_options *options[VM_SIDES]; /* the second NULL: one machine */
    const struct vm_option_table *tables[VM_SIDES];  /* of those */
    const struct vm_versus *versus;                  /* what differs */
    const struct vm_input_options *input;
    struct vm_size size; /* 0: fits the monitor */
    bool full_screen;
    double scale;          /* simulated seconds a second */
    uint64_t shutter;      /* ps; 0: the time that a picture stands for */
    bool no_flash;         /* mean light, nothing that flashes */
    struct vm_time length; /* close after this much simulated time, when given */
    bool console;          /* firmware's console is stdin and stdout */
    const struct vm_saved_options *saved;
    bool latency;       /* say in the end how late hands were seen */
    const char *record; /* file for what is done in the window; NULL: none */
    struct vm_gdb *gdb; /* a debugger may come here; NULL: none */
};

/* Pages that follow each other in one window, each as its own desc says, but for window size and full screen. */
struct vm_show_page {
    struct vm_show_desc desc;
    const char *title, *caption;   /* UTF-8 */
    bool flashes;                  /* the first that does waits behind the warning */
    const struct crt_image *still; /* shown in place of the program; NULL: it runs */
};
struct vm_show_lesson {
    const struct vm_show_page *page;
    int count;
    const char *warning;
    bool projector; /* larger letters */
};

int vm_show(const struct vm_show_desc *desc, struct crt_error *err);

/* ---- shared by the files of the show; nobody else uses what follows ----------------------- */

enum vm_knob { /* what Up and Down turn; the first three are the monitors' */
               VM_KNOB_BRIGHTNESS,
               VM_KNOB_CONTRAST,
               VM_KNOB_FOCUS,
               VM_KNOB_SHUTTER,
               VM_KNOB_GAIN
};

#define VM_SHUTTER_MOST CRT_PS_PER_S

/* When it is shown where the beam is. */
enum vm_where_shown { VM_WHERE_SLOW, VM_WHERE_ALWAYS, VM_WHERE_NEVER };

/* A program on a machine; its parts point at each other, so it stays where it was made. */
struct vm_shown {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_lights lights;
    struct vm_rig rig;
    struct vm_frame frame;          /* what was gathered last */
    struct vm_frame piece;          /* of a long exposure: its last step */
    struct vm_sliding *sliding;     /* NULL: none so far */
    struct vm_calm *calm;           /* with desc->no_flash; NULL: none so far */
    const struct vm_frame *calmed;  /* what it shows */
    struct vm_history *history;     /* NULL: no memory for it, or there is nothing to step by */
    struct vm_gdb_past past;        /* a debugger's way to it */
    uint64_t from;                  /* when the show of it began: later than 0 with --load-state */
    enum vm_view view;              /* wanted; F2 */
    enum vm_view view_drawn;        /* in the last picture; never auto */
    double rate_hz;                 /* refreshes a simulated second; 0: not known */
    uint64_t rate_number, rate_end; /* of the last look at it */
};

#define VM_SCOPE_PAST (CRT_PS_PER_S / 4) /* what an oscilloscope is shown again after a step */

/* A photodiode and its oscilloscope (show_scope.c); it stays where it is from program to program. */
struct vm_scope {
    bool in_hand; /* the mouse's click places it */
    bool placed;
    int side; /* on whose tube */
    enum crt_photodiode_kind kind;
    enum vm_head head;
    double x_mm, y_mm;
    struct vm_probe probe;         /* zero: not on a tube */
    struct vm_probe_report report; /* known: of the last look */
    bool known;
    double next; /* host time of the next look */
};

struct vm_show {
    const struct vm_show_desc *desc;
    struct vm_window *window;
    struct crt_glass *glass[VM_SIDES][VM_HEADS];
    struct vm_hud *hud;

    /* The program (show_program.c), on each machine; NULL before the first. */
    struct vm_shown *side[VM_SIDES];
    int sides;
    struct vm_shown *program;                  /* side[0] */
    char caption[VM_SIDES][VM_VERSUS_CAPTION]; /* of two; UTF-8 */
    char path[4096];
    uint64_t stamp;  /* of the files shown, when they were read */
    bool film_ready; /* the sides' frames hold light */

    /* The tour. */
    struct vm_roms roms;
    bool touring;
    int rom;
    double rom_since; /* host time */

    /* A lesson (show_lesson.c). */
    int page;
    bool begins;        /* nothing has been shown of the desc's program: --load-state is for it */
    bool captioned;     /* Right Ctrl T */
    bool covered;       /* nothing runs behind a page of text or a picture */
    bool warning;       /* which is the warning */
    bool warning_known; /* it was shown */

    /* Pace. */
    double scale, remainder_ps, last_time;
    bool paused, step, skip, quit;
    enum vm_unit unit;         /* of steps */
    uint64_t dark_told;        /* tick before the dark stretch that was told last */
    double speed, speed_since; /* measured: simulated seconds a second */
    uint64_t speed_from;

    uint64_t shutter;       /* ps; 0: the time that a picture stands for */
    bool gain_auto;         /* goes down as exposures get short: */
    int gain_now[VM_HEADS]; /* to that power of two, by now */
    int gain;               /* power of two, when not automatic */

    struct vm_scope scope;
    bool why_shown; /* a panel that any key closes, about a place */
    int why_side;
    enum vm_head why_head;
    double why_x_mm, why_y_mm;
    enum vm_where_shown where;
    bool no_flash; /* the mean light of the last second is shown */
    bool warned;   /* of flashes of this program */

    struct crt_knobs knobs;
    enum vm_knob knob;
    bool knobs_touched;

    /* Hands (show_hands.c): what the mouse is, what it holds, keys held. */
    enum vm_hand hand;
    enum vm_head pen_head; /* the screen it was over last */
    bool hand_there;       /* over a screen */
    unsigned pressed;      /* bits of buttons: left, middle, right */
    bool mouse_known;
    double mouse_x, mouse_y; /* window pixels */
    bool held[256];          /* keys, by KEYCODE_… */
    bool key_waits;          /* pressed, its character has not come yet */
    uint8_t waiting_code;

    /* How late hands are seen, from the event to the picture that shows it, host seconds. */
    double event_time;  /* of the event being looked at */
    double event_since; /* of the first event not yet shown; 0: none */
    double late_sum, late_most;
    unsigned late_count;

    bool recording;        /* of desc->record: until another program is shown */
    double recorded_since; /* host time */

    /* Status line. */
    double status_since, poll_since;
    bool trouble_shown;
    int shots;

    struct vm_terminal terminal; /* with desc->console */
};

/* Shows `path` in place of what is shown; keeps the old one and says why when it cannot. `tube` may
 * be NULL. */
bool vm_show_open(struct vm_show *show, const char *path, const char *tube, struct crt_error *err);
void vm_show_close(struct vm_shown *program);
/* Loads the file again when it has changed (or `force`), without disturbing time or phosphor. */
void vm_show_reload(struct vm_show *show, bool force);
bool vm_show_tour(struct vm_show *show, int step, struct crt_error *err);

/* show_lesson.c: how many machines a window has to have room for; opens a page; N, P: false, it is no lesson;
 * Right Ctrl T; another program is shown. */
int vm_show_most_sides(const struct vm_show_desc *desc);
bool vm_show_page(struct vm_show *show, int page, struct crt_error *err);
bool vm_show_turn_page(struct vm_show *show, int step);
void vm_show_caption(struct vm_show *show, bool shown);
/* What is a page's that covers the program, or is not for anybody then: true. */
bool vm_show_page_event(struct vm_show *show, const struct vm_event *event);

/* show_sides.c: the part of the window that shows a head's tube; false: it is not shown. */
bool vm_show_part(const struct vm_show *show, int side, int head, struct crt_glass_part *part);
/* The captions over two sides. */
void vm_show_name_sides(struct vm_show *show);
/* Which screen a window pixel shows, and where. */
struct vm_spot {
    bool on; /* a screen */
    int side;
    enum vm_head head;
    double x_mm, y_mm; /* from its middle */
};
struct vm_spot vm_show_spot(const struct vm_show *show, double x, double y);
/* The same place of the left machine's tube. */
struct vm_spot vm_show_left_spot(const struct vm_show *show, struct vm_spot spot);

/* show_draw.c: the frames to the glasses; both to the window; a picture of the window. */
void vm_show_develop(struct vm_show *show);
/* Of vm_show_frame(); without looking which view it is. */
void vm_show_upload(struct vm_show *show);
void vm_show_draw(struct vm_show *show, double now);
bool vm_show_picture(struct vm_show *show, struct crt_image *image, struct crt_error *err);
/* F2: the next view. */
void vm_show_next_view(struct vm_show *show);

/* show.c: runs a machine to `until`, or as far as a debugger lets it. */
void vm_show_run(struct vm_show *show, struct vm_shown *program, uint64_t until);

/* show_shutter.c: runs all sides to `until` and has the light that falls within the shutter's time before it shown. */
void vm_show_expose(struct vm_show *show, uint64_t until);
/* How long the picture after a step gathers light: the shutter's time; else a tick, in slow motion as much less, so
 * that after small steps the same is seen as in between. */
uint64_t vm_show_exposure(const struct vm_show *show);
/* What is shown: what was gathered, or without flashes. And that it has been looked at for `seconds`. */
const struct vm_frame *vm_show_frame(const struct vm_show *show, const struct vm_shown *program);
void vm_show_calm(struct vm_show *show, double seconds);
void vm_show_turn_shutter(struct vm_show *show, int direction);
void vm_show_say_shutter(struct vm_show *show);
void vm_show_describe_shutter(uint64_t shutter, char *text, size_t size);
/* The head looked at on the left side, of two the vector head. */
int vm_show_main_head(const struct vm_show *show);
/* Of what a head shows: a power of two; as "x1/32". After each picture gain follows it. */
int vm_show_gain(const struct vm_show *show, int head);
void vm_show_follow_gain(struct vm_show *show);
void vm_show_describe_gain(int gain, char *text, size_t size);
void vm_show_toggle_gain(struct vm_show *show);
void vm_show_turn_gain(struct vm_show *show, int direction);

/* show_where.c: the window pixel at which a place on a head's screen is shown, and the scale there; false: it
 * is not. */
bool vm_show_window_place(const struct vm_show *show, int side, int head, double x_mm, double y_mm,
                          double *x, double *y, double *mm_per_pixel);
/* At rest, or so slow that an eye can follow the beam. */
bool vm_show_is_slow(const struct vm_show *show);
/* The mark at the beam's place; lines for the status, each after a line feed; the time with the digits that
 * move; Right Ctrl M. */
void vm_show_mark_beam(struct vm_show *show);
void vm_show_describe_where(const struct vm_show *show, char *text, size_t size);
void vm_show_describe_time(const struct vm_show *show, char *text, size_t size);
void vm_show_next_where(struct vm_show *show);

/* show_honest.c: at the start; once the rate is known; Right Ctrl L. */
void vm_show_welcome(struct vm_show *show);
void vm_show_warn(struct vm_show *show);
void vm_show_toggle_flash(struct vm_show *show);
/* How often a second a monitor of `host` Hz flashes, between 3 and 30 Hz, when it shows a screen lit
 * `refresh_hz` times a second so much slower; shutter 0: as long as a picture stands for. 0: it does not. */
double vm_show_flash_hz(const struct crt_phosphor *phosphor, double refresh_hz, double scale,
                        double shutter_s, double host);

/* show_scope.c: F4, Right Ctrl A; F9 while it is in hand: true, and it is not any more. */
void vm_show_scope_key(struct vm_show *show);
void vm_show_scope_area(struct vm_show *show);
bool vm_show_scope_let_go(struct vm_show *show);
/* A mouse event that is the photodiode's: true. */
bool vm_show_scope_event(struct vm_show *show, const struct vm_event *event);
/* After the machine has run; what is seen of it; before the tubes go. */
void vm_show_scope_watch(struct vm_show *show);
void vm_show_scope(struct vm_show *show, double now);
void vm_show_mark_diode(struct vm_show *show);
void vm_show_scope_close(struct vm_show *show);
/* Beside the screenshot `name` (without .png): the plot and the figures. */
bool vm_show_scope_save(struct vm_show *show, const char *name, struct crt_error *err);

/* show_why.c: a click with Right Ctrl, or a key of the program's that only closes its panel: true. */
bool vm_show_why_event(struct vm_show *show, const struct vm_event *event);
void vm_show_why_close(struct vm_show *show);
void vm_show_mark_asked(struct vm_show *show);

void vm_show_event(struct vm_show *show, const struct vm_event *event);
/* show_hands.c: a mouse's or key's event becomes what a person does; after the last of a frame, flush. */
void vm_show_hand_event(struct vm_show *show, const struct vm_event *event);
void vm_show_hand_flush(struct vm_show *show);
/* What the hand held for the program it lets go. */
void vm_show_take_away(struct vm_show *show);
/* F9; and for a program that has just been opened. */
void vm_show_next_hand(struct vm_show *show);
void vm_show_first_hand(struct vm_show *show);
/* The act, now, on every machine that has its device; places are of the left one's tube. */
void vm_show_do(struct vm_show *show, struct inp_act act);
/* show_typing.c: a key, the character it makes; none will come any more; all keys let go. */
void vm_show_key_event(struct vm_show *show, const struct vm_event *event);
void vm_show_text_event(struct vm_show *show, uint32_t character);
void vm_show_key_settle(struct vm_show *show);
void vm_show_release_keys(struct vm_show *show);
/* What the light pen sees: a circle in window pixels; false: there is none. */
bool vm_show_ring(const struct vm_show *show, double *x, double *y, double *radius);
/* The knobs are turned: an act of the person's, too. */
void vm_show_turn(struct vm_show *show, enum vm_head head);
void vm_show_status(struct vm_show *show, double now);

/* show_step.c: steps of show->unit, back (−1) and forward (1); the machine stands there, paused, and the
 * light of the tick that ends there is shown. */
void vm_show_step(struct vm_show *show, int direction);
/* At rest: what led here once more, for who has just begun to look. */
void vm_show_look_again(struct vm_show *show);
void vm_show_next_unit(struct vm_show *show);
void vm_show_check_unit(struct vm_show *show); /* of another program */
/* Remembers the run as it goes; what came from outside; that it begins anew. */
void vm_show_note(struct vm_show *show);
void vm_show_mark(struct vm_show *show);
void vm_show_forget(struct vm_show *show);

/* What the status line says. */
struct vm_status {
    const char *name, *tube, *phosphor, *time, *scale, *state;
    double rate_hz; /* 0: not known */
    uint64_t words; /* a refresh */
};

/* The line, with parts left out until it has at most `columns` letters; false: it still has more. */
bool vm_status_text(const struct vm_status *status, int columns, char *text, size_t size);
void vm_show_say(struct vm_show *show, const char *text);

#endif
