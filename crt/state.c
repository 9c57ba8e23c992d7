#include "crt/state.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#define PAGE    4096u
#define NO_PAGE UINT32_MAX /* ends the list of pages */

/* ---- beginning and end ------------------------------------------------------------------------ */

void crt_state_save(struct crt_state *s)
{
    *s = (struct crt_state){.loading = false};
}

void crt_state_load(struct crt_state *s, const uint8_t *bytes, size_t size)
{
    *s = (struct crt_state){.loading = true, .in = bytes, .in_size = size};
}

void crt_state_free(struct crt_state *s)
{
    free(s->out);
    *s = (struct crt_state){.loading = false};
}

/* ---- bytes ------------------------------------------------------------------------------------ */

void crt_state_fail(struct crt_state *s, const char *sentence)
{
    if (!s->failed)
        crt_fail(&s->err, "%s", sentence);
    s->failed = true;
}

/* Room for `size` more bytes; NULL after an error. */
static uint8_t *add(struct crt_state *s, size_t size)
{
    if (s->failed)
        return NULL;
    if (size > s->room - s->size) {
        size_t room = s->room ? s->room : PAGE;
        while (room - s->size < size && room <= SIZE_MAX / 2)
            room *= 2;
        uint8_t *out = room - s->size < size ? NULL : realloc(s->out, room);
        if (!out) {
            crt_state_fail(s, "not enough memory for a snapshot; close other programs");
            return NULL;
        }
        s->out = out;
        s->room = room;
    }
    s->size += size;
    return s->out + (s->size - size);
}

/* The next `size` bytes of the open section; NULL after an error. */
static const uint8_t *take(struct crt_state *s, size_t size)
{
    size_t end = s->open ? s->section : s->in_size;
    if (!s->failed && size > end - s->at)
        crt_state_fail(s, "the snapshot ends too early");
    if (s->failed)
        return NULL;
    s->at += size;
    return s->in + (s->at - size);
}

void crt_state_bytes(struct crt_state *s, void *bytes, size_t size)
{
    if (size == 0)
        return;
    if (s->loading) {
        const uint8_t *from = take(s, size);
        if (from)
            memcpy(bytes, from, size);
        else
            memset(bytes, 0, size);
    } else {
        uint8_t *to = add(s, size);
        if (to)
            memcpy(to, bytes, size);
    }
}

/* ---- numbers ---------------------------------------------------------------------------------- */

static void put(uint8_t *to, uint64_t v, size_t size)
{
    for (size_t i = 0; i < size; i++)
        to[i] = (uint8_t)(v >> 8 * i);
}

static uint64_t got(const uint8_t *from, size_t size)
{
    uint64_t v = 0;
    for (size_t i = 0; i < size; i++)
        v |= (uint64_t)from[i] << 8 * i;
    return v;
}

/* The value saved, or the one loaded. */
static uint64_t number(struct crt_state *s, uint64_t v, size_t size)
{
    if (s->loading) {
        const uint8_t *from = take(s, size);
        return from ? got(from, size) : 0;
    }
    uint8_t *to = add(s, size);
    if (to)
        put(to, v, size);
    return v;
}

void crt_state_u8(struct crt_state *s, uint8_t *v)
{
    *v = (uint8_t)number(s, *v, 1);
}

void crt_state_u16(struct crt_state *s, uint16_t *v)
{
    *v = (uint16_t)number(s, *v, 2);
}

void crt_state_u32(struct crt_state *s, uint32_t *v)
{
    *v = (uint32_t)number(s, *v, 4);
}

void crt_state_u64(struct crt_state *s, uint64_t *v)
{
    *v = number(s, *v, 8);
}

void crt_state_bool(struct crt_state *s, bool *v)
{
    uint8_t bits = *v;
    crt_state_u8(s, &bits);
    if (!crt_state_check(s, bits <= 1, "flag"))
        bits = 0;
    *v = bits != 0;
}

void crt_state_i32(struct crt_state *s, int32_t *v)
{
    uint32_t bits;
    memcpy(&bits, v, sizeof bits);
    crt_state_u32(s, &bits);
    memcpy(v, &bits, sizeof bits);
}

