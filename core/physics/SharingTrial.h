#pragma once

namespace rubble {

/// Finds out whether a world's steps are quicker shared out among several threads. That depends on the machine as much as on the
/// world: on how far apart its processors' caches are (the same heap took 0.57 and 0.95 of its time alone on the same two
/// processors, as their host moved them), and on who else wants them. So it is tried, often at first, while bodies fall, then
/// now and then; results do not depend on it.
class SharingTrial {
public:
    /// How the coming step is to be taken.
    bool isShared() const {
        const int tried = m_step - m_pause;
        return tried < 0 ? m_isWorthIt : kTried <= tried && tried < 2 * kTried;
    }
    /// To be called after each step with what it took.
    void note(double milliseconds);

private:
    // A trial is some steps alone, some shared, and some alone again, lest what grows with each step be held against one of them.
    static constexpr int kTried = 3;
    static constexpr int kFirstPause = 16;  // steps
    static constexpr int kLongestPause = 256;

    int m_step = 0;  // since the last trial
    int m_pause = kFirstPause;
    bool m_isWorthIt = true;
    double m_alone = 0.0;   // ms
    double m_shared = 0.0;  // ms
};

}  // namespace rubble
