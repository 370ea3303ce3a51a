#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the instructions of a robot-step and fails where they are not those of expected.json.

    check.py                    compares; exits 1 where a count is more than 2 % off, either way, or
                                where two SIMD targets do not end in the same state; 2 where
                                there is no valgrind to count with
    check.py --update REASON    writes the counts found as expected.json, with the reason

Counts do not depend on a clock, on load or on the machine, but on the compiler: with another one
than that of expected.json nothing is compared, and a line says so. callgrind counts within
measured_steps() of the driver alone, on one thread. Valgrind 3.19 has no AVX-512.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXPECTED = HERE / "expected.json"
TOLERANCE = 0.02
TARGETS = ("avx2", "scalar")
# name: scene, built-in or in this folder, steps before, steps counted, settings; circle-100 at its
# densest, and what one robot, one crowd or one model costs
CASES = {
    "circle-100 avo_paper": ("circle-100", 220, 20, "method=avo_paper"),
    "uniform-1000 avo_paper": ("uniform-1000", 20, 10, "method=avo_paper"),
    "circle-100 avo": ("circle-100", 180, 20),
    "uniform-1000 free clocks": ("uniform-1000", 2000, 2000, "clock=free"),
    "uniform-1000 a goal for each": ("uniform-1000", 20, 10, "--goals"),
    "uniform-1000 observed": ("uniform-1000", 20, 10, "--metrics"),
    "crush avo": (HERE / "crush.yaml", 30, 4),
    "one-fast avo": (HERE / "one-fast.yaml", 10, 5),
    "drives-100 avo": ("drives-100", 60, 10),
    "sphere-200 in space": (HERE / "sphere-200.yaml", 50, 5),
    "uniform-1000 noise": ("uniform-1000", 20, 10, "sensing.noise.position=0.01"),
}


class Unavailable(Exception):
    """This machine cannot run a target."""


def count(driver, case, target):
    """What the driver prints, and `instructions` of a robot-step."""
    with tempfile.NamedTemporaryFile() as out:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--toggle-collect=measured_steps",
             "--toggle-collect=measured_steps_in_space",
             f"--callgrind-out-file={out.name}", driver, *map(str, CASES[case])],
            env={**os.environ, "AVO_SIMD": target}, capture_output=True, text=True)
        if run.returncode == 2 and "AVO_SIMD" in run.stderr:
            lines = [line for line in run.stderr.splitlines() if line.startswith("AVO_SIMD")]
            raise Unavailable(*lines)
        if run.returncode != 0:
            sys.exit(f"{case}, {target}: exit code {run.returncode} of\n{run.stderr}")
        total = re.search(r"^totals: (\d+)$", pathlib.Path(out.name).read_text(), re.M)
    found = dict(line.split(" ", 1) for line in run.stdout.splitlines())
    found["instructions"] = int(total[1]) / int(found["robot_steps"])
    return found


def count_all(driver):
    """{case: {target: what count() returns}}, and lines on what this machine cannot run."""
    results, skipped = {case: {} for case in CASES}, []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = {(case, target): pool.submit(count, driver, case, target)
                for case in CASES for target in TARGETS}
        for (case, target), job in jobs.items():
            try:
                results[case][target] = job.result()
            except Unavailable as reason:
                if target == "scalar":
                    sys.exit(str(reason))
                skipped.append(f"SKIPPED {case}, {target}: {reason}")
    return results, skipped


def deviations(expected, found):
    """Rows (case, target, expected, found, deviation) of all counts found, None where not expected."""
    rows = []
    for case, targets in found.items():
        for target, result in targets.items():
            before, now = expected.get(case, {}).get(target), result["instructions"]
            rows.append((case, target, before, now, now / before - 1.0 if before else None))
    return rows


def problems(rows, found):
    lines = []
    for case, target, before, now, deviation in rows:
        if deviation is None:
            lines.append(f"{case}, {target}: found no expected count, see --update")
        elif abs(deviation) > TOLERANCE:
            lines.append(f"{case}, {target}: found {now:.0f} instructions, must be within "
                         f"{TOLERANCE:.0%} of {before:.0f}; an intended change: --update REASON")
    for case, targets in found.items():
        for target, result in targets.items():
            if result["simd"] != target:
                lines.append(f"{case}: found SIMD target {result['simd']}, must be {target}")
        if len({result["hash"] for result in targets.values()}) > 1:
            lines.append(f"{case}: found another state for each SIMD target, must be the same")
    return lines


def print_table(rows):
    print("instructions per robot-step       expected      found  deviation")
    for case, target, before, now, deviation in rows:
        columns = ("-", "-") if deviation is None else (f"{before:.0f}", f"{deviation:+.2%}")
        print(f"{case + ', ' + target:<32}{columns[0]:>10} {now:>10.0f} {columns[1]:>10}")


def update(reason, compiler, found, skipped):
    if skipped:
        sys.exit("--update: found a target that is skipped, must measure all of them")
    cases = {case: {target: round(result["instructions"], 1) for target, result in targets.items()}
             for case, targets in found.items()}
    EXPECTED.write_text(json.dumps({"compiler": compiler, "reason": reason, "cases": cases},
                                   indent=2) + "\n")
    return 0


def compiler_of(found):
    return next(iter(next(iter(found.values())).values()))["compiler"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=HERE.parent.parent / "build/release", type=pathlib.Path)
    parser.add_argument("--update", metavar="REASON")
    arguments = parser.parse_args()
    driver = arguments.build / "bench/avo_bench_instructions"
    if not driver.exists():
        sys.exit(f"{driver}: found no such file, build it first")
    if shutil.which("valgrind") is None:
        print("valgrind: found none in PATH, install it to count instructions", file=sys.stderr)
        return 2
    found, skipped = count_all(driver)
    compiler = compiler_of(found)
    expected = json.loads(EXPECTED.read_text()) if EXPECTED.exists() else {"cases": {}}
    rows = deviations(expected["cases"], found)
    print_table(rows)
    for line in skipped:
        print(line)
    if arguments.update is not None:
        return update(arguments.update, compiler_of(found), found, skipped)
    same_compiler = expected.get("compiler", compiler_of(found)) == compiler_of(found)
    lines = problems(rows if same_compiler else [], found)
    if not same_compiler:
        print(f"SKIPPED: found {compiler_of(found)}, expected.json is of {expected['compiler']}")
    elif not lines:
        print("instructions: as expected")
    for line in lines:
        print(line)
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
