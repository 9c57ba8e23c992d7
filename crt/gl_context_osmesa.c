/* Offscreen GL in plain memory: libOSMesa, found at run time (Mesa before 25.1 has it).
 * Values and signatures after GL/osmesa.h of Mesa 22.3. */
#include <dlfcn.h>
#include <stdlib.h>

#include "crt/gl_api.h"
#include "crt/gl_context_backend.h"

enum {
    OSMESA_FORMAT = 0x22,
    OSMESA_RGBA = GL_RGBA,
    OSMESA_DEPTH_BITS = 0x30,
    OSMESA_PROFILE = 0x33,
    OSMESA_CORE_PROFILE = 0x34,
    OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
    OSMESA_CONTEXT_MINOR_VERSION = 0x37
};

/* The context wants a buffer to be current with; all drawing goes to framebuffer objects. */
#define BUFFER_SIDE 16

struct osmesa {
    void *context;
    void (*destroy)(void *context);
    unsigned char buffer[BUFFER_SIDE * BUFFER_SIDE * 4];
};

static void osmesa_destroy(void *state)
{
    struct osmesa *o = state;
    o->destroy(o->context);
    free(o);
}

static bool start(struct osmesa *o, void *library, crt_gl_loader *loader, struct crt_error *err)
{
    void *(*create)(const int *, void *) =
        (void *(*)(const int *, void *))crt_gl_symbol(library, "OSMesaCreateContextAttribs");
    unsigned char (*make_current)(void *, void *, unsigned, int, int) =
        (unsigned char (*)(void *, void *, unsigned, int, int))crt_gl_symbol(library,
                                                                             "OSMesaMakeCurrent");
    o->destroy = (void (*)(void *))crt_gl_symbol(library, "OSMesaDestroyContext");
    *loader = (crt_gl_loader)crt_gl_symbol(library, "OSMesaGetProcAddress");
    if (!create || !make_current || !o->destroy || !*loader)
        return crt_fail(err, "too old, no OSMesaCreateContextAttribs");
    static const int attributes[] = {OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_DEPTH_BITS,
                                     0,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    o->context = create(attributes, NULL);
    if (!o->context)
        return crt_fail(err, "no GL 3.3 core context");
    if (make_current(o->context, o->buffer, GL_UNSIGNED_BYTE, BUFFER_SIDE, BUFFER_SIDE))
        return true;
    o->destroy(o->context);
    return crt_fail(err, "the context cannot be made current");
}

bool crt_gl_open_osmesa(struct crt_gl_backend_state *out, struct crt_error *err)
{
    void *library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        library = dlopen("libOSMesa.so", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return crt_fail(err, "libOSMesa.so.8 is not installed");
    struct osmesa *o = calloc(1, sizeof *o);
    if (!o)
        return crt_fail(err, "out of memory");
    if (!start(o, library, &out->loader, err)) {
        free(o);
        return false;
    }
    out->name = "OSMesa";
    out->state = o;
    out->destroy = osmesa_destroy;
    return true;
}
