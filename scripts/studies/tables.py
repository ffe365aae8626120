"""Numbers and tables as text."""

import csv
import math


def number(value, digits=3):
    """A number, or text as it is; '–' where there is none."""
    if isinstance(value, str):
        return value
    if value is None or math.isnan(value):
        return "–"
    if isinstance(value, int):
        return str(value)
    text = f"{value:.{digits}g}"
    mantissa, _, power = text.partition("e")
    return f"{mantissa}e{int(power)}" if power else text


def markdown(header, rows, digits=3):
    """A table in Markdown."""
    lines = [header, ["---"] * len(header)]
    lines += [[number(value, digits) for value in row] for row in rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def write_csv(path, header, rows):
    """A table with all digits."""
    with open(path, "w", encoding="utf8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header)
        writer.writerows(rows)
