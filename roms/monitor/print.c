#include "roms/monitor/print.h"

#include <stdio.h>
#include <string.h>

double print_tidy_to(float value, int decimals)
{
    static const float halves[] = {0.5f,  0.05f, 0.005f, 0.0005f, 0.00005f,
                                   5e-6f, 5e-7f, 5e-8f,  5e-9f,   5e-10f};
    return value > -halves[decimals] && value < halves[decimals] ? 0 : (double)value;
}

double print_tidy(float value)
{
    return print_tidy_to(value, 4);
}

static void matrix_row(const char *name, int row, const float *at, int count)
{
    printf("%*s", (int)strlen(name), row == 0 ? name : "");
    for (int k = 0; k < count; k++)
        printf(" %9.4f", print_tidy(at[k]));
    printf("\n");
}

void print_matrix3(const char *name, const struct matrix3 *m)
{
    for (int i = 0; i < 3; i++)
        matrix_row(name, i, m->at[i], 3);
}

void print_matrix4(const char *name, const struct matrix4 *m)
{
    for (int i = 0; i < 4; i++)
        matrix_row(name, i, m->at[i], 4);
}

void print_point2(struct point2 p)
{
    printf("(%.4f,%.4f)", print_tidy(p.x), print_tidy(p.y));
}

void print_vector3(struct vector3 p)
{
    printf("(%.4f,%.4f,%.4f)", print_tidy(p.x), print_tidy(p.y), print_tidy(p.z));
}
