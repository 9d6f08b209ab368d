#include "core/play/events/EventReporting.h"

#include "core/base/Assert.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

constexpr double kApartTime = 0.1;         // s: bodies that were apart for so long hit each other anew
constexpr double kSettledDistance = 0.01;  // m: a body that wakes and sleeps without moving so far has not settled

std::uint32_t numberOf(const World& world, BodyId body) { return static_cast<std::uint32_t>(world.tag(body)); }

/// The material of a body's asset; 0 for the ground and plain projectiles.
Id materialIdOf(const SessionParts& parts, const PlayBody& body) {
    return body.asset ? findAsset(parts.scene().project, body.asset->bake->asset)->material : 0;
}

/// The material of the faces inside it.
Id insideMaterialOf(const SessionParts& parts, const PlayBody& body) {
    const Asset& asset = *findAsset(parts.scene().project, body.asset->bake->asset);
    return asset.insideMaterial != 0 ? asset.insideMaterial : asset.material;
}

/// The record of a body, with what all kinds have.
EventRecord recordOf(const SessionParts& parts, EventKind kind, const PlayBody& body) {
    return {.kind = kind,
            .body = body.number,
            .instance = parts.state().origins[body.origin].instance,
            .materials = {materialIdOf(parts, body), 0}};
}

/// The impacts that were reported, by their bodies.
class ReportedImpacts {
public:
    explicit ReportedImpacts(SessionParts& parts)
        : m_parts(parts), m_apartSteps(static_cast<std::uint64_t>(kApartTime / parts.settings().dt + 0.5)) {}

    /// Follows which of their bodies touch; forgets those that have been apart long enough, or are gone.
    void update() {
        std::vector<ReportedImpact>& reported = m_parts.state().reportedImpacts;
        if (reported.empty()) return;
        for (const ContactEvent& event : m_parts.world().events().ended) {
            ReportedImpact* const found = find(event);
            if (found != nullptr && !m_parts.world().areTouching(event.first, event.second)) {
                found->apartSince = m_parts.state().step;
            }
        }
        std::erase_if(reported, [&](const ReportedImpact& one) { return isOver(one); });
        for (const ContactEvent& event : m_parts.world().events().began) {
            if (ReportedImpact* const found = find(event)) found->apartSince = ReportedImpact::kTouching;
        }
    }
    bool contains(std::uint32_t first, std::uint32_t second) const { return find(first, second) != nullptr; }
    void add(std::uint32_t first, std::uint32_t second) {
        std::vector<ReportedImpact>& reported = m_parts.state().reportedImpacts;
        const ReportedImpact added{std::min(first, second), std::max(first, second)};
        reported.insert(std::ranges::upper_bound(reported, keyOf(added), {}, keyOf), added);
    }

private:
    static std::pair<std::uint32_t, std::uint32_t> keyOf(const ReportedImpact& one) { return {one.first, one.second}; }

    ReportedImpact* find(std::uint32_t first, std::uint32_t second) const {
        std::vector<ReportedImpact>& reported = m_parts.state().reportedImpacts;
        const std::pair key{std::min(first, second), std::max(first, second)};
        const auto found = std::ranges::lower_bound(reported, key, {}, keyOf);
        return found != reported.end() && keyOf(*found) == key ? &*found : nullptr;
    }
    /// Null also if one of the bodies is gone.
    ReportedImpact* find(const ContactEvent& event) const {
        const World& world = m_parts.world();
        if (!world.contains(event.first) || !world.contains(event.second)) return nullptr;
        return find(numberOf(world, event.first), numberOf(world, event.second));
    }
    bool isOver(const ReportedImpact& one) const {
        if (one.apartSince != ReportedImpact::kTouching) return m_parts.state().step - one.apartSince >= m_apartSteps;
        return findBody(m_parts.state(), one.first) == nullptr || findBody(m_parts.state(), one.second) == nullptr;
    }

    SessionParts& m_parts;
    std::uint64_t m_apartSteps;
};

