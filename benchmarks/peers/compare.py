"""hfdem beside Yade on the same bonded rock, in turns: nanoseconds of a contact in a mechanical step.

    python3 benchmarks/peers/compare.py build/release/benchmarks [--rounds 5] [--threads 1]

Needs Debian's package yade. LAMMPS's lighter model (harmonic bonds and granular contacts with
history) runs beside them if `lmp` is installed. You should see hfdem need about 1/50 of the time
of Yade's law with bond moments (docs/performance.md).
"""

import argparse
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def result(command, begins=""):
    done = subprocess.run(list(map(str, command)), text=True, capture_output=True, check=False,
                          env={**os.environ, "PYTHONPATH": str(HERE)})  # for rock_file
    lines = [line for line in done.stdout.splitlines() if line.startswith(begins + "{")]
    if not lines:
        sys.exit(f"{command[0]} printed no result:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return json.loads(lines[-1][len(begins):])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=pathlib.Path, help="folder with peer_steps")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--discs", type=int, default=17511)
    parser.add_argument("--steps", type=int, default=100, help="of Yade; hfdem makes 50 times as many")
    options = parser.parse_args()
    ours = options.programs.resolve() / "peer_steps"
    with tempfile.TemporaryDirectory() as folder:
        rock = pathlib.Path(folder) / "rock.txt"
        subprocess.run([ours, "--make", rock, "--discs", str(options.discs)], check=True)

        def yade(law):
            return ["yade", "-n", "-x", f"-j{options.threads}", HERE / "yade_rock.py", rock, law,
                    options.steps]

        works = {"hfdem, LinearParallelBond": ([ours, rock, "--steps", 50 * options.steps,
                                                "--threads", options.threads], "")}
        if shutil.which("yade"):
            works["Yade, CohFrict with bond moments"] = (yade("cohfrict"), "RESULT ")
            works["Yade, JCFpm"] = (yade("jcfpm"), "RESULT ")
        if shutil.which("lmp"):
            works["LAMMPS, harmonic bonds and granular history"] = (
                [sys.executable, HERE / "lammps_rock.py", rock, options.steps, options.threads], "")
        found = {name: [] for name in works}
        for turn in range(options.rounds):
            order = list(works)
            for name in order[turn % len(order):] + order[:turn % len(order)]:
                found[name].append(result(*works[name]))
        base = [r["ns_per_contact_step"] for r in found["hfdem, LinearParallelBond"]]
        print("| code and law | contacts | ns per contact-step | over hfdem |\n|---|---|---|---|")
        for name, results in found.items():
            times = [r["ns_per_contact_step"] for r in results]
            ratio = statistics.median(t / b for t, b in zip(times, base))
            print(f"| {name} | {results[0]['contacts']} | {statistics.median(times):.1f} "
                  f"| {ratio:.1f} |")


if __name__ == "__main__":
    main()
