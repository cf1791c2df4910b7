#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/particles/wall.h"
#include "engine/problem.h"

namespace runout {

/// Strength on the bed over the effective pressure at x: tan(delta) where that is less than sin(phi), else
/// sin(phi).
double base_strength_ratio(const Material& material, const Effects& effects, double x);

/// What resists sliding on the bed where that is least, over the pressure: sin(phi), or tan(delta) of a
/// weaker base.
double least_strength(const Material& material, const Effects& effects);

/// base_strength_ratio per boundary particle. Empty where the whole bed is rough.
std::vector<double> base_strength_ratios(const Material& material, const Effects& effects, const Wall& wall);

/// Greatest mean tension that the soil bears, Pa: as given, or that of uniaxial tension at yield,
/// c cos(phi)/(1 + sin(phi)). 0 without cohesion.
double tension_cut_off(const Material& material, const Effects& effects);

/// Yield stress of Coulomb soil,
///   |s| <= c cos(phi) + max(p - u, -T) mu,   mu = sin(phi), or mu(I) where friction depends on the rate.
/// On a weaker base tan(delta) stands for sin(phi), and cohesion is reduced in the same proportion: the soil
/// within the kernel's reach of the bed carries the traction to the bed, so all of it gets that strength.
class YieldStrength {
  public:
    YieldStrength(const Material& material, const Effects& effects, std::vector<double> base_ratios);

    /// Yield stress, Pa, of a node whose nearest boundary particle is `boundary` (-1: none near). Where the
    /// effect is there, `pore_pressure` and `strain_rate`, |e|, are looked at: Pa, Pa and 1/s.
    [[nodiscard]] double at(int boundary, double pressure, double pore_pressure, double strain_rate) const {
        const double p = std::max(wet_ ? pressure - pore_pressure : pressure, -tension_);
        if (boundary >= 0 && !base_ratios_.empty()) {
            const double ratio = base_ratios_[static_cast<std::size_t>(boundary)];
            if (ratio < sin_phi_) return std::max(0.0, p * ratio + cohesion_ * ratio / sin_phi_);
        }
        const double mu = rate_ && p > 0.0 ? friction(p, strain_rate) : sin_phi_;
        return std::max(0.0, p * mu + cohesion_);
    }

    [[nodiscard]] bool wet() const { return wet_; }
    [[nodiscard]] bool cohesive() const { return cohesion_ > 0.0; }
    [[nodiscard]] bool depends_on_rate() const { return rate_.has_value(); }

  private:
    [[nodiscard]] double friction(double effective_pressure, double strain_rate) const;

    double sin_phi_;
    double cohesion_;  ///< c cos(phi), Pa
    double tension_;   ///< Pa
    std::optional<RateDependence> rate_;
    bool wet_;
    std::vector<double> base_ratios_;
};

}  // namespace runout
