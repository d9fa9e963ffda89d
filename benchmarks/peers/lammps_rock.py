"""A rock of bonded discs in LAMMPS's lighter model: harmonic bonds between centres, without bending
or strength, and granular contacts with history beside them. Run by compare.py, as

    python3 lammps_rock.py SPECIMEN STEPS THREADS
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

import rock_file

path, steps, threads = sys.argv[1], int(sys.argv[2]), sys.argv[3]

INPUT = """units si
atom_style hybrid bond sphere
dimension 2
boundary f f p
newton off
comm_modify vel yes
special_bonds lj/coul 1 1 1
read_data rock.data
pair_style gran/hooke/history 1e7 NULL 50 NULL 0.5 1
pair_coeff * *
bond_style harmonic
bond_coeff 1 1e-3 0.008
neighbor 1e-4 bin
neigh_modify delay 0 every 1000000 check no
timestep 1e-8
fix motion all nve/sphere disc
fix plane all enforce2d
run 20
run {steps}
"""


def bonds_of(discs, gap):
    size = 2 * max(radius for _, _, radius in discs) + gap
    cells = {}
    for i, (x, y, _) in enumerate(discs):
        cells.setdefault((int(x // size), int(y // size)), []).append(i)
    for (column, row), members in cells.items():
        near = [j for a in (-1, 0, 1) for b in (-1, 0, 1)
                for j in cells.get((column + a, row + b), ())]
        for i in members:
            x, y, radius = discs[i]
            for j in near:
                if i < j and (discs[j][0] - x) ** 2 + (discs[j][1] - y) ** 2 \
                        <= (radius + discs[j][2] + gap) ** 2:
                    yield i + 1, j + 1


header, discs = rock_file.read(path)
bonds = list(bonds_of(discs, header["bonding_gap"]))
with tempfile.TemporaryDirectory() as folder:
    lines = ["A rock of hfdem's", "", f"{len(discs)} atoms", f"{len(bonds)} bonds", "1 atom types",
             "1 bond types", "12 extra bond per atom", "20 extra special per atom", "",
             f"-0.1 {header['width'] + 0.1} xlo xhi", f"-0.1 {header['height'] + 0.1} ylo yhi",
             "-0.01 0.01 zlo zhi", "", "Atoms # hybrid", ""]
    lines += [f"{i + 1} 1 {x!r} {y!r} 0 1 {2 * radius!r} {header['density']}"
              for i, (x, y, radius) in enumerate(discs)]
    lines += ["", "Bonds", ""] + [f"{k + 1} 1 {a} {b}" for k, (a, b) in enumerate(bonds)]
    pathlib.Path(folder, "rock.data").write_text("\n".join(lines) + "\n", encoding="utf-8")
    pathlib.Path(folder, "in.rock").write_text(INPUT.format(steps=steps), encoding="utf-8")
    command = ["lmp", "-in", "in.rock"]
    if threads != "1":
        command = ["mpirun", "--allow-run-as-root", "-np", threads, *command]
    done = subprocess.run(command, cwd=folder, text=True, capture_output=True, check=False)
loops = re.findall(r"Loop time of (\S+) on", done.stdout)
if len(loops) != 2:
    sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
print(json.dumps({"contacts": len(bonds),
                  "ns_per_contact_step": 1e9 * float(loops[1]) / (steps * len(bonds))}))