/// What two bodies did to each other in a step, at all their hulls together.
HitEvent joined(std::span<const HitEvent> hits) {
    HitEvent all = hits.front();
    Vec3 point = all.impulse * all.point;
    for (const HitEvent& hit : hits.subspan(1)) {
        point += hit.impulse * hit.point;
        if (hit.approachSpeed > all.approachSpeed) all.normal = hit.normal;
        all.approachSpeed = std::max(all.approachSpeed, hit.approachSpeed);
        all.impulse += hit.impulse;
        all.energy += hit.energy;
    }
    if (all.impulse > 0.0) all.point = point / all.impulse;
    return all;
}

EventRecord impactRecord(const SessionParts& parts, const HitEvent& hit) {
    // The body meant is the one that the artist placed or that came of it, rather than a plain projectile or the
    // ground; of two, that with the lower number.
    const PlayBody* body = findBody(parts.state(), numberOf(parts.world(), hit.first));
    const PlayBody* other = findBody(parts.state(), numberOf(parts.world(), hit.second));
    RUBBLE_ASSERT(body != nullptr && other != nullptr);
    Vec3 normal = -hit.normal;  // into the first
    const auto rank = [](const PlayBody& one) {
        return std::tuple(one.role == PlayRole::Ground, one.asset == nullptr, one.number);
    };
    if (rank(*other) < rank(*body)) {
        std::swap(body, other);
        normal = -normal;
    }
    EventRecord record = recordOf(parts, EventKind::Impact, *body);
    record.other = other->number;
    record.point = hit.point;
    record.normal = normal;
    record.impulse = hit.impulse;
    record.speed = hit.approachSpeed;
    record.energy = std::max(hit.energy, 0.0);  // what pushes them apart counts in restEnergy
    record.materials[1] = materialIdOf(parts, *other);
    record.box.include(hit.point);
    return record;
}

/// Adds the impacts of bodies that did not touch before; the energy of others is that of bodies at rest.
void addImpacts(SessionParts& parts, std::vector<EventRecord>& records) {
    ReportedImpacts reported(parts);
    reported.update();
    const std::vector<HitEvent>& hits = parts.world().events().hits;
    double& rest = parts.state().events.report.restEnergy;
    rest = parts.world().events().contactLoss;
    for (auto begin = hits.begin(); begin != hits.end();) {
        const auto end = std::find_if(begin, hits.end(), [&](const HitEvent& one) {
            return one.first != begin->first || one.second != begin->second;
        });
        const HitEvent hit = joined({begin, end});
        begin = end;
        const std::uint32_t first = numberOf(parts.world(), hit.first), second = numberOf(parts.world(), hit.second);
        if (reported.contains(first, second)) continue;
        records.push_back(impactRecord(parts, hit));
        rest -= records.back().energy;
        if (hit.energy >= parts.scene().project.events.leastEnergy) reported.add(first, second);
    }
}

/// The energy that changes of some kinds took from a body and what hit it, J.
double energyOf(const SessionParts& parts, std::uint32_t body, std::initializer_list<EnergyChange> changes) {
    double energy = 0.0;
    for (const EnergyEntry& entry : parts.state().events.energy) {
        const bool isMeant = std::ranges::find(changes, entry.change) != changes.end();
        if (isMeant && entry.body == body) energy += entry.before + entry.given - entry.after;
    }
    return energy;
}

/// The energy that a break took: of the impulse between the body and its impactor, and of the swap, J.
double energyOfBreak(const SessionParts& parts, std::uint32_t body) {
    return energyOf(parts, body, {EnergyChange::BreakImpulse, EnergyChange::Swap, EnergyChange::Cut});
}

