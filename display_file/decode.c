#include "display_file/decode.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "display_file/disasm.h"
#include "display_file/encode.h"

static const char *const modes[] = {"char",   "shortv", "longv",   "point",
                                    "graphx", "graphy", "relpoint"};

const char *df_mode_name(unsigned mode)
{
    assert(mode <= DF_MODE_RELPOINT);
    return modes[mode];
}

/* ---- text into a fixed buffer ---- */

struct out {
    char *text;
    size_t size, used;
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
add(struct out *out, const char *format, ...);

static void add(struct out *out, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    int length = vsnprintf(out->text + out->used, out->size - out->used, format, args);
    va_end(args);
    size_t rest = out->size - out->used;
    if (length > 0) {
        out->used += (size_t)length < rest ? (size_t)length : rest - (rest > 0);
    }
}

/* ---- control words: the text, or false when no statement says this word ---- */

static bool set_mode(uint16_t word, struct out *out)
{
    static const char *const lines[] = {"solid", "dash", "shortdash", "dotdash"};
    unsigned mode = word >> DF_MODE_SHIFT & 017;
    uint16_t exact = DF_SET_MODE | (uint16_t)(mode << DF_MODE_SHIFT);
    add(out, "%s", modes[mode]);
    if (word & DF_SGM_INTENSITY) {
        unsigned level = word >> DF_SGM_INTENSITY_SHIFT & 7;
        exact = (uint16_t)(exact | DF_SGM_INTENSITY | level << DF_SGM_INTENSITY_SHIFT);
        add(out, " i=%u", level);
    }
    if (word & DF_SGM_PEN) {
        exact = (uint16_t)(exact | DF_SGM_PEN | (word & DF_SGM_PEN_ON));
        add(out, " pen=%s", word & DF_SGM_PEN_ON ? "on" : "off");
    }
    if (word & DF_SGM_BLINK) {
        exact = (uint16_t)(exact | DF_SGM_BLINK | (word & DF_SGM_BLINK_ON));
        add(out, " blink=%s", word & DF_SGM_BLINK_ON ? "on" : "off");
    }
    if (word & DF_SGM_LINE) {
        exact = (uint16_t)(exact | DF_SGM_LINE | (word & 3));
        add(out, " line=%s", lines[word & 3]);
    }
    return exact == word;
}

static bool status_a(uint16_t word, struct out *out)
{
    uint16_t exact = DF_STATUS_A | (word & (DF_LSA_STOP | DF_LSA_SYNC));
    bool stop = word & DF_LSA_STOP, sync = word & DF_LSA_SYNC;
    add(out, "%s", stop ? "stop" : sync ? "sync" : "status");
    if (stop && sync) {
        add(out, " sync");
    }
    if (word & DF_LSA_STOP_INT) {
        exact |= DF_LSA_STOP_INT | (word & DF_LSA_STOP_INT_ON);
        add(out, " stopint=%s", word & DF_LSA_STOP_INT_ON ? "on" : "off");
    }
    if (word & DF_LSA_INTENSIFY) {
        exact |= DF_LSA_INTENSIFY | (word & DF_LSA_INTENSIFY_OFF);
        add(out, " penlight=%s", word & DF_LSA_INTENSIFY_OFF ? "off" : "on");
    }
    if (word & DF_LSA_ITALICS) {
        exact |= DF_LSA_ITALICS | (word & DF_LSA_ITALICS_ON);
        add(out, " italics=%s", word & DF_LSA_ITALICS_ON ? "on" : "off");
    }
    return exact == word;
}

static bool status_b(uint16_t word, struct out *out)
{
    static const char *const colours[] = {"green", "yellow", "orange", "red"};
    unsigned step = word & DF_LSB_VALUE;
    unsigned colour = (word & (unsigned)DF_LSB_COLOUR_BITS) >> DF_LSB_COLOUR_SHIFT;
    bool steps = word & DF_LSB_STEP, colours_too = word & DF_LSB_COLOUR;
    unsigned exact = DF_STATUS_B;
    if (colours_too) {
        add(out, "colour %s", colours[colour]);
        exact |= DF_LSB_COLOUR | colour << DF_LSB_COLOUR_SHIFT;
    }
    if (steps) {
        add(out, colours_too ? " step=%u" : "step %u", step);
        exact |= DF_LSB_STEP | step;
    }
    return exact == word && exact != DF_STATUS_B;
}

static bool control(uint16_t word, struct out *out)
{
    if (word < DF_SET_MODE + ((DF_MODE_RELPOINT + 1) << DF_MODE_SHIFT)) {
        return set_mode(word, out);
    }
    if (word == DF_NOP) {
        add(out, "nop");
        return true;
    }
    if (word >= DF_STATUS_B) {
        return status_b(word, out);
    }
    return word >= DF_STATUS_A && status_a(word, out);
}

/* ---- data words ---- */

static int32_t signed_delta(uint16_t word, uint16_t sign, uint16_t magnitude, unsigned shift)
{
    int32_t size = (word & magnitude) >> shift;
    return word & sign ? -size : size;
}

static bool short_data(uint16_t word, struct out *out)
{
    bool lit = word & DF_BEAM_ON;
    int32_t dx = signed_delta(word, DF_SIGN_X, DF_SHORT_DX, DF_SHORT_DX_SHIFT);
    int32_t dy = signed_delta(word, DF_SHORT_SIGN_Y, DF_SHORT_DY, 0);
    add(out, "%s %d, %d", lit ? "draw" : "move", (int)dx, (int)dy);
    return df_encode_short(lit, dx, dy) == word;
}

static bool long_data(const uint16_t *words, struct out *out)
{
    bool lit = words[0] & DF_BEAM_ON;
    int32_t dx = signed_delta(words[0], DF_SIGN_X, DF_LONG_DELTA, 0);
    int32_t dy = signed_delta(words[1], DF_SIGN_X, DF_LONG_DELTA, 0);
    add(out, "%s %d, %d", lit ? "draw" : "move", (int)dx, (int)dy);
    return df_encode_long_x(lit, dx) == words[0] && df_encode_long_y(dy) == words[1];
}

static bool point_data(const uint16_t *words, struct out *out)
{
    bool lit = words[0] & DF_BEAM_ON;
    int32_t x = words[0] & DF_LONG_DELTA, y = words[1] & DF_LONG_DELTA;
    add(out, "%s %d, %d", lit ? "plot" : "at", (int)x, (int)y);
    return df_encode_point_x(lit, x) == words[0] && df_encode_point_y(y) == words[1];
}

static uint32_t value_data(const uint16_t *words, uint32_t count, struct out *out)
{
    uint32_t used = 0;
    while (used < count && words[used] <= DF_POINT_MAX) {
        add(out, "%s%u", used == 0 ? "value " : ", ", (unsigned)words[used]);
        used++;
    }
    return used;
}

static void add_character(struct out *out, unsigned code)
{
    if (code == '"' || code == '\\') {
        add(out, "\\%c", (int)code);
    } else if (code >= ' ' && code <= '~') {
        add(out, "%c", (int)code);
    } else if (code == '\r' || code == '\n') {
        add(out, "\\%c", code == '\r' ? 'r' : 'n');
    } else {
        add(out, "\\x%02x", code);
    }
}

/* A string ends after a line feed, and where its last word is padded with NUL. */
static uint32_t text_data(const uint16_t *words, uint32_t count, struct out *out)
{
    uint32_t used = 0;
    bool ended = false;
    while (used < count && !ended && (words[used] & 0100200) == 0) {
        unsigned low = words[used] & 0177, high = words[used] >> 8;
        add(out, "%s", used == 0 ? "text \"" : "");
        add_character(out, low);
        ended = high == 0 || high == '\n';
        if (high != 0) {
            add_character(out, high);
        }
        used++;
    }
    if (used > 0) {
        add(out, "\"");
    }
    return used;
}

/* How many words a data statement takes; 0: none says them. */
static uint32_t data(const uint16_t *words, uint32_t count, unsigned mode, struct out *out)
{
    bool pair = count >= 2 && !(words[1] & DF_CONTROL);
    switch (mode) {
    case DF_MODE_CHAR:
        return text_data(words, count, out);
    case DF_MODE_SHORT:
    case DF_MODE_RELPOINT:
        return short_data(words[0], out) ? 1 : 0;
    case DF_MODE_LONG:
        return pair && long_data(words, out) ? 2 : 0;
    case DF_MODE_POINT:
        return pair && point_data(words, out) ? 2 : 0;
    case DF_MODE_GRAPHX:
    case DF_MODE_GRAPHY:
        return value_data(words, count, out);
    default:
        return 0;
    }
}

struct df_decoded df_decode(const uint16_t *words, uint32_t count, unsigned mode, char *text,
                            size_t size)
{
    struct out out = {text, size, 0};
    uint16_t word = words[0];
    struct df_decoded decoded = {.words = 1};
    bool said;
    if (word == DF_JUMP && count >= 2 && words[1] % 2 == 0) {
        add(&out, "jump ");
        decoded.words = 2;
        decoded.jump = true;
        return decoded;
    }
    if (word & DF_CONTROL) {
        said = control(word, &out);
        decoded.mode = word >> DF_MODE_SHIFT & 017;
        decoded.sets_mode = decoded.mode <= DF_MODE_RELPOINT;
    } else {
        uint32_t used = data(words, count, mode, &out);
        said = used > 0;
        decoded.words = said ? used : 1;
    }
    if (!said) {
        out.used = 0;
        add(&out, ".word 0o%06o", (unsigned)word);
        decoded.raw = true;
    }
    return decoded;
}

/* ---- one word on its own ---- */

static void lone_datum(uint16_t word, unsigned mode, struct out *out)
{
    const char *lit = word & DF_BEAM_ON ? ", lit" : "";
    if (mode == DF_MODE_LONG) {
        int32_t delta = signed_delta(word, DF_SIGN_X, DF_LONG_DELTA, 0);
        add(out, "delta %d%s", (int)delta, lit);
    } else {
        add(out, "coordinate %u%s", (unsigned)(word & DF_LONG_DELTA), lit);
    }
}

void df_disassemble_word(uint16_t word, unsigned mode, char *text, unsigned long size)
{
    struct out out = {text, size, 0};
    if (size == 0) {
        return;
    }
    text[0] = 0;
    if (!(word & DF_CONTROL) && (mode == DF_MODE_LONG || mode == DF_MODE_POINT)) {
        lone_datum(word, mode, &out);
    } else if (word >= DF_JUMP && word < DF_NOP) {
        add(&out, "jump");
    } else if (word >= DF_NOP && word < DF_STATUS_A) {
        add(&out, "nop");
    } else {
        df_decode(&word, 1, mode, text, size);
    }
}
