#include "measures/measures.h"

#include <array>

namespace runout {

std::span<const MeasureField> measure_fields() {
    static constexpr std::array fields{
        // In the order of the database.
        MeasureField{
            "run_out_m", &Measures::run_out_m,
            "front of the deposit at rest: farthest place where all soil is front_thickness_m thick"},
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
                     "greatest speed of the soil at the front, mean over depth and window"},
        MeasureField{"time_to_rest_s", &Measures::time_to_rest_s, "simulated time at which motion ended"},
        MeasureField{"stray_particles", &Measures::stray_particles, "particles apart from the deposit"},
        MeasureField{"eroded_area_m2", &Measures::eroded_area_m2, "soil of an erodible bed that has moved"},
        MeasureField{"run_out_along_bed_m", &Measures::run_out_along_bed_m,
                     "the same front, along the bed and not horizontally"},
        MeasureField{"farthest_front_m", &Measures::farthest_front_m, "farthest front at any instant"},
        MeasureField{"front_window_m", &Measures::front_window_m,
                     "half-width of the window that thickness and speed are taken in"},
        MeasureField{"front_by_top_m", &Measures::front_by_top_m, "front of the contiguous deposit, by top"},
        MeasureField{"peak_mass_995_speed_m_s", &Measures::peak_mass_995_speed_m_s,
                     "greatest speed of the 99.5 % mass point"},
        MeasureField{"farthest_soil_m", &Measures::farthest_soil_m, "farthest single grain at any instant"},
        MeasureField{"beyond_front_area_m2", &Measures::beyond_front_area_m2,
                     "soil at rest beyond the front, thinner than the threshold"},
        MeasureField{"beyond_front_speed_m_s", &Measures::beyond_front_speed_m_s,
                     "greatest speed of a grain beyond the front of its instant"},
    };
    return fields;
}

}  // namespace runout
