/* gl_api.h — the part of OpenGL 3.3 core that the glass draws with, and its loader.
 *
 * Models:     nothing. Every function comes from the caller's loader (glfwGetProcAddress,
 *             OSMesaGetProcAddress, eglGetProcAddress), so nothing links with a GL library and no
 *             GL header is needed to build.
 * Source:     names, values and signatures after the OpenGL 3.3 core profile specification.
 * Ownership:  struct crt_gl is a plain table of functions, valid while its context lives.
 * Errors:     a missing function is named.
 */
#ifndef CRT_GL_API_H
#define CRT_GL_API_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/error.h"
#include "crt/glass.h"

enum {
    GL_NO_ERROR = 0,
    GL_FALSE = 0,
    GL_TRUE = 1,
    GL_TRIANGLES = 0x0004,
    GL_COLOR_BUFFER_BIT = 0x4000,
    GL_SRC_ALPHA = 0x0302,
    GL_ONE_MINUS_SRC_ALPHA = 0x0303,
    GL_ONE = 1,
    GL_OUT_OF_MEMORY = 0x0505,
    GL_DITHER = 0x0BD0,
    GL_BLEND = 0x0BE2,
    GL_SCISSOR_TEST = 0x0C11,
    GL_DEPTH_TEST = 0x0B71,
    GL_UNPACK_ROW_LENGTH = 0x0CF2,
    GL_UNPACK_SKIP_ROWS = 0x0CF3,
    GL_UNPACK_SKIP_PIXELS = 0x0CF4,
    GL_UNPACK_ALIGNMENT = 0x0CF5,
    GL_PACK_ALIGNMENT = 0x0D05,
    GL_MAX_TEXTURE_SIZE = 0x0D33,
    GL_TEXTURE_2D = 0x0DE1,
    GL_UNSIGNED_BYTE = 0x1401,
    GL_UNSIGNED_SHORT = 0x1403,
    GL_FLOAT = 0x1406,
    GL_RED = 0x1903,
    GL_RGB = 0x1907,
    GL_RGBA = 0x1908,
    GL_RG = 0x8227,
    GL_RENDERER = 0x1F01,
    GL_VERSION = 0x1F02,
    GL_NEAREST = 0x2600,
    GL_LINEAR = 0x2601,
    GL_TEXTURE_MAG_FILTER = 0x2800,
    GL_TEXTURE_MIN_FILTER = 0x2801,
    GL_TEXTURE_WRAP_S = 0x2802,
    GL_TEXTURE_WRAP_T = 0x2803,
    GL_RGBA8 = 0x8058,
    GL_RGBA16 = 0x805B,
    GL_RGBA32F = 0x8814,
    GL_REPEAT = 0x2901,
    GL_CLAMP_TO_EDGE = 0x812F,
    GL_R32F = 0x822E,
    GL_RG32F = 0x8230,
    GL_TEXTURE0 = 0x84C0,
    GL_ARRAY_BUFFER = 0x8892,
    GL_STREAM_DRAW = 0x88E0,
    GL_FRAGMENT_SHADER = 0x8B30,
    GL_VERTEX_SHADER = 0x8B31,
    GL_COMPILE_STATUS = 0x8B81,
    GL_LINK_STATUS = 0x8B82,
    GL_FRAMEBUFFER = 0x8D40,
    GL_READ_FRAMEBUFFER = 0x8CA8,
    GL_DRAW_FRAMEBUFFER = 0x8CA9,
    GL_COLOR_ATTACHMENT0 = 0x8CE0,
    GL_FRAMEBUFFER_COMPLETE = 0x8CD5
};

