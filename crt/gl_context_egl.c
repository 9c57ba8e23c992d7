/* Offscreen GL without a window system: EGL on Mesa's surfaceless platform, found at run time.
 * Values and signatures after EGL 1.5 and EGL_MESA_platform_surfaceless. */
#include <dlfcn.h>
#include <stdlib.h>

#include "crt/gl_context_backend.h"

enum {
    EGL_NONE = 0x3038,
    EGL_SURFACE_TYPE = 0x3033,
    EGL_RENDERABLE_TYPE = 0x3040,
    EGL_OPENGL_BIT = 0x0008,
    EGL_OPENGL_API = 0x30A2,
    EGL_CONTEXT_MAJOR_VERSION = 0x3098,
    EGL_CONTEXT_MINOR_VERSION = 0x30FB,
    EGL_CONTEXT_OPENGL_PROFILE_MASK = 0x30FD,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT = 1,
    EGL_PLATFORM_SURFACELESS_MESA = 0x31DD
};

/* X(return type, name, parameters) */
#define EGL_FUNCTIONS(X)                                                                           \
    X(crt_gl_function, GetProcAddress, (const char *name))                                         \
    X(unsigned, Initialize, (void *display, int *major, int *minor))                               \
    X(unsigned, BindAPI, (unsigned api))                                                           \
    X(unsigned, ChooseConfig, (void *display, const int *want, void **configs, int n, int *found)) \
    X(void *, CreateContext, (void *display, void *config, void *share, const int *attributes))    \
    X(unsigned, DestroyContext, (void *display, void *context))                                    \
    X(unsigned, MakeCurrent, (void *display, void *draw, void *read, void *context))

struct egl {
#define X(type, name, parameters) type(*name) parameters;
    EGL_FUNCTIONS(X)
#undef X
    void *display, *context;
};

typedef void *(*get_platform_display)(unsigned platform, void *native, const int *attributes);

/* The display stays initialised: eglTerminate would take it from every other context as well. */
static void egl_destroy(void *state)
{
    struct egl *e = state;
    if (e->context) {
        e->MakeCurrent(e->display, NULL, NULL, NULL);
        e->DestroyContext(e->display, e->context);
    }
    free(e);
}

static bool load(struct egl *e, void *library, struct crt_error *err)
{
#define X(type, name, parameters)                                                                  \
    e->name = (type(*) parameters)crt_gl_symbol(library, "egl" #name);                             \
    if (!e->name)                                                                                  \
        return crt_fail(err, "libEGL has no egl" #name);
    EGL_FUNCTIONS(X)
#undef X
    return true;
}

static bool start(struct egl *e, struct crt_error *err)
{
    get_platform_display get_display =
        (get_platform_display)e->GetProcAddress("eglGetPlatformDisplayEXT");
    void *display = get_display ? get_display(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL) : NULL;
    if (!display || !e->Initialize(display, NULL, NULL))
        return crt_fail(err, "no surfaceless display (EGL_MESA_platform_surfaceless)");
    e->display = display;
    static const int want[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    void *config = NULL;
    int found = 0;
    if (!e->BindAPI(EGL_OPENGL_API) || !e->ChooseConfig(display, want, &config, 1, &found) ||
        found < 1)
        return crt_fail(err, "the surfaceless display has no OpenGL");
    static const int attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    e->context = e->CreateContext(display, config, NULL, attributes);
    if (!e->context)
        return crt_fail(err, "no GL 3.3 core context");
    if (!e->MakeCurrent(display, NULL, NULL, e->context))
        return crt_fail(err, "the context cannot be made current without a surface");
    return true;
}

bool crt_gl_open_egl(struct crt_gl_backend_state *out, struct crt_error *err)
{
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return crt_fail(err, "libEGL.so.1 is not installed");
    struct egl *e = calloc(1, sizeof *e);
    if (!e)
        return crt_fail(err, "out of memory");
    if (!load(e, library, err) || !start(e, err)) {
        egl_destroy(e);
        return false;
    }
    out->name = "EGL";
    out->loader = e->GetProcAddress;
    out->state = e;
    out->destroy = egl_destroy;
    return true;
}
