#include "crt/gl_context.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#include "crt/gl_context_backend.h"

struct crt_gl_context {
    struct crt_gl_backend_state backend;
};

crt_gl_function crt_gl_symbol(void *library, const char *name)
{
    /* POSIX promises that the two kinds of pointer have one representation; C does not convert
     * them. */
    void *symbol = dlsym(library, name);
    crt_gl_function f;
    memcpy(&f, &symbol, sizeof f);
    return f;
}

static bool open_backend(enum crt_gl_backend backend, struct crt_gl_backend_state *out,
                         struct crt_error *err)
{
    struct crt_error osmesa = {"not tried"}, egl = {"not tried"};
    if (backend != CRT_GL_EGL && crt_gl_open_osmesa(out, &osmesa))
        return true;
    if (backend != CRT_GL_OSMESA && crt_gl_open_egl(out, &egl))
        return true;
    return crt_fail(err,
                    "no offscreen OpenGL 3.3: OSMesa: %.180s; EGL: %.180s; install libosmesa6, or "
                    "libegl1 and libgl1-mesa-dri",
                    osmesa.text, egl.text);
}

struct crt_gl_context *crt_gl_context_create(enum crt_gl_backend backend, struct crt_error *err)
{
    struct crt_gl_context *context = calloc(1, sizeof *context);
    if (!context) {
        crt_fail(err, "out of memory for an offscreen GL context");
        return NULL;
    }
    if (open_backend(backend, &context->backend, err))
        return context;
    free(context);
    return NULL;
}

void crt_gl_context_destroy(struct crt_gl_context *context)
{
    if (!context)
        return;
    context->backend.destroy(context->backend.state);
    free(context);
}

crt_gl_loader crt_gl_context_loader(const struct crt_gl_context *context)
{
    return context->backend.loader;
}

const char *crt_gl_context_name(const struct crt_gl_context *context)
{
    return context->backend.name;
}

/* Sanitizers call these by name. Mesa keeps a record of some hundred bytes for every context that
 * was ever current, and llvmpipe's threads synchronise by means that ThreadSanitizer cannot see in
 * a library built without it. Ordinary builds never call them. */
const char *__lsan_default_suppressions(void);
const char *__tsan_default_suppressions(void);
const char *__tsan_default_options(void);

const char *__lsan_default_suppressions(void)
{
    return "leak:libOSMesa.so\nleak:libGLX_mesa.so\nleak:libEGL_mesa.so\nleak:swrast_dri.so\n";
}

const char *__tsan_default_suppressions(void)
{
    return "race:libOSMesa.so\nrace:swrast_dri.so\nrace:libgallium\n"
           "called_from_lib:libOSMesa.so\ncalled_from_lib:swrast_dri.so\n";
}

/* LLVM takes and gives back more locks in compiling shaders than the detector can count. */
const char *__tsan_default_options(void)
{
    return "detect_deadlocks=0";
}
