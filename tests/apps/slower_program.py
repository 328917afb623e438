"""Makes a build of the program that draws slower: slower_program.py SOURCE PROGRAM PERCENT OUTPUT

One function of algorithms/catalog.cpp waits after each drawing for PERCENT of its time; it is compiled and linked with
the commands of the build that made PROGRAM."""
import pathlib, shlex, subprocess, sys

source, program, percent, output = sys.argv[1:]
build = pathlib.Path(program).resolve().parent.parent
OLD = "  return algorithm.draw(graph, complete_options(algorithm, given));\n"
NEW = f"""  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  Drawing drawing = algorithm.draw(graph, complete_options(algorithm, given));
  const auto end = begin + (Clock::now() - begin) * (100 + {percent}) / 100;
  while (Clock::now() < end) {{
  }}
  return drawing;
"""
text = pathlib.Path(source, "algorithms/catalog.cpp").read_text()
assert text.count(OLD) == 1, "algorithms/catalog.cpp has another draw()"
changed, compiled = output + ".cpp", output + ".o"
pathlib.Path(changed).write_text("#include <chrono>\n" + text.replace(OLD, NEW))

commands = subprocess.run(["ninja", "-t", "commands", "apps/ar3d"], cwd=build, check=True, capture_output=True, text=True).stdout
commands = [shlex.split(line) for line in commands.splitlines()]


def run(command, replacements):
    for option, value in replacements.items():
        command[command.index(option) + 1] = value
    subprocess.run(command, cwd=build, check=True)


compile_it, = [c for c in commands if c[-1].endswith("algorithms/catalog.cpp")]
run(compile_it, {"-o": compiled, "-c": changed, "-MF": compiled + ".d"})
link = [word for word in commands[-1] if word not in (":", "&&")]
link.insert(link.index("-o"), compiled)
run(link, {"-o": output})
