#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reference for the elementary functions of src/core/elementary.h, in 80 decimal digits.

Power series alone; shares no code with the library.

    elementary_reference.py FOLDER          writes elementary.json
    elementary_reference.py --check FOLDER  demands that its results are right, and the constants of
                                            src/core/elementary.h and sine_coefficients.h
    elementary_reference.py --tables        prints these constants

A case is [function, arguments, value], all numbers hexadecimal; value is [high, low], whose sum is the
exact result to 2^-105 of it.
"""
import json
import math
import pathlib
import random
import re
import sys
from decimal import ROUND_HALF_EVEN, Context, Decimal, setcontext
from fractions import Fraction

setcontext(Context(prec=80, Emin=-9999, Emax=9999))
SEED = 1971
LARGEST = 2.0**40  # of the angles
SMALL = Decimal("1e-82")


def series(first, factor):
    """first, and then each term the one before times factor(n), n = 1, 2, ..."""
    total, term, n = first, first, 0
    while term != 0 and abs(term) > SMALL * abs(total):
        n += 1
        term *= factor(n)
        total += term
    return total


def arctangent(x):
    """x >= 0; halved by tan(a/2) = tan a / (1 + sqrt(1 + tan² a)) until the series is short."""
    doublings = 0
    while x > Decimal("0.05"):
        x /= 1 + (1 + x * x).sqrt()
        doublings += 1
    return 2**doublings * series(x, lambda n: -x * x * (2 * n - 1) / (2 * n + 1))


PI = 4 * arctangent(Decimal(1))


def turned(x):
    """(quadrant, rest) of the nearest multiple of π/2; for large x in as many digits as that takes."""
    x = Decimal(x)
    quadrant = (x / (PI / 2)).to_integral_value(ROUND_HALF_EVEN)
    return int(quadrant) % 4, x - quadrant * (PI / 2)


def sine(x, quarters=0):
    quadrant, r = turned(x)
    quadrant = (quadrant + quarters) % 4
    if quadrant % 2 == 0:
        value = series(r, lambda n: -r * r / (2 * n * (2 * n + 1)))
    else:
        value = series(Decimal(1), lambda n: -r * r / ((2 * n - 1) * 2 * n))
    return value if quadrant < 2 else -value


def cosine(x):
    return sine(x, 1)


def angle(y, x):
    """Of (x, y), neither zero."""
    y, x = Decimal(y), Decimal(x)
    value = arctangent(abs(y / x))
    return (value if x > 0 else PI - value).copy_sign(y)


def growth(x):
    x = Decimal(x)
    if x > -1:
        return series(x, lambda n: x / (n + 1))
    return x.exp() - 1


FUNCTIONS = {"sin": sine, "cos": cosine, "atan2": angle, "expm1": growth}


def parts(value, count):
    """Doubles whose sum is value, each the nearest to what is left."""
    result = []
    for _ in range(count):
        result.append(float(value))
        value -= Decimal(result[-1])
    return result


def of(name, *arguments):
    value = parts(FUNCTIONS[name](*arguments), 2)
    return [name, [a.hex() for a in arguments], [v.hex() for v in value]]


def nearly_whole(ratio):
    """Whole 2^52 <= q < 2^53 with q ratio nearly whole: the denominators of its continued fraction."""
    p, q, last_p, last_q, x = 1, 0, 0, 1, Fraction(ratio)
    while q < 2**53:
        if q >= 2**52:
            yield q
        whole = math.floor(x)
        p, q, last_p, last_q = whole * p + last_p, whole * q + last_q, p, q
        x = 1 / (x - whole)


def angles(rng):
    """All magnitudes, and the nearest that doubles come to multiples of π/2."""
    quarter = Fraction(PI / 2)
    for exponent in range(-53, -12):
        yield from (math.ldexp(q, exponent) for q in nearly_whole(Fraction(2)**exponent / quarter))
    for k in [*range(1, 9), *(rng.randrange(2**39) for _ in range(40))]:
        near = float(k * PI / 2)
        yield from (near, math.nextafter(near, 0.0), -math.nextafter(near, LARGEST))
    yield from (rng.uniform(-math.pi, math.pi) for _ in range(80))
    yield from (rng.uniform(-LARGEST, LARGEST) for _ in range(30))
    yield from (math.ldexp(rng.uniform(-1, 1), rng.randrange(-80, 40)) for _ in range(60))
    yield from (5e-324, -2.0**-1022, 2.0**-27, math.nextafter(2.0**-27, 0.0), math.pi / 4, LARGEST)


def points(rng):
    """(y, x) of all ratios and sizes, and near the ends of the 32nds that the table is cut at."""
    for _ in range(150):
        size = math.ldexp(1.0, rng.choice([0, 0, 0, 900, -900]))
        x = size * rng.uniform(-1, 1) * 2.0**rng.uniform(-70, 70)
        yield size * rng.uniform(-1, 1), x
    for k in range(33):
        y, x = k / 32 * rng.uniform(0.5, 1), rng.choice([1.0, -1.0])
        yield from ((y or 2.0**-61, x), (-x, y or 5e-324), (math.nextafter(k / 32 or 1.0, 2.0), x))
    for _ in range(60):
        yield rng.choice([-1, 1]) * rng.randrange(1, 20), float(rng.choice([-1, 1]) * rng.randrange(1, 20))
    yield from ((5e-324, 1.0), (5e-324, -5e-324), (1e308, 5e-324), (1.7e308, -1.7e308))


def exponents(rng):
    yield from (-k / 32 for k in range(1, 100))
    yield from (-rng.uniform(0, 3) for _ in range(150))
    yield from (-math.exp(rng.uniform(math.log(1e-300), math.log(1000.0))) for _ in range(100))
    for k in range(1, 60):  # where the reduction changes
        yield from (-(k - 0.5) * math.log(2), -math.nextafter((k - 0.5) * math.log(2), 0.0))
    yield from (-5e-324, -37.4, -37.5, -40.0, math.nextafter(-40.0, -41.0), -1e300)


def cases():
    rng = random.Random(SEED)
    result = []
    for x in angles(rng):
        result += [of("sin", x), of("cos", x)]
    result += [of("atan2", float(y), x) for y, x in points(rng) if y != 0 and x != 0]
    result += [of("expm1", x) for x in exponents(rng)]
    return result


def constants():
    """Of elementary.h and sine_coefficients.h."""
    ln2 = Decimal(2).ln()
    # the first part has 36 bits, so that its products by numbers below 2^17 are exact
    first = math.ldexp(math.floor(ln2 * 2**36), -36)
    yield from parts(PI / 2, 3)
    yield float(2 / PI)
    for k in range(17):
        yield from parts(arctangent(Decimal(k) / 16), 2) if k else (0.0, 0.0)
    yield from (first, float(ln2 - Decimal(first)), float(1 / ln2))
    for n in (6, 24, 120):
        yield from parts(1 / Decimal(n), 2)


def write(folder):
    rows = ",\n".join(json.dumps(case) for case in cases())
    (folder / "elementary.json").write_text(f'{{"seed": {SEED}, "cases": [\n{rows}\n]}}\n')


def check(folder):
    for number, case in enumerate(json.loads((folder / "elementary.json").read_text())["cases"]):
        if of(case[0], *map(float.fromhex, case[1])) != case:
            sys.exit(f"elementary.json: case {number} differs from what the reference computes")
    core = folder.parent.parent / "src/core"
    sources = [core / "elementary.h", core / "sine_coefficients.h"]
    texts = re.findall(r"0x[0-9a-f.]+p[+-]\d+", "".join(source.read_text() for source in sources))
    there = {abs(float.fromhex(text)) for text in texts}
    for constant in constants():
        if constant != 0.0 and abs(constant) not in there:
            sys.exit(f"{' and '.join(map(str, sources))}: have no constant {constant.hex()}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--tables"]:
        print(*(constant.hex() for constant in constants()), sep="\n")
    else:
        (check if sys.argv[1] == "--check" else write)(pathlib.Path(sys.argv[-1]).resolve())
