#include "measures/measures.h"

#include <array>

namespace runout {

std::span<const MeasureField> measure_fields() {
    static constexpr std::array fields{
        MeasureField{"run_out_m", &Measures::run_out_m,
                     "front of the contiguous deposit (by top), along the run-out surface from the toe"},
        MeasureField{"run_out_normalised", &Measures::run_out_normalised, "run-out / sqrt(deposit area)"},
        MeasureField{"front_by_mass_m", &Measures::front_by_mass_m, "the same front, thickness by mass"},
        MeasureField{"front_mass_995_m", &Measures::front_mass_995_m,
                     "distance that 99.5 % of the mass does not pass"},
        MeasureField{"front_thickness_m", &Measures::front_thickness_m, "thickness that counts as front"},
        MeasureField{"reach_angle_deg", &Measures::reach_angle_deg,
                     "from the head of the source to the distal margin"},
        MeasureField{"source_area_m2", &Measures::source_area_m2, "S_0"},
        MeasureField{"deposit_area_m2", &Measures::deposit_area_m2, "S_inf"},
        MeasureField{"front_area_m2", &Measures::front_area_m2,
                     "S_front, source above the discontinuity plane"},
        MeasureField{"front_area_ratio", &Measures::front_area_ratio, "S_front / S_0"},
        MeasureField{"drop_height_m", &Measures::drop_height_m, "H_d to its datum"},
        MeasureField{"drop_height_normalised", &Measures::drop_height_normalised, "H_d / sqrt(S_inf)"},
        MeasureField{"deposit_height_m", &Measures::deposit_height_m, "greatest thickness of the deposit"},
        MeasureField{"toe_thickness_m", &Measures::toe_thickness_m, "thickness of the deposit at the toe"},
        MeasureField{"peak_front_speed_m_s", &Measures::peak_front_speed_m_s,
                     "greatest speed of the 99.5 % mass point"},
        MeasureField{"time_to_rest_s", &Measures::time_to_rest_s, "simulated time at which motion ended"},
        MeasureField{"stray_particles", &Measures::stray_particles, "particles apart from the deposit"},
        MeasureField{"eroded_area_m2", &Measures::eroded_area_m2, "soil of an erodible bed that has moved"},
    };
    return fields;
}

}  // namespace runout
