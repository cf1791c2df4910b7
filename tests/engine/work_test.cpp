// What a run may cost, in counts that are the same on every machine: steps, solver iterations, allocations.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "engine/simulation.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Every allocation of the program under test is counted; the replaced functions must be global. Inlined, new
// and free look mismatched to g++.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace runout {
namespace {

TEST(Work, StepsDoNotAllocateOnceTheyAreWarm) {
    Scene scene = scenes::aluminium_column(21.9, 0.004);
    scene.run.threads = 1;
    Simulation simulation(make_problem(scene));
    while (simulation.time() < 0.4) simulation.step();
    const long before = allocations;
    const long steps_before = simulation.work().steps;
    while (simulation.time() < 0.7) simulation.step();
    EXPECT_GT(simulation.work().steps, steps_before + 100);
    // All that is left is the room of a block of rows that reaches the bed with more pairs than ever before.
    // (CHOLMOD takes memory past this count, for each new factor of the coarse level.)
    EXPECT_LE(allocations - before, 5);
}

TEST(Work, FreeFlightDoesNotAllocate) {
    Scene scene = scenes::aluminium_column(21.9, 0.004);
    for (Vec2& corner : scene.source.outline) corner += Vec2{0.1, 0.3};  // off bed and wall
    Simulation simulation(make_problem(scene));
    while (simulation.time() < 0.05) simulation.step();
    const long before = allocations;
    while (simulation.time() < 0.15) simulation.step();
    EXPECT_EQ(simulation.work().flying_particle_steps, simulation.work().particle_steps);
    EXPECT_EQ(allocations - before, 0);
}

TEST(Work, AColumnTakesSoManyStepsAndIterations) {
    Scene scene = scenes::aluminium_column(21.9, 0.004);
    Simulation simulation(make_problem(scene));
    while (simulation.status() == RunStatus::running) simulation.step();
    const WorkCounts& work = simulation.work();
    EXPECT_LT(work.steps, 1300);
    EXPECT_LT(work.pressure_iterations, 8 * work.steps);
    EXPECT_EQ(work.unconverged_solves, 0);
}

}  // namespace
}  // namespace runout
