# SPDX-License-Identifier: Apache-2.0
"""Multi-robot collision avoidance that respects acceleration limits. SI units."""
from ._avo import *
