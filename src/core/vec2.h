#pragma once

#include <algorithm>
#include <cmath>

/// Run-out of cut slopes. SI units and radians throughout.
namespace runout {

/// A point or vector in the plane of the section, SI units. Two numbers and no more, since nearly every file
/// includes it; linear algebra proper is Eigen's.
class Vec2 {
  public:
    /// The origin.
    constexpr Vec2() = default;
    /// Of these two components.
    constexpr Vec2(double x, double y) : x_(x), y_(y) {}
    /// Both components `value`.
    static constexpr Vec2 Constant(double value) { return {value, value}; }

    /// Towards the run-out.
    [[nodiscard]] constexpr double x() const { return x_; }
    /// Upwards.
    [[nodiscard]] constexpr double y() const { return y_; }
    /// To be changed in place.
    constexpr double& x() { return x_; }
    /// To be changed in place.
    constexpr double& y() { return y_; }

    /// Both components are equal.
    constexpr bool operator==(const Vec2&) const = default;

    /// By components.
    constexpr Vec2& operator+=(const Vec2& other) {
        x_ += other.x_;
        y_ += other.y_;
        return *this;
    }
    /// By components.
    constexpr Vec2& operator-=(const Vec2& other) {
        x_ -= other.x_;
        y_ -= other.y_;
        return *this;
    }
    /// Both components times `factor`.
    constexpr Vec2& operator*=(double factor) {
        x_ *= factor;
        y_ *= factor;
        return *this;
    }
    /// Both components over `divisor`.
    constexpr Vec2& operator/=(double divisor) {
        x_ /= divisor;
        y_ /= divisor;
        return *this;
    }

    /// Scalar product.
    [[nodiscard]] constexpr double dot(const Vec2& other) const { return x_ * other.x_ + y_ * other.y_; }
    /// Square of the length.
    [[nodiscard]] constexpr double squaredNorm() const { return dot(*this); }
    /// Length.
    [[nodiscard]] double norm() const { return std::sqrt(squaredNorm()); }
    /// Of length 1; the null vector stays what it is.
    [[nodiscard]] Vec2 normalized() const;

    /// The lesser of each component.
    [[nodiscard]] constexpr Vec2 cwiseMin(const Vec2& other) const {
        return {std::min(x_, other.x_), std::min(y_, other.y_)};
    }
    /// The greater of each component.
    [[nodiscard]] constexpr Vec2 cwiseMax(const Vec2& other) const {
        return {std::max(x_, other.x_), std::max(y_, other.y_)};
    }
    /// Absolute value of each component.
    [[nodiscard]] Vec2 cwiseAbs() const { return {std::abs(x_), std::abs(y_)}; }
    /// The greater component.
    [[nodiscard]] constexpr double maxCoeff() const { return std::max(x_, y_); }
    /// Neither component is infinite or no number.
    [[nodiscard]] bool allFinite() const { return std::isfinite(x_) && std::isfinite(y_); }

  private:
    double x_ = 0;
    double y_ = 0;
};

/// Sum.
constexpr Vec2 operator+(Vec2 a, const Vec2& b) {
    return a += b;
}
/// Difference.
constexpr Vec2 operator-(Vec2 a, const Vec2& b) {
    return a -= b;
}
/// The opposite vector.
constexpr Vec2 operator-(const Vec2& a) {
    return {-a.x(), -a.y()};
}
/// Both components times `factor`.
constexpr Vec2 operator*(Vec2 a, double factor) {
    return a *= factor;
}
/// Both components times `factor`.
constexpr Vec2 operator*(double factor, Vec2 a) {
    return a *= factor;
}
/// Both components over `divisor`.
constexpr Vec2 operator/(Vec2 a, double divisor) {
    return a /= divisor;
}

inline Vec2 Vec2::normalized() const {
    const double length2 = squaredNorm();
    return length2 > 0 ? *this / std::sqrt(length2) : *this;
}

}  // namespace runout
