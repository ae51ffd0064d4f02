"""The functions that the effects' C calls, each in the file where an effect needs it, and the states that they keep."""

from __future__ import annotations

STATES = """\
/* A drive and what follows it; a drive and its past; loops. Times and what adds up are double in either variant. */
typedef struct { double t_s, drive, value; long segment; int begun; } labcal_behind;
typedef struct { double t_s[LABCAL_HISTORY], value[LABCAL_HISTORY]; long segment; int count, last; } labcal_history;
typedef struct { double drive, value; long segment; int begun; } labcal_dahl;
typedef struct { labcal_real play; long segment; int begun; } labcal_stop;
typedef struct { double curve, drive, value; long segment; int begun; } labcal_core;
"""

HELPERS = {
    "on_each_axis": """\
/* The same drive on each axis of B. */
static void on_each_axis(labcal_real e[][3], labcal_real drive)
{
    e[0][0] = drive;
    e[1][1] = drive;
    e[2][2] = drive;
}
""",
    "along_axis": """\
/* A drive along one of the sensor's axes. */
static void along_axis(labcal_real e[3], int axis, labcal_real drive)
{
    for (int j = 0; j < 3; ++j)
        e[j] = AXES[j][axis] * drive;
}
""",
    "mode_is": """\
static labcal_real mode_is(const labcal_now *now, int mode)
{
    return now->mode == mode ? R(1.0) : R(0.0);
}
""",
    "magnitude": """\
static labcal_real magnitude(labcal_real s)
{
    return s < 0 ? -s : s;
}
""",
    "bend": """\
/* What a saturating curve lacks of a straight one; in double, for it is a small difference. */
static labcal_real bend(labcal_real u)
{
    return (labcal_real)(tanh((double)u) - (double)u);
}
""",
    "low_passed": """\
/* Response of first order, exact for a drive that is straight between readings. It begins anew after a gap between
   segments longer than three time constants. */
static labcal_real low_passed(labcal_behind *state, const labcal_now *now, double drive, double slope, double tau_s)
{
    const double since = state->begun ? (now->t_s - state->t_s) / tau_s : 0.0;
    const int anew = now->segment != state->segment && (since <= 0.0 || since > 3.0);
    if (!state->begun || anew) {
        state->value = drive - (isfinite(slope) ? tau_s * slope : 0.0);
    } else {
        const double step = since > 0.0 ? since : 0.0;
        const double keep = exp(-step), ramp = step > 0.0 ? -expm1(-step) / step : 1.0;
        state->value = keep * state->value + (ramp - keep) * state->drive + (1.0 - ramp) * drive;
    }
    state->t_s = now->t_s;
    state->drive = drive;
    state->segment = now->segment;
    state->begun = 1;
    return (labcal_real)state->value;
}
""",
    "earlier": """\
/* A drive so much earlier, straight between readings of the segment; its first value, and `late`, before them. */
static double earlier(labcal_history *past, labcal_now *now, double drive, double by_s)
{
    const double at_s = now->t_s - by_s;
    int newer;
    if (past->count == 0 || past->segment != now->segment) {
        past->count = 0;
        past->last = LABCAL_HISTORY - 1;
        past->segment = now->segment;
    }
    past->last = (past->last + 1) % LABCAL_HISTORY;
    past->count += past->count < LABCAL_HISTORY;
    past->t_s[past->last] = now->t_s;
    past->value[past->last] = drive;
    newer = past->last;
    if (past->t_s[newer] <= at_s)
        return drive;
    for (int back = 1; back < past->count; ++back) {
        const int older = (past->last + LABCAL_HISTORY - back) % LABCAL_HISTORY;
        if (past->t_s[older] <= at_s) {
            const double part = (at_s - past->t_s[older]) / (past->t_s[newer] - past->t_s[older]);
            return past->value[older] + part * (past->value[newer] - past->value[older]);
        }
        newer = older;
    }
    now->late = 1;
    return past->value[newer];
}
""",
    "dahl": """\
/* Dahl's loop within +-1. */
static double dahl(labcal_dahl *state, const labcal_now *now, labcal_real drive, labcal_real width)
{
    const double step = (double)drive - state->drive;
    if (!state->begun || state->segment != now->segment) {
        state->value = 0.0;
    } else {
        const double keep = exp(-fabs(step) / (double)width);
        state->value = keep * state->value + (step > 0.0 ? 1.0 : step < 0.0 ? -1.0 : 0.0) * (1.0 - keep);
    }
    state->drive = (double)drive;
    state->segment = now->segment;
    state->begun = 1;
    return state->value;
}
""",
    "stop": """\
/* The field since it turned, within +-threshold. begins: 0 at rest in the field of each segment's first reading,
   1 from no field before each segment, 2 from no field before the first. */
static labcal_real stop(labcal_stop *state, const labcal_now *now, labcal_real drive, labcal_real threshold, int begins)
{
    if (!state->begun || (begins < 2 && state->segment != now->segment))
        state->play = begins == 0 ? drive : R(0.0);
    if (state->play < drive - threshold)
        state->play = drive - threshold;
    if (state->play > drive + threshold)
        state->play = drive + threshold;
    state->segment = now->segment;
    state->begun = 1;
    return drive - state->play;
}
""",
    "saturating": """\
/* A bounded function of the play, less the same of the field. */
static labcal_real saturating(labcal_real drive, labcal_real stopped, labcal_real level)
{
    const double play = (double)drive - (double)stopped;
    return (labcal_real)(tanh(play / (double)level) - tanh((double)drive / (double)level));
}
""",
    "relays": """\
/* The mean of a bounded function of the plays of several widths, less the same of the field. */
static labcal_real relays(labcal_stop *states, const labcal_now *now, labcal_real drive, labcal_real level,
                          const labcal_real *width, const double *share, int count)
{
    double sum = 0.0;
    for (int k = 0; k < count; k++)
        sum += share[k] * (double)saturating(drive, stop(&states[k], now, drive, width[k], 0), level);
    return (labcal_real)sum;
}
""",
    "langevin": """\
/* L(u) = coth u - 1/u, and what it lacks of u / 3. */
static double langevin(double u)
{
    return fabs(u) < 1e-2 ? u / 3.0 - u * u * u / 45.0 + 2.0 * u * u * u * u * u / 945.0 : 1.0 / tanh(u) - 1.0 / u;
}
""",
    "bent": """\
static double bent(double u)
{
    return langevin(u) - u / 3.0;
}
""",
    "magnetised": """\
/* How far a core's magnetisation is from its curve; exact where the curve is straight between readings. */
static labcal_real magnetised(labcal_core *state, const labcal_now *now, labcal_real drive, labcal_real bend,
                              labcal_real pin, labcal_real part)
{
    const double curve = langevin((double)drive / (double)bend), rise = curve - state->curve;
    double way = fabs((double)drive - state->drive) / (double)pin;
    if (!state->begun || state->segment != now->segment) {
        state->value = (double)part * curve;
    } else if (rise < 0.0 || rise > 0.0) {
        const double ahead = (state->value - state->curve) / rise;
        if (ahead < 1.0) {
            const double start = ahead <= 0.0 ? state->curve : state->value;
            way *= 1.0 - fmax(ahead, 0.0);
            state->value = curve + (state->value - start) * exp(-way)
                         - (curve - start) * (way > 0.0 ? -expm1(-way) / way : 1.0);
        }
    }
    state->curve = curve;
    state->drive = (double)drive;
    state->segment = now->segment;
    state->begun = 1;
    return (labcal_real)(state->value - curve);
}
""",
    "length_of": """\
static double length_of(const labcal_real field[3])
{
    const double x = (double)field[0], y = (double)field[1], z = (double)field[2];
    return sqrt(x * x + y * y + z * z);
}
""",
    "b_splines": """\
/* All B-splines of a degree on the knots, at x held between their ends (de Boor, A Practical Guide to Splines, 9). */
static void b_splines(const double knots[], int count, int degree, double x, double b[])
{
    int place = degree;
    x = fmin(fmax(x, knots[degree]), knots[count - degree - 1]);
    while (place < count - degree - 2 && knots[place + 1] <= x)
        ++place;
    for (int i = 0; i < count - 1; ++i)
        b[i] = i == place ? 1.0 : 0.0;
    for (int d = 1; d <= degree; ++d)
        for (int i = 0; i + d + 1 < count; ++i) {
            const double rise = knots[i + d] - knots[i], fall = knots[i + d + 1] - knots[i + 1];
            b[i] = (rise > 0.0 ? (x - knots[i]) / rise * b[i] : 0.0)
                 + (fall > 0.0 ? (knots[i + d + 1] - x) / fall * b[i + 1] : 0.0);
        }
}
""",
    "within": """\
/* Whether a point lies in a convex hull, its corners against the clock; `edge` of the hull's size is still within. */
static int within(const double hull[][2], int corners, double x, double y, double edge)
{
    double low[2] = {hull[0][0], hull[0][1]}, high[2] = {hull[0][0], hull[0][1]};
    for (int i = 1; i < corners; ++i)
        for (int k = 0; k < 2; ++k) {
            low[k] = fmin(low[k], hull[i][k]);
            high[k] = fmax(high[k], hull[i][k]);
        }
    const double width = fmax(high[0] - low[0], 1e-300), height = fmax(high[1] - low[1], 1e-300);
    for (int i = 0; i < corners; ++i) {
        const double *from = hull[i], *to = hull[(i + 1) % corners];
        const double left = (to[0] - from[0]) / width * ((y - from[1]) / height)
                          - (to[1] - from[1]) / height * ((x - from[0]) / width);
        if (left < -edge)
            return 0;
    }
    return 1;
}
""",
    "sum": """\
static void sum(labcal_real e[][3], const labcal_real beta[], int n, labcal_real value[3])
{
    for (int j = 0; j < 3; ++j) {
        value[j] = R(0.0);
        for (int p = 0; p < n; ++p)
            value[j] += e[p][j] * beta[p];
    }
}
""",
    "keep": """\
static void keep(labcal_real e[][3], const int place[], int n, labcal_real slopes[][3])
{
    for (int p = 0; p < n; ++p)
        for (int j = 0; j < 3; ++j)
            slopes[place[p]][j] = -e[p][j];
}
""",
    "further": """\
/* How an effect changes with a parameter that it does not depend on linearly. */
static void further(labcal_real e[][3], const labcal_real beta[], int n, const labcal_real value[3], labcal_real step,
                    labcal_real slope[3])
{
    labcal_real moved[3];
    sum(e, beta, n, moved);
    for (int j = 0; j < 3; ++j)
        slope[j] = (value[j] - moved[j]) / step;
}
""",
}
