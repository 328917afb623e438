#!/usr/bin/env python3
"""A program that draws any graph without crossings: vertex i at (i, i^2, i^3), edges straight."""

import json
import sys

for head in sys.stdin:
    n, m = map(int, head.split())
    for _ in range(m):
        next(sys.stdin)
    print(json.dumps({"vertices": [[i, i * i, i ** 3] for i in range(n)]}), flush=True)
