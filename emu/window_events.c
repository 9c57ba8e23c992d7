#include "emu/window_events.h"

#include <stdlib.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define MANY_EVENTS 1000

struct vm_event_queue {
    GLFWwindow *handle;
    struct vm_event *event;
    size_t count, next, room;
    double x, y;                       /* mouse, window pixels */
    bool chord;                        /* Right Ctrl is held */
    bool host_held[GLFW_KEY_LAST + 1]; /* keys whose press went to the host */
};

static struct vm_event_queue *queue_of(GLFWwindow *handle)
{
    return glfwGetWindowUserPointer(handle);
}

/* A new event at the end of the queue, NULL when there is no memory. */
static struct vm_event *push(struct vm_event_queue *q, enum vm_event_kind kind)
{
    if (q->count == q->room) {
        size_t room = q->room ? 2 * q->room : 64;
        struct vm_event *larger = realloc(q->event, room * sizeof *larger);
        if (!larger)
            return NULL;
        q->event = larger;
        q->room = room;
    }
    struct vm_event *e = &q->event[q->count++];
    memset(e, 0, sizeof *e);
    e->kind = kind;
    e->time = vm_window_time();
    e->x = q->x;
    e->y = q->y;
    return e;
}

static enum vm_key key_of(int glfw)
{
    static const struct {
        int glfw;
        enum vm_key key;
    } others[] = {{GLFW_KEY_ESCAPE, VM_KEY_ESCAPE},
                  {GLFW_KEY_ENTER, VM_KEY_ENTER},
                  {GLFW_KEY_TAB, VM_KEY_TAB},
                  {GLFW_KEY_BACKSPACE, VM_KEY_BACKSPACE},
                  {GLFW_KEY_INSERT, VM_KEY_INSERT},
                  {GLFW_KEY_DELETE, VM_KEY_DELETE},
                  {GLFW_KEY_RIGHT, VM_KEY_RIGHT},
                  {GLFW_KEY_LEFT, VM_KEY_LEFT},
                  {GLFW_KEY_DOWN, VM_KEY_DOWN},
                  {GLFW_KEY_UP, VM_KEY_UP},
                  {GLFW_KEY_PAGE_UP, VM_KEY_PAGE_UP},
                  {GLFW_KEY_PAGE_DOWN, VM_KEY_PAGE_DOWN},
                  {GLFW_KEY_HOME, VM_KEY_HOME},
                  {GLFW_KEY_END, VM_KEY_END},
                  {GLFW_KEY_CAPS_LOCK, VM_KEY_CAPS_LOCK},
                  {GLFW_KEY_SCROLL_LOCK, VM_KEY_SCROLL_LOCK},
                  {GLFW_KEY_NUM_LOCK, VM_KEY_NUM_LOCK},
                  {GLFW_KEY_PRINT_SCREEN, VM_KEY_PRINT_SCREEN},
                  {GLFW_KEY_PAUSE, VM_KEY_PAUSE},
                  {GLFW_KEY_KP_DECIMAL, VM_KEY_KP_DECIMAL},
                  {GLFW_KEY_KP_DIVIDE, VM_KEY_KP_DIVIDE},
                  {GLFW_KEY_KP_MULTIPLY, VM_KEY_KP_MULTIPLY},
                  {GLFW_KEY_KP_SUBTRACT, VM_KEY_KP_SUBTRACT},
                  {GLFW_KEY_KP_ADD, VM_KEY_KP_ADD},
                  {GLFW_KEY_KP_ENTER, VM_KEY_KP_ENTER},
                  {GLFW_KEY_KP_EQUAL, VM_KEY_KP_EQUAL},
                  {GLFW_KEY_LEFT_SHIFT, VM_KEY_LEFT_SHIFT},
                  {GLFW_KEY_LEFT_CONTROL, VM_KEY_LEFT_CONTROL},
                  {GLFW_KEY_LEFT_ALT, VM_KEY_LEFT_ALT},
                  {GLFW_KEY_LEFT_SUPER, VM_KEY_LEFT_SUPER},
                  {GLFW_KEY_RIGHT_SHIFT, VM_KEY_RIGHT_SHIFT},
                  {GLFW_KEY_RIGHT_ALT, VM_KEY_RIGHT_ALT},
                  {GLFW_KEY_RIGHT_SUPER, VM_KEY_RIGHT_SUPER},
                  {GLFW_KEY_MENU, VM_KEY_MENU}};
    if (glfw >= GLFW_KEY_SPACE && glfw <= GLFW_KEY_GRAVE_ACCENT)
        return (enum vm_key)glfw; /* both are ASCII */
    if (glfw >= GLFW_KEY_F1 && glfw <= GLFW_KEY_F12)
        return (enum vm_key)(VM_KEY_F1 + glfw - GLFW_KEY_F1);
    if (glfw >= GLFW_KEY_KP_0 && glfw <= GLFW_KEY_KP_9)
        return (enum vm_key)(VM_KEY_KP_0 + glfw - GLFW_KEY_KP_0);
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        if (others[i].glfw == glfw)
            return others[i].key;
    return VM_KEY_UNKNOWN;
}

