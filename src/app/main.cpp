#include "app/program.h"

int main(int argc, char** argv) { return raywalk::run_program(argc, argv); }