void crt_state_f32(struct crt_state *s, float *v)
{
    uint32_t bits;
    memcpy(&bits, v, sizeof bits);
    crt_state_u32(s, &bits);
    memcpy(v, &bits, sizeof bits);
}

void crt_state_f64(struct crt_state *s, double *v)
{
    uint64_t bits;
    memcpy(&bits, v, sizeof bits);
    crt_state_u64(s, &bits);
    memcpy(v, &bits, sizeof bits);
}

static void save_floats(struct crt_state *s, const float *v, size_t count)
{
    uint8_t *to = add(s, 4 * count);
    for (size_t i = 0; to && i < count; i++, to += 4) {
        uint32_t bits;
        memcpy(&bits, &v[i], sizeof bits);
        to[0] = (uint8_t)bits; /* spelt out, compilers make one store of it */
        to[1] = (uint8_t)(bits >> 8);
        to[2] = (uint8_t)(bits >> 16);
        to[3] = (uint8_t)(bits >> 24);
    }
}

static void load_floats(struct crt_state *s, float *v, size_t count)
{
    const uint8_t *from = take(s, 4 * count);
    for (size_t i = 0; i < count; i++) {
        const uint8_t *b = from ? from + 4 * i : (const uint8_t[4]){0};
        uint32_t bits = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
        memcpy(&v[i], &bits, sizeof bits);
    }
}

void crt_state_f32s(struct crt_state *s, float *v, size_t count)
{
    if (s->loading)
        load_floats(s, v, count);
    else
        save_floats(s, v, count);
}

void crt_state_size(struct crt_state *s, size_t *v, size_t most)
{
    uint64_t n = number(s, *v, 8);
    if (!crt_state_check(s, n <= most, "count"))
        n = 0;
    *v = (size_t)n;
}

void crt_state_unsigned(struct crt_state *s, unsigned *v, unsigned most)
{
    uint64_t n = number(s, *v, 4);
    if (!crt_state_check(s, n <= most, "number"))
        n = 0;
    *v = (unsigned)n;
}

/* ---- memory that is mostly 0 ------------------------------------------------------------------ */

/* Bytes, or 16-bit words seen as bytes. */
struct memory {
    uint8_t *bytes;
    uint16_t *words; /* when bytes is NULL */
    size_t size;     /* bytes */
};

static size_t page_size(const struct memory *m, size_t at)
{
    return m->size - at < PAGE ? m->size - at : PAGE;
}

static bool all_zero(const void *memory, size_t size)
{
    const uint8_t *bytes = memory;
    return bytes[0] == 0 && memcmp(bytes, bytes + 1, size - 1) == 0;
}

static bool is_dark(const struct memory *m, size_t at)
{
    return all_zero(m->bytes ? m->bytes + at : (const void *)(m->words + at / 2), page_size(m, at));
}

/* The page at `at`, in `room` where it has to be made of words. */
static uint8_t *page_of(const struct memory *m, size_t at, uint8_t room[PAGE])
{
    if (m->bytes)
        return m->bytes + at;
    for (size_t i = 0; i < page_size(m, at); i += 2)
        put(room + i, m->words[(at + i) / 2], 2);
    return room;
}

static void save_pages(struct crt_state *s, const struct memory *m)
{
    uint8_t room[PAGE];
    uint32_t end = NO_PAGE;
    for (size_t at = 0; at < m->size; at += PAGE) {
        uint32_t index = (uint32_t)(at / PAGE);
        if (is_dark(m, at))
            continue;
        crt_state_u32(s, &index);
        crt_state_bytes(s, page_of(m, at, room), page_size(m, at));
    }
    crt_state_u32(s, &end);
}

/* What is dark already is not written: the host need not provide memory for it. */
static void darken(const struct memory *m, size_t from, size_t to)
{
    for (size_t at = from; at < to && at < m->size; at += PAGE)
        if (!is_dark(m, at))
            memset(m->bytes ? (void *)(m->bytes + at) : m->words + at / 2, 0, page_size(m, at));
}

