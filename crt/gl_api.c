#include "crt/gl_api.h"

#include <assert.h>
#include <string.h>

#define PIECES_MAX 12

bool crt_gl_load(struct crt_gl *gl, crt_gl_loader loader, struct crt_error *err)
{
    crt_gl_function f;
#define X(type, name, parameters)                                                                  \
    f = loader("gl" #name);                                                                        \
    if (!f)                                                                                        \
        return crt_fail(err, "the GL driver has no gl" #name                                       \
                             "; OpenGL 3.3 core is needed (package libgl1-mesa-dri has it)");      \
    gl->name = (type(*) parameters)f;
    CRT_GL_FUNCTIONS(X)
#undef X
    return true;
}

/* Driver logs end in newlines and may be long; the sentence takes the first line. */
static void first_line(char *text)
{
    text[strcspn(text, "\r\n")] = '\0';
}

static unsigned compile(const struct crt_gl *gl, unsigned type, const char *prefix,
                        const char *const *source, struct crt_error *err)
{
    const char *parts[PIECES_MAX + 1] = {prefix};
    int count = 1;
    for (; source[count - 1]; count++) {
        assert(count <= PIECES_MAX);
        parts[count] = source[count - 1];
    }
    unsigned shader = gl->CreateShader(type);
    gl->ShaderSource(shader, count, parts, NULL);
    gl->CompileShader(shader);
    int good = 0;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good)
        return shader;
    char log[300] = "";
    gl->GetShaderInfoLog(shader, (int)sizeof log, NULL, log);
    first_line(log);
    crt_fail(err, "the GL driver (%s) does not compile the %s shader: %s",
             (const char *)gl->GetString(GL_VERSION),
             type == GL_VERTEX_SHADER ? "vertex" : "fragment", log);
    gl->DeleteShader(shader);
    return 0;
}

unsigned crt_gl_program(const struct crt_gl *gl, const char *prefix, const char *const *vertex,
                        const char *const *fragment, struct crt_error *err)
{
    unsigned v = compile(gl, GL_VERTEX_SHADER, prefix, vertex, err);
    if (!v)
        return 0;
    unsigned f = compile(gl, GL_FRAGMENT_SHADER, prefix, fragment, err);
    if (!f) {
        gl->DeleteShader(v);
        return 0;
    }
    unsigned program = gl->CreateProgram();
    gl->AttachShader(program, v);
    gl->AttachShader(program, f);
    gl->LinkProgram(program);
    gl->DeleteShader(v);
    gl->DeleteShader(f);
    int good = 0;
    gl->GetProgramiv(program, GL_LINK_STATUS, &good);
    if (good)
        return program;
    char log[300] = "";
    gl->GetProgramInfoLog(program, (int)sizeof log, NULL, log);
    first_line(log);
    crt_fail(err, "the GL driver (%s) does not link the glass: %s",
             (const char *)gl->GetString(GL_VERSION), log);
    gl->DeleteProgram(program);
    return 0;
}
