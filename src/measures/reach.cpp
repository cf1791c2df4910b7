#include "measures/reach.h"

#include <algorithm>
#include <cmath>

namespace runout {

ReachRecorder::ReachRecorder(const FrontRule& rule, const StateView& start) : soil_(rule, start) {
    look(start);
}

void ReachRecorder::look(const StateView& state) {
    soil_.take(state);
    front_ = soil_.front();
    farthest_front_ = std::max(farthest_front_, front_);
    if (front_ > ThicknessField::nowhere) {
        const Vec2 velocity = soil_.at(front_).velocity;
        if (velocity.x() > 0) peak_front_speed_ = std::max(peak_front_speed_, velocity.norm());
    }
    double fastest_2 = 0;
    for (std::size_t i = 0; i < state.x.size(); ++i) {
        if (!state.is_debris(i)) continue;
        farthest_soil_ = std::max(farthest_soil_, state.x[i]);
        if (state.x[i] > front_)
            fastest_2 = std::max(fastest_2, state.vx[i] * state.vx[i] + state.vy[i] * state.vy[i]);
    }
    speed_beyond_front_ = std::max(speed_beyond_front_, std::sqrt(fastest_2));
}

}  // namespace runout
