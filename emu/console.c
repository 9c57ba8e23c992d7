#include "emu/console.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

void vm_console_init(struct vm_console *c, const struct vm_console_desc *desc)
{
    memset(c, 0, sizeof *c);
    c->desc = *desc;
}

void vm_console_free(struct vm_console *c)
{
    free(c->queue);
    c->queue = NULL;
    c->count = c->room = c->next = 0;
}

/* ---- typed --------------------------------------------------------------------------------------
 */

static bool make_room(struct vm_console *c, size_t more)
{
    size_t room = c->room ? c->room : 256;
    if (more > SIZE_MAX / sizeof *c->queue / 4 - c->count)
        return false;
    while (room < c->count + more)
        room *= 2;
    if (room == c->room)
        return true;
    struct vm_typed *queue = realloc(c->queue, room * sizeof *queue);
    if (!queue)
        return false;
    c->queue = queue;
    c->room = room;
    return true;
}

bool vm_console_type(struct vm_console *c, const char *bytes, size_t length, uint64_t t)
{
    while (c->count > c->next && c->queue[c->count - 1].not_before > t)
        c->count--;
    if (!make_room(c, length))
        return false;
    for (size_t i = 0; i < length; i++)
        c->queue[c->count++] = (struct vm_typed){(uint8_t)bytes[i], t};
    return true;
}

bool vm_console_key(struct vm_console *c, const char *bytes, size_t length)
{
    if (c->keyed_count + length > VM_CONSOLE_KEYED)
        return false;
    for (size_t i = 0; i < length; i++)
        c->keyed[(c->keyed_first + c->keyed_count++) % VM_CONSOLE_KEYED] = (uint8_t)bytes[i];
    return true;
}

void vm_console_close(struct vm_console *c)
{
    c->ends = true;
}

uint64_t vm_console_next(const struct vm_console *c, uint64_t ready)
{
    if (c->keyed_count > 0)
        return ready;
    if (c->next < c->count) {
        uint64_t typed = c->queue[c->next].not_before;
        return typed > ready ? typed : ready;
    }
    if (c->desc.source && !c->exhausted) {
        uint64_t quiet = c->last + VM_CONSOLE_QUIET_PS;
        return c->in_line || quiet < ready ? ready : quiet;
    }
    return c->ends && !c->ended ? ready : UINT64_MAX;
}

bool vm_console_empty(const struct vm_console *c)
{
    return c->keyed_count == 0 && c->next == c->count;
}

int vm_console_take(struct vm_console *c, uint64_t t)
{
    if (c->keyed_count > 0) {
        uint8_t byte = c->keyed[c->keyed_first];
        c->keyed_first = (c->keyed_first + 1) % VM_CONSOLE_KEYED;
        c->keyed_count--;
        return byte;
    }
    if (c->next == c->count && c->desc.source && !c->exhausted) {
        int byte = c->desc.source(c->desc.ctx);
        if (byte < 0)
            c->exhausted = c->ends = true;
        else if (!vm_console_type(c, &(char){(char)byte}, 1, t))
            return byte; /* no memory to remember it: deliver it all the same */
    }
    if (c->next < c->count) {
        uint8_t byte = c->queue[c->next++].byte;
        c->in_line = byte != '\n' && byte != '\r';
        return byte;
    }
    if (c->ends && !c->ended) {
        c->ended = true;
        return VM_CONSOLE_EOT;
    }
    return -1;
}

/* ---- printed ------------------------------------------------------------------------------------
 */

void vm_console_watch(struct vm_console *c, const char *text)
{
    size_t length = strlen(text), k = 0;
    assert(length >= 1 && length < VM_CONSOLE_WATCH_MAX);
    memcpy(c->watch, text, length + 1);
    c->watch_length = length;
    c->matched = 0;
    c->found = false;
    c->border[0] = 0;
    for (size_t i = 1; i < length; i++) {
        while (k > 0 && text[i] != text[k])
            k = c->border[k - 1];
        k += text[i] == text[k];
        c->border[i] = (uint8_t)k;
    }
}

static void look(struct vm_console *c, char byte)
{
    while (c->matched > 0 && byte != c->watch[c->matched])
        c->matched = c->border[c->matched - 1];
    c->matched += byte == c->watch[c->matched];
    if (c->matched == c->watch_length) {
        c->found = true;
        c->matched = c->border[c->matched - 1];
    }
}

void vm_console_print(struct vm_console *c, uint8_t byte, uint64_t t)
{
    if (c->watch_length)
        look(c, (char)byte);
    c->last = t;
    if (++c->sent <= c->shown)
        return;
    c->shown = c->sent;
    if (c->desc.sink)
        c->desc.sink(c->desc.ctx, byte, t);
}

/* The ring from its first byte on. */
static void keyed_state(struct vm_console *c, struct crt_state *s)
{
    uint8_t bytes[VM_CONSOLE_KEYED];
    for (unsigned i = 0; i < c->keyed_count && !s->loading; i++)
        bytes[i] = c->keyed[(c->keyed_first + i) % VM_CONSOLE_KEYED];
    crt_state_unsigned(s, &c->keyed_count, VM_CONSOLE_KEYED);
    crt_state_bytes(s, bytes, s->failed ? 0 : c->keyed_count);
    if (!s->loading)
        return;
    c->keyed_first = 0;
    c->keyed_count = s->failed ? 0 : c->keyed_count;
    memcpy(c->keyed, bytes, c->keyed_count);
}

void vm_console_state(struct vm_console *c, struct crt_state *s)
{
    crt_state_begin(s, "CONS", 2);
    size_t next = c->next;
    crt_state_size(s, &next, SIZE_MAX);
    crt_state_bool(s, &c->ended);
    crt_state_u64(s, &c->sent);
    crt_state_u64(s, &c->last);
    crt_state_bool(s, &c->in_line);
    keyed_state(c, s);
    crt_state_check(s, c->last < CRT_STATE_LATEST, "time of the console");
    crt_state_end(s);
    if (!s->loading || s->failed)
        return;
    /* Another run may have been typed less: it goes on with what it has. */
    c->next = next < c->count ? next : c->count;
    if (c->sent > c->shown)
        c->shown = c->sent;
    c->matched = 0;
}
