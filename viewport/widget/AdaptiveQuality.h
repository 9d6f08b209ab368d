#pragma once

namespace rubble {

/// The quality of the pictures of a moving view: as high as the time that they take allows, so that it moves smoothly
/// also where the processor draws.
class AdaptiveQuality {
public:
    static constexpr double kGoal = 0.030;   // s for a picture to be drawn: 25 a second, with time left for all else
    static constexpr double kLowest = 0.35;  // blurred, but recognizable

    /// Of each side, in [kLowest, 1].
    double resolution() const { return m_resolution; }
    /// Intact instances whose fragments are smaller on average are drawn as a whole, pixels.
    double minFragmentPixels() const;
    bool isLowest() const { return m_resolution <= kLowest; }

    /// Reports the time that a picture of this quality took, s.
    void add(double seconds);

private:
    double m_resolution = 1.0;
};

}  // namespace rubble
