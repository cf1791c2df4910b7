// What the engine's parts cost by size. Read ratios within one run, not seconds:
//
//     build/release/tests/engine_bench                               all
//     build/release/tests/engine_bench --benchmark_filter=Step       whole steps from 3,000 to 300,000
//     particles
//
// `per_particle` is the time of one call over the number of particles; `iterations` those of a pressure
// solve.

#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/pairs/neighbours.h"
#include "engine/pairs/operators.h"
#include "engine/pressure/pressure_solver.h"
#include "engine/simulation.h"
#include "filled_box.h"
#include "scene/make_problem.h"
#include "scenes.h"

namespace runout {
namespace {

using namespace filled_box;

constexpr double gravity = 9.81;

int cells_for(const benchmark::State& state) {
    return static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)))));
}

void count_per_particle(benchmark::State& state, int particles) {
    state.counters["per_particle"] = benchmark::Counter(
        particles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// a = b + s c over arrays far larger than the caches: what the memory gives, bytes per second.
void MemoryTriad(benchmark::State& state) {
    const std::size_t size = 1 << 24;
    std::vector<double> a(size, 0.0), b(size, 1.0), c(size, 2.0);
    for (auto _ : state) {
        for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 3.0 * c[i];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(static_cast<long>(state.iterations() * 3 * size * sizeof(double)));
}

void FindNeighbours(benchmark::State& state) {
    Filled f(cells_for(state));
    for (auto _ : state) f.search.find(f.soil, f.wall, f.neighbours);
    count_per_particle(state, f.soil.count);
}

/// Bytes of the pair rows that one pass of the divergence streams: column, gx, gy.
void StressDivergence(benchmark::State& state) {
    Filled f(cells_for(state));
    std::vector<FloatPair> stress(f.neighbours.nodes, FloatPair{1.0F, 0.5F});
    std::vector<FloatPair> force(f.neighbours.nodes);
    std::size_t pairs = 0;
    for (const PairBlock& block : f.neighbours.blocks)
        pairs += static_cast<std::size_t>(block.offset[slices_per_block]);
    for (auto _ : state) {
        for (const PairBlock& block : f.neighbours.blocks)
            pair_kernels().stress_divergence(pair_rows(block, f.neighbours), stress.data(), force.data());
        benchmark::ClobberMemory();
    }
    count_per_particle(state, f.soil.count);
    state.SetBytesProcessed(static_cast<long>(state.iterations() * pairs * 12));
    state.counters["flops"] =
        benchmark::Counter(static_cast<double>(pairs) * 10.0, benchmark::Counter::kIsIterationInvariantRate);
}

void PressureProduct(benchmark::State& state) {
    Filled f(cells_for(state));
    std::vector<double> x(f.neighbours.nodes, 1.0);
    std::vector<double> out(f.neighbours.nodes);
    for (auto _ : state) {
        for (const PairBlock& block : f.neighbours.blocks)
            pair_kernels().pressure_product(pair_rows(block, f.neighbours), x.data(), x.data(), out.data());
        benchmark::ClobberMemory();
    }
    count_per_particle(state, f.soil.count);
}

/// From nothing to a relative residual of 1e-2: harder than in a run, which starts from the last pressure.
void PressureSolve(benchmark::State& state) {
    const int cells = cells_for(state);
    Filled f(cells);
    PressureSolver solver(f.d, gravity, 1.0, 1e-2);
    const NodeVectors velocity = even_velocity(f, {0.0, -gravity * 1e-3});
    NodeVectors gradient;
    int iterations = 0;
    for (auto _ : state) {
        std::fill(f.soil.pressure.begin(), f.soil.pressure.end(), 0.0);
        iterations = solver.solve(f, velocity, {1e-3, 0.0, false}, gradient).iterations;
    }
    count_per_particle(state, f.soil.count);
    state.counters["iterations"] = iterations;
}

/// One step of the column of aluminium bars in full flow, on `range(1)` threads.
void Step(benchmark::State& state) {
    Scene scene = scenes::aluminium_column(21.9, std::sqrt(0.02 / static_cast<double>(state.range(0))));
    scene.run.threads = static_cast<int>(state.range(1));
    Simulation simulation(make_problem(scene));
    while (!simulation.released() || simulation.work().steps < 30) simulation.step();
    const WorkCounts before = simulation.work();
    const PhaseClock clock_before = simulation.clock();
    for (auto _ : state) simulation.step();
    const WorkCounts& after = simulation.work();
    count_per_particle(state, static_cast<int>(simulation.state().x.size()));
    state.counters["iterations"] =
        static_cast<double>(after.pressure_iterations - before.pressure_iterations) /
        static_cast<double>(after.steps - before.steps);
    for (const Phase phase : {Phase::neighbours, Phase::friction, Phase::pressure, Phase::motion}) {
        state.counters[to_string(phase)] =  // ns per particle and step
            1e9 * (simulation.clock().seconds(phase) - clock_before.seconds(phase)) /
            static_cast<double>(after.steps - before.steps) /
            static_cast<double>(simulation.state().x.size());
    }
}

BENCHMARK(MemoryTriad)->Unit(benchmark::kMillisecond);
BENCHMARK(FindNeighbours)->Arg(3000)->Arg(30000)->Arg(300000);
BENCHMARK(StressDivergence)->Arg(3000)->Arg(30000)->Arg(300000);
BENCHMARK(PressureProduct)->Arg(3000)->Arg(30000)->Arg(300000);
BENCHMARK(PressureSolve)->Arg(3000)->Arg(30000)->Arg(300000);
BENCHMARK(Step)
    ->ArgNames({"particles", "threads"})
    ->Args({3000, 1})
    ->Args({10000, 1})
    ->Args({30000, 1})
    ->Args({100000, 1})
    ->Args({300000, 1})
    ->Args({10000, 2})
    ->Args({30000, 2})
    ->Args({100000, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
// Two at once, each on one thread and on its own: what a second core of this machine is worth at most. The
// time is that of one step of either, over two.
BENCHMARK(Step)
    ->ArgNames({"particles", "threads"})
    ->Args({10000, 1})
    ->Args({30000, 1})
    ->Args({100000, 1})
    ->Threads(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace runout

BENCHMARK_MAIN();
