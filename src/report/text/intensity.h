#pragma once

#include <string>
#include <vector>

#include "measures/measures.h"

namespace runout {

/// A class of what debris does to a place: thicker and faster than these.
struct IntensityClass {
    std::string name;
    double thickness_m = 0, speed_m_s = 0;
};

/// From the least to the greatest class. Unless the user gives others: medium wherever the debris comes, high
/// where it is thicker than 1 m and faster than 1 m/s.
std::vector<IntensityClass> usual_intensities();

/// Where that table comes from, a sentence.
std::string usual_intensities_origin();

/// A table of classes, and where it comes from.
struct Intensities {
    std::vector<IntensityClass> classes = usual_intensities();
    std::string origin = usual_intensities_origin();
};

/// Name of the greatest class that thickness and speed exceed; empty: none.
std::string intensity_of(const std::vector<IntensityClass>& classes, double thickness_m, double speed_m_s);

/// A part of the section of one class, horizontally from the toe.
struct IntensityStretch {
    std::string name;
    double from_m = 0, to_m = 0;
};

/// By the greatest thickness and speed of each node that was as thick as the front; from uphill to downhill.
std::vector<IntensityStretch> intensity_stretches(const Envelope& envelope, double front_thickness_m,
                                                  const std::vector<IntensityClass>& classes);

/// "medium=0,0" -> the class. Throws InputError, naming the option.
IntensityClass intensity_from(const std::string& text, const std::string& option);

/// The classes that an option gives, the least first; the usual ones where it gives none. Throws InputError
/// as intensity_from and check_intensities_rise.
Intensities intensities_from(const std::vector<std::string>& texts, const std::string& option);

/// Throws InputError where a class is not above the one before it in one of the two and not below in the
/// other.
void check_intensities_rise(const std::vector<IntensityClass>& classes, const std::string& option);

}  // namespace runout
