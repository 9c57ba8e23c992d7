#include "roms/lessons/field.h"

#include <math.h>
#include <string.h>

enum { LAST = FIELD_SIDE - 1, MIDDLE = FIELD_SIDE / 2, WALL = 11, RIM = 6 };

void field_begin(struct field *f, enum field_kind kind)
{
    memset(f, 0, sizeof *f);
    f->kind = kind;
    for (int r = 0; r < FIELD_SIDE; r++) {
        for (int c = 0; c < FIELD_SIDE; c++) {
            int in = r < c ? r : c, other = LAST - (r > c ? r : c);
            in = in < other ? in : other;
            f->damping[r][c] = in < RIM ? 0.05f * (float)(RIM - in) : 0.004f;
        }
    }
}

bool field_is_wall(const struct field *f, int row, int column)
{
    int from_middle = column > MIDDLE ? column - MIDDLE : MIDDLE - column;
    return f->kind == FIELD_SLITS && row == WALL && (from_middle < 4 || from_middle > 6);
}

/* What is held at a value, whatever the equation says. */
static void hold(struct field *f)
{
    float swing = sinf((float)f->steps * 0.45f);
    float rise = f->steps < 20 ? (float)f->steps / 20 : 1;
    switch (f->kind) {
    case FIELD_SOURCES:
        f->now[MIDDLE][10] = f->now[MIDDLE][22] = 1.1f * swing * rise;
        break;
    case FIELD_SLITS:
        for (int c = 0; c < FIELD_SIDE; c++) {
            f->now[3][c] = 0.8f * swing * rise;
            if (field_is_wall(f, WALL, c))
                f->now[WALL][c] = 0;
        }
        break;
    default:
        f->now[9][9] = f->now[9][10] = f->now[10][9] = f->now[10][10] = 1;
        for (int k = 0; k < 9; k++)
            f->now[22][14 + k] = 0.8f;
        break;
    }
}

void field_step(struct field *f)
{
    static const float speed2 = 0.25f, conduction = 0.2f;
    float row_before[FIELD_SIDE], row[FIELD_SIDE];
    memcpy(row_before, f->now[0], sizeof row_before);
    for (int r = 1; r < LAST; r++) {
        memcpy(row, f->now[r], sizeof row);
        for (int c = 1; c < LAST; c++) {
            float u = row[c];
            float laplace = row_before[c] + f->now[r + 1][c] + row[c - 1] + row[c + 1] - 4 * u;
            if (f->kind == FIELD_HEAT) {
                f->now[r][c] = u + conduction * laplace;
            } else {
                float change = (u - f->before[r][c]) * (1 - f->damping[r][c]);
                f->before[r][c] = u;
                f->now[r][c] = u + change + speed2 * laplace;
            }
        }
        memcpy(row_before, row, sizeof row);
    }
    f->steps++;
    hold(f);
}

void field_until(struct field *f, float seconds)
{
    int wanted = (int)(seconds * FIELD_RATE);
    if (wanted > f->steps + FIELD_RATE)
        wanted = f->steps + FIELD_RATE;
    while (f->steps < wanted)
        field_step(f);
}

float field_low(const struct field *f)
{
    return f->kind == FIELD_HEAT ? 0 : -0.8f;
}

float field_high(const struct field *f)
{
    return f->kind == FIELD_HEAT ? 1 : 0.8f;
}
