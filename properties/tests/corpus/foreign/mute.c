/* A library that is no solver. */
int plumb_solver_version(void);
int plumb_solver_version(void) {
  return 1;
}
