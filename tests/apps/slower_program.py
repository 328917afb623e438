"""Makes a build of the program that draws slower where it is asked to: slower_program.py SOURCE PROGRAM OUTPUT

One function of algorithms/algorithm.cpp reads AR3D_SLOWER="ALGORITHM PERCENT KIND" (ALGORITHM may be "all") and adds to
that algorithm's drawings PERCENT of their time: KIND "wait" waits on the clock, "work" computes, as many steps for every
vertex on every run. It is compiled and linked with the commands of the build that made PROGRAM."""
import pathlib, shlex, subprocess, sys

source, program, output = sys.argv[1:]
build = pathlib.Path(program).resolve().parent.parent
OLD = "  return algorithm.draw(graph, complete_options(algorithm, given));\n"
NEW = """  static const char* const asked = std::getenv("AR3D_SLOWER");
  char name[64] = "", kind[8] = "";
  int percent = 0;
  if (asked != nullptr) std::sscanf(asked, "%63s %d %7s", name, &percent, kind);
  if (algorithm.name != name && std::strcmp(name, "all") != 0) percent = 0;
  const auto now = [] {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec * 1000000000L + time.tv_nsec;
  };
  const long begin = now();
  Drawing drawing = algorithm.draw(graph, complete_options(algorithm, given));
  if (std::strcmp(kind, "wait") == 0) {
    const long end = begin + (now() - begin) * (100 + percent) / 100;
    while (now() < end) {
    }
  }
  // A drawing takes some 1000 instructions and more for every vertex; a step takes two.
  const long steps = std::strcmp(kind, "work") == 0 ? 5L * percent * (graph.num_vertices() + 1) : 0;
  for (long i = 0; i < steps; ++i) asm volatile("" : : "r"(i));
  return drawing;
"""
text = pathlib.Path(source, "algorithms/algorithm.cpp").read_text()
assert text.count(OLD) == 1, "algorithms/algorithm.cpp has another draw()"
changed, compiled = output + ".cpp", output + ".o"
headers = "".join(f"#include <{name}>\n" for name in ["cstdio", "cstdlib", "cstring", "ctime"])
pathlib.Path(changed).write_text(headers + text.replace(OLD, NEW))

commands = subprocess.run(["ninja", "-t", "commands", "apps/ar3d"], cwd=build, check=True, capture_output=True, text=True).stdout
commands = [shlex.split(line) for line in commands.splitlines()]


def run(command, replacements):
    for option, value in replacements.items():
        command[command.index(option) + 1] = value
    subprocess.run(command, cwd=build, check=True)


# Alone, or among the sources that are compiled together with it.
path = str(pathlib.Path(source, "algorithms/algorithm.cpp"))
compile_it, = [c for c in commands if c[-1].endswith((".cpp", ".cxx")) and (c[-1] == path or path in pathlib.Path(build, c[-1]).read_text())]
if compile_it[-1] != path:
    together = pathlib.Path(build, compile_it[-1]).read_text()
    pathlib.Path(output + ".cxx").write_text(together.replace(path, str(pathlib.Path(changed).resolve())))
    changed = output + ".cxx"
run(compile_it, {"-o": compiled, "-c": changed, "-MF": compiled + ".d"})
link = [word for word in commands[-1] if word not in (":", "&&")]
link.insert(link.index("-o"), compiled)
run(link, {"-o": output})
