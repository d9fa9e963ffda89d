"""Runs that are killed or asked to stop, and resumed: the results of a run without a break.

    python3 tests/programs/checkpoint_test.py build/release/examples
"""

import json
import math
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAMS = pathlib.Path(sys.argv.pop(1))
KGD, TOUGHNESS, INTACT = PROGRAMS / "kgd", PROGRAMS / "toughness", PROGRAMS / "intact"
FRACTURED = PROGRAMS / "fractured"
SMALL_ROCK = ("--quick", "--set", "specimen.width=0.12", "--set", "specimen.height=0.12",
              "--set", "specimen.grains=250", "--set", "run.end_time=0.02",
              "--set", "run.snapshot_interval=0.002")
SHORT_SLITS = ("--quick", "--set", "specimen.columns=20", "--set", "specimen.rows=20",
               "--set", "slits.shortest=4", "--set", "slits.longest=8")
# What the clock and the command line set, and nothing else, may differ.
VARYING = ("wall_s", "particle_steps_per_s", "threads")


def work_of(process):
    """Processor time that a process has had, s: on a busy machine it says how far a run has come,
    which the time of day does not."""
    try:
        return time.clock_gettime(~process.pid << 3 | 2)  # clock_getcpuclockid(3)
    except OSError:  # it has ended
        return math.inf


class CheckpointTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.random = random.Random(1)

    def path(self, name):
        return self.folder / name

    def run_program(self, program, *options, status=0):
        done = subprocess.run([program, "--quiet", *map(str, options)], text=True, capture_output=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def work_of_the_whole(self, program, *options):
        """Makes the run that the others are compared with; its processor time, s."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.run_program(program, "--out", self.path("whole"), *options)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def interrupt(self, program, name, *options, by, after=0.0):
        """Starts or resumes a run in a folder, and sends a signal some seconds of its own work after
        it has begun to write; its exit status and words."""
        folder = self.path(name)
        begin = ("--resume", folder) if (folder / "checkpoint").exists() else ("--out", folder)
        config = folder / "config.toml"
        before = config.stat().st_ino if config.exists() else 0
        process = subprocess.Popen([program, "--quiet", *map(str, begin + options)], text=True,
                                   stderr=subprocess.PIPE)
        while process.poll() is None and (not config.exists() or config.stat().st_ino == before):
            time.sleep(0.001)
        until = work_of(process) + after
        while process.poll() is None and work_of(process) < until:
            time.sleep(0.001)
        process.send_signal(by)
        _, words = process.communicate()
        return process.returncode, words

    def check_same_results(self, one, other):
        files = [sorted(p.relative_to(self.path(f)) for p in self.path(f).rglob("*") if p.is_file())
                 for f in (one, other)]
        self.assertEqual(*files)
        for name in files[0]:
            a, b = ((self.path(f) / name).read_bytes() for f in (one, other))
            if name.name == "summary.json":
                a, b = (json.loads(text) for text in (a, b))
                for varying in VARYING:
                    a.pop(varying, None), b.pop(varying, None)
            if name.name != "report.html":
                self.assertTrue(a == b, f"{name} differs")

    def check_killed(self, kills, *options, program=KGD, threads=("1",)):
        """Kills a run at random moments until `kills` of them have hit it, a third of them a run
        that had been resumed, and lets it finish."""
        longest = self.work_of_the_whole(program, *options)
        hits = resumed = 0
        while hits < kills or resumed < kills / 3:
            resumes = (self.path("killed") / "checkpoint").exists()
            status, words = self.interrupt(
                program, "killed", *(() if resumes else options), "--checkpoint", "0.005", "--threads",
                self.random.choice(threads), after=self.random.uniform(0, 0.7 * longest),
                by=signal.SIGKILL)
            if status != 0:
                self.assertEqual(status, -signal.SIGKILL, words)
                hits += 1
                resumed += resumes
            else:
                self.check_same_results("whole", "killed")
                shutil.rmtree(self.path("killed"))  # once more from the beginning
        if (self.path("killed") / "checkpoint").exists():
            self.run_program(program, "--resume", self.path("killed"))
            self.check_same_results("whole", "killed")

    def test_a_run_killed_at_twenty_moments_gives_the_same_bytes(self):
        # A crack that grows fast, and snapshots so often that kills hit those files, too.
        self.check_killed(20, "--quick", "--set", "injection.rate=3e-4", "--set", "run.end_time=0.03",
                          "--set", "run.snapshot_interval=0.001")

    def test_the_books_of_energy_go_on_too(self):
        self.check_killed(3, "--quick", "--set", "injection.rate=3e-4", "--set", "run.end_time=0.01",
                          "--set", "run.energy=true")

    def test_a_larger_run_on_any_number_of_threads_too(self):
        self.check_killed(3, "--set", "specimen.columns=50", "--set", "specimen.rows=50",
                          "--set", "scheme.equilibrium=true", "--set", "run.end_time=0.006",
                          "--set", "boundary.kind=dead_loads", threads=("1", "2", "3"))

    def test_fluid_that_flows_goes_on_too(self):
        # The scheme is not asked for again.
        for scheme in ("implicit", "conventional"):
            self.check_killed(3, "--quick", "--scheme", scheme, "--set", "run.end_time=0.004", "--set",
                              "fluid.viscosity=0.1", "--set", "injection.rate=3e-4", threads=("1", "2"))
            shutil.rmtree(self.path("whole"))
            shutil.rmtree(self.path("killed"), ignore_errors=True)

    def test_a_random_rock_killed_at_twenty_moments_gives_the_same_bytes(self):
        self.check_killed(20, *SMALL_ROCK, "--set", "run.energy=true", program=INTACT)

    def test_a_fractured_rock_goes_on_with_its_own_fractures(self):
        fractures = self.path("mine.csv")
        fractures.write_text("x1_m,y1_m,x2_m,y2_m\n0.02,0.08,0.055,0.1\n0.07,0.02,0.1,0.035\n")
        # Without the file that they came from.
        self.check_killed(4, *SMALL_ROCK, "--fractures", fractures, program=FRACTURED)

    def check_asked_to_stop(self, program, *options, keep=()):
        """Asks a run to stop a few times, some part of its work apart, and lets it finish."""
        whole = self.work_of_the_whole(program, *options, *keep)
        stops = 0
        for _ in range(3):
            status, words = self.interrupt(program, "stopped", *(() if stops else options), *keep,
                                           by=signal.SIGTERM, after=0.2 * whole)
            if status == 0:
                break
            self.assertEqual(status, 4, words)
            self.assertIn("--resume " + str(self.path("stopped")), words)
            stops += 1
        self.assertGreater(stops, 0)
        if status != 0:
            self.run_program(program, "--resume", self.path("stopped"), *keep)
        self.check_same_results("whole", "stopped")

    def test_several_rocks_go_on_in_the_middle_of_one(self):
        rock = pathlib.Path(__file__).resolve().parents[2] / "examples/data/rock.toml"
        self.check_asked_to_stop(INTACT, *SMALL_ROCK, "--toughness", rock, keep=("--seeds", "3"))

    def test_rock_tests_and_a_study_of_parameters_go_on_too(self):
        self.check_asked_to_stop(PROGRAMS / "rock_tests", "--quick")
        shutil.rmtree(self.path("whole"))
        shutil.rmtree(self.path("stopped"))
        self.check_asked_to_stop(PROGRAMS / "sensitivity", *SMALL_ROCK,
                                 keep=("--seeds", "2", "--vary", "contact.friction=0.2"))

    def test_a_stopped_run_killed_on_its_way_stops_at_the_same_place(self):
        toughness = pathlib.Path(__file__).resolve().parents[2] / "examples/data/toughness.toml"
        options = ("--quick", "--set", "run.end_time=2", "--set", "injection.rate=3e-4",
                   "--toughness", toughness)
        self.run_program(KGD, "--out", self.path("whole"), *options, status=3)
        status, words = self.interrupt(KGD, "killed", *options, by=signal.SIGTERM)
        self.assertEqual(status, 4, words)
        self.run_program(KGD, "--resume", self.path("killed"), status=3)
        self.check_same_results("whole", "killed")
        summary = json.loads((self.path("killed") / "summary.json").read_text())
        self.assertIn("in_infinite_plane", summary["toughness"])  # the prediction is not forgotten

    def test_asked_to_stop_it_saves_and_says_how_to_go_on(self):
        options = ("--quick", "--set", "scheme.equilibrium=true")
        whole = self.work_of_the_whole(KGD, *options)
        reached = 0.0
        for by, begin in ((signal.SIGTERM, options), (signal.SIGINT, ())):
            status, words = self.interrupt(KGD, "asked", *begin, by=by, after=0.2 * whole)
            self.assertEqual(status, 4, words)
            said = re.fullmatch(r"kgd: interrupted at t = (\S+) s; go on with --resume (\S+)\n", words)
            self.assertEqual(said.group(2), str(self.path("asked")))
            self.assertFalse((self.path("asked") / "summary.json").exists())
            self.assertGreater(float(said.group(1)), reached)
            reached = float(said.group(1))
        self.run_program(KGD, "--resume", self.path("asked"))
        self.check_same_results("whole", "asked")

    def test_the_report_of_a_resumed_run_is_that_of_the_whole(self):
        self.run_program(KGD, "--resume", self.unfinished())
        page = (self.path("out") / "report.html").read_text()
        self.assertIn(f"--out {self.path('out')} --quick", page)
        self.assertNotIn("--resume", page)

    def test_slits_are_not_tested_twice(self):
        self.run_program(TOUGHNESS, "--out", self.path("whole"), *SHORT_SLITS)
        status, words = self.interrupt(TOUGHNESS, "killed", *SHORT_SLITS, by=signal.SIGTERM)
        self.assertEqual(status, 4, words)
        self.assertIn("interrupted after slit 1 of 3; go on with --resume", words)
        status, words = self.interrupt(TOUGHNESS, "killed", by=signal.SIGTERM)
        self.assertIn("interrupted after slit 2 of 3", words)
        self.run_program(TOUGHNESS, "--resume", self.path("killed"))
        self.check_same_results("whole", "killed")

    def unfinished(self):
        """The folder of a run that was stopped at one of its first fluid steps, of which it has so
        many that it does not end before it is asked."""
        status, words = self.interrupt(KGD, "out", "--quick", "--set", "run.end_time=0.01",
                                       "--set", "scheme.fluid_dt=1e-6", by=signal.SIGTERM)
        self.assertEqual(status, 4, words)
        return self.path("out")

    def test_a_new_run_does_not_destroy_an_unfinished_one_unasked(self):
        out = self.unfinished()
        before = {p: p.read_bytes() for p in out.rglob("*") if p.is_file()}
        words = self.run_program(KGD, "--out", out, "--quick", status=2).stderr
        self.assertIn(f"{out} holds an unfinished run: go on with it by --resume {out}", words)
        self.assertIn("--overwrite", words)
        self.assertEqual(before, {p: p.read_bytes() for p in out.rglob("*") if p.is_file()})
        options = ("--quick", "--set", "run.end_time=0.02")
        self.run_program(KGD, "--out", out, *options, "--overwrite")
        self.run_program(KGD, "--out", self.path("whole"), *options)
        self.check_same_results("whole", "out")
        self.run_program(KGD, "--out", out, *options)  # a finished one is replaced as ever

    def test_a_checkpoint_that_does_not_fit_is_refused_with_what_and_where(self):
        out = self.unfinished()
        file, config = out / "checkpoint", out / "config.toml"
        sound, parameters = file.read_bytes(), config.read_text()

        def refused(*words, program=KGD):
            history = (out / "history.csv").read_bytes()
            done = self.run_program(program, "--resume", out, status=2)
            for word in words:
                self.assertIn(word, done.stderr)
            self.assertEqual((out / "history.csv").read_bytes(), history)

        for place in (0, 13, 20, 100, len(sound) // 2, len(sound) - 1):
            file.write_bytes(sound[:place] + bytes([sound[place] ^ 4]) + sound[place + 1:])
            refused(str(file))
        for length in (0, 5, 20, len(sound) // 2, len(sound) - 1):
            file.write_bytes(sound[:length])
            refused(str(file))
        file.write_bytes(sound)
        config.write_text(parameters.replace("1.7e+10", "1.8e+10", 1))
        refused(str(file), "belongs to other parameters: there contact.E = 1.7e+10", "1.8e+10")
        config.write_text("")
        refused(str(file), "belongs to other parameters", "specimen.columns = 40",
                "specimen.columns = 100")
        config.write_text(parameters)
        shutil.copy(out / "history.csv", self.path("history"))
        (out / "history.csv").write_text("time_s\n")
        refused("history.csv holds 7 bytes, and held", "at the checkpoint")
        shutil.copy(self.path("history"), out / "history.csv")
        file.unlink()
        refused("nothing to resume in " + str(out))
        file.write_bytes(sound)
        self.run_program(KGD, "--resume", out)

    def test_the_checkpoint_of_another_program_is_refused(self):
        self.interrupt(TOUGHNESS, "slits", *SHORT_SLITS, by=signal.SIGTERM)
        kgd = self.unfinished()
        (self.path("slits") / "checkpoint").replace(kgd / "checkpoint")
        words = self.run_program(KGD, "--resume", kgd, status=2).stderr
        self.assertIn("was made by the program toughness, not by kgd", words)

    def test_the_command_line_of_a_resumed_run(self):
        out = self.unfinished()
        for options in (("--set", "contact.E=1e9"), ("--quick",), ("--config", out / "config.toml"),
                        ("--out", out), ("--overwrite",), ("--toughness", out / "config.toml")):
            self.assertIn("--resume", self.run_program(KGD, "--resume", out, *options, status=2).stderr)
        self.assertIn("--out", self.run_program(KGD, status=2).stderr)
        self.run_program(KGD, "--out", self.path("new"), "--checkpoint", "-1", status=2)
        self.run_program(KGD, "--resume", self.path("nowhere"), status=2)


if __name__ == "__main__":
    unittest.main()
