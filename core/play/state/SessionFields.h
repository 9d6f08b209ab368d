#pragma once

#include "core/physics/state/WorldFields.h"
#include "core/play/state/SessionState.h"

namespace rubble {

/// Visits the fields of the structs of a SessionState, as those in WorldFields.h. Assets and hulls of bodies follow
/// from their origins and are not visited, nor are the events of the last step.
template <FieldsOf<ContentHash> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [high, low] = self;
    visit("high", high);
    visit("low", low);
}

template <FieldsOf<AssetVariant> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [asset, variant] = self;
    visit("asset", asset);
    visit("variant", variant);
}

template <FieldsOf<Throw> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [kind, asset, size, mass, from, to, speed] = self;
    visit("kind", kind);
    visit("asset", asset);
    visit("size", size);
    visit("mass", mass);
    visit("from", from);
    visit("to", to);
    visit("speed", speed);
}

template <FieldsOf<Hammer, Blast> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [at, impulse, radius] = self;
    visit("at", at);
    visit("impulse", impulse);
    visit("radius", radius);
}

template <FieldsOf<Colour> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [red, green, blue] = self;
    visit("red", red);
    visit("green", green);
    visit("blue", blue);
}

template <FieldsOf<Material> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [id, name, density, friction, restitution, tensileStrength, fractureToughness, youngsModulus, outside, inside,
           opacity, finish] = self;
    visit("id", id);
    visit("name", name);
    visit("density", density);
    visit("friction", friction);
    visit("restitution", restitution);
    visit("tensileStrength", tensileStrength);
    visit("fractureToughness", fractureToughness);
    visit("youngsModulus", youngsModulus);
    visit("outside", outside);
    visit("inside", inside);
    visit("opacity", opacity);
    static_cast<void>(finish);  // pictures take it from the scene: states of earlier versions have none
}

template <FieldsOf<ShotInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [name, action] = self;
    visit("name", name);
    visit("action", action);
}

template <FieldsOf<ThresholdInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [asset, instance, threshold] = self;
    visit("asset", asset);
    visit("instance", instance);
    visit("threshold", threshold);
}

template <FieldsOf<MaterialInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [material] = self;
    visit("material", material);
}

template <FieldsOf<BreakInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [body] = self;
    visit("body", body);
}

template <FieldsOf<GravityInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [gravity] = self;
    visit("gravity", gravity);
}

template <FieldsOf<DestructionInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [isOn] = self;
    visit("isOn", isOn);
}

template <FieldsOf<GrabInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [body, point, force] = self;
    visit("body", body);
    visit("point", point);
    visit("force", force);
}

template <FieldsOf<DragInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [to] = self;
    visit("to", to);
}

template <FieldsOf<ReleaseInput> Self, class Visit>
void visitFields(Self&, Visit&) {}

template <FieldsOf<InstancePart> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [instance, fragments] = self;
    visit("instance", instance);
    visit("fragments", fragments);
}

template <FieldsOf<RemoveInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [part] = self;
    visit("part", part);
}

template <FieldsOf<TimedInput> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [step, input] = self;
    visit("step", step);
    visit("input", input);
}

template <FieldsOf<ImpactCut> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    visit("point", self.point);
    visit("number", self.number);
    visit("cutHeight", self.height);
}

template <FieldsOf<InstanceDamage> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [kind, bake, cut, broken, partial] = self;
    visit("kind", kind);
    visit("bake", bake);
    visit("cut", cut);
    visit("broken", broken);
    visit("partialDamage", partial);
}

template <FieldsOf<PlayBody> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    [[maybe_unused]] auto& [number, body, role, origin, asset, fragment, hull, born, isUnbreakable, restCentre,
                            structure, nodes, isHeld, collapseStep, heldLevel, heldUntil] = self;
    visit("number", number);
    visit("body", body);
    visit("role", role);
    visit("origin", origin);
    visit("fragment", fragment);
    visit("born", born);
    visit("isUnbreakable", isUnbreakable);
    visit("restCentre", restCentre);
    visit("structure", structure);
    visit("bondedNodes", nodes);
    visit("isHeld", isHeld);
    visit("collapseStep", collapseStep);
    visit("heldLevel", heldLevel);
    visit("heldUntil", heldUntil);
}

template <FieldsOf<StructureState> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    [[maybe_unused]] auto& [origin, parent, damage, bodyOfNode, structure] = self;
    visit("origin", origin);
    visit("parent", parent);
    visit("damage", damage);
}

template <FieldsOf<PlayOrigin> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [name, instance, asset, variant, thrown] = self;
    visit("name", name);
    visit("instance", instance);
    visit("asset", asset);
    visit("variant", variant);
    visit("thrown", thrown);
}

template <FieldsOf<ReportedImpact> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [first, second, apartSince] = self;
    visit("first", first);
    visit("second", second);
    visit("apartSince", apartSince);
}

template <FieldsOf<SessionState> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    [[maybe_unused]] auto& [step, elapsed, dividedUntil, hasDestruction, bodies, nextNumber, origins, damage,
                            structures, pending, materials, assetThresholds, instanceThresholds, lowest, events,
                            reportedImpacts, keptSupports] = self;
    visit("step", step);
    visit("dividedUntil", dividedUntil);
    visit("hasDestruction", hasDestruction);
    visit("bodies", bodies);
    visit("nextNumber", nextNumber);
    visit("origins", origins);
    visit("damage", damage);
    visit("structures", structures);
    visit("pending", pending);
    visit("materials", materials);
    visit("assetThresholds", assetThresholds);
    visit("instanceThresholds", instanceThresholds);
    visit("lowest", lowest);
    visit("reportedImpacts", reportedImpacts);
}

}  // namespace rubble
