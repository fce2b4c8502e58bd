"""Damages a file: the same seed damages it in the same way."""

import random
import re

NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?")
WILD = [b"nan", b"-inf", b"1e308", b"-1e999", b"1e-320", b"0", b"-1", b"2147483648", b"-2147483649", b"1e9",
        b"99999999999999999999", b"0.0000000001", b"1.", b"#", b"''", b"\x1b[2J", b"\xff\xfe", b"\x00"]


def changed_number(data, rng):
    numbers = [match.span() for match in NUMBER.finditer(data)]
    if not numbers:
        return data
    start, end = rng.choice(numbers)
    return data[:start] + rng.choice(WILD) + data[end:]


def nudged_number(data, rng):
    numbers = [match.span() for match in NUMBER.finditer(data)]
    if not numbers:
        return data
    start, end = rng.choice(numbers)
    try:
        value = float(data[start:end])
    except ValueError:
        return data
    factor = rng.choice([-1.0, 0.5, 2.0, 1000.0, 1.0 + 1e-9])
    return data[:start] + repr(value * factor).encode() + data[end:]


def flipped_bits(data, rng):
    data = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 8])):
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    return bytes(data)


def wild_double(data, rng):
    """For binary files: eight bytes that are a number no file should have."""
    at = rng.randrange(max(1, len(data) - 8))
    wild = [b"\x00" * 6 + b"\xf8\x7f", b"\x00" * 6 + b"\xf0\x7f", b"\xff" * 8, b"\xff" * 6 + b"\xef\x7f", b"\x00" * 8]
    return data[:at] + rng.choice(wild) + data[at + 8 :]


def piece_of(data, rng, longest=200):
    start = rng.randrange(len(data))
    return start, min(len(data), start + rng.randrange(1, longest))


def lost_piece(data, rng):
    start, end = piece_of(data, rng)
    return data[:start] + data[end:]


def repeated_piece(data, rng):
    start, end = piece_of(data, rng)
    return data[:end] + data[start:end] * rng.choice([1, 2, 50]) + data[end:]


def swapped_lines(data, rng):
    lines = data.split(b"\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]
    return b"\n".join(lines)


def cut_end(data, rng):
    return data[: rng.randrange(1, len(data))]


DAMAGES = [changed_number] * 4 + [nudged_number] * 3 + [flipped_bits] * 3 + [
    wild_double, lost_piece, repeated_piece, swapped_lines, cut_end]


def mutate(data, seed):
    """One to four damages, one after the other."""
    rng = random.Random(seed)
    for _ in range(rng.choice([1, 1, 2, 4])):
        if len(data) > 1:
            data = rng.choice(DAMAGES)(data, rng)
    return data
