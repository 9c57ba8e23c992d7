/* The window, on an Xvfb that this test starts: its picture against the offscreen glass, its events
 * against keys pressed by xdotool, and what it says when there is no display. */
#include <math.h>
#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "crt/gl_context.h"
#include "emu/window.h"

#define WIDTH  640
#define HEIGHT 480

static const struct crt_phosphor green = {.name = "P31", .colours = 1, .colour = {{0.226, 0.528}}};
static const struct crt_glass_settings settings = {
    .gain = 0.01, .room_cd_m2 = 2, .halation = 0.05, .face_radius_mm = 150};

static pid_t server;

/* Starts Xvfb on a display number of its own choosing; false when there is none. */
static bool start_server(char display[16])
{
    int ends[2];
    char fd[12], number[8] = "";
    if (pipe(ends) != 0)
        return false;
    snprintf(fd, sizeof fd, "%d", ends[1]);
    server = fork();
    if (server == 0) {
        close(ends[0]);
        if (!freopen("/dev/null", "w", stderr))
            _exit(127);
        execlp("Xvfb", "Xvfb", "-displayfd", fd, "-screen", "0", "800x600x24", "-nolisten", "tcp",
               (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    struct pollfd wait_for = {.fd = ends[0], .events = POLLIN};
    size_t got = 0;
    while (server > 0 && got + 1 < sizeof number && !strchr(number, '\n') &&
           poll(&wait_for, 1, 20000) == 1) {
        ssize_t n = read(ends[0], number + got, sizeof number - 1 - got);
        if (n <= 0)
            break;
        got += (size_t)n;
    }
    close(ends[0]);
    snprintf(display, 16, ":%d", atoi(number));
    return strchr(number, '\n') != NULL;
}

static void stop_server(void)
{
    if (server <= 0)
        return;
    kill(server, SIGTERM);
    waitpid(server, NULL, 0);
    server = 0;
}

static int set_up(void **state)
{
    (void)state;
    char display[16];
    if (start_server(display))
        return setenv("DISPLAY", display, 1);
    stop_server();
    return unsetenv("DISPLAY");
}

static int tear_down(void **state)
{
    (void)state;
    stop_server();
    return 0;
}

static void pause_ms(long ms)
{
    const struct timespec t = {0, ms * 1000000};
    nanosleep(&t, NULL);
}

/* Skips without a server; otherwise a missing window is a failure. */
static struct vm_window *open_window(void)
{
    struct crt_error err = {""};
    if (!getenv("DISPLAY")) {
        print_message("# SKIP Xvfb cannot be started\n");
        skip();
    }
    struct vm_window *window = vm_window_open(WIDTH, HEIGHT, 1, "test", &err);
    if (!window)
        fail_msg("%s", err.text);
    return window;
}

static struct crt_film new_film(void)
{
    struct crt_film f = {.grid = {200, 152, 0.5, -50, 38}, .colours = 1, .t1 = 20000000000};
    f.light[0] = calloc(200 * 152, sizeof(float));
    assert_non_null(f.light[0]);
    for (int i = 0; i < 30; i++)
        for (int r = 0; r < 152; r++)
            for (int c = 0; c < 200; c++) {
                double x = c - (i * 41) % 200, y = r - (i * 29) % 152, s = 1 + i % 4;
                f.light[0][r * 200 + c] +=
                    (float)(0.02 * 6 * i * exp(-(x * x + y * y) / (2 * s * s)));
            }
    return f;
}

static struct crt_glass *new_glass(crt_gl_loader loader, const struct crt_film *film)
{
    static uint8_t text[WIDTH * HEIGHT * 4];
    struct crt_error err = {""};
    struct crt_glass *glass = crt_glass_create(loader, &err);
    if (!glass)
        fail_msg("%s", err.text);
    for (int y = 400; y < 420; y++)
        for (int x = 30; x < 300; x++)
            memcpy(text + (y * WIDTH + x) * 4, (const uint8_t[]){10, 200, 90, 150}, 4);
    crt_glass_film(glass, film, &green);
    crt_glass_overlay(glass, text, WIDTH, HEIGHT);
    return glass;
}

/* What the X server shows, through ImageMagick; false where that is missing. */
static bool grab_screen(struct crt_image *image)
{
    struct crt_error err;
    assert_true(crt_image_init(image, WIDTH, HEIGHT, 8, &err));
    FILE *pixels = popen("import -window root -crop 640x480+0+0 -depth 8 rgb:- 2>/dev/null", "r");
    size_t count = WIDTH * HEIGHT * 3, got = 0;
    int sample;
    while (pixels && got < count && (sample = getc(pixels)) != EOF)
        image->samples[got++] = (uint16_t)sample;
    if (pixels)
        pclose(pixels);
    return got == count;
}

static void assert_close(const char *what, const struct crt_image *a, const struct crt_image *b)
{
    struct crt_image_difference d = crt_image_compare(a, b, 2);
    print_message("# %s: at most %d steps apart\n", what, d.max_difference);
    assert_true(d.same_shape);
    assert_in_range(d.max_difference, 0, 2);
}

static void shows_what_the_offscreen_glass_renders(void **state)
{
    (void)state;
    struct crt_error err = {""};
    struct crt_image drawn, shot, screen, offscreen;
    struct vm_window *window = open_window();
    struct crt_film film = new_film();
    struct crt_glass *glass = new_glass(vm_window_loader(window), &film);
    int width = 0, height = 0;
    vm_window_size(window, &width, &height);
    assert_int_equal(width, WIDTH);
    assert_int_equal(height, HEIGHT);
    for (int i = 0; i < 5; i++) {
        crt_glass_draw(glass, &settings, 0, width, height);
        assert_true(i > 0 || vm_window_read_pixels(window, &drawn, &err));
        vm_window_swap(window);
        vm_window_poll(window);
        pause_ms(50);
    }
    assert_true(crt_glass_render(glass, &settings, width, height, 8, &shot, &err));
    if (grab_screen(&screen))
        assert_close("screen and framebuffer", &screen, &drawn);
    else
        print_message("# SKIP the X server's screen: no ImageMagick import\n");
    assert_close("framebuffer and screenshot", &drawn, &shot);
    crt_glass_destroy(glass);
    vm_window_close(window);
    struct crt_gl_context *context = crt_gl_context_create(CRT_GL_ANY, &err);
    if (context) {
        glass = new_glass(crt_gl_context_loader(context), &film);
        assert_true(crt_glass_render(glass, &settings, WIDTH, HEIGHT, 8, &offscreen, &err));
        assert_close("screenshot and offscreen glass", &shot, &offscreen);
        crt_image_free(&offscreen);
        crt_glass_destroy(glass);
        crt_gl_context_destroy(context);
    } else {
        print_message("# SKIP %s\n", err.text);
    }
    crt_image_free(&drawn);
    crt_image_free(&shot);
    crt_image_free(&screen);
    free(film.light[0]);
}

/* Waits for an event of this kind and key; what comes before it is passed over. */
static bool find_key(struct vm_window *window, enum vm_event_kind kind, int key, bool chord)
{
    struct vm_event e;
    for (double end = vm_window_time() + 5; vm_window_time() < end;) {
        while (vm_window_next(window, &e)) {
            if (e.kind != kind)
                continue;
            if (kind == VM_EVENT_TEXT && (int)e.u.text.character == key)
                return true;
            if (kind != VM_EVENT_TEXT && (int)e.u.key.key == key && e.u.key.chord == chord &&
                e.u.key.action == VM_PRESS)
                return true;
        }
        vm_window_wait(window, 0.1);
    }
    return false;
}

static void keys_go_to_host_or_guest(void **state)
{
    (void)state;
    struct vm_window *window = open_window();
    for (int i = 0; i < 5; i++) {
        vm_window_swap(window);
        vm_window_poll(window);
        pause_ms(50);
    }
    if (system("xdotool mousemove 100 50 key F5 key a key Escape key Tab keydown Control_R key r "
               "keyup Control_R 2>/dev/null") != 0) {
        vm_window_close(window);
        print_message("# SKIP no xdotool\n");
        skip();
    }
    assert_true(find_key(window, VM_EVENT_HOST_KEY, VM_KEY_F1 + 4, false));
    assert_true(find_key(window, VM_EVENT_GUEST_KEY, 'A', false));
    assert_true(find_key(window, VM_EVENT_TEXT, 'a', false));
    assert_true(find_key(window, VM_EVENT_GUEST_KEY, VM_KEY_ESCAPE, false));
    assert_true(find_key(window, VM_EVENT_GUEST_KEY, VM_KEY_TAB, false));
    assert_true(find_key(window, VM_EVENT_HOST_KEY, 'R', true));
    vm_window_close(window);
}

static void full_screen_and_back(void **state)
{
    (void)state;
    struct vm_window *window = open_window();
    int width = 0, height = 0;
    vm_window_set_full_screen(window, true);
    assert_true(vm_window_is_full_screen(window));
    for (int i = 0; i < 20 && width != 800; i++) {
        vm_window_wait(window, 0.1);
        vm_window_size(window, &width, &height);
    }
    assert_int_equal(width, 800);
    assert_int_equal(height, 600);
    vm_window_set_full_screen(window, false);
    for (int i = 0; i < 20 && width != WIDTH; i++) {
        vm_window_wait(window, 0.1);
        vm_window_size(window, &width, &height);
    }
    assert_int_equal(width, WIDTH);
    assert_int_equal(height, HEIGHT);
    vm_window_close(window);
}

static void without_a_display_says_what_to_use(void **state)
{
    (void)state;
    struct crt_error err = {""};
    const char *display = getenv("DISPLAY");
    char kept[64] = "";
    snprintf(kept, sizeof kept, "%s", display ? display : "");
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    assert_null(vm_window_open(WIDTH, HEIGHT, 1, "test", &err));
    assert_non_null(strstr(err.text, "kinescope capture FILE -o OUT.png"));
    assert_non_null(strstr(err.text, "xvfb-run"));
    if (display)
        setenv("DISPLAY", kept, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        /* First: GLFW stays with the display it has found. */
        cmocka_unit_test(without_a_display_says_what_to_use),
        cmocka_unit_test(shows_what_the_offscreen_glass_renders),
        cmocka_unit_test(keys_go_to_host_or_guest),
        cmocka_unit_test(full_screen_and_back),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
