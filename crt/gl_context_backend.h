/* gl_context_backend.h — what gl_context.c and the two backends share; private to them.
 *
 * Ownership:  the libraries stay loaded until the process ends: Mesa starts threads and keeps
 *             static data that do not survive being unloaded, and a second context finds them
 *             ready.
 */
#ifndef CRT_GL_CONTEXT_BACKEND_H
#define CRT_GL_CONTEXT_BACKEND_H

#include "crt/error.h"
#include "crt/glass.h"

struct crt_gl_backend_state {
    const char *name;
    crt_gl_loader loader;
    void *state; /* the backend's own */
    void (*destroy)(void *state);
};

/* Create a context and make it current; on failure write a clause (no full stop) to err. */
bool crt_gl_open_osmesa(struct crt_gl_backend_state *out, struct crt_error *err);
bool crt_gl_open_egl(struct crt_gl_backend_state *out, struct crt_error *err);

/* Finds a function in a dlopened library; NULL when it has none. */
crt_gl_function crt_gl_symbol(void *library, const char *name);

#endif
