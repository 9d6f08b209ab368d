#pragma once

namespace rubble {

/// The resolution of the images of a moving view: as high as the time that they take allows, so that it moves smoothly
/// also where the processor draws.
class AdaptiveResolution {
public:
    static constexpr double kGoal =
        0.034;  // s for an image to be drawn and shown: 25 a second, with time left for all else
    static constexpr double kLowest = 0.35;  // blurred, but recognizable

    /// In [kLowest, 1], of each side.
    double value() const { return m_value; }
    /// Reports the time that an image of this resolution took, s.
    void add(double seconds);

private:
    double m_value = 1.0;
};

}  // namespace rubble