/* GLFW counts both Ctrl keys as one; Right Ctrl is the host's. */
static unsigned modifiers_of(GLFWwindow *handle, int mods)
{
    unsigned m = 0;
    if (mods & GLFW_MOD_SHIFT)
        m |= VM_MOD_SHIFT;
    if (mods & GLFW_MOD_ALT)
        m |= VM_MOD_ALT;
    if (mods & GLFW_MOD_SUPER)
        m |= VM_MOD_SUPER;
    if (glfwGetKey(handle, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS)
        m |= VM_MOD_CONTROL;
    return m;
}

static void on_key(GLFWwindow *handle, int glfw, int scancode, int action, int mods)
{
    (void)scancode;
    struct vm_event_queue *q = queue_of(handle);
    enum vm_key key = key_of(glfw);
    if (glfw == GLFW_KEY_RIGHT_CONTROL)
        q->chord = action != GLFW_RELEASE;
    if (key == VM_KEY_UNKNOWN)
        return;
    if (action == GLFW_PRESS)
        q->host_held[glfw] = q->chord || (key >= VM_KEY_F1 && key <= VM_KEY_F12);
    struct vm_event *e = push(q, q->host_held[glfw] ? VM_EVENT_HOST_KEY : VM_EVENT_GUEST_KEY);
    if (!e)
        return;
    e->u.key.key = key;
    e->u.key.action = action == GLFW_PRESS     ? VM_PRESS
                      : action == GLFW_RELEASE ? VM_RELEASE
                                               : VM_REPEAT;
    e->u.key.modifiers = modifiers_of(handle, mods);
    e->u.key.chord = q->chord;
}

static void on_character(GLFWwindow *handle, unsigned character)
{
    struct vm_event_queue *q = queue_of(handle);
    struct vm_event *e = q->chord ? NULL : push(q, VM_EVENT_TEXT);
    if (e)
        e->u.text.character = character;
}

/* GLFW reports screen coordinates; a dense monitor has several pixels to one. */
static void on_mouse(GLFWwindow *handle, double x, double y)
{
    struct vm_event_queue *q = queue_of(handle);
    int w = 0, h = 0, pixels_w = 0, pixels_h = 0;
    glfwGetWindowSize(handle, &w, &h);
    glfwGetFramebufferSize(handle, &pixels_w, &pixels_h);
    if (w <= 0 || h <= 0)
        return;
    q->x = x * pixels_w / w;
    q->y = y * pixels_h / h;
    struct vm_event *last = q->count > q->next ? &q->event[q->count - 1] : NULL;
    if (last && last->kind == VM_EVENT_MOUSE && q->count - q->next >= MANY_EVENTS) {
        last->x = q->x;
        last->y = q->y;
    } else {
        push(q, VM_EVENT_MOUSE);
    }
}

static void on_button(GLFWwindow *handle, int button, int action, int mods)
{
    struct vm_event *e = push(queue_of(handle), VM_EVENT_BUTTON);
    if (!e)
        return;
    e->u.button.number = button;
    e->u.button.pressed = action == GLFW_PRESS;
    e->u.button.modifiers = modifiers_of(handle, mods);
    e->u.button.chord = queue_of(handle)->chord;
}

static void on_scroll(GLFWwindow *handle, double dx, double dy)
{
    struct vm_event *e = push(queue_of(handle), VM_EVENT_SCROLL);
    if (!e)
        return;
    e->u.scroll.dx = dx;
    e->u.scroll.dy = dy;
}

/* GLFW's names die with the callback. */
static void on_drop(GLFWwindow *handle, int count, const char **paths)
{
    for (int i = 0; i < count; i++) {
        char *copy = strdup(paths[i]);
        struct vm_event *e = copy ? push(queue_of(handle), VM_EVENT_DROP) : NULL;
        if (e)
            e->u.drop.path = copy;
        else
            free(copy);
    }
}

static void on_resize(GLFWwindow *handle, int width, int height)
{
    struct vm_event *e = push(queue_of(handle), VM_EVENT_RESIZE);
    if (!e)
        return;
    e->u.size.width = width;
    e->u.size.height = height;
}

static void on_focus(GLFWwindow *handle, int gained)
{
    struct vm_event_queue *q = queue_of(handle);
    if (!gained)
        q->chord = false; /* its release may go elsewhere */
    struct vm_event *e = push(q, VM_EVENT_FOCUS);
    if (e)
        e->u.focus.gained = gained != 0;
}

static void on_close(GLFWwindow *handle)
{
    glfwSetWindowShouldClose(handle, GLFW_FALSE);
    push(queue_of(handle), VM_EVENT_CLOSE);
}

struct vm_event_queue *vm_event_queue_create(GLFWwindow *handle)
{
    struct vm_event_queue *q = calloc(1, sizeof *q);
    if (!q)
        return NULL;
    q->handle = handle;
    glfwSetWindowUserPointer(handle, q);
    glfwSetKeyCallback(handle, on_key);
    glfwSetCharCallback(handle, on_character);
    glfwSetCursorPosCallback(handle, on_mouse);
    glfwSetMouseButtonCallback(handle, on_button);
    glfwSetScrollCallback(handle, on_scroll);
    glfwSetDropCallback(handle, on_drop);
    glfwSetFramebufferSizeCallback(handle, on_resize);
    glfwSetWindowFocusCallback(handle, on_focus);
    glfwSetWindowCloseCallback(handle, on_close);
    return q;
}

static void forget(struct vm_event_queue *q, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (q->event[i].kind == VM_EVENT_DROP) {
            union {
                const char *kept;
                char *ours;
            } path = {q->event[i].u.drop.path};
            free(path.ours); /* copied in on_drop */
        }
}

void vm_event_queue_destroy(struct vm_event_queue *q)
{
    if (!q)
        return;
    forget(q, q->count);
    free(q->event);
    free(q);
}

void vm_event_queue_rewind(struct vm_event_queue *q)
{
    forget(q, q->next);
    if (q->count > q->next)
        memmove(q->event, q->event + q->next, (q->count - q->next) * sizeof *q->event);
    q->count -= q->next;
    q->next = 0;
}

bool vm_event_queue_next(struct vm_event_queue *q, struct vm_event *event)
{
    if (q->next == q->count)
        return false;
    *event = q->event[q->next++];
    return true;
}
