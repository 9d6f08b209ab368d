#pragma once

#include "core/base/Random.h"
#include "core/play/state/EventRecord.h"

namespace rubble {

/// Where a particle of an event starts, and how fast.
struct EmittedStart {
    Vec3 from;      // m
    Vec3 velocity;  // m/s
};

/// Starts of the particles of an event.
class ParticleEmitter {
public:
    virtual ~ParticleEmitter() = default;
    virtual EmittedStart next(Random& random) const = 0;
};

/// On the surface that was hit and on the opposite one, away from the point.
class BreakEmitter : public ParticleEmitter {
public:
    /// `density`, kg/m³: of the body, whose thickness follows from it.
    BreakEmitter(const EventRecord& broken, double density);
    /// The largest extent of what broke, at most 1 m: the size that speeds follow from.
    double size() const { return m_size; }
    /// The same without a limit, m.
    double extent() const { return m_largest; }
    EmittedStart next(Random& random) const override;

private:
    const EventRecord& m_broken;
    Vec3 m_extent;
    double m_largest, m_size;
    double m_thickness = 0.0;  // m, of the body along the normal
};

/// At the point, to all sides along the surface.
class ImpactEmitter : public ParticleEmitter {
public:
    explicit ImpactEmitter(const EventRecord& impact);
    EmittedStart next(Random& random) const override;

private:
    const EventRecord& m_impact;
    double m_speed;  // m/s
};

/// The random numbers of what an event makes, of which each use has a `stream` of its own.
Random randomOf(const EventRecord& event, std::uint64_t stream);
Vec3 randomDirection(Random& random);
/// In proportion to the cube root of an energy, J: `one` at a joule.
double scaledByEnergy(double energy, double one, double least, double most);

}  // namespace rubble
