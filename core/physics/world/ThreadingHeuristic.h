#pragma once

namespace rubble {

/// Decides by measurement whether the steps of a world run on one thread or several. That depends on the machine as
/// much as on the world: on the distance of the cores' caches (two threads took 57 % or 95 % of the time of one for the
/// same scene, depending on the cores assigned by the host) and on other load. It therefore runs trials, often at
/// first, while bodies fall, and less often later. Results do not depend on it.
class ThreadingHeuristic {
public:
    /// Whether to run the next step on several threads.
    bool isThreaded() const {
        const int trialStep = m_step - m_pause;
        return trialStep < 0 ? m_isFaster : kTrialSteps <= trialStep && trialStep < 2 * kTrialSteps;
    }
    /// Reports the duration of a step; call after each one.
    void addStep(double milliseconds);

private:
    // A trial runs some steps on one thread, some on several, and some on one again, so that a trend does not bias the
    // comparison.
    static constexpr int kTrialSteps = 3;
    static constexpr int kInitialPause = 16;  // steps between trials
    static constexpr int kMaxPause = 256;

    int m_step = 0;  // since the last trial
    int m_pause = kInitialPause;
    bool m_isFaster = true;
    double m_single = 0.0;    // ms, best step on one thread
    double m_threaded = 0.0;  // ms, best step on several
};

}  // namespace rubble
