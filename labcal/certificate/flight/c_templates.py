"""The text of `labcal_calibration.h` and `.c` that is the same for every calibration; `@NAME@` is filled in."""

from __future__ import annotations

from collections.abc import Mapping

HEADER = """\
/*
@ABOUT@
 *
 * C99, nothing is allocated. labcal_begin() once, then labcal_apply() for each reading in the order of time. With
 * LABCAL_FLOAT32 numbers are float (times, channels and what adds up stay double): a component is then off by at most
 * LABCAL_FLOAT32_ERROR_NT, over readings like those of test_vectors.csv.
 */
#ifndef LABCAL_CALIBRATION_H
#define LABCAL_CALIBRATION_H

#ifdef LABCAL_FLOAT32
typedef float labcal_real;
#else
typedef double labcal_real;
#endif

#define LABCAL_SHA256 "@SHA256@" /* of the calibration file */
#define LABCAL_FLOAT32_ERROR_NT @FLOAT_ERROR@
#ifndef LABCAL_HISTORY
#define LABCAL_HISTORY @HISTORY@ /* readings that delays look back over; more where they come faster than in the run */
#endif

extern const char labcal_calibration_sha256[];

/* The places of labcal_row.input; NaN where one is not known: the effect is then left out. */
enum {
@INPUTS@
};

/* Power modes. */
enum {
@MODES@
};

/* Flags of a corrected reading, bit by bit. */
enum {
    LABCAL_FIELD_RANGE = 1,       /* |b| is outside what the run covered */
    LABCAL_TEMPERATURE_RANGE = 2, /* so is the temperature */
    LABCAL_MODE = 4,              /* so is the power mode */
    LABCAL_SATURATED = 8,         /* the reading is at its end */
    LABCAL_LEFT_OUT = 16,         /* an effect lacks its input */
    LABCAL_LATE = 32,             /* a delay reaches back before the segment, or LABCAL_HISTORY is too short */
    LABCAL_DOMAIN = 128,          /* a channel that an effect follows is where it was not seen */
    LABCAL_NO_READING = 64        /* it is not finite, and so is no field */
};

typedef struct {
    double t_s;             /* of the reading, any epoch */
    long segment;           /* another number: delays and loops begin anew (after a pause); else keep it */
    int mode;
    labcal_real reading[3]; /* m, raw */
    double input[@PLACES@];
} labcal_row;

typedef struct {
    double t_s;             /* the time that the field belongs to */
    labcal_real b_nT[3];    /* body axes */
    labcal_real u_nT;       /* standard uncertainty of one component; nothing for what was before labcal_begin() */
} labcal_field;

@STATES@
@EFFECTS@

typedef struct {
@MEMBERS@
    int unused;
} labcal_state;

void labcal_begin(labcal_state *state);

/* Returns the flags. */
unsigned labcal_apply(labcal_state *state, const labcal_row *row, labcal_field *found);

#endif
"""

