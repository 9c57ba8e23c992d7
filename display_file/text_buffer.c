#include "display_file/text_buffer.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool reserve(struct df_text *text, size_t more)
{
    if (text->failed) {
        return false;
    }
    if (more >= text->capacity - text->length || text->bytes == NULL) {
        size_t capacity = (text->length + more + 1) * 2;
        char *bytes = realloc(text->bytes, capacity);
        if (bytes == NULL) {
            text->failed = true;
            return false;
        }
        text->bytes = bytes;
        text->capacity = capacity;
    }
    return true;
}

void df_text_bytes(struct df_text *text, const char *bytes, size_t length)
{
    if (!reserve(text, length)) {
        return;
    }
    memcpy(text->bytes + text->length, bytes, length);
    text->length += length;
    text->bytes[text->length] = 0;
}

void df_text_add(struct df_text *text, const char *format, ...)
{
    char small[256];
    va_list args;
    va_start(args, format);
    int length = vsnprintf(small, sizeof small, format, args);
    va_end(args);
    if (length < 0) {
        text->failed = true;
        return;
    }
    if ((size_t)length < sizeof small) {
        df_text_bytes(text, small, (size_t)length);
        return;
    }
    if (!reserve(text, (size_t)length)) {
        return;
    }
    va_start(args, format);
    vsnprintf(text->bytes + text->length, (size_t)length + 1, format, args);
    va_end(args);
    text->length += (size_t)length;
}

void df_text_column(struct df_text *text, size_t column)
{
    size_t start = text->length;
    while (start > 0 && text->bytes[start - 1] != '\n') {
        start--;
    }
    size_t at = text->length - start;
    do {
        df_text_bytes(text, " ", 1);
        at++;
    } while (at < column && !text->failed);
}

char *df_text_take(struct df_text *text)
{
    df_text_bytes(text, "", 0);
    char *bytes = text->failed ? NULL : text->bytes;
    if (text->failed) {
        free(text->bytes);
    }
    *text = (struct df_text){0};
    return bytes;
}

void df_text_free(struct df_text *text)
{
    free(text->bytes);
    *text = (struct df_text){0};
}