/// What broke of the bonds of a body in a step, in all passes together.
EventRecord bondsRecord(const SessionParts& parts, std::uint32_t body) {
    const std::vector<PlaySplit>& splits = parts.state().events.splits;
    const auto first = std::ranges::find(splits, body, [](const PlaySplit& one) { return one.body.number; });
    EventRecord record = recordOf(parts, EventKind::Bonds, first->body);
    record.materials[1] = insideMaterialOf(parts, first->body);
    record.energy = energyOf(parts, body, {EnergyChange::Bonds, EnergyChange::Split});
    Vec3 weighted(0.0);
    double strongest = -1.0;
    for (const PlaySplit& split : splits) {
        if (split.body.number != body) continue;
        if (split.impulse > strongest) {
            strongest = split.impulse;
            record.other = split.impactorNumber;
            record.point = split.point;
            record.normal = split.normal;
            record.speed = split.approachSpeed;
        }
        weighted += split.impulse * split.point;
        record.impulse += split.impulse;
        record.area += split.area;
        record.count += split.bonds;
        for (const std::uint32_t number : split.freed) {
            const PlayBody* const freed = findBody(parts.state(), number);
            if (freed == nullptr) continue;
            record.mass += parts.world().mass(freed->body);
            record.box.include(parts.world().box(freed->body));
        }
    }
    if (record.impulse > 0.0) record.point = weighted / record.impulse;
    if (record.box.isEmpty()) record.box.include(record.point);
    return record;
}

/// A body that came off another one.
EventRecord detachedRecord(const SessionParts& parts, const PlayBody& freed, std::uint32_t from) {
    EventRecord record = recordOf(parts, EventKind::Detached, freed);
    if (from != freed.number) record.other = from;  // else the heaviest island, which was held
    record.point = parts.world().state(freed.body).centre;
    record.mass = parts.world().mass(freed.body);
    record.count = freed.nodes.empty() ? 1 : static_cast<std::uint32_t>(freed.nodes.size());
    record.materials[1] = insideMaterialOf(parts, freed);
    record.box = parts.world().box(freed.body);
    return record;
}

/// The bonds that broke, and what came free: of a body that came off and lost fragments in the same step, both.
void addSplits(SessionParts& parts, std::vector<EventRecord>& records) {
    std::vector<std::uint32_t> reported;
    for (const PlaySplit& split : parts.state().events.splits) {
        if (split.bonds > 0 && std::ranges::find(reported, split.body.number) == reported.end()) {
            reported.push_back(split.body.number);
            records.push_back(bondsRecord(parts, split.body.number));
        }
        for (const std::uint32_t number : split.freed) {
            const PlayBody* const freed = findBody(parts.state(), number);
            if (freed != nullptr) records.push_back(detachedRecord(parts, *freed, split.body.number));
        }
    }
    // What bonds took that hold.
    for (const EnergyEntry& entry : parts.state().events.energy) {
        if (entry.change != EnergyChange::Bonds && entry.change != EnergyChange::Split) continue;
        if (std::ranges::find(reported, entry.body) != reported.end()) continue;
        parts.state().events.report.restEnergy += entry.before - entry.after;
    }
}

EventRecord breakRecord(const SessionParts& parts, const PlayBreak& broken) {
    EventRecord record = recordOf(parts, EventKind::Broken, broken.body);
    record.other = broken.impactorNumber;
    record.point = broken.point;
    record.normal = broken.normal;
    record.impulse = broken.impact;
    record.speed = broken.approachSpeed;
    record.energy = energyOfBreak(parts, broken.body.number);
    record.area = broken.asset->fractureOf(broken.body.fragment)->area;
    record.materials[1] = insideMaterialOf(parts, broken.body);
    for (std::uint32_t k = 0; k < broken.fragmentCount; ++k) {
        const PlayBody* const fragment = findBody(parts.state(), broken.firstFragment + k);
        if (fragment == nullptr) continue;
        record.mass += parts.world().mass(fragment->body);
        ++record.count;
        record.box.include(parts.world().box(fragment->body));
    }
    if (record.box.isEmpty()) record.box.include(broken.pose.position);
    return record;
}

void addSettled(SessionParts& parts, std::vector<EventRecord>& records) {
    for (const BodyId id : parts.world().events().fellAsleep) {
        PlayBody* const body = findBody(parts.state(), numberOf(parts.world(), id));
        RUBBLE_ASSERT(body != nullptr);
        const Vec3 centre = parts.world().state(id).centre;
        const bool hasMoved = !body->restCentre || glm::distance(*body->restCentre, centre) > kSettledDistance;
        body->restCentre = centre;
        if (!hasMoved) continue;
        EventRecord record = recordOf(parts, EventKind::Settled, *body);
        record.point = centre;
        record.mass = parts.world().mass(id);
        record.box = parts.world().box(id);
        records.push_back(record);
    }
}

