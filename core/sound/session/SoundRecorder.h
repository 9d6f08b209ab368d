#pragma once

#include "core/play/session/Session.h"
#include "core/sound/mix/SoundTrack.h"

#include <vector>

namespace rubble {

/// What is heard of a session's last step, at the time after it: the impacts and breaks that it reports.
std::vector<SoundCue> cuesOf(const Session& session);

/// In front of the instances, towards +z, as far away as they are large, and 3 m at least.
Listener frontListener(const Session& session);

/// Records what is heard of a session while it is played. It only reads the session.
class SoundRecorder {
public:
    /// Must be called after each step.
    void add(const Session& session);
    const std::vector<SoundCue>& cues() const { return m_cues; }
    /// The cues, mixed to a track as long as what was played.
    ///
    /// Errors: those of mixedTrack().
    Result<StereoTrack> track(const Listener& listener) const { return mixedTrack(m_cues, m_seconds, listener); }

private:
    double m_seconds = 0.0;
    std::vector<SoundCue> m_cues;
};

}  // namespace rubble
