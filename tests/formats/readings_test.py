"""Files as people have them, after bug reports of networkx, igraph, Graphviz, Gephi, pandas and R, and every way to write a file wrongly:
each line of readings.tsv is a file's name, options and text, and what is read of it: graphs as "n m" with " / " between them and notes
behind " | ", or the message that refuses it, with line, column, value and what to do. readings_test.py AR3D CLASS"""
import glob
import json
import os
import re
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCES = sorted(glob.glob(HERE + "/../../formats/graphs/*.cpp"))
LITERALS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
# Texts of the sources that are no message: what a format is, what a writer writes, what a beginning is; and two that need gigabytes.
OTHERS = re.compile(r'^ *(summary|"[^"]*summary)|^(  (node|edge) \[|<|% METIS|\{\} matrix coordinate pattern symm|graph 1, order|leda\.graph|SQLite format)'
                    r"|would be gigabytes|ids fit 32 bits|edges claimed by \{\} bytes|subgraphs in each other|equal sizes|starts_with")


def cases():
    with open(HERE + "/readings.tsv", encoding="utf-8") as table:
        for line in table:
            if not line.startswith("# "):
                name, options, text, meant = line.rstrip("\n").split("\t")
                yield name, options, json.loads('"' + text.replace('"', '\\"') + '"').encode("latin1"), meant


class FilesAsPeopleHaveThem(unittest.TestCase):
    def test_each_is_read_as_meant_or_refused(self):
        with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:
            program = subprocess.Popen([os.environ["AR3D_READ_MANY"]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
            for name, options, text, meant in cases():
                with open(f"{folder}/{name}", "wb") as file:
                    file.write(text)
                program.stdin.write(f"{folder}/{name}\t{options}\n")
                program.stdin.flush()
                answer = json.loads(program.stdout.readline())
                graphs = " / ".join(f"{graph['n']} {len(graph['edges'])}" for graph in answer.get("graphs", []))
                found = answer.get("refused") or " | ".join([graphs, *answer["notes"]])
                self.assertEqual(found.replace(folder + "/", ""), meant, f"{name} {options} {text}")
            program.stdin.close()
            program.stdout.close()
            program.wait()

    def test_every_message_of_the_readers_is_in_the_table(self):
        meant = "\n".join(case[3] for case in cases())
        for path in SOURCES:
            with open(path, encoding="utf-8") as file:
                source = re.sub(r"(?m)//.*$|\.summary =\s*(\"[^\n]*\s*)+", "", file.read())
            for literal in LITERALS.finditer(source):
                text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literal[0])).replace('\\"', '"').replace("\\\\", "\\")
                if len(re.findall(r"[a-zA-Z]{2,}", text)) > 1 and " " in text and not OTHERS.search(text):
                    pattern = ".*".join(re.escape(part) for part in re.split(r"\{[^{}]*\}", text))
                    self.assertIsNotNone(re.search(pattern, meant, re.I), f"{os.path.basename(path)}: {text}")


if __name__ == "__main__":
    import sys
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
