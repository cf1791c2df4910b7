#pragma once

#include <limits>
#include <string>
#include <vector>

namespace runout {

/// What the empirical relations ask about a slide.
struct TravelCase {
    double drop = 0;         ///< H, from the head of the source to the distal margin, m
    double slope_angle = 0;  ///< of the cut, rad
    double volume = std::numeric_limits<double>::quiet_NaN();  ///< m3; NaN: no width was given
    double apron_angle = 0;  ///< mean inclination of the run-out surface below the horizontal, rad
};

/// One line of a relation: H/L = tan(travel angle).
struct TravelLine {
    std::string label;  ///< "mean", "95 % lower limit", "2 % go further"
    double ratio = 0;   ///< H/L
};

/// What one relation says of a slide, or why it says nothing.
struct TravelEstimate {
    std::string relation;
    std::string origin;
    bool second_hand = false;       ///< the source itself has not been read
    std::string form;               ///< formula in words
    std::string range;              ///< where it holds
    std::string refusal;            ///< why it is not applied here; empty when it is
    std::string caution;            ///< what could not be checked; empty mostly
    std::vector<TravelLine> lines;  ///< empty when refused
};

/// Hunter & Fell, Finlay et al., Corominas by class, and the fits to wet and dry landslides.
std::vector<TravelEstimate> travel_estimates(const TravelCase& slide);

/// A documented landslide.
struct TravelPair {
    std::string group;  ///< "Hong Kong", "wet, elsewhere", "dry"
    double volume = 0;  ///< m3
    double angle_deg = 0;
};

/// 316 pairs of volume and travel angle; 70 of them from Hong Kong.
const std::vector<TravelPair>& travel_pairs();

/// H/L at a volume by a relation that is a power of the volume, for charts; lines as in travel_estimates.
struct VolumeBand {
    std::string label;
    double coefficient = 0;  ///< H/L = coefficient * V^exponent
    double exponent = 0;
    double low_volume = 0, high_volume = 0;  ///< where it is drawn: its range within that of the chart
    bool second_hand = false;
};
std::vector<VolumeBand> volume_bands();

}  // namespace runout
