// A slab on a plane steeper than it can stand accelerates with g (sin t - sin(phi) cos t).
#include <runout/engine/simulation.h>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
    const double slope = std::numbers::pi / 4, friction_angle = 30 * std::numbers::pi / 180;
    const double spacing = 0.005, length = 150 * spacing, height = 10 * spacing;
    const runout::Vec2 down{std::cos(slope), -std::sin(slope)}, up{std::sin(slope), std::cos(slope)};
    const runout::Vec2 start = length / 3 * down;

    runout::Problem problem;
    problem.mass.outline = {start, start + length * down, start + length * down + height * up,
                            start + height * up};
    problem.mass.ground = {{0, 0}, 3 * length * down};
    problem.mass.area = length * height;
    problem.material.friction_angle = friction_angle;
    problem.settings.particle_spacing = spacing;
    problem.settings.threads = 1;

    runout::Simulation simulation(problem);
    while (simulation.status() == runout::RunStatus::running && simulation.time() < 0.1) simulation.step();

    const runout::StateView state = simulation.state();
    double speed = 0;
    int counted = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        const double along = (runout::Vec2{state.x[i], state.y[i]} - start).dot(down);
        if (std::abs(along - 0.5 * length) > 0.25 * length) continue;  // away from the ends
        speed += runout::Vec2{state.vx[i], state.vy[i]}.dot(down);
        ++counted;
    }
    const double measured = speed / counted / simulation.time();
    const double exact =
        problem.settings.gravity * (std::sin(slope) - std::sin(friction_angle) * std::cos(slope));
    std::printf("acceleration %.3f m/s2, exact %.3f\n", measured, exact);
    return std::abs(measured / exact - 1) < 0.03 ? 0 : 1;
}
