#pragma once

namespace runout {

/// Lets threads that wait for each other spin for microseconds, then sleep. The OpenMP library by default
/// spins for milliseconds, which on a machine that is busy with something else makes two threads slower than
/// one. It reads its setting when the program is loaded, so the program starts itself once more with it;
/// where that fails, or the user has set OMP_WAIT_POLICY or GOMP_SPINCOUNT, nothing happens.
void let_waiting_threads_sleep(char** argv);

}  // namespace runout
