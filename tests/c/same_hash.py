#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails unless COMMAND, which is given the hash that PROGRAM prints, prints it too.

usage: same_hash.py PROGRAM COMMAND...
"""
import subprocess
import sys


def output(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main():
    program, *command = sys.argv[1:]
    expected = output([program])
    said = output([*command, expected])
    print(said, end="")
    if f"state hash {expected}\n" not in said or "100" not in said:
        sys.exit(f"must say 100 arrivals and state hash {expected}")


if __name__ == "__main__":
    main()
