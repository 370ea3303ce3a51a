# SPDX-License-Identifier: Apache-2.0
"""Exports as MCAP, read by @mcap/core and protobufjs: read_mcap.mjs. The packages come from npm, once, as locked."""
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from exported import Exported

SOURCE = pathlib.Path(__file__).resolve().parent / "node"
FOLDER = pathlib.Path(sys.argv[1]) / "node"
NPM = ("npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund")


def fetch_packages():
    if os.environ.get("AVO_NETWORK") != "1":
        print("skipped: npm fetches packages from the network only with AVO_NETWORK=1")
        sys.exit(77)
    for program in ("node", "npm"):
        if shutil.which(program) is None:
            sys.exit(f"{program}: found none, must be there: packages-test.txt")
    lock, stamp = SOURCE / "package-lock.json", FOLDER / "fetched"
    FOLDER.mkdir(parents=True, exist_ok=True)
    for path in SOURCE.iterdir():
        shutil.copy(path, FOLDER)
    if stamp.exists() and stamp.read_bytes() == lock.read_bytes():
        return
    done = subprocess.run(NPM, cwd=FOLDER, capture_output=True, text=True)
    if done.returncode != 0:
        why = [line for line in done.stderr.splitlines() if "npm" in line and "warn" not in line]
        sys.exit(f"{' '.join(NPM)}: found no packages, must fetch those of {lock.name}: {why[0] if why else ''}")
    stamp.write_bytes(lock.read_bytes())


class Npm(Exported):
    def test_reads_every_message(self):
        for scene, walls, *arguments in (("circle-100", 0, "--duration", 30), ("doorway", 3, "--duration", 5),
                                         ("circle-5", 0, "--set", "clock=free", "--duration", 3)):
            recording = self.record(scene, *arguments, name=f"{scene}.h5")
            paths = [self.convert(recording, name) for name in ("out.mcap", "out.csv")]
            done = subprocess.run(["node", "read_mcap.mjs", *map(str, paths), str(walls)], cwd=FOLDER,
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, r"^\d+ messages\n$")


fetch_packages()
unittest.main(argv=sys.argv[:1])
