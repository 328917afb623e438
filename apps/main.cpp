// The program is a library, so that programs with algorithms of their own have all verbs, too
// (examples/own_algorithm).
#include "ar3d/apps/program.h"

int main(int argc, char** argv) { return ar3d::run_program(argc, argv); }
