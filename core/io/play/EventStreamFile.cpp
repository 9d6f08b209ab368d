#include "core/io/play/EventStreamFile.h"

#include "core/base/Assert.h"
#include "core/io/json/FormatVersion.h"
#include "core/io/pack/PackExport.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/project/ShotJson.h"
#include "core/play/events/MovingContacts.h"
#include "core/play/session/Timeline.h"

#include <algorithm>
#include <charconv>

namespace rubble {
namespace {

constexpr FileFormat kEventsFormat{.name = "rubble-events", .noun = "events", .version = 2};
constexpr int kDigits = 7;               // of numbers: all that a float of the solver has
constexpr std::size_t kMaxContacts = 3;  // that slide or roll, a step

/// A number with as many digits as the file has.
double shortened(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
    double read = value;
    std::from_chars(text.data(), end.ptr, read);
    return read;
}

void writeShort(JsonWriter& json, std::string_view key, double value) { json.number(key, shortened(value)); }

void writeShort(JsonWriter& json, std::string_view key, Vec3 vector) {
    json.numbers(key, {shortened(vector.x), shortened(vector.y), shortened(vector.z)});
}

void writeShort(JsonWriter& json, const Box3& box) {
    json.openArray("box");
    writeShort(json, {}, box.min);
    writeShort(json, {}, box.max);
    json.close();
}

void writeMaterials(JsonWriter& json, const EventRecord& record) { json.wholeNumbers("materials", record.materials); }

/// Where the frame of a body's asset is in the world, and how the body moves. A plain projectile has a frame of its
/// own.
void writeMotion(JsonWriter& json, const PlayBody& body, const BodyState& state) {
    const Quat turned = state.pose.orientation;
    writeShort(json, "position", state.pose.position - turned * frameOf(body));
    json.numbers("rotation", {shortened(turned.x), shortened(turned.y), shortened(turned.z), shortened(turned.w)});
    if (state.velocity != Vec3(0.0)) writeShort(json, "velocity", state.velocity);
    if (state.angularVelocity != Vec3(0.0)) writeShort(json, "angularVelocity", state.angularVelocity);
}

/// What a body consists of: fragments of its asset's bake; kNone: the whole.
std::vector<std::uint32_t> partsOf(const PlayBody& body) {
    return isPartial(body) ? fragmentsOf(body) : std::vector<std::uint32_t>{body.fragment};
}

void writePaths(JsonWriter& json, const PlayAsset& asset, const std::vector<std::uint32_t>& fragments) {
    json.list("fragments", fragments,
              [&](JsonWriter& list, std::uint32_t fragment) { list.text({}, asset.bake->fragmentPath(fragment)); });
}

/// The fragments of a body that is not the whole of its asset.
void writeFragments(JsonWriter& json, const PlayBody& body) {
    const std::vector<std::uint32_t> fragments = body.asset ? partsOf(body) : std::vector<std::uint32_t>{kNone};
    if (fragments != std::vector<std::uint32_t>{kNone}) writePaths(json, *body.asset, fragments);
}

/// What nothing came off of: an instance, or what was thrown.
void writeOrigin(JsonWriter& json, const Session& session, const PlayBody& body) {
    const PlayOrigin& origin = session.origins()[body.origin];
    json.text("name", origin.name);
    if (origin.instance != 0) json.wholeNumber("instance", std::uint64_t{origin.instance});
    if (origin.asset != 0) {
        json.wholeNumber("asset", std::uint64_t{origin.asset});
        json.wholeNumber("variant", std::uint64_t{origin.variant});
    }
    if (!origin.thrown) return;
    json.text("projectile", nameOf(origin.thrown->kind));
    writeShort(json, "size", origin.thrown->size);
}

/// The mass of what moves; what does not is fixed.
void writeMass(JsonWriter& json, double mass) {
    if (mass > 0.0) writeShort(json, "mass", mass);
    if (!(mass > 0.0)) json.boolean("fixed", true);
}

/// The mass of what is left of a body, if it moves.
void writeRest(JsonWriter& json, const Session& session, std::uint32_t number) {
    const PlayBody* const rest = session.body(number);
    const double mass = rest != nullptr ? session.world().mass(rest->body) : 0.0;
    if (mass > 0.0) writeShort(json, "restMass", mass);
}

void writeBlow(JsonWriter& json, const EventRecord& record) {
    writeShort(json, "point", record.point);
    writeShort(json, "normal", record.normal);
    writeShort(json, "impulse", record.impulse);
    writeShort(json, "speed", record.speed);
    writeShort(json, "energy", record.energy);
}

void writeAsset(JsonWriter& json, const PlayScene& scene, const PackNames& names, AssetVariant key) {
    const PlayAsset& asset = *scene.assets.at(key);
    const Asset& recipe = *findAsset(scene.project, key.asset);
    json.openObject();
    json.wholeNumber("asset", std::uint64_t{key.asset});
    json.wholeNumber("variant", std::uint64_t{key.variant});
    json.text("name", recipe.name);
    json.text("folder", names.folder);
    json.wholeNumber("material", std::uint64_t{recipe.material});
    if (asset.isBonded) {
        std::vector<std::uint32_t> all(asset.fragments.size());
        for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
        writePaths(json, asset, all);
    }
    json.close();
}

/// The body with a number as it is, or was when it was born in this step.
const PlayBody* bornBody(const Session& session, std::uint32_t number) {
    if (const PlayBody* present = session.body(number)) return present;
    for (const PlayBody& body : session.events().born)
        if (body.number == number) return &body;
    return nullptr;
}

/// How a body moves after the step, or moved when it broke or was removed in it.
BodyState lastState(const Session& session, const PlayBody& body) {
    const PlayEvents& events = session.events();
    if (session.body(body.number) != nullptr) return session.world().state(body.body);
    const auto isIt = [&](const auto& one) { return one.body.number == body.number; };
    for (const std::vector<PlayRemoval>* removals : {&events.removed, &events.taken}) {
        const auto removed = std::ranges::find_if(*removals, isIt);
        if (removed != removals->end()) return removed->state;
    }
    const auto broken = std::ranges::find_if(events.breaks, isIt);
    RUBBLE_ASSERT(broken != events.breaks.end());
    const Vec3 centre = body.asset->solid(body.fragment).shape->mass.centre;
    return {.pose = broken->pose,
            .centre = broken->pose.position + broken->pose.orientation * centre,
            .velocity = broken->velocity,
            .angularVelocity = broken->angularVelocity};
}

/// What is broken or more damaged than before.
void writeDamage(JsonWriter& json, const InstanceDamage& now, const InstanceDamage* before) {
    const bool isSame = before != nullptr && before->cut == now.cut && before->broken.size() == now.broken.size();
    if (now.cut && !isSame) {
        json.openObject("cut");
        if (now.cut->isInPlane()) {
            json.numbers("point", {now.cut->point.x, now.cut->point.y});
        } else {
            json.numbers("point", {now.cut->point.x, now.cut->point.y, now.cut->height});
        }
        json.text("number", std::to_string(now.cut->number));
        json.close();
    }
    json.openArray("broken");
    for (std::uint32_t k = 0; k < now.broken.size(); ++k)
        if (now.broken[k] && !(isSame && before->broken[k])) json.wholeNumber({}, std::uint64_t{k});
    json.close();
    json.openArray("weakened");
    for (const auto& [bond, amount] : now.partial) {
        const auto known = isSame ? before->partial.find(bond) : now.partial.end();
        if (isSame && known != before->partial.end() && known->second == amount) continue;
        json.openArray();
        json.wholeNumber({}, std::uint64_t{bond});
        json.wholeNumber({}, std::uint64_t{amount});
        json.close();
    }
    json.close();
}

}  // namespace

EventStreamText::EventStreamText(const Session& session) {
    addHeader(session);
    addDamage(session);
}

void EventStreamText::add(const Session& session) {
    addImpacts(session);
    addBonds(session);
    addBirths(session);
    addBreaks(session);
    addSettled(session);
    addRemovals(session);
    const PlayEvents& events = session.events();
    if (!events.breaks.empty() || !events.splits.empty() || !events.impacts.empty() || !events.inputs.empty())
        addDamage(session);
    addContacts(session);
    addSums(session);
}

std::string EventStreamText::take() { return std::exchange(m_text, {}); }

template <class Write>
void EventStreamText::addLine(const Write& write) {
    JsonWriter json(JsonLayout::Compact);
    json.openObject();
    write(json);
    json.close();
    m_text += std::move(json).finished();
}

template <class Write>
void EventStreamText::addEvent(const Session& session, std::string_view kind, const Write& write) {
    addLine([&](JsonWriter& json) {
        json.wholeNumber("step", session.stepsDone());
        json.text("kind", kind);
        write(json);
    });
}

void EventStreamText::addHeader(const Session& session) {
    const PlayScene& scene = session.scene();
    const std::map<AssetVariant, PackNames> names = packNames(scene.project);
    addLine([&](JsonWriter& json) {
        json.text("format", kEventsFormat.name);
        json.wholeNumber("version", std::uint64_t{kEventsFormat.version});
        writeUnits(json);
        json.wholeNumber("step", session.stepsDone());
        json.number("dt", session.stepLength());
        const Vec3 gravity = session.world().gravity();
        writeShort(json, "gravity", gravity);
        json.list("materials", scene.project.materials, [](JsonWriter& list, const Material& material) {
            list.openObject();
            list.wholeNumber("material", std::uint64_t{material.id});
            list.text("name", material.name);
            list.close();
        });
        json.openArray("assets");
        for (const auto& [key, asset] : scene.assets) writeAsset(json, scene, names.at(key), key);
        json.close();
        json.list("bodies", session.bodies(), [&](JsonWriter& list, const PlayBody& body) {
            remember(session, body);
            list.openObject();
            list.wholeNumber("body", std::uint64_t{body.number});
            writeOrigin(list, session, body);
            writeFragments(list, body);
            writeMass(list, massOf(session, body.number));
            writeMotion(list, body, session.world().state(body.body));
            list.close();
        });
    });
}

void EventStreamText::addImpacts(const Session& session) {
    const std::vector<EventRecord>& happened = session.events().happened;
    std::vector<std::uint32_t> impacts;
    for (std::uint32_t k = 0; k < happened.size(); ++k)
        if (happened[k].kind == EventKind::Impact) impacts.push_back(k);
    const std::size_t most = std::min<std::size_t>(session.scene().project.events.maxRecords, impacts.size());
    std::ranges::stable_sort(impacts, std::greater(), [&](std::uint32_t k) { return happened[k].energy; });
    m_listed = {impacts.begin(), impacts.begin() + static_cast<std::ptrdiff_t>(most)};
    for (const std::uint32_t k : m_listed) {
        const EventRecord& record = happened[k];
        addEvent(session, nameOf(record.kind), [&](JsonWriter& json) {
            json.wholeNumber("body", std::uint64_t{record.body});
            json.wholeNumber("other", std::uint64_t{record.other});
            writeBlow(json, record);
            json.numbers("masses", {shortened(massOf(session, record.body)), shortened(massOf(session, record.other))});
            writeMaterials(json, record);
        });
    }
}

void EventStreamText::addBonds(const Session& session) {
    for (const EventRecord& record : session.events().happened) {
        if (record.kind != EventKind::Bonds) continue;
        addEvent(session, nameOf(record.kind), [&](JsonWriter& json) {
            json.wholeNumber("body", std::uint64_t{record.body});
            if (record.other != kNone) json.wholeNumber("other", std::uint64_t{record.other});
            writeBlow(json, record);
            writeShort(json, "area", record.area);
            json.wholeNumber("count", std::uint64_t{record.count});
            writeMaterials(json, record);
            writeShort(json, record.box);
        });
    }
}

void EventStreamText::addBirths(const Session& session) {
    std::set<std::uint32_t> numbers;
    for (const PlayBody& body : session.events().born) numbers.insert(body.number);
    for (const PlaySplit& split : session.events().splits) numbers.insert(split.freed.begin(), split.freed.end());
    for (const std::uint32_t number : numbers) {
        if (const PlayBody* body = bornBody(session, number)) addBirth(session, *body);
    }
}

void EventStreamText::addBirth(const Session& session, const PlayBody& body) {
    const bool isThrown = body.role == PlayRole::Projectile;
    const bool isIsland = !isThrown && body.asset->isBonded;
    addEvent(session, isIsland ? nameOf(EventKind::Detached) : "born", [&](JsonWriter& json) {
        const BodyState state = lastState(session, body);
        json.wholeNumber("body", std::uint64_t{body.number});
        const std::uint32_t owner = isThrown ? kNone : ownerOf(body);
        if (owner != kNone && owner != body.number) {
            json.wholeNumber("other", std::uint64_t{owner});
            if (isIsland) writeRest(json, session, owner);
        }
        if (isThrown) writeOrigin(json, session, body);
        writeFragments(json, body);
        writeMass(json, massOf(session, body.number));
        writeShort(json, "point", state.centre);
        writeMotion(json, body, state);
    });
    remember(session, body);
}

void EventStreamText::addBreaks(const Session& session) {
    for (const EventRecord& record : session.events().happened) {
        if (record.kind != EventKind::Broken) continue;
        addEvent(session, nameOf(record.kind), [&](JsonWriter& json) {
            const auto isIt = [&](const PlayBreak& one) { return one.body.number == record.body; };
            const auto broken = std::ranges::find_if(session.events().breaks, isIt);
            json.wholeNumber("body", std::uint64_t{record.body});
            if (record.other != kNone) json.wholeNumber("other", std::uint64_t{record.other});
            writeBlow(json, record);
            writeShort(json, "area", record.area);
            json.wholeNumber("count", std::uint64_t{record.count});
            writeMotion(json, broken->body, lastState(session, broken->body));
            writeMaterials(json, record);
            writeShort(json, record.box);
        });
    }
}

void EventStreamText::addSettled(const Session& session) {
    for (const EventRecord& record : session.events().happened) {
        const PlayBody* const body = record.kind == EventKind::Settled ? session.body(record.body) : nullptr;
        if (body == nullptr) continue;
        addEvent(session, nameOf(record.kind), [&](JsonWriter& json) {
            json.wholeNumber("body", std::uint64_t{record.body});
            writeShort(json, "point", record.point);
            writeMotion(json, *body, session.world().state(body->body));
            writeShort(json, record.box);
        });
    }
}

void EventStreamText::addRemovals(const Session& session) {
    for (const PlayRemoval& removal : session.events().taken) addRemoval(session, removal);
    for (const PlayRemoval& removal : session.events().removed) addRemoval(session, removal);
}

void EventStreamText::addRemoval(const Session& session, const PlayRemoval& removal) {
    addEvent(session, nameOf(EventKind::Removed), [&](JsonWriter& json) {
        json.wholeNumber("body", std::uint64_t{removal.body.number});
        json.text("reason", nameOf(removal.reason));
        if (!removal.fragments.empty()) {
            writePaths(json, *removal.body.asset, removal.fragments);
            writeRest(json, session, removal.body.number);
        }
        writeShort(json, "point", removal.centre);
        writeMotion(json, removal.body, removal.state);
        writeShort(json, removal.box);
    });
}

void EventStreamText::addDamage(const Session& session) {
    SessionDamage damage = session.damage();
    for (const auto& [instance, now] : damage) {
        const auto known = m_damage.find(instance);
        const InstanceDamage* const before = known != m_damage.end() ? &known->second : nullptr;
        if (before != nullptr ? *before == now : now.isIntact()) continue;
        addEvent(session, "damaged", [&](JsonWriter& json) {
            json.wholeNumber("instance", std::uint64_t{instance});
            writeDamage(json, now, before);
        });
    }
    m_damage = std::move(damage);
}

void EventStreamText::addContacts(const Session& session) {
    for (const MovingContact& contact : movingContacts(session.world(), kMaxContacts)) {
        addEvent(session, contact.isRolling ? "rolling" : "sliding", [&](JsonWriter& json) {
            json.wholeNumber("body", std::uint64_t{contact.body});
            json.wholeNumber("other", std::uint64_t{contact.other});
            writeShort(json, "point", contact.point);
            writeShort(json, "speed", contact.speed);
            writeShort(json, "load", contact.load);
        });
    }
}

void EventStreamText::addSums(const Session& session) {
    const PlayEvents& events = session.events();
    OmittedEvents omitted = events.weakImpacts;
    for (std::uint32_t k = 0; k < events.happened.size(); ++k) {
        if (events.happened[k].kind != EventKind::Impact || m_listed.contains(k)) continue;
        ++omitted.count;
        omitted.energy += events.happened[k].energy;
    }
    if (omitted.count == 0 && events.report.restEnergy == 0.0) return;
    addEvent(session, "sums", [&](JsonWriter& json) {
        json.openObject("omitted");
        if (omitted.count > 0) {
            json.openObject(nameOf(EventKind::Impact));
            json.wholeNumber("count", std::uint64_t{omitted.count});
            writeShort(json, "energy", omitted.energy);
            json.close();
        }
        json.close();
        writeShort(json, "restEnergy", events.report.restEnergy);
    });
}

/// The mass of a body, or of one that is gone as it was last, kg; 0: it does not move.
double EventStreamText::massOf(const Session& session, std::uint32_t number) const {
    if (const PlayBody* body = session.body(number)) return session.world().mass(body->body);
    if (const auto known = m_masses.find(number); known != m_masses.end()) return known->second;
    const std::vector<EventRecord>& happened = session.events().happened;
    const auto isEnd = [&](const EventRecord& record) {
        return record.body == number && (record.kind == EventKind::Broken || record.kind == EventKind::Removed);
    };
    const auto end = std::ranges::find_if(happened, isEnd);
    return end != happened.end() ? end->mass : 0.0;
}

/// Keeps what a body that appeared weighs and consists of.
void EventStreamText::remember(const Session& session, const PlayBody& body) {
    if (session.body(body.number) != nullptr) m_masses[body.number] = session.world().mass(body.body);
    if (!body.asset) return;
    for (const std::uint32_t fragment : partsOf(body)) m_owner[{body.origin, fragment}] = body.number;
    if (body.role == PlayRole::Projectile) m_owner[{body.origin, kNone}] = body.number;
}

/// The body that the fragments of one that just appeared were part of.
std::uint32_t EventStreamText::ownerOf(const PlayBody& body) const {
    std::uint32_t fragment = partsOf(body).front();
    while (true) {
        const auto known = m_owner.find({body.origin, fragment});
        if (known != m_owner.end()) return known->second;
        if (fragment == kNone) return kNone;
        fragment = body.asset->bake->fragment(fragment).parent;
    }
}

Result<std::string> eventStream(Session session, std::vector<TimedInput> inputs, std::uint64_t steps,
                                const TaskContext& task) {
    EventStreamText text(session);
    const auto add = [&](const Session& played) {
        text.add(played);
        return success();
    };
    const Status played = playOn(std::move(session), std::move(inputs), steps, task, add);
    if (!played) return played.error();
    return text.take();
}

}  // namespace rubble
