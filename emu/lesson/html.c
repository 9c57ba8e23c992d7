#include "emu/lesson/html.h"

#include <stdbool.h>
#include <string.h>

static void put(FILE *out, char c)
{
    switch (c) {
    case '&':
        fputs("&amp;", out);
        break;
    case '<':
        fputs("&lt;", out);
        break;
    case '>':
        fputs("&gt;", out);
        break;
    case '"':
        fputs("&quot;", out);
        break;
    default:
        fputc(c, out);
    }
}

void vm_html_bytes(FILE *out, const char *text, size_t n)
{
    for (size_t i = 0; i < n; i++)
        put(out, text[i]);
}

void vm_html_text(FILE *out, const char *text)
{
    vm_html_bytes(out, text, strlen(text));
}

void vm_html_prose(FILE *out, const char *text)
{
    for (const char *p = text; *p; p++) {
        const char *end = *p == '`' ? strchr(p + 1, '`') : NULL;
        if (!end) {
            put(out, *p);
            continue;
        }
        fputs("<code>", out);
        vm_html_bytes(out, p + 1, (size_t)(end - p - 1));
        p = end;
        fputs("</code>", out);
    }
}

void vm_html_base64(FILE *out, const unsigned char *bytes, size_t length)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < length; i += 3) {
        size_t left = length - i;
        unsigned v = (unsigned)bytes[i] << 16 | (left > 1 ? (unsigned)bytes[i + 1] << 8 : 0) |
                     (left > 2 ? bytes[i + 2] : 0);
        fputc(digits[v >> 18], out);
        fputc(digits[v >> 12 & 63], out);
        fputc(left > 1 ? digits[v >> 6 & 63] : '=', out);
        fputc(left > 2 ? digits[v & 63] : '=', out);
    }
}

static unsigned long big_endian(const unsigned char *p)
{
    return (unsigned long)p[0] << 24 | (unsigned long)p[1] << 16 | (unsigned long)p[2] << 8 | p[3];
}

void vm_html_png(FILE *out, const unsigned char *bytes, size_t length, const char *alt)
{
    fputs("<img", out);
    if (length >= 24) /* IHDR comes first: PNG 11.2.2 */
        fprintf(out, " width=\"%lu\" height=\"%lu\"", big_endian(bytes + 16),
                big_endian(bytes + 20));
    fputs(" alt=\"", out);
    vm_html_text(out, alt);
    fputs("\" src=\"data:image/png;base64,", out);
    vm_html_base64(out, bytes, length);
    fputs("\">", out);
}

/* One value; the character after it. Quoted values may have commas, line ends and doubled quotes. */
static const char *put_value(FILE *out, const char *p)
{
    if (*p != '"') {
        for (; *p && *p != ',' && *p != '\n'; p++)
            if (*p != '\r')
                put(out, *p);
        return p;
    }
    for (p++; *p && !(p[0] == '"' && p[1] != '"'); p++) {
        p += *p == '"';
        put(out, *p);
    }
    return p + (*p == '"');
}

static const char *put_row(FILE *out, const char *p, const char *cell)
{
    fputs("<tr>", out);
    for (bool more = true; more;) {
        fprintf(out, "<%s>", cell);
        p = put_value(out, p);
        while (*p && *p != ',' && *p != '\n')
            p++;
        fprintf(out, "</%.2s>", cell);
        more = *p == ',';
        p += more;
    }
    fputs("</tr>\n", out);
    return p + (*p == '\n');
}

void vm_html_csv(FILE *out, const char *csv, int most)
{
    int left = 0;
    fputs("<table>\n<thead>", out);
    const char *p = put_row(out, csv, "th scope=\"col\"");
    fputs("</thead>\n<tbody>\n", out);
    for (int i = 0; *p && i < most; i++)
        p = put_row(out, p, "td");
    for (; *p; p++)
        left += *p == '\n' || !p[1];
    fputs("</tbody></table>\n", out);
    if (left)
        fprintf(out, "<p class=\"more\">… and %d more rows.</p>\n", left);
}
