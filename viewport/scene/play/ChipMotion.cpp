#include "viewport/scene/play/ChipMotion.h"

#include "core/base/math/Trigonometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

constexpr double kRestitution = 0.28, kGrip = 0.55;  // of the speeds across and along the ground at a bounce
constexpr double kSliding = 7.0;                     // 1/s: it slides as far as it would fly in 1/7 s
constexpr double kSpinLeft = 0.5;                    // of the rotation at a bounce
constexpr double kShrinking = 0.7;                   // s, at the end of its life
constexpr std::size_t kFlights = 3;                  // from the start, and after each of two bounces
constexpr double kForever = std::numeric_limits<double>::infinity();

/// A parabola between two bounces.
struct Flight {
    Vec3 from, velocity;
    double duration = 0.0;  // s
};

struct Motion {
    Vec3 position;
    double angle = 0.0;  // rad
};

/// When what starts at a height over the ground with a speed upwards meets it, falling with `fall` m/s².
double timeToGround(double height, double up, double fall) {
    if (fall <= 0.0) return up < 0.0 && height > 0.0 && fall == 0.0 ? height / -up : kForever;
    return (up + std::sqrt(up * up + 2.0 * fall * std::max(height, 0.0))) / fall;
}

std::array<Flight, kFlights> flightsOf(const ChipStart& start, const ParticleWorld& world) {
    std::array<Flight, kFlights> flights{};
    const double floor = std::min(world.ground + lyingHeight(start), start.from.y);
    Vec3 from = start.from, velocity = start.velocity;
    for (Flight& flight : flights) {
        const double time = timeToGround(from.y - floor, velocity.y, -world.gravity.y);
        flight = {from, velocity, time};
        if (time == kForever) break;
        from += velocity * time + 0.5 * time * time * world.gravity;
        from.y = floor;
        velocity += time * world.gravity;
        velocity = {kGrip * velocity.x, kRestitution * std::abs(velocity.y), kGrip * velocity.z};
    }
    return flights;
}

Motion motionAt(const ChipStart& start, double age, const ParticleWorld& world) {
    const std::array<Flight, kFlights> flights = flightsOf(start, world);
    if (flights[0].duration == kForever) {
        return {start.from + start.velocity * age + 0.5 * age * age * world.gravity, start.spin * age};
    }
    Motion motion;
    double left = age, spin = start.spin;
    bool isFlying = false;
    for (const Flight& flight : flights) {
        const double flown = std::min(left, flight.duration);
        const double whole = flight.duration == kForever ? 0.0 : flight.duration;
        motion.angle -= spin * (whole - flown);  // 0 once it lies
        if (!isFlying) motion.position = flight.from + flight.velocity * flown + 0.5 * flown * flown * world.gravity;
        isFlying = isFlying || left < flight.duration;
        left = std::max(0.0, left - flight.duration);
        spin *= kSpinLeft;
    }
    if (isFlying) return motion;
    const Flight& last = flights.back();
    const Vec3 landing = last.velocity + last.duration * world.gravity;
    const double slid = left / (1.0 + kSliding * left);
    motion.position += kGrip * slid * Vec3(landing.x, 0.0, landing.z);
    motion.position.y = std::min(world.ground + lyingHeight(start), start.from.y);
    return motion;
}

double wrapped(double angle) { return angle - kFullTurn * std::floor(angle / kFullTurn); }

}  // namespace

double lyingHeight(const ChipStart& start) {
    switch (start.shape) {
        case ChipShape::Angular: return 0.45 * start.radius;
        case ChipShape::Flat: return 0.12 * start.radius;
        case ChipShape::Long: return 0.15 * start.radius;
    }
    return 0.0;
}

Chip chipAt(const ChipStart& start, double age, const ParticleWorld& world) {
    const Motion now = motionAt(start, age, world);
    const Motion before = motionAt(start, std::max(0.0, age - world.stepLength), world);
    const double size = std::clamp((start.lifetime - age) / kShrinking, 0.0, 1.0);
    const double kind = static_cast<double>(start.shape), largest = 0.999999;  // below 1 as a float, too
    return {glm::vec4(glm::vec3(now.position - world.origin), start.radius * size),
            glm::vec4(glm::vec3(before.position - now.position), before.angle - now.angle),
            glm::vec4(glm::vec3(start.axis), wrapped(now.angle)),
            glm::vec4(start.colour, kind + std::min(start.seed, largest))};
}

}  // namespace rubble
