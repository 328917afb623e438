#include "ar3d/apps/program.h"

int main(int argc, char** argv) { return ar3d::run_program(argc, argv); }
