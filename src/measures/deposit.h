#pragma once

#include <vector>

#include "engine/state_view.h"

namespace runout {

/// Soil that hangs together, over chainage. Bins of two spacings, edges at multiples of that from the toe;
/// local frame.
struct DepositProfile {
    struct Bin {
        double x = 0;        ///< middle of the bin, m
        double bed = 0;      ///< bed elevation there, m
        double by_mass = 0;  ///< soil area per width of column, m
        double by_top = 0;   ///< highest particle + dl/2 above the bed, m
    };
    double bin_width = 0;
    std::vector<Bin> bins;  ///< from the uphill end of the mass to its distal end, none left out
};

/// 1 for particles of clusters (links up to 1.6 spacings) that hold at least 1 % of all particles, since
/// debris may rest in several parts, on a bench and below it; 0 for strays. One value per particle.
std::vector<char> connected_body(const StateView& state);

DepositProfile deposit_profile(const StateView& state, const std::vector<char>& body);

/// Distal end x of the contiguous deposit thicker than `threshold`, in the most distal part of the deposit
/// that is that thick, reckoned from the part's thickest bin and interpolated between bins; `thickness` picks
/// the definition. The thickest bin's middle if nothing is that thick.
double contiguous_front(const DepositProfile& profile, double DepositProfile::Bin::*thickness,
                        double threshold);

/// Least x that has at most `share` of the mass beyond it.
double mass_front(const StateView& state, double share);

/// Area of the connected deposit, m2: volumes of its particles at the density they have (1 at the free
/// surface).
double deposit_area(const StateView& state, const std::vector<char>& body);

/// Inclination below the horizontal of the free surface (by mass) in the middle half between the uphill end
/// and `front`, by least squares, rad; head and toe feel the wall and the bed. NaN with fewer than three bins
/// there.
double surface_angle(const DepositProfile& profile, double front);

/// Length along the bed from the toe (the origin) to x, negative uphill of it.
double distance_along_bed(const BedLine& bed, double x);

}  // namespace runout