SOURCE = """\
#include "labcal_calibration.h"

#include <math.h>
#include <string.h>

#define R(x) ((labcal_real)(x))
#define LAG_S @LAG@

const char labcal_calibration_sha256[] = LABCAL_SHA256;

typedef struct {
    double t_s;
    long segment;
    int mode, late;
    labcal_real field[3], along[3]; /* a = K m - k, in B and along the sensor's own axes [nT] */
    double input[sizeof(((labcal_row *)0)->input) / sizeof(double)];
} labcal_now;

@K@@OFFSET@@AXES@
/* From B to the sensor's own axes. */
@ALONG@
/* The covariance of K row by row, k, and the effects' parameters is FACTOR times its transpose. */
@FACTOR@
enum { PARAMETERS = sizeof FACTOR / sizeof FACTOR[0], RANK = sizeof FACTOR[0] / sizeof FACTOR[0][0] };

@HELPERS@
@EFFECTS@
/* By what part of a range a value lies outside; what is not known lies a whole one outside. */
static double excess(double value, double low, double high, double noise, unsigned flag, unsigned *flags)
{
    const double largest = fabs(low) > fabs(high) ? fabs(low) : fabs(high);
    double width = high - low, beyond = 0.0;
    if (value >= low - noise && value <= high + noise)
        return 0.0;
    *flags |= flag;
    if (!isfinite(value))
        return 1.0;
    width = width > 0.1 * largest ? width : 0.1 * largest;
    width = width > 1e-9 ? width : 1e-9;
    beyond = value < low ? low - value : value - high;
    return beyond / width;
}

/* The variance of the three components together, from the parameters' covariance. */
static double spread(labcal_real slopes[][3])
{
    double total = 0.0;
    for (int r = 0; r < RANK; ++r)
        for (int j = 0; j < 3; ++j) {
            labcal_real moved = R(0.0);
            for (int p = 0; p < PARAMETERS; ++p)
                moved += slopes[p][j] * FACTOR[p][r];
            total += (double)moved * (double)moved;
        }
    return total;
}

void labcal_begin(labcal_state *state)
{
    memset(state, 0, sizeof *state);
}

unsigned labcal_apply(labcal_state *state, const labcal_row *row, labcal_field *found)
{
    labcal_now now;
    labcal_real slopes[PARAMETERS][3], variance = @CONSTANT@;
    double length = 0.0, growth = 1.0;
    unsigned flags = 0;
    int saturated = 0;
    (void)state;
    memset(&now, 0, sizeof now);
    memset(slopes, 0, sizeof slopes);
    for (int j = 0; j < 3; ++j) {
        now.field[j] = K[j][0] * row->reading[0] + K[j][1] * row->reading[1] + K[j][2] * row->reading[2] - OFFSET[j];
        slopes[9 + j][j] = R(-1.0);
        for (int i = 0; i < 3; ++i)
            slopes[3 * j + i][j] = row->reading[i];
        found->b_nT[j] = now.field[j];
    }
    found->t_s = row->t_s - LAG_S;
    found->u_nT = (labcal_real)NAN;
    if (!isfinite((double)(now.field[0] + now.field[1] + now.field[2]))) {
        found->b_nT[0] = found->b_nT[1] = found->b_nT[2] = (labcal_real)NAN;
        return LABCAL_NO_READING;
    }
    for (int j = 0; j < 3; ++j)
        now.along[j] = ALONG[j][0] * now.field[0] + ALONG[j][1] * now.field[1] + ALONG[j][2] * now.field[2];
    now.t_s = row->t_s;
    now.segment = row->segment;
    now.mode = row->mode;
@TAKE@
    now.t_s = found->t_s;
@BLOCKS@
    for (int j = 0; j < 3; ++j)
        length += (double)found->b_nT[j] * (double)found->b_nT[j];
    length = sqrt(length);
@RANGE@
    found->u_nT = (labcal_real)(sqrt((double)variance + spread(slopes) / 3.0) * growth);
    return flags;
}
"""
SETTLED = """\
/* The same in the field without it. */
static void settled_@N@(const double shape[], labcal_effect_@N@ *state, const labcal_now *now, labcal_real e[][3])
{
    const labcal_effect_@N@ before = *state;
    labcal_now alone = *now;
    labcal_real held[3] = {R(0.0), R(0.0), R(0.0)}, value[3];
    double last = INFINITY, change = INFINITY;
    for (int round = 0; round < @ROUNDS@; ++round) {
        *state = before;
        memset(e, 0, @P@ * sizeof e[0]);
        effect_@N@(shape, state, &alone, e);
        sum(e, BETA_@N@, @P@, value);
        last = change;
        change = 0.0;
        for (int j = 0; j < 3; ++j) {
            change = fmax(change, fabs((double)value[j] - (double)held[j]));
            held[j] = value[j];
            alone.field[j] = now->field[j] - held[j];
        }
        for (int j = 0; j < 3; ++j)
            alone.along[j] =
                ALONG[j][0] * alone.field[0] + ALONG[j][1] * alone.field[1] + ALONG[j][2] * alone.field[2];
        if (change < @SETTLED@ || !(change < last))
            break;
    }
}
"""


def filled(template: str, values: Mapping[str, str]) -> str:
    """A template with the value of each name in the place of @NAME@, no line ending in blanks."""
    for name, value in values.items():
        template = template.replace(f"@{name}@", value)
    return "\n".join(line.rstrip() for line in template.splitlines()) + "\n"
