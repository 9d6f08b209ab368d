#pragma once

#include "core/physics/state/WorldState.h"

#include <concepts>
#include <type_traits>

namespace rubble {

/// The structs of a WorldState, const or not, whose fields visitFields() visits for writing and reading: visit(name,
/// field) is called for each, in the order of their declaration. A member that is added to a struct does not compile
/// until it is visited here. Structs with the same members share a function. Shapes are shared and not visited, nor are
/// the events of the last step, which the next step clears.
template <class Self, class... Ts>
concept FieldsOf = (std::same_as<std::remove_const_t<Self>, Ts> || ...);

template <FieldsOf<Quatf, QuatRow> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [x, y, z, w] = self;
    visit("x", x);
    visit("y", y);
    visit("z", z);
    visit("w", w);
}

template <FieldsOf<SymMat3f, SymMat3Row> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [xx, xy, xz, yy, yz, zz] = self;
    visit("xx", xx);
    visit("xy", xy);
    visit("xz", xz);
    visit("yy", yy);
    visit("yz", yz);
    visit("zz", zz);
}

template <FieldsOf<Box> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [low, high] = self;
    visit("low", low);
    visit("high", high);
}

template <FieldsOf<BodyId> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [index, generation] = self;
    visit("index", index);
    visit("generation", generation);
}

template <FieldsOf<BodyMotion> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [velocity, inverseMass, angularVelocity, linearDamping, deltaPosition, angularDamping, deltaRotation] = self;
    visit("velocity", velocity);
    visit("inverseMass", inverseMass);
    visit("angularVelocity", angularVelocity);
    visit("linearDamping", linearDamping);
    visit("deltaPosition", deltaPosition);
    visit("angularDamping", angularDamping);
    visit("deltaRotation", deltaRotation);
}

template <FieldsOf<BodyPose> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [centre, arc, rotation, inverseInertia, boundingRadius, travel] = self;
    visit("centre", centre);
    visit("arc", arc);
    visit("rotation", rotation);
    visit("inverseInertia", inverseInertia);
    visit("boundingRadius", boundingRadius);
    visit("travel", travel);
}

template <FieldsOf<Body> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    [[maybe_unused]] auto& [shape, generation, kind, isAwake, isBullet, mass, inertia, inverseInertia, centreRemainder,
                            angularMomentum, referenceAngularVelocity, isFastRotating, isTouched, friction, restitution,
                            boxValidUntil, restTime, restDisplacement, restRotation, stayTime, stayReach, stayPath,
                            stayCentre, stayRotation, sleepingIsland, firstProxy, firstContact, tag] = self;
    visit("generation", generation);
    visit("kind", kind);
    visit("isAwake", isAwake);
    visit("isBullet", isBullet);
    visit("mass", mass);
    visit("inertia", inertia);
    visit("inverseInertia", inverseInertia);
    visit("centreRemainder", centreRemainder);
    visit("angularMomentum", angularMomentum);
    visit("referenceAngularVelocity", referenceAngularVelocity);
    visit("isFastRotating", isFastRotating);
    visit("isTouched", isTouched);
    visit("friction", friction);
    visit("restitution", restitution);
    visit("boxValidUntil", boxValidUntil);
    visit("restTime", restTime);
    visit("restDisplacement", restDisplacement);
    visit("restRotation", restRotation);
    visit("stayTime", stayTime);
    visit("stayReach", stayReach);
    visit("stayPath", stayPath);
    visit("stayCentre", stayCentre);
    visit("stayRotation", stayRotation);
    visit("sleepingIsland", sleepingIsland);
    visit("firstProxy", firstProxy);
    visit("firstContact", firstContact);
    visit("tag", tag);
}

template <FieldsOf<Proxy> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [body, hull, leaf, next] = self;
    visit("body", body);
    visit("hull", hull);
    visit("leaf", leaf);
    visit("next", next);
}

template <FieldsOf<ContactSlot> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [list, index] = self;
    visit("list", list);
    visit("index", index);
}

template <FieldsOf<SeparatingAxis> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [kind, first, second, separation, normal] = self;
    visit("kind", kind);
    visit("first", first);
    visit("second", second);
    visit("separation", separation);
    visit("normal", normal);
}

template <FieldsOf<Contact> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [proxies, bodies, next, previous, slot, stored, separatedIndex, axis, features] = self;
    visit("proxies", proxies);
    visit("bodies", bodies);
    visit("next", next);
    visit("previous", previous);
    visit("slot", slot);
    visit("stored", stored);
    visit("separatedIndex", separatedIndex);
    visit("axis", axis);
    visit("features", features);
}

template <FieldsOf<SeparatedContact> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [contact, bodies, apart, gapNormal] = self;
    visit("contact", contact);
    visit("bodies", bodies);
    visit("apart", apart);
    visit("gapNormal", gapNormal);
}

