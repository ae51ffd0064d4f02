"""`main.c`: checks the functions against `test_vectors.csv` in the current folder; exit 0 where all rows agree."""

from __future__ import annotations

from labcal.certificate.flight.c_source import Program
from labcal.certificate.flight.vectors import Vectors
from labcal.model.effects.c_form import enumerator

CELL = 26  # characters of a number and its comma


def check_program(program: Program, vectors: Vectors) -> str:
    """Its text: the columns are those that `vectors.written` writes."""
    reads = [f"        row.input[{enumerator(one)}] = number(&at);" for one in program.inputs]
    where = "the calibration's run" if vectors.of_the_run else "no run: they are made up"
    values = {"LINE": str(CELL * (16 + len(program.inputs)) + 2000), "READS": "\n".join(reads), "WHERE": where}
    text = MAIN
    for name, value in values.items():
        text = text.replace(f"@{name}@", value)
    return text


MAIN = """\
/* Checks labcal_calibration.c against test_vectors.csv (rows of @WHERE@).
 * cc -std=c99 main.c labcal_calibration.c -lm && ./a.out */
#include "labcal_calibration.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIELD 1e-6 /* of |b| */
#define UNCERTAINTY 0.01

/* The next cell of a line; NaN for an empty one. */
static double number(char **at)
{
    char *end = *at;
    const double value = strtod(*at, &end);
    const int empty = end == *at;
    *at = end + (*end == ',');
    return empty ? (double)NAN : value;
}

static double larger(double one, double other)
{
    return one > other || isnan(one) ? one : other;
}

int main(void)
{
    static labcal_state state;
    static char line[@LINE@];
    FILE *vectors = fopen("test_vectors.csv", "r");
    double off_nT = 0.0, off = 0.0, off_u = 0.0, off_s = 0.0;
    long rows = 0;
    int good;
    if (vectors == NULL || fgets(line, sizeof line, vectors) == NULL) {
        fprintf(stderr, "test_vectors.csv is not in this folder\\n");
        return 2;
    }
    labcal_begin(&state);
    while (fgets(line, sizeof line, vectors) != NULL) {
        labcal_row row;
        labcal_field found;
        double expected[3], t_s, u_nT, length = 0.0, apart = 0.0;
        char *at = line;
        memset(&row, 0, sizeof row);
        row.t_s = number(&at);
        row.segment = (long)number(&at);
        row.mode = (int)number(&at);
        for (int j = 0; j < 3; ++j)
            row.reading[j] = (labcal_real)number(&at);
@READS@
        t_s = number(&at);
        for (int j = 0; j < 3; ++j)
            expected[j] = number(&at);
        u_nT = number(&at);
        (void)labcal_apply(&state, &row, &found);
        for (int j = 0; j < 3; ++j) {
            length += expected[j] * expected[j];
            apart = larger(fabs((double)found.b_nT[j] - expected[j]), apart);
        }
        off_nT = larger(apart, off_nT);
        off = larger(apart / sqrt(length), off);
        off_s = larger(fabs(found.t_s - t_s), off_s);
        if (!isnan(u_nT))
            off_u = larger(fabs((double)found.u_nT / u_nT - 1.0), off_u);
        ++rows;
    }
    fclose(vectors);
#ifdef LABCAL_FLOAT32
    good = off_nT <= LABCAL_FLOAT32_ERROR_NT;
#else
    good = off <= FIELD;
#endif
    good = good && rows > 0 && off_u <= UNCERTAINTY && off_s <= 1e-6;
    printf("%s: %ld rows, field within %.3g nT (%.2g of |b|), u within %.2g, time within %.2g s\\n",
           good ? "good" : "NOT GOOD", rows, off_nT, off, off_u, off_s);
    return good ? 0 : 1;
}
"""
