#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the inputs of gpu_bench.cpp: make_balls.py DATA_FOLDER OUT_FOLDER.

A .balls file holds three int32 (lattice digits, balls, operators), then per ball four int32 (x, y, z and
radius on the lattice), then per operator twelve doubles (rows of rotation and translation, in Angstrom).
Radii are RasMol's by element (C 1.548, N 1.400, O 1.348, S 1.808, others 1.700); waters are left out.
"""
import gzip
import struct
import sys

RADIUS = {"C": 1548, "N": 1400, "O": 1348, "S": 1808}


def text(path):
    return gzip.open(path, "rt") if path.endswith(".gz") else open(path)


def write(path, digits, balls, operators):
    with open(path, "wb") as out:
        out.write(struct.pack("<iii", digits, len(balls), len(operators)))
        for ball in balls:
            out.write(struct.pack("<4i", *ball))
        for operator in operators:
            out.write(struct.pack("<12d", *operator))


def from_crd(path, out):
    words = text(path).read().split()
    numbers = [round(float(w) * 10000) for w in words[1 : 1 + 4 * int(words[0])]]
    write(out, 4, list(zip(*[iter(numbers)] * 4)), [])


def from_pdb(path, out, hetero=False, assembly=False):
    balls, matrices = [], {}
    for line in text(path):
        if line.startswith("ATOM  ") or (hetero and line.startswith("HETATM")):
            if line[16] not in " A1" or line[17:20] in ("HOH", "DOD"):
                continue
            element = line[76:78].strip() or line[12:14].strip()[:1]
            centre = [round(float(line[a : a + 8]) * 1000) for a in (30, 38, 46)]
            balls.append((*centre, RADIUS.get(element, 1700)))
        elif assembly and line.startswith("REMARK 350   BIOMT"):
            words = line[19:].split()
            matrices.setdefault(int(words[0]), {})[int(line[18])] = [float(w) for w in words[1:5]]
        elif line.startswith("ENDMDL"):
            break
    write(out, 3, balls, [m[1] + m[2] + m[3] for _, m in sorted(matrices.items())])


if __name__ == "__main__":
    data, out = sys.argv[1:3]
    from_crd(f"{data}/thesis/1k4c.crd.gz", f"{out}/1k4c.balls")
    from_crd(f"{data}/ladder/1grm.crd", f"{out}/1grm.balls")
    from_pdb(f"{data}/thesis/1aon.pdb.gz", f"{out}/1aon.balls", hetero=True)
    from_pdb(f"{data}/ladder/2buk.pdb", f"{out}/2buk.balls", hetero=True, assembly=True)
    from_pdb(f"{data}/ladder/3j6r.pdb.gz", f"{out}/3j6r.balls", assembly=True)
    from_pdb(f"{data}/ladder/1m4x.pdb.gz", f"{out}/1m4x.balls", assembly=True)
