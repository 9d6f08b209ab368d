#pragma once

#include "core/base/TaskContext.h"
#include "core/io/json/JsonWriter.h"
#include "core/play/session/Session.h"

#include <map>
#include <set>
#include <utility>

namespace rubble {

/// The text of a file of events of version 2, which docs/formats/events.md describes: a line that introduces the
/// session, then an object a line for each event. Which bodies there are, of which fragments, and the damage of
/// instances are reported wholly; of impacts and contacts the strongest.
class EventStreamText {
public:
    /// Introduces a session as it is.
    explicit EventStreamText(const Session& session);

    /// Adds what happened in the last step. Must be called after each step.
    void add(const Session& session);
    /// The text since the last call.
    std::string take();

private:
    template <class Write>
    void addLine(const Write& write);
    /// A line of a kind of event of the last step.
    template <class Write>
    void addEvent(const Session& session, std::string_view kind, const Write& write);
    void addHeader(const Session& session);
    void addImpacts(const Session& session);
    void addBonds(const Session& session);
    void addBirths(const Session& session);
    void addBirth(const Session& session, const PlayBody& body);
    void addBreaks(const Session& session);
    void addSettled(const Session& session);
    void addRemovals(const Session& session);
    void addRemoval(const Session& session, const PlayRemoval& removal);
    void addDamage(const Session& session);
    void addContacts(const Session& session);
    void addSums(const Session& session);
    double massOf(const Session& session, std::uint32_t number) const;
    void remember(const Session& session, const PlayBody& body);
    std::uint32_t ownerOf(const PlayBody& body) const;

    std::string m_text;
    std::map<std::uint32_t, double> m_masses;                                  // kg, by number of body
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_owner;  // body, by origin and fragment
    SessionDamage m_damage;                                                    // after the last step
    std::set<std::uint32_t> m_listed;  // impacts of the last step that are reported, by index in PlayEvents::happened
};

/// Plays a session on, with inputs (ascending step), until `steps` steps are done. Returns the text of its events.
///
/// Errors: those of Timeline::seek(); Cancelled.
Result<std::string> eventStream(Session session, std::vector<TimedInput> inputs, std::uint64_t steps,
                                const TaskContext& task = {});

}  // namespace rubble
