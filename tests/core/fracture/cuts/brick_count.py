#!/usr/bin/env python3
"""Lays a wall of bricks brick by brick, and prints how many pieces it has and how long its joints are, in m.

brick_count.py BOND LENGTH WIDTH HEIGHT MORTAR ORIGIN_X ORIGIN_Y WALL_WIDTH WALL_HEIGHT

Exact fractions throughout; shares nothing with the program but the words for bonds.
"""
import sys
from fractions import Fraction


def course(bond, number, length, width):
    """Where a course begins, and the bricks that are repeated along it, with their mortar."""
    odd = number % 2 != 0
    if bond == "stack":
        return Fraction(0), [length]
    if bond == "stretcher":
        return (length / 2 if odd else Fraction(0)), [length]
    if bond == "header":
        return (width / 2 if odd else Fraction(0)), [width]
    if bond == "english":
        return (width / 2, [width]) if odd else (Fraction(0), [length])
    return ((length + width) / 2 if odd else Fraction(0)), [length, width]


def joints_of(bond, number, length, width, origin, wall_width):
    """The places of upright joints inside the wall."""
    start, bricks = course(bond, number, length, width)
    period = sum(bricks)
    place = origin + start
    while place > 0:
        place -= period
    places = []
    while place < wall_width:
        for brick in bricks:
            if 0 < place < wall_width:
                places.append(place)
            place += brick
    return places


def main():
    bond = sys.argv[1]
    length, width, height, mortar, origin_x, origin_y, wall_width, wall_height = map(Fraction, sys.argv[2:])
    length, width, rise = length + mortar, width + mortar, height + mortar
    number = 0
    while origin_y + number * rise > 0:
        number -= 1
    while origin_y + (number + 1) * rise <= 0:
        number += 1
    pieces, joints = 0, Fraction(0)
    while origin_y + number * rise < wall_height:
        bottom, top = origin_y + number * rise, origin_y + (number + 1) * rise
        inside = min(top, wall_height) - max(bottom, Fraction(0))
        uprights = joints_of(bond, number, length, width, origin_x, wall_width)
        pieces += len(uprights) + 1
        joints += len(uprights) * inside
        if 0 < bottom:
            joints += wall_width
        number += 1
    print(pieces, float(joints))


main()
