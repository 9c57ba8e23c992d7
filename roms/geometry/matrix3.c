#include "roms/geometry/matrix3.h"

struct matrix3 matrix3_identity(void)
{
    return (struct matrix3){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

struct matrix3 matrix3_product(const struct matrix3 *a, const struct matrix3 *b)
{
    struct matrix3 p;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            p.at[i][k] =
                a->at[i][0] * b->at[0][k] + a->at[i][1] * b->at[1][k] + a->at[i][2] * b->at[2][k];
    return p;
}

struct point2 matrix3_apply(const struct matrix3 *m, struct point2 p)
{
    float x = m->at[0][0] * p.x + m->at[0][1] * p.y + m->at[0][2];
    float y = m->at[1][0] * p.x + m->at[1][1] * p.y + m->at[1][2];
    float h = m->at[2][0] * p.x + m->at[2][1] * p.y + m->at[2][2];
    return h == 1 ? (struct point2){x, y} : (struct point2){x / h, y / h};
}

/* The minor without a row and a column, with its sign: indices go round. */
static float cofactor(const struct matrix3 *m, int row, int column)
{
    int r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    return m->at[r1][c1] * m->at[r2][c2] - m->at[r1][c2] * m->at[r2][c1];
}

bool matrix3_inverse(const struct matrix3 *m, struct matrix3 *out)
{
    float determinant = 0;
    for (int k = 0; k < 3; k++)
        determinant += m->at[0][k] * cofactor(m, 0, k);
    if (determinant == 0)
        return false;
    struct matrix3 inverse;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            inverse.at[k][i] = cofactor(m, i, k) / determinant;
    *out = inverse;
    return true;
}