/* X(return type, name, parameters) */
#define CRT_GL_FUNCTIONS(X)                                                                        \
    X(const unsigned char *, GetString, (unsigned name))                                           \
    X(void, GetIntegerv, (unsigned name, int *value))                                              \
    X(unsigned, GetError, (void))                                                                  \
    X(void, Finish, (void))                                                                        \
    X(void, Enable, (unsigned capability))                                                         \
    X(void, Disable, (unsigned capability))                                                        \
    X(void, BlendFuncSeparate, (unsigned src, unsigned dst, unsigned src_a, unsigned dst_a))       \
    X(void, Viewport, (int x, int y, int w, int h))                                                \
    X(void, Scissor, (int x, int y, int w, int h))                                                 \
    X(void, ClearColor, (float r, float g, float b, float a))                                      \
    X(void, Clear, (unsigned buffers))                                                             \
    X(void, PixelStorei, (unsigned name, int value))                                               \
    X(void, ReadPixels, (int x, int y, int w, int h, unsigned format, unsigned type, void *data))  \
    X(void, DrawArrays, (unsigned mode, int first, int count))                                     \
    X(void, GenTextures, (int n, unsigned *names))                                                 \
    X(void, DeleteTextures, (int n, const unsigned *names))                                        \
    X(void, ActiveTexture, (unsigned unit))                                                        \
    X(void, BindTexture, (unsigned target, unsigned name))                                         \
    X(void, TexParameteri, (unsigned target, unsigned name, int value))                            \
    X(void, TexImage2D,                                                                            \
      (unsigned target, int level, int internal, int w, int h, int border, unsigned format,        \
       unsigned type, const void *data))                                                           \
    X(void, TexSubImage2D,                                                                         \
      (unsigned target, int level, int x, int y, int w, int h, unsigned format, unsigned type,     \
       const void *data))                                                                          \
    X(unsigned, CreateShader, (unsigned type))                                                     \
    X(void, DeleteShader, (unsigned shader))                                                       \
    X(void, ShaderSource,                                                                          \
      (unsigned shader, int count, const char *const *strings, const int *lengths))                \
    X(void, CompileShader, (unsigned shader))                                                      \
    X(void, GetShaderiv, (unsigned shader, unsigned name, int *value))                             \
    X(void, GetShaderInfoLog, (unsigned shader, int size, int *length, char *log))                 \
    X(unsigned, CreateProgram, (void))                                                             \
    X(void, DeleteProgram, (unsigned program))                                                     \
    X(void, AttachShader, (unsigned program, unsigned shader))                                     \
    X(void, LinkProgram, (unsigned program))                                                       \
    X(void, GetProgramiv, (unsigned program, unsigned name, int *value))                           \
    X(void, GetProgramInfoLog, (unsigned program, int size, int *length, char *log))               \
    X(void, UseProgram, (unsigned program))                                                        \
    X(int, GetUniformLocation, (unsigned program, const char *name))                               \
    X(void, Uniform1i, (int location, int x))                                                      \
    X(void, Uniform1f, (int location, float x))                                                    \
    X(void, Uniform1fv, (int location, int count, const float *v))                                 \
    X(void, Uniform2i, (int location, int x, int y))                                               \
    X(void, Uniform2f, (int location, float x, float y))                                           \
    X(void, Uniform3f, (int location, float x, float y, float z))                                  \
    X(void, Uniform4i, (int location, int x, int y, int z, int w))                                 \
    X(void, GenBuffers, (int n, unsigned *names))                                                  \
    X(void, DeleteBuffers, (int n, const unsigned *names))                                         \
    X(void, BindBuffer, (unsigned target, unsigned name))                                          \
    X(void, BufferData, (unsigned target, ptrdiff_t size, const void *data, unsigned usage))       \
    X(void, EnableVertexAttribArray, (unsigned index))                                             \
    X(void, VertexAttribPointer,                                                                   \
      (unsigned index, int size, unsigned type, unsigned char normalised, int stride,              \
       const void *offset))                                                                        \
    X(void, GenVertexArrays, (int n, unsigned *names))                                             \
    X(void, DeleteVertexArrays, (int n, const unsigned *names))                                    \
    X(void, BindVertexArray, (unsigned name))                                                      \
    X(void, GenFramebuffers, (int n, unsigned *names))                                             \
    X(void, DeleteFramebuffers, (int n, const unsigned *names))                                    \
    X(void, BindFramebuffer, (unsigned target, unsigned name))                                     \
    X(void, FramebufferTexture2D,                                                                  \
      (unsigned target, unsigned attachment, unsigned kind, unsigned texture, int level))          \
    X(void, BlitFramebuffer,                                                                       \
      (int sx0, int sy0, int sx1, int sy1, int dx0, int dy0, int dx1, int dy1, unsigned buffers,   \
       unsigned filter))                                                                           \
    X(unsigned, CheckFramebufferStatus, (unsigned target))

struct crt_gl {
#define X(type, name, parameters) type(*name) parameters;
    CRT_GL_FUNCTIONS(X)
#undef X
};

bool crt_gl_load(struct crt_gl *gl, crt_gl_loader loader, struct crt_error *err);

/* Compiles `prefix` (the #version line and #defines) followed by the vertex source, or by the
 * pieces of the fragment source (NULL ends them); 0 and a sentence that carries the driver's first
 * lines when it fails. */
unsigned crt_gl_program(const struct crt_gl *gl, const char *prefix, const char *const *vertex,
                        const char *const *fragment, struct crt_error *err);

#endif