static void load_page(struct crt_state *s, const struct memory *m, size_t at)
{
    size_t size = page_size(m, at);
    const uint8_t *from = take(s, size);
    if (from && m->bytes)
        memcpy(m->bytes + at, from, size);
    for (size_t i = 0; from && !m->bytes && i < size; i += 2)
        m->words[(at + i) / 2] = (uint16_t)got(from + i, 2);
}

/* Pages come in order, each once. */
static void load_pages(struct crt_state *s, const struct memory *m)
{
    size_t after = 0;
    for (uint32_t index = 0; !s->failed;) {
        crt_state_u32(s, &index);
        if (s->failed || index == NO_PAGE)
            break;
        size_t at = (size_t)index * PAGE;
        if (!crt_state_check(s, at >= after && at < m->size, "memory"))
            break;
        darken(m, after, at);
        load_page(s, m, at);
        after = at + PAGE;
    }
    darken(m, after, m->size);
}

static void all_pages(struct crt_state *s, const struct memory *m)
{
    assert(m->size / PAGE < NO_PAGE);
    if (s->loading)
        load_pages(s, m);
    else
        save_pages(s, m);
}

void crt_state_pages(struct crt_state *s, uint8_t *bytes, size_t size)
{
    all_pages(s, &(struct memory){bytes, NULL, size});
}

void crt_state_word_pages(struct crt_state *s, uint16_t *words, size_t count)
{
    all_pages(s, &(struct memory){NULL, words, 2 * count});
}

/* ---- sections --------------------------------------------------------------------------------- */

#define HEADER 16u /* tag, version, length */

/* Up to the section's first byte; gives its version. */
static uint32_t open_section(struct crt_state *s)
{
    char tag[4];
    uint32_t version = 0;
    uint64_t length = 0;
    crt_state_bytes(s, tag, sizeof tag);
    crt_state_u32(s, &version);
    crt_state_u64(s, &length);
    if (s->failed)
        return 0;
    if (memcmp(tag, s->tag, sizeof tag) != 0) {
        crt_fail(&s->err, "the snapshot has no part %s where it should be", s->tag);
        s->failed = true;
    } else if (length > s->in_size - s->at) {
        crt_state_fail(s, "the snapshot ends too early");
    } else {
        s->section = s->at + (size_t)length;
        s->open = true;
    }
    return version;
}

static void begin_loading(struct crt_state *s, uint32_t version)
{
    uint32_t found = open_section(s);
    if (s->failed || found == version)
        return;
    crt_fail(&s->err, "the snapshot's part %s is of version %lu; this program has version %lu",
             s->tag, (unsigned long)found, (unsigned long)version);
    s->failed = true;
}

void crt_state_begin(struct crt_state *s, const char *tag, uint32_t version)
{
    assert(!s->open && strlen(tag) == 4);
    if (s->failed)
        return;
    memcpy(s->tag, tag, sizeof s->tag);
    if (s->loading) {
        begin_loading(s, version);
        return;
    }
    uint8_t *header = add(s, HEADER);
    if (!header)
        return;
    memcpy(header, tag, 4);
    put(header + 4, version, 4);
    s->section = s->size - 8;
    s->open = true;
}

void crt_state_end(struct crt_state *s)
{
    if (!s->failed && s->loading && s->at != s->section) {
        crt_fail(&s->err, "the snapshot's part %s is longer than it should be", s->tag);
        s->failed = true;
    }
    if (!s->failed && !s->loading)
        put(s->out + s->section, s->size - s->section - 8, 8);
    s->open = false;
}

void crt_state_skip(struct crt_state *s, const char *tag)
{
    assert(s->loading && !s->open && strlen(tag) == 4);
    if (s->failed)
        return;
    memcpy(s->tag, tag, sizeof s->tag);
    (void)open_section(s);
    if (!s->failed)
        s->at = s->section;
    s->open = false;
}

bool crt_state_check(struct crt_state *s, bool ok, const char *what)
{
    if (!ok && !s->failed) {
        crt_fail(&s->err, "the snapshot's %s is impossible", what);
        s->failed = true;
    }
    return !s->failed;
}
