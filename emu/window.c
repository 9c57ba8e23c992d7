#include "emu/window.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "crt/gl_api.h"
#include "emu/window_events.h"

struct vm_window {
    GLFWwindow *handle;
    struct crt_gl gl;
    struct vm_event_queue *events;
    bool full_screen;
    int x, y, width, height; /* of the window when not full screen, screen coordinates */
};

static const char *glfw_trouble(void)
{
    const char *text = NULL;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

static bool no_window(struct crt_error *err)
{
    return crt_fail(err,
                    "no window can be opened (%.200s); without a display use `kinescope capture "
                    "FILE -o OUT.png`, or run under a virtual one: `xvfb-run -s \"-screen 0 "
                    "1280x1024x24\" kinescope run FILE`",
                    glfw_trouble());
}

/* A square that leaves room for title bar and panels. */
/* Squares side by side. */
static void default_size(int squares, int *width, int *height)
{
    int x = 0, y = 0, w = 0, h = 0;
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    if (monitor)
        glfwGetMonitorWorkarea(monitor, &x, &y, &w, &h);
    int side = (int)(0.85 * (w < h ? w : h));
    if (side < 480)
        side = 480;
    *width = side;
    *height = side;
    if (squares > 1) {
        *width = squares * side < (int)(0.95 * w) ? squares * side : (int)(0.95 * w);
        *height = *width / squares < side ? *width / squares : side;
    }
}

/* No larger than the monitor: what lies outside would be drawn for nobody. */
static void fit_monitor(int *width, int *height)
{
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (!mode)
        return;
    *width = *width < mode->width ? *width : mode->width;
    *height = *height < mode->height ? *height : mode->height;
}

static bool open_handle(struct vm_window *window, int width, int height, int squares,
                        const char *title, struct crt_error *err)
{
    if (width <= 0 || height <= 0)
        default_size(squares, &width, &height);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_ALPHA_BITS, 0);
    fit_monitor(&width, &height);
    window->handle = glfwCreateWindow(width, height, title, NULL, NULL);
    if (!window->handle)
        return no_window(err);
    glfwMakeContextCurrent(window->handle);
    glfwSwapInterval(1);
    return crt_gl_load(&window->gl, glfwGetProcAddress, err);
}

struct vm_window *vm_window_open(int width, int height, int squares, const char *title,
                                 struct crt_error *err)
{
    struct vm_window *window = calloc(1, sizeof *window);
    if (!window) {
        crt_fail(err, "out of memory for a window");
        return NULL;
    }
    if (!glfwInit()) {
        no_window(err);
        free(window);
        return NULL;
    }
    if (open_handle(window, width, height, squares, title, err)) {
        window->events = vm_event_queue_create(window->handle);
        if (window->events)
            return window;
        crt_fail(err, "out of memory for the window's events");
    }
    vm_window_close(window);
    return NULL;
}

/* GLFW itself stays until the process ends: terminating would unload the GL driver, whose threads
 * and static data do not survive that well (gl_context_backend.h keeps its libraries for the same
 * reason). */
void vm_window_close(struct vm_window *window)
{
    if (!window)
        return;
    if (window->handle)
        glfwDestroyWindow(window->handle);
    vm_event_queue_destroy(window->events);
    free(window);
}

crt_gl_loader vm_window_loader(const struct vm_window *window)
{
    (void)window;
    return glfwGetProcAddress;
}

void vm_window_poll(struct vm_window *window)
{
    vm_event_queue_rewind(window->events);
    glfwPollEvents();
}

void vm_window_wait(struct vm_window *window, double seconds)
{
    vm_event_queue_rewind(window->events);
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

bool vm_window_next(struct vm_window *window, struct vm_event *event)
{
    return vm_event_queue_next(window->events, event);
}

void vm_window_size(const struct vm_window *window, int *width, int *height)
{
    glfwGetFramebufferSize(window->handle, width, height);
}

void vm_window_swap(struct vm_window *window)
{
    glfwSwapBuffers(window->handle);
}

void vm_window_set_vsync(struct vm_window *window, bool on)
{
    (void)window;
    glfwSwapInterval(on ? 1 : 0);
}

/* The monitor under the window's centre. */
static GLFWmonitor *monitor_of(const struct vm_window *window)
{
    int count = 0, x = 0, y = 0, w = 0, h = 0;
    GLFWmonitor *const *monitors = glfwGetMonitors(&count);
    glfwGetWindowPos(window->handle, &x, &y);
    glfwGetWindowSize(window->handle, &w, &h);
    for (int i = 0; i < count; i++) {
        int mx = 0, my = 0;
        const GLFWvidmode *mode = glfwGetVideoMode(monitors[i]);
        glfwGetMonitorPos(monitors[i], &mx, &my);
        int cx = x + w / 2 - mx, cy = y + h / 2 - my;
        if (mode && cx >= 0 && cx < mode->width && cy >= 0 && cy < mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

double vm_window_refresh_hz(const struct vm_window *window)
{
    GLFWmonitor *monitor = monitor_of(window);
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    return mode && mode->refreshRate > 0 ? mode->refreshRate : 0;
}

void vm_window_set_title(struct vm_window *window, const char *title)
{
    glfwSetWindowTitle(window->handle, title);
}

void vm_window_set_full_screen(struct vm_window *window, bool on)
{
    if (on == window->full_screen)
        return;
    if (on) {
        GLFWmonitor *monitor = monitor_of(window);
        const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
        if (!mode)
            return;
        glfwGetWindowPos(window->handle, &window->x, &window->y);
        glfwGetWindowSize(window->handle, &window->width, &window->height);
        glfwSetWindowMonitor(window->handle, monitor, 0, 0, mode->width, mode->height,
                             mode->refreshRate);
    } else {
        glfwSetWindowMonitor(window->handle, NULL, window->x, window->y, window->width,
                             window->height, GLFW_DONT_CARE);
    }
    window->full_screen = on;
}

bool vm_window_is_full_screen(const struct vm_window *window)
{
    return window->full_screen;
}

void vm_window_show_cursor(struct vm_window *window, bool shown)
{
    glfwSetInputMode(window->handle, GLFW_CURSOR, shown ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
}

double vm_window_time(void)
{
    return (double)glfwGetTimerValue() / (double)glfwGetTimerFrequency();
}

bool vm_window_read_pixels(struct vm_window *window, struct crt_image *out, struct crt_error *err)
{
    const struct crt_gl *gl = &window->gl;
    int width, height;
    vm_window_size(window, &width, &height);
    if (width <= 0 || height <= 0)
        return crt_fail(err,
                        "the window is minimised, there is no picture in it; restore it first");
    if (!crt_image_init(out, width, height, 8, err))
        return false;
    size_t row = (size_t)width * 3;
    uint8_t *rgb = malloc(row * (size_t)height);
    if (!rgb) {
        crt_image_free(out);
        return crt_fail(err, "out of memory for a picture of %d x %d", width, height);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    for (size_t y = 0; y < (size_t)height; y++) /* GL's rows start at the bottom */
        for (size_t i = 0; i < row; i++)
            out->samples[y * row + i] = rgb[((size_t)height - 1 - y) * row + i];
    free(rgb);
    return true;
}
