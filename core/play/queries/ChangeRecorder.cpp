#include "core/play/queries/ChangeRecorder.h"

#include "core/base/Assert.h"
#include "core/geometry/search/MergedBoxes.h"

#include <algorithm>

namespace rubble {
namespace {

/// The box of a body's exact hulls in its own frame: collision shapes are simplified.
Box3 localBox(const PlayBody& body) {
    Box3 box;
    for (const Polytope& hull : hullsOf(body)) {
        for (const Vec3& vertex : hull.vertices) box.include(vertex);
    }
    return box;
}

/// A world box that contains a box at a pose.
Box3 boxAt(const Box3& local, const Pose& pose) {
    Box3 box;
    for (int corner = 0; corner < 8; ++corner) box.include(pose.position + pose.orientation * local.corner(corner));
    return box;
}

}  // namespace

ChangeRecorder::ChangeRecorder(const Session& session, std::size_t maxChanges)
    : m_maxChanges(maxChanges), m_step(session.stepsDone()) {
    std::vector<Change> unused;
    addBorn(session, unused);
}

void ChangeRecorder::add(const Session& session) {
    RUBBLE_ASSERT(session.stepsDone() == m_step + 1);
    m_step = session.stepsDone();
    Span span{.last = m_step};
    addMoved(session, span.changes);
    addBorn(session, span.changes);
    if (span.changes.empty()) return;
    m_changes += span.changes.size();
    m_spans.push_back(std::move(span));
    if (m_changes > m_maxChanges) joinOlderHalf();
}

/// Adds the bodies that moved or are gone.
void ChangeRecorder::addMoved(const Session& session, std::vector<Change>& changes) {
    bool isAnyGone = false;
    auto body = session.bodies().begin();
    for (Place& place : m_places) {
        while (body != session.bodies().end() && body->number < place.number) ++body;
        if (body == session.bodies().end() || body->number != place.number) {
            changes.push_back({place.number, place.box});
            place.body = {};
            isAnyGone = true;
            continue;
        }
        const Pose pose = session.world().state(place.body).pose;
        if (pose == place.pose) continue;
        changes.push_back({place.number, place.box});
        place.pose = pose;
        place.box = boxAt(place.local, pose);
    }
    if (isAnyGone) std::erase_if(m_places, [](const Place& place) { return place.body.index == 0; });
}

/// Adds the bodies that are new: numbers ascend in order of creation.
void ChangeRecorder::addBorn(const Session& session, std::vector<Change>& changes) {
    const std::uint32_t first = m_places.empty() ? 0 : m_places.back().number + 1;
    auto body = std::ranges::lower_bound(session.bodies(), first, {}, &PlayBody::number);
    for (; body != session.bodies().end(); ++body) {
        const Box3 local = localBox(*body);
        const Pose pose = session.world().state(body->body).pose;
        m_places.push_back({body->number, body->body, local, pose, boxAt(local, pose)});
        changes.push_back({body->number, {}});
    }
}

void ChangeRecorder::joinOlderHalf() {
    Span joined;
    std::size_t count = 0;
    auto end = m_spans.begin();
    while (end != m_spans.end() && (end == m_spans.begin() || count + end->changes.size() <= m_maxChanges / 2)) {
        count += end->changes.size();
        joined.changes.insert(joined.changes.end(), end->changes.begin(), end->changes.end());
        joined.last = end->last;
        ++end;
    }
    std::ranges::stable_sort(joined.changes, {}, &Change::number);
    std::vector<Change> changes;
    for (const Change& change : joined.changes) {
        if (changes.empty() || changes.back().number != change.number) changes.push_back({change.number, {}});
        changes.back().before.include(change.before);
    }
    joined.changes = std::move(changes);
    m_changes -= count - joined.changes.size();
    m_spans.erase(m_spans.begin() + 1, end);
    m_spans.front() = std::move(joined);
}

std::vector<Box3> ChangeRecorder::changedBoxes(std::uint64_t step) const {
    std::vector<Change> changes;
    for (auto span = std::ranges::upper_bound(m_spans, step, {}, &Span::last); span != m_spans.end(); ++span) {
        changes.insert(changes.end(), span->changes.begin(), span->changes.end());
    }
    // The first change of each body has its place at that step.
    std::ranges::stable_sort(changes, {}, &Change::number);
    const auto repeated = std::ranges::unique(changes, {}, &Change::number);
    changes.erase(repeated.begin(), repeated.end());
    std::vector<Box3> boxes;
    auto place = m_places.begin();
    for (const Change& change : changes) {
        boxes.push_back(change.before);
        while (place != m_places.end() && place->number < change.number) ++place;
        if (place != m_places.end() && place->number == change.number) boxes.push_back(place->box);
    }
    return mergedBoxes(std::move(boxes));
}

}  // namespace rubble
