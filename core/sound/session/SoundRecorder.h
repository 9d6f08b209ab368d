#pragma once

#include "core/play/session/Session.h"
#include "core/sound/mix/SoundTrack.h"

#include <vector>

namespace rubble {

/// Records what is heard of a session while it is played: the impacts and breaks that its steps tell. It only reads the
/// session.
class SoundRecorder {
public:
    /// Heard from in front of the instances, towards +z, as far away as they are large, and 3 m at least.
    explicit SoundRecorder(const Session& session);

    /// Must be called after each step.
    void add(const Session& session);
    const std::vector<SoundCue>& cues() const { return m_cues; }
    const Listener& listener() const { return m_listener; }
    /// The cues, mixed to a track as long as what was played.
    ///
    /// Errors: those of mixedTrack().
    Result<StereoTrack> track() const { return mixedTrack(m_cues, m_seconds, m_listener); }

private:
    Listener m_listener;
    double m_seconds = 0.0;
    std::vector<SoundCue> m_cues;
};

}  // namespace rubble