EventRecord removalRecord(const SessionParts& parts, const PlayRemoval& removal) {
    EventRecord record = recordOf(parts, EventKind::Removed, removal.body);
    record.reason = removal.reason;
    record.point = removal.centre;
    record.mass = removal.mass;
    record.box = removal.box;
    return record;
}

bool isStronger(const EventRecord& a, const EventRecord& b) {
    return std::tuple(-a.energy, -a.mass, a.body, a.other) < std::tuple(-b.energy, -b.mass, b.body, b.other);
}

/// How many records of each kind are reported: each kind gets one in turn, while it has any.
std::array<std::size_t, kEventKinds> sharesOf(const std::array<std::vector<EventRecord>, kEventKinds>& kinds,
                                              std::size_t most) {
    std::array<std::size_t, kEventKinds> shares{};
    for (bool isAny = true; isAny && most > 0;) {
        isAny = false;
        for (std::size_t kind = 0; kind < kEventKinds && most > 0; ++kind) {
            if (shares[kind] == kinds[kind].size()) continue;
            ++shares[kind];
            --most;
            isAny = true;
        }
    }
    return shares;
}

/// The path of a body's fragment in its asset; empty for what is whole.
std::string fragmentPathOf(const SessionParts& parts, std::uint32_t number) {
    const PlayBody* body = findBody(parts.state(), number);
    const auto isIt = [&](const auto& one) { return one.body.number == number; };
    const PlayEvents& events = parts.state().events;
    if (const auto broken = std::ranges::find_if(events.breaks, isIt); broken != events.breaks.end()) {
        body = &broken->body;
    }
    if (const auto removed = std::ranges::find_if(events.removed, isIt); removed != events.removed.end()) {
        body = &removed->body;
    }
    if (body == nullptr || !body->asset || body->fragment == kNone) return {};
    return body->asset->bake->fragmentPath(body->fragment);
}

}  // namespace

std::vector<EventRecord> happenedEvents(SessionParts& parts) {
    std::vector<EventRecord> records;
    addImpacts(parts, records);
    addSplits(parts, records);
    for (const PlayBreak& broken : parts.state().events.breaks) records.push_back(breakRecord(parts, broken));
    addSettled(parts, records);
    return records;
}

void tellEvents(SessionParts& parts) {
    EventReport& report = parts.state().events.report;
    std::vector<EventRecord>& happened = parts.state().events.happened;
    const EventSettings& settings = parts.scene().project.events;
    for (const PlayRemoval& removal : parts.state().events.removed) happened.push_back(removalRecord(parts, removal));
    OmittedEvents& weak = parts.state().events.weakImpacts;
    std::erase_if(happened, [&](const EventRecord& record) {
        if (record.kind != EventKind::Impact || record.energy >= settings.leastEnergy) return false;
        ++weak.count;
        weak.energy += record.energy;
        return true;
    });
    report.omitted[static_cast<std::size_t>(EventKind::Impact)] = weak;
    std::array<std::vector<EventRecord>, kEventKinds> kinds;
    for (const EventRecord& record : happened) kinds[static_cast<std::size_t>(record.kind)].push_back(record);
    const std::array<std::size_t, kEventKinds> shares = sharesOf(kinds, settings.maxRecords);
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        std::vector<EventRecord>& all = kinds[kind];
        std::ranges::sort(all, isStronger);
        for (std::size_t k = shares[kind]; k < all.size(); ++k) {
            ++report.omitted[kind].count;
            report.omitted[kind].energy += all[k].energy;
        }
        all.resize(shares[kind]);
        std::ranges::sort(all, {}, [](const EventRecord& one) { return std::pair(one.body, one.other); });
        for (EventRecord& record : all) {
            record.step = parts.state().step;
            record.fragment = fragmentPathOf(parts, record.body);
            report.records.push_back(std::move(record));
        }
    }
}

}  // namespace rubble
