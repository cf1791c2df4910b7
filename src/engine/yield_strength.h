#pragma once

#include <optional>
#include <vector>

#include "engine/neighbours.h"
#include "engine/wall.h"
#include "scene/scene.h"

namespace runout {

/// Strength on the bed over the effective pressure at x: tan(delta) where that is less than sin(phi), else
/// sin(phi).
double base_strength_ratio(const Material& material, const Effects& effects, double x);

/// The same per boundary particle. Empty where the whole bed is rough.
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

    /// On return `strength` has the yield stress of every node, Pa. `pore_pressure` and `strain_rate`, per
    /// node, Pa and 1/s (|e|), are looked at where the effect is there.
    void find(const Neighbours& n, const std::vector<double>& pressure,
              const std::vector<double>& pore_pressure, const std::vector<double>& strain_rate, int threads,
              std::vector<float>& strength) const;

    [[nodiscard]] bool cohesive() const { return cohesion_ > 0.0; }
    [[nodiscard]] bool depends_on_rate() const { return rate_.has_value(); }

  private:
    [[nodiscard]] double friction(double effective_pressure, double strain_rate) const;
    void weaken_base(const Neighbours& n, const std::vector<double>& pressure,
                     const std::vector<double>& pore_pressure, std::vector<float>& strength) const;

    double sin_phi_;
    double cohesion_;  ///< c cos(phi), Pa
    double tension_;   ///< Pa
    std::optional<RateDependence> rate_;
    bool wet_;
    std::vector<double> base_ratios_;
};

}  // namespace runout