template <FieldsOf<Prediction> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [centre, arc] = self;
    visit("centre", centre);
    visit("arc", arc);
}

template <FieldsOf<SleepingIsland> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [bodies, contacts] = self;
    visit("bodies", bodies);
    visit("contacts", contacts);
}

template <FieldsOf<StoredContact> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [block, reference] = self;
    visit("block", block);
    visit("reference", reference);
}

template <FieldsOf<Vec3Row> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [x, y, z] = self;
    visit("x", x);
    visit("y", y);
    visit("z", z);
}

template <FieldsOf<PointRows> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [position, separation, impulse, effectiveMass, lever, stepImpulse, approach, sustained] = self;
    visit("position", position);
    visit("separation", separation);
    visit("impulse", impulse);
    visit("effectiveMass", effectiveMass);
    visit("lever", lever);
    visit("stepImpulse", stepImpulse);
    visit("approach", approach);
    visit("sustained", sustained);
}

template <FieldsOf<ContactBlock> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [first, second, contact, pointCount, normal, tangent, centreOffset, firstInverseInertia, secondInverseInertia,
           friction, restitution, againstFixed, stiffening, sharedMassScale, sharedImpulseScale, coupling, points,
           frictionCentre, tangentMassXX, tangentMassXY, tangentMassYY, torsionalMass, frictionX, frictionY,
           torsionalImpulse, stepFrictionX, stepFrictionY, stepTorsionalImpulse] = self;
    visit("first", first);
    visit("second", second);
    visit("contact", contact);
    visit("pointCount", pointCount);
    visit("normal", normal);
    visit("tangent", tangent);
    visit("centreOffset", centreOffset);
    visit("firstInverseInertia", firstInverseInertia);
    visit("secondInverseInertia", secondInverseInertia);
    visit("friction", friction);
    visit("restitution", restitution);
    visit("againstFixed", againstFixed);
    visit("stiffening", stiffening);
    visit("sharedMassScale", sharedMassScale);
    visit("sharedImpulseScale", sharedImpulseScale);
    visit("coupling", coupling);
    visit("points", points);
    visit("frictionCentre", frictionCentre);
    visit("tangentMassXX", tangentMassXX);
    visit("tangentMassXY", tangentMassXY);
    visit("tangentMassYY", tangentMassYY);
    visit("torsionalMass", torsionalMass);
    visit("frictionX", frictionX);
    visit("frictionY", frictionY);
    visit("torsionalImpulse", torsionalImpulse);
    visit("stepFrictionX", stepFrictionX);
    visit("stepFrictionY", stepFrictionY);
    visit("stepTorsionalImpulse", stepTorsionalImpulse);
}

template <FieldsOf<ReferenceBlock> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [firstRotation, secondRotation, centreOffset, separation, slack, isSwept] = self;
    visit("firstRotation", firstRotation);
    visit("secondRotation", secondRotation);
    visit("centreOffset", centreOffset);
    visit("separation", separation);
    visit("slack", slack);
    visit("isSwept", isSwept);
}

template <FieldsOf<WorldState> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    [[maybe_unused]] auto& [gravity, sleeping, bodies, motions, poses, predictedTravel, predictions, obstacleSizes,
                            bouncyBodies, compoundBodies, freeBodies, awake, woken, hasRemovedAwake, proxies,
                            freeProxies, tree, rebox, contacts, freeContacts, pairs, colours, separated,
                            sleepingIslands, freeSleepingIslands, stored, freeStored, grabbed, grabPoint, grabTarget,
                            grabForce, grabWork, events] = self;
    visit("gravity", gravity);
    visit("sleeping", sleeping);
    visit("bodies", bodies);
    visit("motions", motions);
    visit("poses", poses);
    visit("predictedTravel", predictedTravel);
    visit("predictions", predictions);
    visit("obstacleSizes", obstacleSizes);
    visit("bouncyBodies", bouncyBodies);
    visit("compoundBodies", compoundBodies);
    visit("freeBodies", freeBodies);
    visit("awake", awake);
    visit("woken", woken);
    visit("hasRemovedAwake", hasRemovedAwake);
    visit("proxies", proxies);
    visit("freeProxies", freeProxies);
    visit("tree", tree);
    visit("rebox", rebox);
    visit("contacts", contacts);
    visit("freeContacts", freeContacts);
    visit("pairs", pairs);
    visit("colours", colours);
    visit("separated", separated);
    visit("sleepingIslands", sleepingIslands);
    visit("freeSleepingIslands", freeSleepingIslands);
    visit("stored", stored);
    visit("freeStored", freeStored);
    visit("grabbed", grabbed);
    visit("grabPoint", grabPoint);
    visit("grabTarget", grabTarget);
    visit("grabForce", grabForce);
    visit("grabWork", grabWork);
}

}  // namespace rubble
