#pragma once

#include "core/play/Session.h"

#include <map>

namespace rubble {

/// All of a session that changes, beside its world.
struct SessionState {
    std::uint64_t step = 0;
    bool hasDestruction = true;
    std::vector<PlayBody> bodies;  // ascending number
    std::uint32_t nextNumber = 0;
    std::vector<PlayOrigin> origins;
    std::vector<TimedInput> pending;  // ascending step; of equal steps as they were given
    std::vector<Material> materials;  // as they are now; ascending id
    std::map<Id, double> assetThresholds;
    std::map<Id, double> instanceThresholds;  // where an instance has its own
    double lowest = 0.0;                      // m: what falls below it is out of the world
    PlayEvents events;
    std::vector<PlayBreak> recentBreaks;  // of the last kRecentTime; nothing that follows depends on them
};

struct SessionSnapshot {
    SessionState state;
    std::shared_ptr<const Snapshot> world;
};

/// A moment's access to the parts of a session, for those who carry its step out.
struct SessionParts {
    const PlayScene& scene;
    const SessionSettings& settings;
    SessionState& state;
    World& world;
};

const Material& materialOf(const SessionState& state, const PlayScene& scene, Id asset);
/// What a body of an asset is made of; by the thesis's preset each piece weighs 100 kg, whatever its size.
BodyMaterial bodyMaterial(const SessionParts& parts, const PlayAsset& asset, std::uint32_t fragment, PlayRole role);
double thresholdOf(const SessionState& state, const PlayScene& scene, const PlayBody& body);
/// The body with a number or with a world id; null where it is gone.
PlayBody* findBody(SessionState& state, std::uint32_t number);

/// Puts a body into world and list, with the next number.
///
/// Errors: those of World::addBody().
Result<std::uint32_t> addBody(const SessionParts& parts, BodyDefinition definition, PlayBody body);
/// Takes a body out of the world. It stays in the list, of no world id, until forgetTakenOut() takes all such out at once.
void takeOut(const SessionParts& parts, std::uint32_t number);
void forgetTakenOut(SessionState& state);

/// Ground and instances.
Status placeScene(const SessionParts& parts);

/// Says what is wrong with an input, or nothing.
std::optional<std::string> faultOf(const PlayInput& input, const PlayScene& scene, const SessionState& state);
/// Follows the inputs that are due.
void followInputs(const SessionParts& parts);

/// Finds what breaks in the step that was collided, and swaps it for its pieces. True where anything did.
bool breakWhatIsHit(const SessionParts& parts);
/// Breaks these bodies: strikers pay, wholes are swapped in order of their numbers.
void carryOut(const SessionParts& parts, std::vector<PendingBreak> breaks);
/// The break of a body by something that is no body of the world.
PendingBreak pendingBreak(const SessionParts& parts, const PlayBody& body);

/// In [0, 1]: how much of a body has faded away.
double fadeOf(const PlayBody& body, const Debris& debris, std::uint64_t step, double dt);
/// Takes away debris that is due, and what fell out of the world.
void clearAway(const SessionParts& parts);

}  // namespace rubble
