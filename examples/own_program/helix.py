# helix.py
import json, math, sys

for header in sys.stdin:                                              # "n m", then m lines "u v"
    n, m = map(int, header.split())
    edges = [tuple(map(int, sys.stdin.readline().split())) for _ in range(m)]
    turn = [2 * math.pi * v / n for v in range(n)]
    vertices = [[round(math.cos(t), 9), round(math.sin(t), 9), round(t, 9)] for t in turn]
    print(json.dumps({"vertices": vertices}), flush=True)             # straight edges
