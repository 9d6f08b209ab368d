#pragma once

#include "core/physics/state/WorldState.h"
#include "core/play/session/Session.h"

#include <variant>

namespace rubble {

/// How much of a session is saved. Written to files: values never change.
enum class StateKind : std::uint8_t {
    Whole = 1,  // its moment, bit for bit: it goes on as if it had never been saved
    Small = 2,  // damage and poses: its bodies rest where they are and sleep
};

/// Where a body rests.
struct RestingPose {
    Vec3f centre{0.0f, 0.0f, 0.0f};  // m, of mass
    Quatf rotation;                  // world from body
};

/// What a small state has in place of a world.
struct RestingWorld {
    Vec3f gravity{0.0f, 0.0f, 0.0f};  // m/s²
    bool sleeping = true;
    std::vector<RestingPose> poses;  // of SessionState::bodies
};

/// A session as it is saved: a value that names assets, fragments and projectiles, but has no shapes.
struct SavedSession {
    double dt = 1.0 / 60.0;                     // s
    std::map<AssetVariant, ContentHash> bakes;  // damageHash() of the assets in use
    ContentHash hash;                           // Session::hash(); 0 in a small state
    SessionState state;
    std::variant<WorldState, RestingWorld> world;

    StateKind kind() const { return world.index() == 0 ? StateKind::Whole : StateKind::Small; }
};

/// The present moment of a session. A small state drops motions, contacts and pending inputs.
SavedSession savedSession(const Session& session, StateKind kind);

/// A state as if another bake of an asset had been in use when it was saved, that of `variant`, for all its instances.
///
/// Errors: BadInput if an instance or projectile of the asset is broken in it.
Result<SavedSession> withBake(SavedSession saved, const Asset& variant, const Bake& bake);

/// A session at the saved moment. `settings` gives threads and lanes; the rest is saved. Stepping a whole state gives
/// the same bits as going on with the session that was saved. The bodies of a small one sleep, if sleeping is on.
///
/// Errors: BadInput if the bakes of the scene are others, with both hashes; if something in it is not as savedSession()
/// writes it, with its place: "The state cannot be used: world.contacts[3].next is wrong."; those of Session::start().
Result<Session> resumedSession(std::shared_ptr<const PlayScene> scene, SavedSession saved,
                               SessionSettings settings = {});

}  // namespace rubble
