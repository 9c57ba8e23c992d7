/* window.h — one window with a GL 3.3 core context, its input as plain events.
 *
 *      open ─▶ loop { poll ─▶ next_event … ─▶ crt_glass_draw(…, 0, w, h) ─▶ swap } ─▶ close
 *
 * Models:     nothing: a thin layer over GLFW, and the only file that knows it. No machine logic.
 * Keys:       F1–F12, and every key pressed while Right Ctrl is held, are the host's
 *             (VM_EVENT_HOST_KEY); all others, Tab and Escape included, are the guest's
 *             (VM_EVENT_GUEST_KEY, and VM_EVENT_TEXT for the characters they make). Right Ctrl
 *             itself is never reported. A release goes to whom the press went.
 * Space:      window pixels, that is framebuffer pixels: origin top left, y down, the centre of
 *             the first pixel at ½, ½.
 * Time:       seconds of a monotonic host clock, the same for events and vm_window_time.
 * Ownership:  vm_window_open allocates, vm_window_close frees. GL objects (crt_glass) must be
 *             destroyed before the close. Names of dropped files live until the next
 *             vm_window_poll or _wait.
 * Threads:    everything here on the main thread.
 * Errors:     one sentence; without a display it says what to use instead.
 * Not modelled: pen pressure, joysticks, several windows.
 */
#ifndef VM_WINDOW_H
#define VM_WINDOW_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/error.h"
#include "crt/glass.h"
#include "crt/image.h"

/* Keys by their place on a US keyboard: printable ones are their ASCII code, letters upper case. */
enum vm_key {
    VM_KEY_UNKNOWN = 0,
    VM_KEY_SPACE = ' ',
    VM_KEY_ESCAPE = 256,
    VM_KEY_ENTER,
    VM_KEY_TAB,
    VM_KEY_BACKSPACE,
    VM_KEY_INSERT,
    VM_KEY_DELETE,
    VM_KEY_RIGHT,
    VM_KEY_LEFT,
    VM_KEY_DOWN,
    VM_KEY_UP,
    VM_KEY_PAGE_UP,
    VM_KEY_PAGE_DOWN,
    VM_KEY_HOME,
    VM_KEY_END,
    VM_KEY_CAPS_LOCK,
    VM_KEY_SCROLL_LOCK,
    VM_KEY_NUM_LOCK,
    VM_KEY_PRINT_SCREEN,
    VM_KEY_PAUSE,
    VM_KEY_F1 = 290, /* F1 … F12 are consecutive */
    VM_KEY_F12 = VM_KEY_F1 + 11,
    VM_KEY_KP_0 = 320, /* keypad 0 … 9 are consecutive */
    VM_KEY_KP_9 = VM_KEY_KP_0 + 9,
    VM_KEY_KP_DECIMAL,
    VM_KEY_KP_DIVIDE,
    VM_KEY_KP_MULTIPLY,
    VM_KEY_KP_SUBTRACT,
    VM_KEY_KP_ADD,
    VM_KEY_KP_ENTER,
    VM_KEY_KP_EQUAL,
    VM_KEY_LEFT_SHIFT = 340,
    VM_KEY_LEFT_CONTROL,
    VM_KEY_LEFT_ALT,
    VM_KEY_LEFT_SUPER,
    VM_KEY_RIGHT_SHIFT,
    VM_KEY_RIGHT_ALT,
    VM_KEY_RIGHT_SUPER,
    VM_KEY_MENU
};

enum vm_modifier { VM_MOD_SHIFT = 1, VM_MOD_CONTROL = 2, VM_MOD_ALT = 4, VM_MOD_SUPER = 8 };

enum vm_event_kind {
    VM_EVENT_HOST_KEY,  /* key: an F key, or any key held with Right Ctrl (key.chord) */
    VM_EVENT_GUEST_KEY, /* key */
    VM_EVENT_TEXT,      /* text.character, from a guest key */
    VM_EVENT_MOUSE,     /* mouse: position changed */
    VM_EVENT_BUTTON,    /* button, and mouse position */
    VM_EVENT_SCROLL,    /* scroll, and mouse position */
    VM_EVENT_DROP,      /* drop.path; one event a file */
    VM_EVENT_RESIZE,    /* size, in framebuffer pixels; also after full screen on or off */
    VM_EVENT_FOCUS,     /* focus.gained; when lost, release all held guest keys and buttons */
    VM_EVENT_CLOSE      /* the user asked; the window stays until vm_window_close */
};

enum vm_key_action { VM_RELEASE, VM_PRESS, VM_REPEAT };

struct vm_event {
    enum vm_event_kind kind;
    double time; /* seconds, as vm_window_time */
    double x, y; /* mouse position, window pixels */
    union {
        struct {
            enum vm_key key;
            enum vm_key_action action;
            unsigned modifiers; /* enum vm_modifier; Right Ctrl is not among them */
            bool chord;         /* held with Right Ctrl */
        } key;
        struct {
            uint32_t character; /* Unicode */
        } text;
        struct {
            int number; /* 0 left, 1 right, 2 middle, 3 … 7 */
            bool pressed;
            unsigned modifiers;
            bool chord; /* with Right Ctrl held */
        } button;
        struct {
            double dx, dy; /* notches; dy > 0 = away from the user */
        } scroll;
        struct {
            const char *path;
        } drop;
        struct {
            int width, height;
        } size;
        struct {
            bool gained;
        } focus;
    } u;
};

struct vm_window;

/* Opens a window of width × height pixels (0, 0: so many squares side by side that fit the monitor) and makes its
 * GL 3.3 core context current; vsync is on. NULL and a sentence when there is no display or no
 * GL 3.3. */
struct vm_window *vm_window_open(int width, int height, int squares, const char *title,
                                 struct crt_error *err);
void vm_window_close(struct vm_window *window);

/* For crt_glass_create. */
crt_gl_loader vm_window_loader(const struct vm_window *window);

/* Gathers what has happened since the last call; _wait sleeps until something does or `seconds`
 * pass. vm_window_next then returns events in order, false when there are no more. When very
 * many events pile up between polls, mouse movements without anything between them become one, to where they
 * lead; nothing else is left out. */
void vm_window_poll(struct vm_window *window);
void vm_window_wait(struct vm_window *window, double seconds);
bool vm_window_next(struct vm_window *window, struct vm_event *event);

/* Framebuffer size in pixels; 0 × 0 while minimised: then draw nothing. */
void vm_window_size(const struct vm_window *window, int *width, int *height);

/* Shows what was drawn into framebuffer 0; with vsync waits for the monitor. */
void vm_window_swap(struct vm_window *window);
void vm_window_set_vsync(struct vm_window *window, bool on);

/* The monitor's refresh rate in Hz, 0 when unknown (as under Xvfb). */
double vm_window_refresh_hz(const struct vm_window *window);

void vm_window_set_title(struct vm_window *window, const char *title);
void vm_window_set_full_screen(struct vm_window *window, bool on);
bool vm_window_is_full_screen(const struct vm_window *window);
void vm_window_show_cursor(struct vm_window *window, bool shown);

/* Seconds of a monotonic clock, from an arbitrary origin. */
double vm_window_time(void);

/* What framebuffer 0 holds right now, 8 bit: call after drawing, before the swap. */
bool vm_window_read_pixels(struct vm_window *window, struct crt_image *out, struct crt_error *err);

#endif
