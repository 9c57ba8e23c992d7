/* glass_part.c — the glass in a part of a window: drawn aside, then copied there; and the text that goes
 * over all parts. */
#include "crt/glass_private.h"

void crt_glass_draw_part(struct crt_glass *glass, const struct crt_glass_settings *settings,
                         unsigned fbo, const struct crt_glass_part *part)
{
    const struct crt_gl *gl = &glass->gl;
    const struct crt_glass_tile tile = {0, 0, part->w, part->h, part->w, part->h, false, true};
    unsigned aside = 0;
    if (part->w < 1 || part->h < 1 || part->w > glass->max_side || part->h > glass->max_side)
        return;
    crt_glass_texture_resize(glass, &glass->target, GL_RGBA8, part->w, part->h, GL_NEAREST);
    gl->GenFramebuffers(1, &aside);
    gl->BindFramebuffer(GL_FRAMEBUFFER, aside);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                             glass->target.name, 0);
    crt_glass_draw_tile(glass, settings, aside, &tile);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, aside);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, fbo);
    int bottom = part->win_h - part->y - part->h; /* GL's rows start at the bottom */
    gl->BlitFramebuffer(0, 0, part->w, part->h, part->x, bottom, part->x + part->w,
                        bottom + part->h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, fbo);
    gl->DeleteFramebuffers(1, &aside);
}

void crt_glass_clear(struct crt_glass *glass, unsigned fbo, int width, int height)
{
    const struct crt_gl *gl = &glass->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, fbo);
    gl->Viewport(0, 0, width, height);
    gl->ClearColor(0, 0, 0, 1);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

void crt_glass_draw_overlay(struct crt_glass *glass, unsigned fbo, int width, int height)
{
    const struct crt_glass_tile whole = {0, 0, width, height, width, height, false, false};
    const struct crt_gl *gl = &glass->gl;
    gl->BindVertexArray(glass->vertex_array);
    gl->BindFramebuffer(GL_FRAMEBUFFER, fbo);
    gl->Viewport(0, 0, width, height);
    crt_glass_draw_text(glass, &whole);
    gl->Disable(GL_SCISSOR_TEST);
}
