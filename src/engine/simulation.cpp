#include "engine/simulation.h"

#include "engine/pairs/operators.h"
#include "engine/stepper.h"

namespace runout {
namespace {

Packing packing_of(const Problem& problem) {
    const SolverSettings& settings = problem.settings;
    return pack_mass(problem.mass, settings.particle_spacing, settings.smoothing_ratio,
                     settings.lattice_seed);
}

}  // namespace

Simulation::Simulation(const Problem& problem) : Simulation(problem, packing_of(problem)) {}

Simulation::Simulation(const Problem& problem, const Packing& packing)
    : stepper_(std::make_unique<Stepper>(problem, packing)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&& other) noexcept = default;
Simulation& Simulation::operator=(Simulation&& other) noexcept = default;

void Simulation::step() {
    stepper_->step();
}

void Simulation::end_at_rest() {
    stepper_->end_at_rest();
}

RunStatus Simulation::status() const {
    return stepper_->ending().status();
}
const std::string& Simulation::status_detail() const {
    return stepper_->ending().detail();
}
double Simulation::time() const {
    return stepper_->time();
}
double Simulation::time_limit() const {
    return stepper_->ending().time_limit();
}
double Simulation::motion_ended() const {
    return stepper_->ending().rest().motion_ended();
}
double Simulation::rested() const {
    return stepper_->ending().rest().progress();
}
bool Simulation::released() const {
    return stepper_->equilibrium().reached();
}
bool Simulation::stage_ended() const {
    return stepper_->release().stage_ended();
}

StateView Simulation::state() const {
    return stepper_->state();
}
EnergyBudget Simulation::energy() const {
    return stepper_->energy();
}
Vec2 Simulation::bed_force() const {
    return runout::bed_force(stepper_->particles(), stepper_->discretisation().volume());
}
const BarrierForce* Simulation::barrier_force() const {
    return stepper_->effects().barrier_force();
}
std::vector<double> Simulation::strain_rate() const {
    return strain_rates(stepper_->particles());
}
double Simulation::eroded_area() const {
    return stepper_->effects().eroded_area();
}

const WorkCounts& Simulation::work() const {
    return stepper_->work();
}
const PhaseClock& Simulation::clock() const {
    return stepper_->clock();
}
const std::vector<EffectCost>& Simulation::effect_costs() const {
    return stepper_->effects().costs();
}
const InvariantReadings& Simulation::invariants() const {
    return stepper_->invariants().readings();
}
int Simulation::boundary_particles() const {
    return stepper_->particles().wall.boundary_count;
}
int Simulation::threads() const {
    return stepper_->threads();
}
double Simulation::time_scale() const {
    return stepper_->scales().time;
}

}  // namespace runout
