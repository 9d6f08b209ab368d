#pragma once

#include "viewport/scene/MomentBuilder.h"

namespace rubble {

/// A session from which pictures are taken: it goes on to the moments that are asked for, one after the other.
class Take {
public:
    /// A session of `scene` that has not begun, with what is to come to it: `inputs`, ascending step, beside those that wait in
    /// it already. Of the options, colouring and hulls count.
    Take(std::shared_ptr<const PlayScene> scene, Session session, std::vector<TimedInput> inputs = {},
         const SceneOptions& options = {}, const PlayOverlays& overlays = {});

    const Session& session() const { return m_session; }
    /// The moment as it is.
    std::shared_ptr<const RenderScene> moment() { return m_builder->momentOf(m_session); }
    /// Goes on to a step and gives the moment then. Of the second before it every moment is made: heat cools down from step to
    /// step, and a picture may be of a time between the last two. Inputs that cannot be followed are left out, with a notice.
    ///
    /// Errors: Cancelled.
    Result<std::shared_ptr<const RenderScene>> momentAfter(std::uint64_t step, const TaskContext& task = {});
    /// What the session had to tell since this was asked last, sentence by sentence.
    std::vector<std::string> takeNotices();

private:
    void step();

    Session m_session;
    std::vector<TimedInput> m_inputs;
    std::size_t m_given = 0;  // of the inputs
    std::unique_ptr<MomentBuilder> m_builder;
    std::vector<std::string> m_notices;
};

}  // namespace rubble
