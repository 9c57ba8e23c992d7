/* gl_context.h — an offscreen GL 3.3 core context, from OSMesa or, where that is missing, from
 * EGL's surfaceless platform.
 *
 * Models:     nothing. Both libraries are loaded with dlopen, so the program starts without them.
 * Source:     the OSMesa and EGL 1.5 interfaces, EGL_MESA_platform_surfaceless.
 * Ownership:  create/destroy pair; one context may be current per thread.
 * Errors:     one sentence saying which libraries were tried and which package has them.
 */
#ifndef CRT_GL_CONTEXT_H
#define CRT_GL_CONTEXT_H

#include "crt/error.h"
#include "crt/glass.h"

enum crt_gl_backend { CRT_GL_ANY, CRT_GL_OSMESA, CRT_GL_EGL };

struct crt_gl_context;

/* Creates a context and makes it current. */
struct crt_gl_context *crt_gl_context_create(enum crt_gl_backend backend, struct crt_error *err);
void crt_gl_context_destroy(struct crt_gl_context *context);
crt_gl_loader crt_gl_context_loader(const struct crt_gl_context *context);
const char *crt_gl_context_name(const struct crt_gl_context *context); /* "OSMesa" or "EGL" */

#endif
